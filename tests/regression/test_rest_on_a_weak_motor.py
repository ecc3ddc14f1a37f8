"""A load that was too heavy for the motor that was to hold it began with too much tension in its rope.

At rest the motor lets it down to the ground and then pulls with its capacity of 45 kN. What lies on the drum
is laid under that tension, and the drum counted the 10 m that it had let go as if they had come off with that
strain too. They were 12 mm shorter in the run, which began at 61 kN, lifted off, rang, and left 40 J
unexplained.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.scenario import parse_scenario
from weak_hoist import hanging

CAPACITY = 45e3


def test_the_motor_pulls_with_what_it_has() -> None:
    """And the ground bears the rest; nothing moves."""
    lift = parse_scenario(hanging("{step: wait, hold: 1 s}", 10, "capacity: 45 kN, brake: 80 kN", 2.0))
    run = gantline.simulate(lift)
    assert run.column("rope_tension", run.coordinates["rope"][0]) == pytest.approx(CAPACITY, rel=1e-8)
    height = run.column("body_position", "load")[:, 2]
    assert np.ptp(height) < 1e-5
    kinds = dict(zip(run.coordinates["energy_kind"], run["energy"].values.T, strict=True))
    assert np.abs(kinds["remainder"]).max() < 1e-9 * kinds["elastic"][0]
