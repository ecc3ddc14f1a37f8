"""`added_mass: [30 kg, 40 kg, 80 kg]` of a load in water, for tonnes, was in order.

The manifold of `splash_zone` displaces 7.6 m³: with a hundredth of that as added mass nothing slams and
nothing is carried along by the waves. Too much was told, too little was not.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


@pytest.mark.parametrize(
    ("added", "is_told"),
    [(("30 kg", "40 kg", "80 kg"), True), (("0", "0", "4 t"), False)],
)
def test_too_little_is_told(added: tuple[str, ...], is_told: bool) -> None:
    """1025 kg/m³ × 7.6 m³ = 7.79 t."""
    changes = {"load.in_water.added_mass": list(added), "load.in_water.slamming_coefficient": 20}
    found = assemble(load_scenario("splash_zone").changed(changes)).warnings
    said = "it is 80 kg along an axis at most, and the load displaces 7.79 t of water; a unit has slipped"
    assert list(found) == ([said] if is_told else [])
