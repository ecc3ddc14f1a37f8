"""Slings that just reach their lugs, and a factor of safety of 6e13 in the table.

A load stands on the ground, and its slings are as long as from hook to lug to the last digit. Rounding of
lengths leaves 2e-8 N in them. The table of an equilibrium called that taut, gave each its share of the mean,
and the check on ropes 1350 kN over it, which is no factor of anything.
"""

from __future__ import annotations

import numpy as np
import pytest

from four_slings import CONTINGENCY, LIFT
from gantline.cli.rest_table import slings_of
from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.statics import Equilibrium, Statics
from of_recording import checks_of

#: Without weight of their own, so that nothing else is in them; EA and breaking force [N].
EA, STRENGTH = 90e6, 1350e3
_GIVEN = "construction: 6x36 IWRC, grade: 1960, diameter: 44 mm"
_LIGHT = f"axial_stiffness: {EA} N, minimum_breaking_force: {STRENGTH} N, mass: none"
LIGHT = LIFT.replace(_GIVEN, _LIGHT).replace("duration: 70 s", "duration: 70 s\nstart: as_given")


def rest(length: float) -> Equilibrium:
    return Statics(parse_scenario(LIGHT.replace("8.6 m", f"{length!r} m"))).equilibrium(0.0)


def reach(found: Equilibrium) -> float:
    """From hook to lug [m]."""
    upper, lower = series.rope_ends(found.recording, "sling.A")
    return float(np.linalg.norm(upper[-1] - lower[-1]))


def test_what_rounding_leaves_is_no_tension() -> None:
    """EA times a few last digits of 8.5 m over 8.5 m."""
    found = rest(reach(rest(9.0)) * (1.0 - 5e-16))
    left = found.recording.column("rope_tension", "sling.A")[-1]
    assert 0.0 < left < 4 * np.finfo(float).eps * EA
    assert found.tension("sling.A") == 0.0
    assert series.of_the_mean(found.recording)["A"] is None
    rows = [line.split() for line in slings_of(found, []) if line.lstrip().startswith(("A", "B", "C", "D"))]
    assert len(rows) == 4 and all(row[-1] == "slack" and "1.0000" not in row for row in rows)
    assert not [one for one in checks_of(found.recording, "rope_factor_on_breaking_force") if one.value]


def test_a_millimetre_is_one() -> None:
    """EA d/L, d what the ground leaves of 1 mm as it bears less; the factor is with the design weight."""
    length = reach(rest(9.0)) - 1e-3
    found = rest(length)
    stretched = reach(found) - length
    assert 0.9e-3 < stretched < 1e-3
    assert found.tension("sling.A") == pytest.approx(EA * stretched / length, rel=1e-9)
    [check] = checks_of(found.recording, "rope_factor_on_breaking_force")
    assert check.value == pytest.approx(STRENGTH / (CONTINGENCY * found.tension("sling.A")), rel=1e-9)
