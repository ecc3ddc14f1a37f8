"""The rule's dynamic amplification factor was left out of what is borne between two holds.

What hooks, lugs and charts bear as a load is turned from one hold to another was raised to the design weight
and not by the rule's factor, which is on static forces, and only a hold had one. A column of 160 t, upended
by two crawler cranes with a factor of 1.1, was NO-GO with the main crane at 102 % of its chart; without the
holds at which it hung upright it was a go, at 94 %. Where a beam slopes by 35 deg for 4 s, too short for a
hold, its raised end hangs with 71 % of it, and bears as much as if it were held there.

Shackles and hoist ropes had less: static load over working load limit, and the plain factor on the breaking
force of a hoist rope, were those of the holds with the beam level. And a shackle that is pulled aside between
two holds had all of its working load limit for static loads.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of, values_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from turned_beam import ABOVE, CONTINGENCY, HALF, LIFT, MASS, RAISED, RATED, USED, by_crawlers

#: By the rule.
FACTOR = 1.1
_SLOPES, _BACK = "  - {step: slopes, hold: 4 s}\n", "  - {step: back"
_RULES = f"rules: {{dynamic_amplification_factor: {FACTOR}}}\n"


def _checks(text: str) -> list[Check]:
    return check_recording(simulate(parse_scenario(text.replace(_BACK, _SLOPES + _BACK) + _RULES)))


def _of(checks: list[Check], name: str) -> Check:
    (check,) = [one for one in checks if one.name == name]
    return check


@pytest.fixture(scope="module")
def checks() -> list[Check]:
    return _checks(LIFT.replace(f"contingency: {CONTINGENCY}", "contingency: 1.0"))


@pytest.mark.parametrize("name", ["hoist_load_of_rated_capacity", "lug_load_of_capacity"])
def test_the_factor_counts_as_it_is_turned(checks: list[Check], name: str) -> None:
    """14.2 t of the raised end times the factor, of 14.5 t: 108 %, as the contingency of 1.1 leaves it."""
    check = _of(checks, name)
    assert check.value == pytest.approx(USED / CONTINGENCY * FACTOR, rel=1e-2)
    assert check.verdict is Verdict.FAILED and "between holds" in check.formula
    assert outcome_of(checks) is Outcome.NO_GO


def test_the_static_hook_load_is_that_of_the_slope(checks: list[Check]) -> None:
    expected = USED / CONTINGENCY * RATED * 9.81e3
    assert _of(checks, "static_hook_load").value == pytest.approx(expected, rel=1e-2)


@pytest.mark.parametrize("name", ["shackle_load_of_working_load_limit", "shackle_dynamic_load_of_strength"])
def test_a_shackle_bears_it_statically(checks: list[Check], name: str) -> None:
    """The rule's factor is in the dynamic load and in what a shackle may bear of it: both shares are one."""
    assert _of(checks, name).value == pytest.approx(USED / CONTINGENCY, rel=1e-2)


def test_the_chart_and_the_hoist_rope_of_a_crane() -> None:
    """On four parts hang the hook block with its sheaves, 1.001 t, and USED of 14.5 t by design weight."""
    strength = 500.0
    rope = "hoist: {axial_stiffness: 36 MN,"
    text = by_crawlers()
    assert text.count(rope) == 1
    found = _checks(text.replace(rope, f"{rope} minimum_breaking_force: {strength} kN,"))
    chart = _of(found, "hoist_load_of_rating")
    assert chart.value == pytest.approx(USED * FACTOR, rel=2e-2)
    assert chart.verdict is Verdict.FAILED and "between holds" in chart.formula
    factor = _of(found, "rope_factor_on_breaking_force")
    assert factor.element.startswith("hoist.E.H")
    assert factor.value == pytest.approx(4.0 * strength / ((USED * RATED + 1.0) * 9.81), rel=2e-2)


def test_a_shackle_that_is_pulled_aside_on_the_way() -> None:
    """Across plates that slope by 20.5 deg the lower end, with less force, uses more of its shackle.

    It has 39 % of the beam, by moments about the other lug, and half of it level; 75 % of a shackle is left
    from 20 deg on, of Crosby's chart. Slings of 100 m lean by less than 0.5 deg.
    """
    slope = math.radians(20.5)
    share = 0.5 - ABOVE * math.tan(slope) / (2.0 * HALF)
    text = LIFT.replace(f"capacity: {RATED} t}}", f"main_plate: yz, capacity: {RATED} t}}")
    text = text.replace(f"by: {RAISED} m", f"by: {2.0 * HALF * math.sin(slope)} m")
    recording = simulate(parse_scenario(text.replace(_BACK, _SLOPES + _BACK)))
    used = values_of(recording, "shackle_load_of_working_load_limit")["W bottom"]
    assert share / 0.75 > 1.02 * 0.5
    assert used == pytest.approx(MASS * CONTINGENCY * share / 0.75 / RATED, rel=1e-2)
