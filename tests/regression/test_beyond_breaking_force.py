"""GO, without a warning, for slings at one and a half times their minimum breaking force.

Four slings of 10 mm were written for 44 mm under 40 t. The table showed 156 % of the minimum breaking force;
but the lift set no `sling_factor_on_breaking_force` and no factors of a rule, so no check looked at it, and
hook, shackles and lugs were in order: GO, no warnings, exit code 0. A rope breaks at its breaking force
whatever anybody asks for, as a hook is loaded at its rated capacity.
"""

from __future__ import annotations

import math

import pytest

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario

#: Hook and lugs that bear it.
STRONG = LIFT.replace("capacity: 13.2 t", "capacity: 40 t").replace(
    "rated_capacity: 46 t", "rated_capacity: 60 t"
)
FACTOR = "limits: {rule: yard, sling_factor_on_breaking_force: 5}\n"


def checked(text: str) -> list[Check]:
    return check_recording(gantline.simulate(parse_scenario(text)))


def breaking(checks: list[Check]) -> Check:
    return next(one for one in checks if one.name == "rope_factor_on_breaking_force")


def test_a_sling_beyond_its_breaking_force_is_no_go() -> None:
    checks = checked(STRONG.replace("diameter: 44 mm", "diameter: 10 mm"))
    found = breaking(checks)
    # 0.356 x 10 mm x 10 mm x 1960 N/mm^2 (EN 12385-4, 6x36 with steel core) over 40 t on four slings of 8.6 m
    # to lugs 2.5 m and 1.5 m beside the hook; they stretch by 1.4 %, and ring by as much at lift-off;
    # with the contingency of 1.15 that is 1.7 times what breaks them, at rest.
    strength = 0.356 * 10.0**2 * 1960.0
    tension = 40e3 * 9.81 / (4.0 * math.sqrt(1.0 - (2.5**2 + 1.5**2) / 8.6**2))
    assert found.value == pytest.approx(strength / (1.15 * tension), rel=0.03)
    assert (found.verdict, found.limit) == (Verdict.FAILED, 1.0)
    assert verdict_of(checks).startswith("NO-GO")


def test_a_sling_that_nobody_asks_a_factor_of_is_a_warning() -> None:
    """Below the breaking force, but how far below nothing says: no plain GO."""
    checks = checked(STRONG)
    found = breaking(checks)
    assert found.verdict is Verdict.WARNING
    assert "sling_factor_on_breaking_force" in found.remark
    assert verdict_of(checks).startswith("GO WITH WARNINGS")
    asked = breaking(checked(STRONG + FACTOR))
    assert (asked.verdict, asked.remark) == (Verdict.OK, "")
