"""Pictures: which a lift has, what stands on them, and that they are drawn where things are."""

import ast
import re
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from matplotlib.text import Text
from PIL import Image

from drawn import text_of
from gantline.plot import figures, save_pictures
from gantline.plot.drawing import SIDE, TOP, draw, norm_of
from gantline.plot.labels import beside
from gantline.plot.moments import moments
from gantline.plot.panels import TENSION, draw_water
from gantline.plot.scene import Box, snapshot
from gantline.plot.style import curves, four_digits, label_ends
from gantline.plot.views import equalizer, system
from gantline.results.recording import Recording
from sample_lift import ringing_lift, sample_recording, sample_rig, sample_scene


def pictures(recording: Recording) -> dict[str, Figure]:
    return dict(figures(recording))


@pytest.fixture(scope="module")
def drawn() -> dict[str, Figure]:
    return pictures(ringing_lift())


def plain_system() -> Recording:
    """Two bodies and a rope over a sheave, without yard words."""
    recording = ringing_lift(rig={"title": "Plain"})
    scene = {
        "bodies": [
            {"name": "e1.1", "shape": None, "centre_of_gravity": [0, 0, 0], "kind": "sheave"},
            {"name": "block", "shape": None, "centre_of_gravity": [0, 0, 0], "kind": "body"},
        ],
        "sheaves": [
            {"body": "e1.1", "centre": [0, 0, 0], "axis": [0, 1, 0], "radius": 0.4, "kind": "moving"}
        ],
        "ropes": [],
        "ground": None,
        "axes": None,
    }
    return Recording(recording.variables, recording.coordinates, {**recording.attributes, "scene": scene})


def test_curves_that_are_one_on_paper_are_dashes_of_all_their_colours() -> None:
    """Two that agree to 0.4 % of their reach, one 1 % beside them, and one that is not there at first."""
    time = np.linspace(0.0, 1.0, 101)
    late = np.where(time < 0.2, np.nan, 100.0 * time)
    values = {"a": 100.0 * time, "b": 100.0 * time + 0.4, "c": 100.0 * time + 1.0, "d": late}
    panel = Figure().add_subplot()
    curves(panel, time, values)
    lines = panel.get_lines()
    assert [line.is_dashed() for line in lines] == [False, True, False, False]
    assert lines[1].get_linewidth() == lines[0].get_linewidth() > lines[2].get_linewidth()
    # Wide dashes lie below what is narrower: they hid all of it.
    assert lines[0].get_zorder() <= lines[1].get_zorder() < lines[2].get_zorder()
    assert len({line.get_color() for line in lines}) == 4


def test_a_curve_with_a_peak_of_its_own_is_drawn_whole() -> None:
    """Of 4.5 MN in one sling after another was cut, dashes left two strokes in the air."""
    time = np.linspace(0.0, 1.0, 101)
    flat, peaked = np.full(101, 100.0), np.full(101, 100.0)
    peaked[40] = 120.0
    panel = Figure().add_subplot()
    curves(panel, time, {"a": flat, "b": peaked, "c": flat + 0.05})
    assert [line.is_dashed() for line in panel.get_lines()] == [False, False, True]


def test_a_large_force_is_written_out() -> None:
    """A hook of 1000 t read `1.054e+04 kN`."""
    assert [four_digits(value) for value in (10_544.3, 4_543.1, 0.98765, 123_456.7)] == [
        "10544",
        "4543",
        "0.9877",
        "123457",
    ]


def test_long_names_at_the_ends_leave_room_for_the_titles() -> None:
    """Beside a load with a name of forty letters `Attitude` lay under what was lifted."""
    panel = Figure().add_subplot()
    label_ends(
        panel, np.array([0.0, 1.0]), {"a_very_long_module_name_of_forty_letters": np.array([0.0, 1.0])}
    )
    assert [text.get_text() for text in panel.texts] == ["a_very_lon…ty_letters"]


def test_pictures_of_a_lift_with_an_equalizer(drawn: dict[str, Figure]) -> None:
    assert list(drawn) == [
        "sling_tension",
        "equalizing_rope_tension",
        "sheave_travel",
        "attitude",
        "hook_load",
        "energy",
        "system",
        "equalizer_e1",
    ]


def test_pictures_of_a_plain_system() -> None:
    rising = ringing_lift(hook=np.linspace(36.0, 38.0, 2001))
    recording = Recording(
        rising.variables, rising.coordinates, {**plain_system().attributes, "rig": {"title": "Plain"}}
    )
    assert list(pictures(recording)) == ["rope_tension", "motion", "energy", "system"]


