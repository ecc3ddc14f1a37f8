"""A plain factor on the breaking force of slings had no contingency in it, as all else of their way has.

Hooks, shackles and lugs bear the design weight, slings under a yard's factor of 5 bore what was simulated. A
beam of 20 t hangs by 71 % from one sling of 720 kN as it slopes by 35 deg: 139 kN, a factor of 5.2 and a GO;
with the contingency of 1.1 it is 153 kN and 4.7. So it is at a hold, and where the plan turns it on.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from turned_beam import CONTINGENCY, LIFT, RATED, USED

STRENGTH = 720e3
#: Strong enough for all but the slings.
TEXT = LIFT.replace(f"capacity: {RATED} t", "capacity: 30 t").replace("limit: 14.5 t", "limit: 30 t")
TEXT = TEXT.replace("minimum_breaking_force: 3 MN", "minimum_breaking_force: 720 kN")
HELD = TEXT.replace("  - {step: back", "  - {step: look, hold: 20 s}\n  - {step: back")
#: In the sling at the raised end, with the design weight, by moments [N].
BORNE = USED * RATED * 1e3 * 9.81


def checked(text: str) -> list[Check]:
    return check_recording(simulate(parse_scenario(text)))


def factor(checks: list[Check], name: str = "sling_factor_on_breaking_force") -> Check:
    return next(one for one in checks if one.name == name)


@pytest.mark.parametrize("text", [TEXT, HELD], ids=["turned on", "held"])
def test_the_factor_is_that_of_the_design_weight(text: str) -> None:
    checks = checked(text)
    assert STRENGTH / BORNE < 5.0 < STRENGTH / BORNE * CONTINGENCY
    for name in ("sling_factor_on_breaking_force", "rope_factor_on_breaking_force"):
        assert factor(checks, name).value == pytest.approx(STRENGTH / BORNE, rel=1e-2)
    check = factor(checks)
    assert check.verdict is Verdict.FAILED
    assert check.formula.startswith("720.0 kN / (") and "x 1.1 to the design weight" in check.formula
    assert outcome_of(checks) is Outcome.NO_GO


def test_without_contingency_it_is_the_peak() -> None:
    checks = checked(TEXT.replace(f"contingency: {CONTINGENCY}", "contingency: 1.0"))
    assert factor(checks).value == pytest.approx(STRENGTH / BORNE * CONTINGENCY, rel=1e-2)
    assert factor(checks).formula.count("kN") == 2 and "design" not in factor(checks).formula
