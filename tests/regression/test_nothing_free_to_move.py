"""Steps that were as long as the plan let them where drives alone moved.

`adaptive` takes its step from the error of what it solves for, and where drives prescribe all motion that
is nothing. A weight that a drive turned at 1 rad/s for 100 s took 8 steps, the last of most of the run;
its energy balance was off by 116 %, which was said and no more. A rope on a crank was slack twice in a
minute, not nine times, and its tension at samples was wrong by as much as its peak: a polynomial through
six looks at half a minute.
"""

from __future__ import annotations

import numpy as np
import pytest

from mechanics import G, adaptive, body, document, hinge

MASS, ARM, SPEED = 1000.0, 2.0, 1.0


@pytest.mark.parametrize("balanced", [False, True], ids=["alone", "with a balanced body on it"])
@pytest.mark.parametrize("duration", [10.0, 100.0, 1000.0])
def test_a_drive_that_turns_a_weight_lifts_and_lowers_it(duration: float, balanced: bool) -> None:
    """Work of the drive is ½ (I + m R²) ω² − m g R sin φ, φ = ω (t − ½ s), whatever hangs on it in balance.

    Each step leaves 1e-9 of m g R at most, a sine over 1 rad by Gauss's four points; signs alternate.
    """
    bodies = [body("weight", hinge(drive="turn"), MASS, centre_of_gravity=(ARM, 0, 0), inertia=(1, 1, 1))]
    if balanced:
        bodies.append(body("vane", hinge(), 10.0, parent="weight", inertia=(1, 1, 1)))
    drives = [{"name": "turn", "ramps": [{"at": 0.0, "duration": 1.0, "velocity": SPEED}]}]
    run = adaptive(
        document(bodies, drives=drives),
        duration,
        tension_tolerance=None,
        position_tolerance=None,
        sample_interval=duration / 10,
    )
    angle = SPEED * (duration - 0.5)
    expected = 0.5 * (MASS * ARM**2 + 1.0) * SPEED**2 - MASS * G * ARM * np.sin(angle)
    assert run.energy("drive_work")[-1] == pytest.approx(expected, abs=1e-7 * MASS * G * ARM)
    assert run.energy_remainder < 1e-7
