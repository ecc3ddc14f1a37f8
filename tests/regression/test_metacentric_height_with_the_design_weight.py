"""A vessel whose GM keeps its limit with the weight that is simulated, and not with the design weight.

A sheerleg held GM for heel against its limit as it was simulated, with the calculated weight of what hung
from its boom. That weight counts at the boom's head, 56 m above the keel, so contingency takes from GM: a
limit between both was kept without a word, while heel, trim and freeboard warned of the same weight.
"""

from __future__ import annotations

from importlib.resources import files

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from gantline.statics.inclining import metacentric_heights
from lift_text import changed
from of_recording import checks_of

SWELL = files("gantline.scenarios") / "crane_barge_in_swell.yaml"
#: Contingency of its load [t], its draft, and where its falls begin, 1 m below the head of the boom [m].
MORE, DRAFT, HEAD = 6.0, 3.0, 7.5 + 55.0 * 0.9063 - 1.0
#: What floats: masses of the barge, boom, head gear, hook block, sheave block and load [t].
DISPLACED = 3200 + 250 + 250 + 220 + 3990 + 190 + 25 + 9 + 3 + 120


def lift(limits: str, simulated: str = "calculated") -> Scenario:
    text = SWELL.read_text(encoding="utf-8")
    text = text[: text.index("\nlimits:")] + f"\nlimits: {{{limits}}}\n"
    return parse_scenario(changed(text, ("simulate: calculated", f"simulate: {simulated}")), str(SWELL))


def by_statics(scenario: Scenario) -> Recording:
    return Statics(scenario).equilibrium(0.0).recording


def by_run(scenario: Scenario) -> Recording:
    """Its GM is asked where it begins at rest and where it ends."""
    return simulate(scenario, duration=0.5)


def height(simulated: str = "calculated") -> float:
    """GM with the weight that is simulated."""
    question = Statics(lift("heel: 5 deg", simulated))
    return metacentric_heights(question, question.equilibrium(0.0))["barge"].transverse


def less_by_hand(gm: float) -> float:
    """What m = 6 t at the head take: KM of a wall-sided hull and its KG, to first order m (z + GM - T)/Δ."""
    return MORE * (HEAD + gm - DRAFT) / DISPLACED


def told(recording: Recording) -> Check:
    [check] = checks_of(recording, "metacentric_height")
    return check


@pytest.mark.parametrize("found", [by_statics, by_run])
def test_a_limit_between_both_is_a_warning(found) -> None:  # type: ignore[no-untyped-def]
    """0.055 m of 21.9 m; two decimals are shown, and the falls and slings weigh some t more."""
    gm = height()
    less = less_by_hand(gm)
    assert less == pytest.approx(0.055, abs=1e-3)
    check = told(found(lift(f"metacentric_height: {gm - less / 2} m")))
    assert check.verdict is Verdict.WARNING
    assert check.value == pytest.approx(gm, rel=1e-4)
    comes_to = float(check.remark.partition("with the design weight it comes to ")[2].partition(" m")[0])
    assert comes_to == pytest.approx(gm - less, abs=6e-3)


def test_it_is_that_of_the_lift_with_the_design_weight() -> None:
    """The same lift simulated with it; trimmed by the boom, its falls stand as they are in both."""
    rest = by_statics(lift("metacentric_height: 1 m"))
    [vessel] = rest.rig.vessels
    [change] = vessel.by_contingency
    assert change.metacentric_height == pytest.approx(height("design") - height(), rel=1e-3)
    assert change.metacentric_height == pytest.approx(-less_by_hand(height()), rel=0.02)


def test_a_limit_below_both_is_kept_and_one_above_both_fails() -> None:
    gm = height()
    kept = told(by_statics(lift(f"metacentric_height: {gm - 2 * less_by_hand(gm)} m")))
    assert (kept.verdict, kept.remark) == (Verdict.OK, "")
    assert told(by_statics(lift(f"metacentric_height: {gm + 0.01} m"))).verdict is Verdict.FAILED


def test_asking_leaves_the_equilibrium_where_it_was() -> None:
    """Sensitivities after it are of the lift as it is simulated."""
    gm = height()
    question = Statics(lift("metacentric_height: 1 m"))
    rest = question.equilibrium(0.0)
    assert metacentric_heights(question, rest)["barge"].transverse == pytest.approx(gm, rel=1e-9)