def test_a_recording_of_one_sample_has_no_pictures() -> None:
    assert pictures(sample_recording(np.zeros(1), tension=np.zeros((1, 5)))) == {}


def test_a_lift_that_is_slack_from_start_to_end_is_drawn(tmp_path: Path) -> None:
    assert save_pictures(sample_recording(np.arange(3.0), tension=np.zeros((3, 5))), tmp_path)


def test_axes_carry_names_and_units(drawn: dict[str, Figure]) -> None:
    labels = {
        name: " ".join(axes.get_ylabel().replace("\n", " ") for axes in figure.axes)
        for name, figure in drawn.items()
    }
    assert "Tension [kN]" in labels["sling_tension"]
    assert "From the mean when clear [%]" in labels["sling_tension"]
    assert "travel, down positive [m]" in labels["sheave_travel"]
    assert "Height above start [m]" in labels["attitude"]  # it neither tilts nor drifts
    assert "Hook load [kN]" in labels["hook_load"]
    assert "Energy [kJ]" in labels["energy"]
    for name in ("sling_tension", "equalizing_rope_tension", "hook_load"):
        assert "tonne-force [t]" in text_of(drawn[name])
    for name in set(drawn) - {"system", "equalizer_e1"}:
        assert "Time [s]" in [axes.get_xlabel().split("\n")[0] for axes in drawn[name].axes]


def test_curves_show_the_recorded_values(drawn: dict[str, Figure]) -> None:
    recording = ringing_lift()
    lines = {str(line.get_label()): line for line in drawn["sling_tension"].axes[0].get_lines()}
    tension = recording.column("rope_tension", "sling.S2")
    np.testing.assert_allclose(np.asarray(lines["S2"].get_ydata(), float), tension / 1e3)
    np.testing.assert_allclose(np.asarray(lines["S2"].get_xdata(), float), recording.time)


def test_tonne_force_beside_kilonewtons(drawn: dict[str, Figure]) -> None:
    left = drawn["hook_load"].axes[0]
    (right,) = left.child_axes
    drawn["hook_load"].draw_without_rendering()
    assert right.get_ylim()[1] == pytest.approx(left.get_ylim()[1] / 9.81)


def test_events_and_strokes_are_marked(drawn: dict[str, Figure]) -> None:
    assert "lift-off 9.99 s" in text_of(drawn["sling_tension"])
    assert "hold" in text_of(drawn["sling_tension"])
    travel = text_of(drawn["sheave_travel"])
    assert "1.4 m up" in travel
    assert "1.9 m down" in travel


def test_travel_down_is_drawn_downwards(drawn: dict[str, Figure]) -> None:
    assert drawn["sheave_travel"].axes[0].yaxis_inverted()


def test_names_at_the_ends_of_equal_curves_do_not_cover_each_other(drawn: dict[str, Figure]) -> None:
    figure = drawn["sheave_travel"]
    figure.draw_without_rendering()
    names = [text for text in figure.axes[0].texts if text.get_text().startswith("e1.")]
    extents = [Text.get_window_extent(text) for text in names]  # an annotation's own would include its leader
    boxes = sorted((extent.y0, extent.y1) for extent in extents)
    assert len(boxes) == 5
    assert all(below[1] <= above[0] + 1.0 for below, above in pairwise(boxes))


def test_moments_of_a_lift() -> None:
    recording = ringing_lift()
    shown = [(name, float(recording.time[sample])) for name, sample, _ in moments(recording)]
    peak = recording.metrics()["peak_sling_tension_time"]
    # lift-off at 9.99 s falls on the sample at 10 s, at which the slings are taut as well
    assert shown == [
        ("start", 0.0),
        ("slings taut", 10.0),
        ("peak tension", pytest.approx(peak)),
        ("end", 40.0),
    ]


def test_a_moment_has_its_own_time_and_not_that_of_the_sample_drawn() -> None:
    """A picture said 'lift-off 958.00 s' where the table has 956.1: a sample each 2 s."""
    events = [(9.99, "lift_off", "block")]
    recording = ringing_lift(events=events, tension=np.full((2001, 5), 600e3))
    (lifted,) = (one for one in moments(recording) if one.name == "lift-off")
    assert lifted.time == 9.99 and recording.time[lifted.sample] == 10.0
    picture = system(recording)
    assert picture is not None
    assert "lift-off\n9.99 s" in [panel.get_title() for panel in picture.axes]


def test_a_system_without_slings_is_shown_four_times() -> None:
    recording = plain_system()
    assert [recording.time[sample] for _, sample, _ in moments(recording)] == pytest.approx(
        [0.0, 13.34, 26.68, 40.0]
    )


