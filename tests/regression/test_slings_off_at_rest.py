"""Slings that a step had taken off stood in statics and cases as slack.

An equilibrium left out slings that were not put on yet, and told nothing of those that were taken off: a bed
that was slung anew hung on eight slings of which four were slack, each of the others with `2.0000` of the
mean, the smallest tension of every case was `0.0 kN`, and what 25 mm change was worked out for slings in the
store. Steps that report tensions named them too, with `0.0 kN`. Cases that vary tolerances went on to do so:
each of four slings that were off was made longer and shorter, and bands of `0.0 to 0.0 kN` stood below.
"""

from __future__ import annotations

import gantline
from gantline.cli.hold_points import hold_points
from gantline.cli.rest_table import slings_of
from gantline.scenario import parse_scenario
from gantline.study import run_cases
from gantline.study.state import State, values_of
from hooked_lift import hooked_lift
from of_recording import checks_of

LUGS = {"1": (2.0, 0.0, 4.0), "2": (-2.0, 0.0, 4.0)}
SLINGS = {
    "S1": ("hook", "1", 12.0),
    "S2": ("hook", "2", 12.0),
    "L1": ("hook", "1", 13.0),
    "L2": ("hook", "2", 13.0),
}
PLAN = """\
plan:
  - {step: hang, hold: 1 s}
  - {step: anew, hold: 1 s, detach: [sling.S1, sling.S2], attach: [sling.L1, sling.L2]}
  - {step: both, hold: 1 s, attach: sling.M2}
  - {step: again, hold: until_end, detach: sling.L2}
"""


def test_an_equilibrium_has_no_slings_that_were_taken_off() -> None:
    third = SLINGS | {"M2": ("hook", "2", 13.5)}  # long enough to be put on where the load hangs on 13 m
    lift = hooked_lift({"hook": (0.0, 0.0, 15.0)}, LUGS, third, more=PLAN)
    question = gantline.Statics(parse_scenario(lift))
    for time, on in (
        (0.5, ["S1", "S2"]),
        (1.5, ["L1", "L2"]),
        (2.5, ["L1", "L2", "M2"]),
        (3.5, ["L1", "M2"]),
    ):
        rest = question.equilibrium(time)
        assert [line.split()[0] for line in slings_of(rest, [])[1:]] == on
        assert list(values_of(State("as given", "", "none", time, rest))["sling_tension"]) == on
        # Whether they were slack a run tells.
        assert not checks_of(rest.recording, "detached_slack")


def test_a_step_reports_slings_that_are_on() -> None:
    plan = PLAN.partition("  - {step: both")[0].replace("hold: 1 s", "hold: 1 s, report: [sling_tension]")
    lift = hooked_lift({"hook": (0.0, 0.0, 15.0)}, LUGS, SLINGS, more=plan)
    lines = hold_points(gantline.simulate(parse_scenario(lift)))
    told = [line for line in lines if line.lstrip().startswith("sling tension")]
    names = [[part.split()[0] for part in line.replace("sling tension", "").split(",")] for line in told]
    assert names == [["S1", "S2"], ["L1", "L2"]]


def test_tolerances_are_those_of_slings_that_are_on() -> None:
    """After the first step S1 and S2 are off; where no sling with a tolerance is on, the case says so."""
    vary = "vary: slings.tolerance, pattern"
    cases = f"cases:\n  each: {{{vary}: each}}\n  worst: {{{vary}: worst}}\n"
    plan = PLAN.partition("  - {step: both")[0] + cases
    lift = hooked_lift({"hook": (0.0, 0.0, 15.0)}, LUGS, SLINGS, more=plan)
    all_of_them = lift.replace("sling_defaults: {", "sling_defaults: {tolerance: 10 mm, ")
    found = run_cases(parse_scenario(all_of_them))
    assert [state.variant.split()[0] for state in found.of("each")] == ["L1", "L1", "L2", "L2"]
    assert all(list(state.first_order) == ["L1", "L2"] for state in found.of("each"))
    first = lift.replace("to: load.1, length: 12.0 m", "to: load.1, length: 12.0 m, tolerance: 10 mm")
    found = run_cases(parse_scenario(first))
    for name in ("each", "worst"):
        (state,) = found.of(name)
        assert state.variant == "no sling with a tolerance is on" and state.changes_nothing
