"""A hook at a boom with an upper sheave block of 1 kg tore its lift apart at rest, by `del` at 10 ms.

The sheave block hangs from the boom's head like a pendulum, on an arm of 1 m, under 540 kN of its falls and
not under its own weight: it swings at 680 rad/s. The step took that restoring moment from its start: the
geometric stiffness it had was that of straight parts, which tells how they turn, T/ℓ, and not how the
points to which they pull move on circles, T r. Beyond hω = 2 it swung up without bound; ropes of 490 kN
carried up to 577 MN, and the run ended as if nothing were wrong but the energy balance. A sheave block of
100 kg, hω = 0.7, stood still.
"""

from __future__ import annotations

import numpy as np

import gantline
from gantline.scenario import Scenario, parse_scenario
from lift_text import changed
from luffing_along import by_a_boom, luffed_along


def lift(plan: str, duration: float) -> Scenario:
    """A column between two hooks, with ropes of some stiffness, and a sheave block of 1 kg."""
    text = by_a_boom(plan, inwards=True, angle=60.0, duration=duration, rope=2e3)
    return parse_scenario(changed(text, ("sheave_block_mass: 1 t", "sheave_block_mass: 1 kg")))


def test_a_light_sheave_block_stands_still() -> None:
    """20 s at rest: every rope carries what it carried, to what statics leaves (1e-9 of the tension)."""
    recording = gantline.simulate(
        lift("{step: wait, hold: 20 s}", 20.0), integrator="del", step=0.01, sample_interval=0.01
    )
    tension = recording["rope_tension"].values
    assert np.abs(tension / tension[0] - 1).max() < 1e-7
    assert recording.metrics()["energy_remainder"] < 1e-6
    assert not [one for one in recording.attributes["warnings"] if "energy" in one]


def test_a_light_sheave_block_moves_as_adaptive_has_it() -> None:
    """The hook that stands hoists the column by 4 m and the boom follows: tensions are those of `adaptive`
    to an error that is of first order in the step, and below 1e-3 of the tension at 20 ms.
    """
    moving = lift(luffed_along(4.0), 60.0)
    exact = gantline.simulate(moving)["rope_tension"].values
    errors = []
    for step in (0.02, 0.01):
        found = gantline.simulate(moving, integrator="del", step=step)["rope_tension"].values
        errors.append(np.abs(found - exact).max() / exact.max())
    assert errors[0] < 1e-3
    assert errors[1] < 0.6 * errors[0]
