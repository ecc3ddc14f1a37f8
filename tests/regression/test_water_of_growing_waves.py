"""While waves grow, water is accelerated by more than when they have grown.

What was wrong: the acceleration of the water around a load was g Σ ∂u/∂t, with the growth g of the waves
outside of the derivative, where (LW3) has the derivative of all of u. What weighs as much as the water that
it displaces got slower than that water while waves grew, and stayed so where no drag is. A load of 90 t that
hung half in the water from a compensator, in waves that grew within 5 s, was off by 0.12 m of 1 m of its
motion; from equations with (LW3) itself, tests/verification/test_compensated_in_water.py, it is 7e-8 m now.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from in_water import RHO, growth, lattice, sea, submerged
from mechanics import G, adaptive, body, document, point


def test_what_weighs_as_much_as_water_goes_with_it() -> None:
    """(m + a) v̇ = (ρV + a) u̇ with m = ρV: v = u at all times, u = g a ω e^{κz} (cos θ, sin θ), θ = ε - ωt.
    What (u·∇)u, left out, would make of it in 25 s is κ u t = 2e-4 of u.
    """
    omega, amplitude, phase, rise, depth, volume = 1.1, 1e-4, 0.7, 10.0, -6.0, 0.4
    force = submerged("load", lattice(volume=volume, added=(700.0, 700.0, 700.0)))
    waves = sea((omega, amplitude, 0.0, phase), rise_time=rise)
    system = document([body("load", point((0, 0, depth)), RHO * volume)], forces=[force], sea=waves)
    run = adaptive(system, 25.0, tension_tolerance=1e-5, position_tolerance=1e-10)
    velocity = run.body("load", "body_velocity")
    angle = phase - omega * run.time
    speed = growth(run.time, rise) * amplitude * omega * math.exp(omega**2 / G * depth)
    water = np.stack([speed * np.cos(angle), speed * np.sin(angle)], axis=1)
    assert velocity[:, ::2] == pytest.approx(water, abs=5e-4 * np.abs(water).max())