def test_boxes_stand_where_the_bodies_are() -> None:
    snap = snapshot(ringing_lift(), 0)
    boxes = {box.name: box.faces.reshape(-1, 3) for box in snap.boxes}
    # the load: 10 x 10 x 5 m with its centre of gravity in the middle, at 2.5 m
    assert boxes["block"].min(axis=0) == pytest.approx([-5.0, -5.0, 0.0])
    assert boxes["block"].max(axis=0) == pytest.approx([5.0, 5.0, 5.0])
    # the frame: 3.3 m high around 5.85 m below the bearing at 36.483 m; its centre of gravity is 5 m below
    assert boxes["e1"].max(axis=0) == pytest.approx([4.0, 0.8, 36.483 - 5.85 + 1.65])
    assert snap.frame_origin["e1"] == pytest.approx([0.0, 0.0, 36.483])


def test_a_turned_frame_is_drawn_turned() -> None:
    snap = snapshot(ringing_lift(yaw=np.full(2001, np.pi / 2)), 0)
    frame = next(box.faces.reshape(-1, 3) for box in snap.boxes if box.name == "e1")
    assert np.ptp(frame, axis=0) == pytest.approx([1.6, 8.0, 3.3])
    first = next(sheave.circle for sheave in snap.sheaves if sheave.body == "e1.1")
    assert first[:-1].mean(axis=0) == pytest.approx([0.0, -3.2, 36.483 - 8.65])
    assert np.ptp(first, axis=0) == pytest.approx([0.0, 0.8, 0.8])


def test_views_look_along_y_and_down() -> None:
    point = np.array([1.0, 2.0, 3.0])
    assert SIDE.project(point) == pytest.approx([1.0, 3.0])
    assert TOP.project(point) == pytest.approx([1.0, 2.0])


