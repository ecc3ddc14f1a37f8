"""`displaced_volume: 0.0076 m^3` of a manifold of 60 t, for 7.6 m^3, was in order.

So heavy a load keeps all of its weight in water, and waves that pass it carry nothing of it. One that floats
was told, one of a thousand times the density of steel was not.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


@pytest.mark.parametrize(
    ("volume", "is_told"), [("0.0076 m^3", True), ("5.09 m^3", True), ("5.1 m^3", False), ("7.6 m^3", False)]
)
def test_a_load_that_displaces_less_than_lead_is_told(volume: str, is_told: bool) -> None:
    """60 t / 7850 kg/m^3 = 7.64 m^3, and 5.096 m^3 at one and a half times the density of steel."""
    changed = load_scenario("splash_zone").changed({"load.in_water.displaced_volume": volume})
    found = [one for one in assemble(changed).warnings if "solid steel" in one]
    said = f"it is {volume}, and 60 t of solid steel displace 7.64 m^3; a unit or digit has slipped"
    assert found == ([said] if is_told else [])
