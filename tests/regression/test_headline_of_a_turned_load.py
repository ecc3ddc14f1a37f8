"""A column was upended: drift when clear 3.763 m, said the table, and tilt past the 5 deg of the lift file.

Hooks take the centre of gravity of such a load along as it turns, so that its drift says nothing; what each
hook carries meanwhile was nowhere. The 5 deg are a bound of ours that no lift file had said, and a plan that
asks for the tilt means it.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from gantline.checks import Verdict, check_recording, verdict_of
from gantline.cli.summary import summary
from gantline.plot.traces import attitude as plot_attitude
from gantline.report.attitude import attitude
from gantline.report.first_page import FirstPage
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift
from mechanics import G
from of_recording import checks_of

#: Two hooks, each plumb over its lug at half a load's height; the centre of gravity is in the middle between.
APART, MASS = 8.0, 200e3
HOOKS = {"A": (-APART / 2, 0.0, 20.0), "B": (APART / 2, 0.0, 20.0)}
LUGS = {"1": (-APART / 2, 0.0, 2.0), "2": (APART / 2, 0.0, 2.0)}
SLINGS = {"S1": ("A", "1", 12.0), "S2": ("B", "2", 12.0)}


def turned(height: float, require: str = "") -> Recording:
    plan = f"""\
plan:
  - {{step: turn, hoist: A, speed: 0.1 m/s, by: {height} m}}
  - {{step: end, hold: 20 s{require}}}
"""
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 6.0), more=plan)
    text = text.replace("duration: 10 s", "duration: 150 s").replace("as_given", "rest")
    return gantline.simulate(parse_scenario(text))


def test_hooks_of_a_turned_load_are_told_in_place_of_its_drift() -> None:
    """Slings that lean by b pull with H = m g/2 tan b on lugs at different heights, and so shift the shares.

    The centre of gravity is in the middle between the lugs, whose line tilts by t = asin(5/8):
    m g/2 (1 + tan b tan t) in the upper hook, the end of the turn; m g/2 in the lower one, its start.
    """
    recording = turned(5.0)
    rows = attitude(Subject(recording))
    loads = [text.split() for what, text in rows if what == "hook load when clear"]
    assert [text[0] for text in loads] == ["A", "B"]
    tilt = math.asin(5.0 / APART)
    lean = math.asin(APART * (1.0 - math.cos(tilt)) / 2.0 / 12.0)
    half = MASS / 2e3  # t, as all readings of hooks in reports
    # The largest is that of a load that still swings a little when the hook stands: 0.07 % and 0.2 deg here.
    assert float(loads[0][1]) == pytest.approx(half * (1.0 + math.tan(lean) * math.tan(tilt)), rel=0.002)
    assert float(loads[0][-2]) == pytest.approx(math.degrees(tilt), abs=0.25)
    # Hoisting starts with 0.1 m/s^2, 1 % of g; what starts suddenly swings out to twice that.
    assert half < float(loads[1][1]) < half * (1.0 + 2.0 * 0.1 / G)
    assert not any("drift when clear" in what for what, _ in rows)
    lines = summary(recording, check_recording(recording), lambda verdict: verdict.value)
    assert not any("drift when clear" in line for line in lines)
    told = [line for line in lines if "hook load when clear" in line]
    assert len(told) == 2 and all(" kN at most" in line for line in told)
    assert all(text[2] == "t" for text in loads)


def test_a_load_that_hangs_level_drifts_as_before() -> None:
    """asin(1/8) is 7.2 deg, no turning."""
    recording = turned(1.0)
    assert any("largest drift when clear" in what for what, _ in attitude(Subject(recording)))


@pytest.mark.parametrize("is_meant", [True, False])
def test_a_plan_that_asks_for_the_tilt_is_not_warned_of_it(is_meant: bool) -> None:
    recording = turned(5.0, ", require: {load_tilt: above 30 deg}" if is_meant else "")
    whole, *_ = checks_of(recording, "load_tilt")
    assert whole.value is not None and whole.value > math.radians(30.0)
    assert whole.verdict is (Verdict.NOT_CHECKED if is_meant else Verdict.WARNING)
    assert ("says that the load is turned on purpose" in whole.remark) is not is_meant
    warned = [
        one["text"]
        for one in FirstPage().content(Subject(recording))["verdict"]["warned"]
        if "load tilt" in one["about"]
    ]
    assert len(warned) == (not is_meant)
    for text in warned:
        assert ", past 5.00" in text and "lift file" not in text


def test_a_load_that_is_upended_has_no_heading() -> None:
    """Its x axis passes 80 deg over level, from where on curves of its heading went round for 1200 deg."""
    level, upended = (turned(height) for height in (1.0, 12.0))
    assert "Heading [deg]" in labels(level)
    assert np.degrees(upended.column("load_tilt", "load")).max() > 80.0
    assert "Heading [deg]" not in labels(upended)


def test_a_tilt_to_come_to_is_no_limit_that_is_used_up() -> None:
    """A column came to 87.98 deg where 87.5 were asked for: '100 % load tilt' headed the first page."""
    recording = turned(5.0, ", require: {load_tilt: above 38 deg}")
    (asked,) = (one for one in check_recording(recording) if one.name == "load_tilt" and one.step == "end")
    assert asked.verdict is Verdict.OK and asked.utilisation is None
    missed = turned(5.0, ", require: {load_tilt: above 60 deg}")
    (asked,) = (one for one in check_recording(missed) if one.name == "load_tilt" and one.step == "end")
    assert asked.verdict is Verdict.FAILED
    assert "load_tilt" in verdict_of(check_recording(missed))


def test_a_load_that_is_turned_is_sketched_as_it_comes_clear() -> None:
    """At the end a column stood on end in its sketch, without the slings of the tail crane."""
    level, recording = turned(1.0), turned(5.0)
    assert [one.title for one in sketches(Subject(level))] == [
        "side view at 150.0 s, x to the right",
        "plan at 150.0 s, x to the right",
    ]
    side, plan = sketches(Subject(recording))
    assert (
        side.title == "side view at 0.0 s, x to the right" and plan.title == "plan at 0.0 s, x to the right"
    )
    hooks = [mark.y for mark in side.marks if mark.style == "sk-hook"]
    assert len(hooks) == 2 and hooks[0] == pytest.approx(hooks[1], abs=1e-6)  # level; 5 m apart at the end


def labels(recording: Recording) -> list[str]:
    figure = plot_attitude(recording)
    assert figure is not None
    return [panel.get_ylabel() for panel in figure.axes]