def test_files_are_pictures_of_their_names(tmp_path: Path) -> None:
    paths = save_pictures(ringing_lift(), tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted(paths)
    for path in paths:
        assert path.suffix == ".png"
        assert path.read_bytes().startswith(b"\x89PNG")


def test_a_recording_without_a_scene_is_not_drawn_but_plotted() -> None:
    recording = ringing_lift()
    attributes = {"rig": sample_rig(), "scene": {}, "settings": recording.attributes["settings"]}
    recording = Recording(recording.variables, recording.coordinates, attributes)
    names = list(pictures(recording))
    assert "sling_tension" in names
    assert "equalizer_e1" not in names
    assert sample_scene()["bodies"]


def test_pyplot_is_never_loaded() -> None:
    code = "import gantline.plot, sys; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_an_interrupted_picture_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(picture: Image.Image, path: Path, **options: object) -> None:
        path.write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(Image.Image, "save", interrupt)
    with pytest.raises(KeyboardInterrupt):
        save_pictures(ringing_lift(), tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_names_of_slings_stand_clear_of_ropes_and_centres(drawn: dict[str, Figure]) -> None:
    snap = snapshot(ringing_lift(), 0)
    panel = drawn["system"].axes[len(moments(ringing_lift()))]  # the top view of the start
    width = float(np.ptp(panel.get_xlim()))
    labels = {text.get_text(): np.array(text.get_position()) for text in panel.texts}
    assert labels.keys() >= {"S1", "S2", "S3", "S4", "S5"}
    centre = TOP.project(snap.centres["block"])
    assert np.linalg.norm(labels["S3"] - centre) > 0.05 * width, "sling 3 has its lug under the centre"
    for name, place in labels.items():
        lug = TOP.project(snap.lugs[name])
        assert 0.04 * width < np.linalg.norm(place - lug) < 0.11 * width
        for rope in snap.ropes:
            corners = TOP.project(rope.path)
            between = np.linspace(corners[:-1], corners[1:], 30).reshape(-1, 2)
            assert np.linalg.norm(between - place, axis=1).min() > 0.025 * width


def test_a_label_stands_clear_with_its_whole_length() -> None:
    """A line 0.8 to the right of a place and a point 0.5 to the left: a long name goes up and to the left."""
    line = np.column_stack([np.full(81, 0.8), np.linspace(-4.0, 4.0, 81)])
    taken = np.concatenate([line, [[-0.5, 0.0]]])
    right, up = beside(np.zeros(2), 0.7, taken, 0.3, ((-5.0, 5.0), (-5.0, 5.0)))
    assert right + 0.7 < 0.8 - 0.2, "its end stands clear of the line"
    assert abs(up) > 0.2, "and the name of the point"
    short, _ = beside(np.zeros(2), 0.0, taken, 0.3, ((-5.0, 5.0), (-5.0, 5.0)))
    assert short > right, "a short one has room farther to the right"


def test_a_label_stays_on_its_paper_with_its_whole_length() -> None:
    """A place 0.4 from the right edge: a name of 1.4 has its middle to the left of it."""
    alone = np.zeros((1, 2))
    right, _ = beside(np.zeros(2), 0.7, alone, 0.3, ((-5.0, 0.4), (-5.0, 5.0)))
    assert right + 0.7 <= 0.4


def test_waves_run_over_the_water_of_a_side_view() -> None:
    """z = 2 m + a cos(k_x x + k_y y - w t + e), y = 3 m in the middle of the lift."""
    wave = {"frequency": 0.7, "wave_number": [0.04, 0.03], "amplitude": 0.5, "phase": 0.2}
    rig = {"title": "", "sea": {"components": [wave], "rise_time": 1.0}}
    plain = ringing_lift(rig=rig)
    water = {**plain.attributes, "scene": {"water": {"level": 2.0}}}
    recording = Recording(plain.variables, plain.coordinates, water)
    panel = Figure().add_subplot()
    panel.set(xlim=(-50.0, 50.0), ylim=(-10.0, 20.0))
    draw_water(panel, recording, np.array([[0.0, 1.0, 0.0], [0.0, 5.0, 0.0]]), 9.0)
    (line,) = panel.lines
    x, z = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
    assert (x.min(), x.max()) == (-50.0, 50.0)
    assert z == pytest.approx(2.0 + 0.5 * np.cos(0.04 * x + 0.03 * 3.0 - 0.7 * 9.0 + 0.2))
    (filled,) = panel.patches
    assert isinstance(filled, Polygon)
    assert np.asarray(filled.get_xy())[:, 1].min() == -10.0


def test_times_of_an_equalizer_with_many_sheaves_are_rows() -> None:
    """Side by side twenty sheaves would have a tenth of an inch each; a hundred none at all."""
    recording = ringing_lift()
    which = recording.rig.equalizers[0]
    for sheaves, columns in ((5, len(moments(recording))), (20, 1)):
        names = [*which.moving_sheaves, *(f"more.{n}" for n in range(sheaves - 5))]
        figure = equalizer(recording, replace(which, moving_sheaves=names))
        assert figure is not None
        place = figure.axes[0].get_subplotspec()
        assert place is not None and place.get_gridspec().ncols == columns
    assert equalizer(recording, replace(which, moving_sheaves=[f"many.{n}" for n in range(100)])) is None


def test_the_link_of_a_frame_that_leans_ends_in_the_middle_of_its_top() -> None:
    """A box of 2 m below a bearing, 3 m to its top, both turned by 20° about y: the link is its axis."""
    lean = np.radians(20.0)
    turn = np.array([[np.cos(lean), 0, np.sin(lean)], [0, 1, 0], [-np.sin(lean), 0, np.cos(lean)]])
    corners = np.array([[x, y, z] for x in (-4, 4) for y in (-1, 1) for z in (-5, -3)]) @ turn.T
    snap = replace(
        snapshot(ringing_lift(), 0),
        boxes=[Box("e1", "frame", corners.reshape(2, 4, 3))],
        sheaves=[],
        ropes=[],
        points={},
        centres={},
        lugs={},
        frame_axes={"e1": turn},
        frame_origin={"e1": np.zeros(3)},
    )
    panel = Figure().subplots()
    draw(panel, snap, SIDE, norm_of([("start", snap)]))
    [link] = [line.get_xydata() for line in panel.lines]
    assert link == pytest.approx(np.array([[0.0, 0.0], [-3 * np.sin(lean), -3 * np.cos(lean)]]))


def test_tensions_have_the_colours_of_the_player() -> None:
    """One report has pictures and the player: `ramp` of the palette for light paper."""
    theme = (Path(__file__).parents[2] / "viewer/src/theme.ts").read_text(encoding="utf-8")
    ramp = re.search(r"LIGHT: Palette = \{\s*ramp: (\[.*?\]),\s*slack", theme, re.DOTALL)
    assert ramp
    stops = np.array(ast.literal_eval(ramp[1]))
    # The scale has 256 colours: at a stop it has one that is next to it.
    apart = np.abs(np.diff(stops, axis=0)).max() * (len(stops) - 1) / 255
    assert np.allclose(TENSION(np.linspace(0.0, 1.0, len(stops)))[:, :3], stops, rtol=0.0, atol=apart)
