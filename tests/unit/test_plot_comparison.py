"""Pictures of a comparison: which there are, what stands on them, and that they show the recorded values."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from drawn import text_of
from gantline.plot import comparison_figures, save_comparison_pictures
from gantline.results.comparison import Comparison, compare
from gantline.results.recording import Recording
from sample_lift import ringing_lift, sample_recording

TIME = np.linspace(0.0, 40.0, 2001)


def larger() -> Recording:
    """The ringing lift with 1.2 times the tension and a heading that grows."""
    tension = 1.2 * ringing_lift()["rope_tension"].values[:, 1:]
    return ringing_lift(tension=tension, yaw=np.linspace(0.0, 0.1, 2001))


def pictures(comparison: Comparison) -> dict[str, Figure]:
    return dict(comparison_figures(comparison))


@pytest.fixture(scope="module")
def drawn() -> dict[str, Figure]:
    return pictures(compare(ringing_lift(), larger(), names=("slow", "fast")))


def test_pictures_of_two_lifts(drawn: dict[str, Figure]) -> None:
    assert list(drawn) == ["compare_sling_tension", "compare_hook_load", "compare_load_motion"]
    for figure in drawn.values():
        assert "A: slow\nB: fast" in text_of(figure)
        assert "Time [s]" in text_of(figure)
        assert "lift-off 9.99 s" in text_of(figure), "one mark where both lift off at one time"
    assert "B − A [kN]" in text_of(drawn["compare_hook_load"])
    assert "tonne-force [t]" in text_of(drawn["compare_sling_tension"])
    for label in ("Drift [m]", "Tilt [deg]", "Heading [deg]", "A and B\napart [mm]"):
        assert label in text_of(drawn["compare_load_motion"])


def test_curves_show_a_and_b_and_their_difference(drawn: dict[str, Figure]) -> None:
    upper, lower = drawn["compare_sling_tension"].axes[:2]
    tension = ringing_lift().column("rope_tension", "sling.S2") / 1e3
    curves = [np.asarray(line.get_ydata(), float) for line in upper.get_lines()]
    curves = [values for values in curves if len(values) > 2]
    assert len(curves) == 10
    np.testing.assert_allclose(curves[1], tension)
    np.testing.assert_allclose(curves[6], 1.2 * tension)
    differences = [np.asarray(line.get_ydata(), float) for line in lower.get_lines()]
    differences = [values for values in differences if len(values) > 2]  # without marks
    np.testing.assert_allclose(differences[1], 0.2 * tension, atol=1e-9)
    # a fifth of 606 kN + 101 kN sin at the sample nearest to its peak
    assert "largest: S2  +141 kN at" in text_of(drawn["compare_sling_tension"])


def test_no_difference_is_said() -> None:
    figures = pictures(compare(ringing_lift(), ringing_lift()))
    assert "no difference" in text_of(figures["compare_sling_tension"])


def test_lifts_off_at_different_times_are_told_apart() -> None:
    late = ringing_lift(events=[(0.0, "step_begin", "hoist"), (12.5, "lift_off", "block")])
    text = text_of(pictures(compare(ringing_lift(), late))["compare_hook_load"])
    assert "lift-off A 9.99 s" in text
    assert "lift-off B 12.50 s" in text


def test_bodies_and_ropes_of_plain_systems() -> None:
    def plain(height: float) -> Recording:
        lift = ringing_lift(hook=np.linspace(36.0, height, 2001))
        variables = {name: one for name, one in lift.variables.items() if "hook" not in one.dims}
        coordinates = {dim: names for dim, names in lift.coordinates.items() if dim != "hook"}
        return Recording(variables, coordinates, {**lift.attributes, "rig": {"title": "Plain"}})

    figures = pictures(compare(plain(38.0), plain(38.2)))
    assert list(figures) == ["compare_rope_tension", "compare_motion"]
    assert "largest: test_hook  +200 mm at 40.00 s" in text_of(figures["compare_motion"])
    # As the table has it; it was +2e+03 mm.
    figures = pictures(compare(plain(38.0), plain(40.0)))
    assert "largest: test_hook  +2,000 mm at 40.00 s" in text_of(figures["compare_motion"])


def many_ropes(extra: float, names: list[str]) -> Recording:
    """A plain system with these ropes, of which each has `extra` more than the one before [N]."""
    lift = ringing_lift()
    count = len(names)
    coordinates = {**lift.coordinates, "rope": names}
    tension = np.tile(np.linspace(1e3, 2e3, 2001)[:, None], (1, count)) + extra * np.arange(count)
    variables = {
        name: one for name, one in lift.variables.items() if "rope" not in one.dims or name == "rope_tension"
    }
    one = lift["rope_tension"]
    variables["rope_tension"] = type(one)(one.dims, tension, one.unit, one.description)
    for name, values in (("rope_peak_tension", tension.max(axis=0)), ("rope_peak_time", np.zeros(count))):
        stored = lift[name]
        variables[name] = type(stored)(stored.dims, values, stored.unit, stored.description)
    return Recording(variables, coordinates, {**lift.attributes, "rig": {"title": "Plain"}})


def test_more_curves_than_colours_are_those_that_differ_most() -> None:
    names = [f"rope{k}" for k in range(12)]
    one, other = many_ropes(0.0, names), many_ropes(5.0, names)
    text = text_of(pictures(compare(one, other))["compare_rope_tension"])
    assert "(8 of 12 ropes)" in text
    assert "rope11" in text and "rope3" not in text.split("\n")


@pytest.mark.parametrize("stem", ["mooring.bow", "mooring.of_the_barge_at_the_quay"])
def test_long_names_leave_the_panels_their_width(stem: str, tmp_path: Path) -> None:
    """Names of moorings stood in one row, cut to `mooring.bow…` each, and pressed the panels to a fifth of
    the picture, with `UserWarning: constrained_layout not applied` on the console."""
    names = [f"{stem}.{k}.ps" for k in range(8)]
    comparison = compare(many_ropes(0.0, names), many_ropes(5.0, names))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        save_comparison_pictures(comparison, tmp_path)
        figure = pictures(comparison)["compare_rope_tension"]
        figure.draw_without_rendering()
    panel = figure.axes[0]
    assert panel.get_position().width > 0.8  # of the picture: labels of both axes need what is left
    key = panel.get_legend()
    assert key is not None
    box = key.get_window_extent().transformed(figure.transFigure.inverted())
    assert box.x1 < 1.0
    assert box.height < 0.25
    written = [text.get_text() for text in key.get_texts()[2:]]
    assert len(set(written)) == 8
    assert written == names or max(map(len, names)) > 21 == max(map(len, written))


def test_one_common_sample_makes_no_picture() -> None:
    one = sample_recording(np.zeros(1), tension=np.zeros((1, 5)))
    assert pictures(compare(one, ringing_lift())) == {}


def test_files_are_pictures_of_their_names(tmp_path: Path) -> None:
    paths = save_comparison_pictures(compare(ringing_lift(), larger()), tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted(paths)
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths)
