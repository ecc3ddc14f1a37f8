"""`construction: strand` was answered with rope classes, though strand jacks have none of them.

`grade: 1860` of prestressing strand was refused beside it, and what to write stood in the guide alone.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario

#: Y1860S7 of 15.7 mm by EN 10138-3: 150 mm^2, 195 kN/mm^2 and 1860 N/mm^2, so 29.25 MN and 279 kN.
SAYS = (
    "strands by their EA and breaking force, of n times 150 mm^2 n times 'axial_stiffness: 29.3 MN', "
    "'minimum_breaking_force: 279 kN' and 'mass: 1.17 kg/m', without 'grade'"
)


@pytest.mark.parametrize("construction", ["strand", "7-strand", "Y1860S7", "prestressing strand"])
def test_a_strand_is_told_how_it_is_written(construction: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(LIFT.replace("construction: 6x36 IWRC", f"construction: {construction}"))
    assert f"ropes.sling.construction: '{construction}' is not a construction that is known here; {SAYS}" in (
        str(caught.value)
    )


def test_what_is_said_is_right() -> None:
    said = "axial_stiffness: 29.3 MN, minimum_breaking_force: 279 kN, mass: 1.17 kg/m"
    lift = parse_scenario(LIFT.replace("construction: 6x36 IWRC, grade: 1960, diameter: 44 mm", said))
    assert (lift.ropes or {})["sling"].stiffness == pytest.approx(150e-6 * 195e9, rel=2e-3)
    assert (lift.ropes or {})["sling"].breaking_force == pytest.approx(150e-6 * 1860e6, rel=2e-3)
