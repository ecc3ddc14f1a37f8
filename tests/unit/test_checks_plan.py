"""Checks of runs that end before their plan, and of design weights beyond what a run has carried."""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results import series
from gantline.scenario import parse_scenario, template
from gantline.statics import Statics

EQUALIZER = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
#: Peak over static force of its slings is 1.19; this is more.
CONTINGENCY = 1.3


def named(checks: list[Check], name: str) -> Check | None:
    return next((check for check in checks if check.name == name), None)


@pytest.mark.parametrize(("duration", "remark"), [(5.0, "in 'hoist'; not begun: hold"), (30.0, None)])
def test_a_run_that_ends_before_its_plan_is_told(duration: float, remark: str | None) -> None:
    """From 26 s on it hoists no more and holds to the end, which has nothing left to do."""
    checks = check_recording(gantline.simulate(EQUALIZER, duration=duration))
    found = named(checks, "plan_finished")
    assert (found is None) is (remark is None)
    if found is not None and remark is not None:
        assert found.verdict is Verdict.WARNING
        assert found.remark == f"the run ends at {duration:g} s {remark}"
        verdict = f"NO VERDICT: the run ends at {duration:g} s {remark}; nearest to their limits: "
        assert verdict_of(checks).startswith(verdict)


def test_a_run_that_lifts_nothing_is_no_verdict() -> None:
    """A hook that does not move: what it carries is 1 % of what it may, and says nothing of the lift."""
    text = LIFT[: LIFT.index("plan:")] + LIFT[LIFT.index("rules:") :]
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    found = named(checks, "load_lifted")
    assert found is not None and found.verdict is Verdict.WARNING
    assert found.remark == "'module' is not lifted, 0 % of its weight hangs at most"
    assert verdict_of(checks).startswith(f"NO VERDICT: {found.remark}; ")
    assert named(check_recording(gantline.simulate(parse_scenario(LIFT))), "load_lifted") is None


def test_what_a_step_requires_is_for_a_run() -> None:
    """An equilibrium is of one time: there was said of it that the recording ends too early."""
    recording = Statics(parse_scenario(template())).equilibrium().recording
    (required,) = [check for check in check_recording(recording) if check.step]
    assert required.verdict is Verdict.NOT_CHECKED
    assert required.remark == "a run checks what steps require, and 'gantline statics --steps'"


def test_a_warning_without_a_number_is_no_verdict() -> None:
    warning = Check("plan_finished", Verdict.WARNING, "")
    assert verdict_of([warning]).startswith("NO VERDICT")


def test_a_static_force_of_the_design_weight_beyond_the_peak_governs() -> None:
    """T c / capacity, T of the simulated weight: without the rule's factor there was the peak alone."""
    text = EQUALIZER.read_text(encoding="utf-8").replace("contingency: 1.00", f"contingency: {CONTINGENCY}")
    recording = gantline.simulate(parse_scenario(text))
    window = series.quiet_window(recording)
    slings = {sling.name: series.sling_tension(recording, sling) for sling in recording.rig.slings}
    static = {name: series.static_value(recording, tension, window) for name, tension in slings.items()}
    found = named(check_recording(recording), "lug_load_of_capacity")
    assert found is not None and found.value is not None
    largest = max(value for value in static.values() if value is not None)
    assert largest * CONTINGENCY > max(tension.max() for tension in slings.values())
    assert found.value == pytest.approx(CONTINGENCY * largest / (80e3 * 9.81), rel=1e-12)
    assert found.formula.startswith("max(static ")
    assert found.time is None
