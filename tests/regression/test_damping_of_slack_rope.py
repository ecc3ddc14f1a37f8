"""Rope without damping over a light sheave gave back 502 J of `rope_damping` in a run by `del`.

While such a rope is slack, a step may stretch one of its spans before rope passes from the other. The
spring of that span was booked as held, by a negative loss of its damper, and what it then let go as the
method's: 502 J of the one and 508 J of the other in 0.8 s of a load that lowers itself on a weak brake,
at steps of 0.2 ms; friction took 1.2 kJ. The sum was right, so that no remainder told.

Where such a rope was taken off, a run by `adaptive` that went on from a saved state booked other last
bits of what it had held.
"""

from __future__ import annotations

import json

import pytest

from gantline._core import Simulation
from mechanics import Json, body, document, drum, end, flow, half_turn, point, rope, simulate

EA, RATIO, BRAKE = 39e6, 1.06, 600.0


def rig(**rest: object) -> Json:
    """A load that its brake cannot hold: it falls on rope that goes slack and taut again and again."""
    route = [
        end("load"),
        half_turn(None, (0.0, 0, 9.0), 0.3, over=True, flow="top", ratio=RATIO),
        drum(None, (1.5, 0, 8.0), "winch"),
    ]
    bodies = [
        body("load", point((0, 0, 2.0), (0, 0, 0.3)), 390.0),
        flow("top", 0.0),
        flow("winch", 138.0, brake=BRAKE),
    ]
    return document(bodies, ropes=[rope("r", None, route, EA)], **rest)


@pytest.mark.parametrize("step", [1e-3, 2e-4, 5e-5])
def test_rope_without_damping_damps_nothing(step: float) -> None:
    """τ = 0: nothing but rounding of what a span holds, and what a step does is of its own order."""
    run = simulate(rig(), 0.8, step=step)
    assert len(run.events("slack")) > 1
    taken = run.energy("friction")[-1]
    assert abs(run.energy("rope_damping")[-1]) < 1e-5 * taken
    # 13 J, 6.3 J and 2.5 J: each time that it goes taut is a jump.
    assert 0.0 < run.energy("method")[-1] < 0.02 * taken
    assert run.energy_remainder < 1e-7


def test_it_is_taken_off_in_the_same_bytes_after_a_restore() -> None:
    """`save`, `restore` and a step of `adaptive`, and a step without them, until it is off and after."""
    steps = [
        {"name": "falls", "until": {"type": "duration", "duration": 0.44}},
        {"name": "lost", "detaches": ["r"], "until": {"type": "duration", "duration": 0.1}},
    ]
    method = {"type": "adaptive", "tension_tolerance": 1.0, "position_tolerance": 1e-6}
    settings = json.dumps({"integrator": method, "duration": 0.6, "sample_interval": 0.1})
    document = json.dumps(rig(plan=steps))
    run, count, other = Simulation(document, settings), 0, 0
    while not run.ended():
        again = Simulation(document, settings)
        again.restore(run.save())
        until = run.time() + 1e-9
        for one in (run, again):
            one.run(until=until)
        count += 1
        other += run.save() != again.save()
    assert count > 20
    assert other == 0
