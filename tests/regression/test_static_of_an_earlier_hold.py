"""What hung still in the middle of a lift, and no longer at its end.

Static forces were means over the end of a run alone. A plan that ended by setting the load down had none:
design weight and the factors of the rule were left out without a word, checks compared the simulated peak
by itself, and a NO-GO of 130 % became a GO of 86 % by one more step of the plan. A hook that had handed its
load over, or the lower end of a load that was turned, was held against what was left in it at the end.

Skew was that of the last time alone: slings that had handed their load over "did not hang", and the rule's
factor on them was left out. Metrics had the last static forces, tables and checks the largest.
"""

from __future__ import annotations

import math

import pytest

import gantline
from four_slings import DYNAMIC, HANDED_OVER, LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario
from of_recording import checks_of

SET_DOWN = "  - {step: set down, lower: crane, speed: 1 m/min, by: 0.4 m}\nrules:"


def checked(text: str) -> dict[str, Check]:
    return {one.name: one for one in check_recording(gantline.simulate(parse_scenario(text)))}


def test_a_load_that_is_set_down_is_judged_as_it_hung() -> None:
    hanging = checked(LIFT)
    landed = checked(LIFT.replace("rules:", SET_DOWN))
    for name in ("lug_load_of_capacity", "hoist_load_of_rated_capacity"):
        before, after = hanging[name], landed[name]
        assert before.verdict is after.verdict is Verdict.FAILED
        assert before.value is not None and after.value == pytest.approx(before.value, rel=1e-6)
        assert f"x {DYNAMIC}" in after.formula
    # By hand: 40 t x 1.15 x 1.1 in a hook of 46 t, and four slings, less than a hundredth of that.
    used = landed["hoist_load_of_rated_capacity"].value
    assert used is not None and 1.10 < used < 1.01 * 1.10
    ringing = hanging["hook_dynamic_factor"].value
    assert landed["hook_dynamic_factor"].value == pytest.approx(ringing, rel=1e-6)


def test_a_hook_that_has_handed_its_load_over_is_judged_as_it_held_it() -> None:
    alone, handed = checked(LIFT), checked(HANDED_OVER)
    used = handed["hoist_load_of_rated_capacity"]
    assert (used.element, used.verdict) == ("crane", Verdict.FAILED)
    # The slings of the other hook, 0.3 t, hang on it with their lower halves: 0.4 %.
    assert used.value == pytest.approx(alone["hoist_load_of_rated_capacity"].value, rel=5e-3)
    factor = handed["hook_dynamic_factor"].value
    assert factor is not None and factor < 1.1  # not the peak over the few kilonewtons that are left in it


def test_slings_that_have_handed_their_load_over_keep_the_factor_for_skew() -> None:
    """Lengths decide how four slings share; these are of one length: 40 t/4 over the cosine."""
    rules = f"rules: {{dynamic_amplification_factor: {DYNAMIC}, skew_load_factor: 1.25}}"
    cosine = math.sqrt(1.0 - (2.5**2 + 1.5**2) / 8.6**2)
    rope = 0.409 * 44.0**2 / 100.0 / 1e3  # t/m, EN 12385-4: 6x36 with steel core
    for text, lengths in ((LIFT, 8.6), (HANDED_OVER, 8.6 + 8.7)):
        text = text[: text.index("rules:")] + rules
        recording = gantline.simulate(parse_scenario(text.replace("capacity: 13.2 t", "capacity: 30 t")))
        (worst,) = checks_of(recording, "lug_load_of_capacity")
        assert worst.element.split(".")[1] in "ABCD" and "x 1.25" in worst.formula
        # The lower half of each sling hangs in its lug; ropes stretch, and hang a little less upright: 4e-4.
        carries = (40.0 + 4 * lengths / 2 * rope) / 4 / cosine
        assert worst.value == pytest.approx(carries * 1.25 * 1.15 * DYNAMIC / 30.0, rel=1e-3)
        force = recording.metrics()["static_sling_tension.sling.A"]
        assert force == pytest.approx(carries * 9810.0, rel=1e-3)


def test_a_load_that_never_hung_still_is_a_warning() -> None:
    """Without a hold there is nothing to raise to the design weight, and the check says so."""
    text = LIFT.replace("  - {step: hold point, hold: 20 s}\nrules:", SET_DOWN)
    recording = gantline.simulate(parse_scenario(text))
    checks = check_recording(recording)
    lug = next(one for one in checks if one.name == "lug_load_of_capacity")
    assert lug.verdict is Verdict.WARNING
    assert "never hung still" in lug.remark
    assert not verdict_of(checks).startswith("GO;")
