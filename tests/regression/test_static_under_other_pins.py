"""A sling that never hung still once its pins were out had the factor of the rule on a static force of 0.

Under pins the outer two of three slings carry the load, W/2 each, and the middle one is slack. The pins are
pulled three seconds before it is set down. The load of the middle lug was `max(static 0.0 kN x 1.3, peak)`
without a word: contingency and factor were left out of the only force that it has.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict
from gantline.checks.force import UNRAISED_UNDER_PINS
from gantline.checks.forces import sling_forces
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of
from pinned_lift import LIFT, WEIGHT

FACTOR = 1.3
RULES = f"rules: {{dynamic_amplification_factor: {FACTOR}}}\n"
DOWN = "  - {step: down, lower: hook, speed: 12 m/min, until: {supports: touched}}\n"


def run(lasts: float, rules: str = RULES) -> Recording:
    """The lift with its pins out so long before it is set down [s]; its middle lug has a capacity."""
    text = LIFT.replace(
        "duration: 80 s", f"duration: {40.0 + lasts} s\nground: {{level: 0 m, friction: 0.5}}"
    )
    text = text.replace("hold: 40 s", f"hold: {lasts} s").replace("  - {step: end", f"{DOWN}  - {{step: end")
    text = text.replace("L2: {at: [ 0 m,   0 m, 4 m]}", "L2: {at: [0 m, 0 m, 4 m], capacity: 200 t}")
    return gantline.simulate(parse_scenario(text + rules))


def lug(recording: Recording) -> Check:
    [check] = checks_of(recording, "lug_load_of_capacity")
    return check


def test_nothing_static_is_told() -> None:
    recording = run(3.0)
    force = sling_forces(recording, series.everywhere(recording))["S2"]
    assert force.static == pytest.approx(0.0, abs=1.0)
    assert force.caution == UNRAISED_UNDER_PINS
    check = lug(recording)
    assert (check.element, check.verdict) == ("block.L2", Verdict.WARNING)
    assert UNRAISED_UNDER_PINS in check.remark


def test_a_hold_after_the_pins_tells_it() -> None:
    """Static W/3 with the factor of the rule."""
    recording = run(60.0)
    force = sling_forces(recording, series.everywhere(recording))["S2"]
    assert force.rule == pytest.approx(WEIGHT / 3 * FACTOR, rel=1e-6)
    assert force.caution == ""
    assert UNRAISED_UNDER_PINS not in lug(recording).remark


def test_where_nothing_raises_it_nothing_is_left_out() -> None:
    assert UNRAISED_UNDER_PINS not in lug(run(3.0, "")).remark


def test_what_slings_carry_at_rest_under_pins_counts_on() -> None:
    """The outer ones have W/2 then, and the factor."""
    recording = run(3.0)
    force = sling_forces(recording, series.everywhere(recording))["S1"]
    assert force.rule == pytest.approx(WEIGHT / 2 * FACTOR, rel=1e-3)
