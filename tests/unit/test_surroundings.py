"""Supports, structures and the hole of a dock: in the scene of a recording, and in what is drawn from it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.plot.drawing import SIDE
from gantline.plot.scene import snapshot
from gantline.plot.views import stages, system
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results import Recording, Variable
from gantline.results.surroundings import Ground, Hole, ground_of, structures_of
from gantline.scenario import load_scenario
from gantline.viewer import pack
from hull_lift import HULL, lift, text
from sample_lift import ringing_lift

DOCK = {"type": "dock", "x": ["10 m", "70 m"], "y": ["-200 m", "200 m"], "floor": "-12 m"}
SHED = {"type": "box", "x": ["-90 m", "-80 m"], "y": ["0 m", "6 m"], "z": ["0 m", "8 m"]}
HOLE = Hole((10.0, 70.0), (-200.0, 200.0), -12.0)
FLOOR, LEVEL = -3.0, 0.0


def scene_of(folder: Path, **changes: Any) -> dict[str, Any]:
    path = folder / "scenario.yaml"
    path.write_text(text(lift(**changes)))
    return dict(assemble(load_scenario(path)).scene)


def standing(
    scene: dict[str, Any] | None = None, events: tuple[tuple[float, str, str], ...] = ()
) -> Recording:
    """The ringing lift over a pit of 12 m by 60 m, on a support of 2 m by 1 m that is turned, near a wall."""
    plain = ringing_lift()
    quarter = [np.cos(np.pi / 4), 0.0, 0.0, np.sin(np.pi / 4)]
    pad = {"type": "box", "size": [2, 1, 1.5], "centre": [3, 0, -2.25], "orientation": quarter}
    wall = {"type": "box", "size": [400, 1, 4], "centre": [0, 20, 2]}
    world = {
        "ground": {"level": LEVEL, "holes": [{"x": [-6, 6], "y": [-30, 30], "floor": FLOOR}]},
        "structures": [
            {"name": "wall", "kind": "structure", "boxes": [wall]},
            {"name": "support.a", "kind": "support", "boxes": [pad]},
        ],
    }
    attributes = {**plain.attributes, "scene": {**plain.attributes["scene"], **(scene or world)}}
    columns = {
        name: Variable(("event",), np.array([event[at] for event in events]), "", name)
        for at, name in enumerate(("event_time", "event_kind", "event_name"))
    }
    return Recording({**plain.variables, **(columns if events else {})}, plain.coordinates, attributes)


def test_the_scene_has_supports_structures_and_the_hole_of_the_dock(tmp_path: Path) -> None:
    turned = {"keel_blocks": {**HULL["supports"]["keel_blocks"], "top": ["1 m", "0.5 m"]}}
    load = {**HULL["load"], "heading": "90 deg"}
    scene = scene_of(tmp_path, load=load, supports=turned, structures={"dock": DOCK, "shed": SHED})
    assert scene["ground"] == {
        "level": 0.0,
        "holes": [{"x": [10.0, 70.0], "y": [-200.0, 200.0], "floor": -12.0}],
    }
    shed, *keel = scene["structures"]
    assert (shed["name"], shed["kind"]) == ("shed", "structure")
    assert shed["boxes"] == [{"type": "box", "size": [10.0, 6.0, 8.0], "centre": [-85.0, 3.0, 4.0]}]
    assert [one["kind"] for one in keel] == ["support"] * 16
    assert all(one["name"].startswith("support.keel_blocks.") for one in keel)
    # The load is at -35 m and turned by 90 deg: what is at (-18, -9) on it is at (-35 + 9, -18) of the world.
    (box,) = keel[0]["boxes"]
    assert box["centre"] == pytest.approx([-26.0, -18.0, 0.75])
    recording = Recording({}, {}, {"scene": json.loads(json.dumps(scene))})
    corners = structures_of(recording)[1].boxes[0]
    # 1 m along the load is along world y.
    assert np.ptp(corners, axis=0) == pytest.approx([0.5, 1.0, 1.5])


def test_a_dock_without_ground_stands_as_walls_and_floor(tmp_path: Path) -> None:
    load = {key: value for key, value in HULL["load"].items() if key != "stands_on"}
    law = {"stiffness": "100 MN/m", "damping": "1 MN s/m", "friction": 0.4}
    load["position"] = ["-35 m", "0 m", "8 m"]
    scene = scene_of(tmp_path, load=load, ground=None, supports=None, structures={"dock": {**DOCK, **law}})
    assert scene["ground"] is None
    (dock,) = scene["structures"]
    assert dock["name"] == "dock" and len(dock["boxes"]) == 5


def test_a_lift_without_them_has_no_new_keys(tmp_path: Path) -> None:
    load = {key: value for key, value in HULL["load"].items() if key != "stands_on"}
    scene = scene_of(tmp_path, load=load, supports=None)
    assert list(scene) == ["bodies", "sheaves", "ropes", "contacts", "ground", "axes"]
    assert scene["ground"] == {"level": 0.0}


def test_the_ground_is_cut_by_the_holes_that_the_lift_reaches_over() -> None:
    ground = Ground(0.0, (HOLE,))
    here = np.array([[-60.0, -10.0, 0.0], [60.0, 10.0, 80.0]])
    cut = [(-50, 0), (10, 0), (10, -12), (70, -12), (70, 0), (90, 0)]
    np.testing.assert_array_equal(ground.profile(0, (-50.0, 90.0), here), cut)
    # A window that ends within the dock ends on its floor, without a wall.
    short = [(-50, 0), (10, 0), (10, -12), (40, -12)]
    np.testing.assert_array_equal(ground.profile(0, (-50.0, 40.0), here), short)
    np.testing.assert_array_equal(ground.profile(0, (20.0, 40.0), here), [(20, -12), (40, -12)])
    np.testing.assert_array_equal(ground.profile(0, (20.0, 90.0), here), [(20, -12), *cut[3:]])
    np.testing.assert_array_equal(ground.near(here), [(0, 0, 0), (10, 0, -12)])
    # Along y beside the dock, and along x beyond its end, the ground is level.
    aside = here - np.array([100.0, 0.0, 0.0])
    np.testing.assert_array_equal(ground.profile(1, (-50.0, 90.0), aside), [(-50, 0), (90, 0)])
    beyond = here + np.array([0.0, 300.0, 0.0])
    np.testing.assert_array_equal(ground.profile(0, (-50.0, 90.0), beyond), [(-50, 0), (90, 0)])
    assert len(ground.near(aside)) == len(ground.near(beyond)) == 1


def test_pictures_have_supports_until_they_are_taken_away() -> None:
    recording = standing(events=((5.0, "support_removed", "support.a"),))
    early, late = snapshot(recording, 0), snapshot(recording, len(recording.time) - 1)
    assert [box.name for box in early.surroundings] == ["wall", "support.a"]
    assert [box.name for box in late.surroundings] == ["wall"]
    # Turned by a quarter the support is 1 m along x and 2 m along y.
    assert np.ptp(early.surroundings[1].faces.reshape(-1, 3), axis=0) == pytest.approx([1.0, 2.0, 1.5])
    # The wall of 400 m does not make the lift small.
    assert np.ptp(early.extent()[:, 0]) < 30.0


def test_side_views_show_the_floor_of_the_pit() -> None:
    figure = system(standing())
    assert figure is not None and stages(standing()) is None
    panel = figure.axes[0]
    assert panel.get_ylim()[0] < FLOOR
    lines = [np.asarray(line.get_xydata()) for line in panel.lines]
    ground = next(line for line in lines if len(line) == 6 and line[0][1] == LEVEL)
    np.testing.assert_allclose(ground[1:5], [(-6, LEVEL), (-6, FLOOR), (6, FLOOR), (6, LEVEL)])
    assert SIDE.project(np.array([0.0, 5.0, FLOOR])).tolist() == [0.0, FLOOR]


def test_sketches_show_them_on_their_paper() -> None:
    side, plan = sketches(Subject(standing()))
    (line,) = [mark for mark in side.marks if mark.style == "sk-ground"]
    points = np.array([[float(part) for part in point.split(",")] for point in line.points.split()])
    assert len(points) == 6
    assert np.ptp(points[:, 1]) * side.scale == pytest.approx(LEVEL - FLOOR, abs=0.01 * side.scale)
    assert (points[3, 0] - points[2, 0]) * side.scale == pytest.approx(12.0, abs=0.01 * side.scale)
    assert [mark.style for mark in side.marks[:2]] == ["sk-solid sk-structure", "sk-solid sk-support"]
    assert any(mark.style == "sk-hole" for mark in plan.marks)
    for sketch in (side, plan):
        places = [tuple(map(float, p.split(","))) for mark in sketch.marks for p in mark.points.split()]
        assert all(0 <= x <= sketch.width and 0 <= y <= sketch.height for x, y in places)


def test_they_are_packed_for_the_player() -> None:
    header = json.loads(pack(standing(events=((5.0, "support_removed", "support.a"),))).header_text())
    assert header["ground"] == LEVEL
    assert header["holes"] == [{"x": [-6, 6], "y": [-30, 30], "floor": FLOOR}]
    wall, support = header["structures"]
    assert (wall["name"], wall["kind"], wall["removedAt"]) == ("wall", "structure", None)
    assert (support["name"], support["kind"], support["removedAt"]) == ("support.a", "support", 5.0)
    # Corners with z fastest, x slowest.
    assert wall["boxes"][0][:3] == [[-200, 19.5, 0], [-200, 19.5, 4], [-200, 20.5, 0]]
    plain = pack(ringing_lift()).header
    assert (plain["ground"], plain["holes"], plain["structures"]) == (0.0, [], [])


def test_a_recording_without_ground_has_none() -> None:
    recording = standing({"ground": None})
    assert ground_of(recording) is None
    assert structures_of(recording) == []
