"""The top of a bulb is no deck.

A deck was all of a hull that looks upwards. The top of a bulb, of a sonar dome or of a skeg does too, and
lies under water as it should: of six hulls of ships five had a freeboard below zero at rest, DTMB 5415 of
-7.08 m for 3.95 m, and an event that its deck went under at the start, and every lift on them was a NO-GO. So
had those on pontoons.
"""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from afloat import lift_of, written
from gantline import simulate
from gantline.hydro import Attitude, box_hull, hydrostatics
from gantline.hydro.mesh_file import read_hull
from gantline.results.recording import Recording

SHARED = Path(__file__).resolve().parents[2].parent / "shared" / "data"
#: Sizes and middles of bottoms: a hull with a bulb ahead of it.
HULL = ((60.0, 20.0, 6.0), (30.0, 0.0, 0.0))
BULB = ((5.0, 3.0, 1.5), (62.5, 0.0, 0.5))
#: Two pontoons, four columns and the deck on these.
PONTOONS = [((60.0, 10.0, 5.0), (30.0, y, 0.0)) for y in (-15.0, 15.0)]
COLUMNS = [((6.0, 6.0, 10.0), (x, y, 5.0)) for x in (10.0, 50.0) for y in (-15.0, 15.0)]
TOP = ((60.0, 40.0, 3.0), (30.0, 0.0, 15.0))


def at_rest(folder: Path, mesh: Path, draft: float, **changes: Any) -> Recording:
    """A vessel with this hull that floats upright at its draft: its weight is over its centre of buoyancy."""
    hull = read_hull(mesh)
    found = hydrostatics(hull, Attitude(draft, middle=float(hull.box[:, 0].mean())))
    x, y, z = (float(one) for one in found.centre_of_buoyancy)
    low = z + 0.25 * float(min(found.bm_transverse, found.bm_longitudinal))
    masses = {"all": {"mass": f"{float(found.mass)!r} kg", "at": [f"{one!r} m" for one in (x, y, low)]}}
    vessel = {
        "draft": f"{draft!r} m",
        "hull": {"mesh": mesh.name},
        "masses": masses,
        "radii_of_gyration": ["9 m", "25 m", "26 m"],
        **changes,
    }
    return simulate(written(folder, lift_of(vessel, start="as_given", duration="0.1 s")))


def boxes(folder: Path, *parts: tuple[tuple[float, ...], tuple[float, ...]]) -> Path:
    """An OBJ file of closed boxes."""
    lines, count = [], 1
    for size, bottom in parts:
        vertices, triangles = box_hull(size).mesh
        middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2 * [1, 1, 0]
        lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in (vertices - middle + bottom).tolist()]
        lines += ["f " + " ".join(str(corner + count) for corner in one) for one in triangles.tolist()]
        count += len(vertices)
    path = folder / "hull.obj"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def said(run: Recording, words: str) -> list[str]:
    return [one for one in run.attributes["warnings"] if words in one]


def test_a_bulb_is_no_deck(tmp_path: Path) -> None:
    """15 of 1215 m², 1.2 %: freeboard is depth less draft, at any draft, and the bulb is not told of."""
    hull = boxes(tmp_path, HULL, BULB)
    for draft in (4.0, 1.0):
        run = at_rest(tmp_path, hull, draft)
        assert run.metrics()["least_freeboard"] == pytest.approx(6.0 - draft, abs=1e-3)
        assert not run.events("flooding")
        assert not said(run, "looks up")


def test_pontoons_are_no_deck_and_told(tmp_path: Path) -> None:
    """1200 of 3744 m² that look up, with the tops of columns below the deck, which end at 15 m."""
    run = at_rest(tmp_path, boxes(tmp_path, *PONTOONS, *COLUMNS, TOP), 10.0)
    assert run.metrics()["least_freeboard"] == pytest.approx(5.0, abs=1e-3)
    assert said(run, "looks up") == [
        "lift.yaml:1: vessels.barge.draft: 32 % of what looks up on the hull of barge is under water at 10 m "
        "of draft: pontoons, if that is right; the deck's edge is that of the rest"
    ]
    # Afloat on them they are the deck: with 4 m of draft 1 m is left.
    run = at_rest(tmp_path, tmp_path / "hull.obj", 4.0)
    assert run.metrics()["least_freeboard"] == pytest.approx(1.0, abs=1e-3)


def test_most_of_what_looks_up_is_deck(tmp_path: Path) -> None:
    """A low deck with a house of 40 % of it aft: under water it is what it was, a deck."""
    house = ((24.0, 20.0, 4.0), (12.0, 0.0, 6.0))
    run = at_rest(tmp_path, boxes(tmp_path, HULL, house), 7.0)
    assert run.metrics()["least_freeboard"] == pytest.approx(-1.0, abs=1e-3)
    assert run.events("flooding")


def test_a_deck_awash_is_a_deck(tmp_path: Path) -> None:
    """A low deck of 29 % aft that rises from 4 m at the stern to 5 m: at 4.5 m of draft its end is 0.5 m
    under, whatever stands ahead of it.
    """
    path = boxes(tmp_path, ((40.0, 20.0, 8.0), (40.0, 0.0, 0.0)), ((16.0, 20.0, 5.0), (12.0, 0.0, 0.0)))
    text = path.read_text(encoding="utf-8")
    for y in (-10.0, 10.0):
        text = text.replace(f"v 4.0 {y!r} 5.0\n", f"v 4.0 {y!r} 4.0\n")
    path.write_text(text, encoding="utf-8")
    run = at_rest(tmp_path, path, 4.5)
    assert run.metrics()["least_freeboard"] < -0.4
    assert not said(run, "looks up")


@pytest.mark.skipif(not SHARED.is_dir(), reason="needs the shared data")
@pytest.mark.parametrize(
    ("name", "draft", "edge"),
    [
        ("hulls/dtmb5415.stl", 6.15, 10.1016),
        ("crane_vessels/buoyancy_cheetah.obj", 6.75, 11.939),
        ("crane_vessels/buoyancy_husky.obj", 3.5, 6.8296),
        ("crane_vessels/buoyancy_turtle.obj", 8.0, 9.262),
    ],
)
def test_hulls_of_ships(tmp_path: Path, name: str, draft: float, edge: float) -> None:
    """`edge` is the lowest height of the largest piece that looks up, read from the file by hand."""
    place = tmp_path / Path(name).name
    shutil.copy(SHARED / name, place)
    run = at_rest(tmp_path, place, draft)
    # Within the first 0.1 s next to nothing moves.
    assert run.column("vessel_freeboard", "barge")[0] == pytest.approx(edge - draft, abs=2e-3)
    assert not run.events("flooding")


def test_boxes_are_where_they_should_be(tmp_path: Path) -> None:
    """Of the helper: 60 · 20 · 4 m³ and the bulb's 22.5 m³."""
    hull = read_hull(boxes(tmp_path, HULL, BULB))
    found = hydrostatics(hull, Attitude(4.0, middle=32.5))
    assert found.volume == pytest.approx(60 * 20 * 4 + 22.5)
    assert np.allclose(hull.box, [[0, -10, 0], [65, 10, 6]])
