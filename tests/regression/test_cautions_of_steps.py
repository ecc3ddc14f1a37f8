"""Cautions of what a step of the plan requires, and of cases.

What is to be known of a measure within its limit too, "2 cranes lift together, and no rule keeps capacity
back", was said by the check of the whole lift alone. Where that had failed for another reason, a hook beyond
its chart, a hold point before was ok without a word; and `gantline cases` said nothing of it at all.
"""

from __future__ import annotations

from gantline.checks import Check, Verdict
from gantline.cli.cases_table import cases_table
from gantline.scenario import load_scenario, parse_scenario
from gantline.study import run_cases
from of_recording import checks_of
from rated_lift import recording

CAUTION = (
    "2 cranes lift together, and no rule keeps capacity back; 'several_cranes' or 'several_cranes_factor' of "
    "'rules' does"
)
STEPS = [
    {"step": name, "kind": "hold", "require": {"hoist_load_of_rating": {"below": 0.9}}}
    for name in ("first", "second")
]


def checked(beyond: float) -> list[Check]:
    """Two cranes of one hook each with 40 t at 16 m at the ends of both steps, and at `beyond` [m] then."""
    radius = [[16.0, 16.0], [16.0, 16.0], [beyond, beyond]]
    of = recording(radius, [[40.0, 40.0]] * 3, cranes=("c1", "c2"), plan=STEPS)
    return checks_of(of, "hoist_load_of_rating")


def test_a_step_says_what_the_whole_lift_does_not() -> None:
    """Each once: the first step says it, and the second has nothing new."""
    whole, first, second = checked(1000.0)
    assert whole.verdict is Verdict.FAILED and CAUTION not in whole.remark
    assert (first.step, first.verdict, first.remark) == ("first", Verdict.WARNING, CAUTION)
    assert (second.step, second.verdict, second.remark) == ("second", Verdict.OK, "")


def test_what_the_whole_lift_says_steps_do_not_repeat() -> None:
    whole, first, second = checked(16.0)
    assert whole.verdict is Verdict.WARNING and CAUTION in whole.remark
    assert [one.remark for one in (first, second)] == ["", ""]
    assert first.to_json()["cautions"] == ()


def test_cases_say_each_caution_once() -> None:
    """At rest there is no peak: two checks say so in each case, and one that the load may tilt."""
    text = load_scenario("equalizer").text.rstrip("\n")
    cases = "cases:\n  longer: {set: {slings.S1.length: 23.01 m}}\n"
    table = cases_table(run_cases(parse_scenario(f"{text}\n{cases}")), width=400, variants=False)
    static = "static only: an equilibrium has no peak, and the rules no dynamic_amplification_factor"
    assert table.count(f"  hoist_load_of_rated_capacity, lug_load_of_capacity: {static}: everywhere") == 1
    (loose,) = [line for line in table if "no tilt stiffness" in line]
    assert loose.startswith("  load_tilt: the slings of e1 give ") and loose.endswith(": everywhere")
    assert "\n".join(table).count("static only") == 1
