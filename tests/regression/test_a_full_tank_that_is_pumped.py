"""A tank full to its brim that a step pumps was refused: `13.57 m³ are in it; it holds from 0 to
13.569999999999984 m³`. Its mesh encloses less than its sides make, by rounding, the farther off the more.
"""

from __future__ import annotations

import pytest

from ballasted import barge, lift, pump, tank
from gantline.simulation import Simulation
from gantline.statics import Statics


@pytest.mark.parametrize("at", [20.0, 41.7, 70.1])
def test_a_full_tank_is_full(at: float) -> None:
    box = (1.0, 2.3, 5.9)
    full = 1025.0 * 1.0 * 2.3 * 5.9 / 1e3
    scenario = lift(barge({"a": tank((at, 3.3, 0.1), full, box)}), [pump("a", "sea", "100 t/h", by="5 t")])
    assert Simulation(scenario).now("body_position", "barge").shape == (3,)
    weight = Statics(scenario).equilibrium(0.0).recording.column("vessel_displacement", "barge")[-1]
    # Hull, 11 000 t, and all of the tank, to the accuracy of equilibria.
    assert weight == pytest.approx(11e6 + 1e3 * full, rel=1e-9)
