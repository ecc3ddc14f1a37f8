"""The peak of a rope over light sheaves went on rising once the rope had parted.

An equalizing rope that broke at 52 kN under a snatch had a peak of 1055 kN in its recording, 90 ms later:
what its way would have stretched it to, as the sheaves that it had held flew to their stops. Checks of its
breaking force go by that peak. `del` and ropes over ideal sheaves, or over sheaves with inertia, had the
right one.
"""

from __future__ import annotations

import math

import pytest

from mechanics import (
    G,
    Json,
    Run,
    adaptive,
    body,
    document,
    drum,
    end,
    flow,
    half_turn,
    rope,
    simulate,
    slider,
)

MASS, RADIUS, HIGH = 1000.0, 0.5, 10.0
STIFFNESS, RHO = 1e7, 1.1
LENGTH = 2 * HIGH + math.pi * RADIUS


def hung(drum_too: bool = False, **parting: float) -> Json:
    """A weight on a just taut rope over a light sheave to a dead end, or to a drum whose brake holds."""
    bodies = [body("weight", slider(), MASS, position=(-RADIUS, 0, 0)), flow("sheave", 0.0)]
    last = end(None, (RADIUS, 0, 0))
    if drum_too:
        bodies.append(flow("drum", 100.0, brake=1e6))
        last = drum(None, (RADIUS, 0, 0), "drum")
    over = half_turn(None, (0, 0, HIGH), RADIUS, over=True, flow="sheave", ratio=RHO)
    line = rope("r", LENGTH, [end("weight"), over, last], STIFFNESS)
    return document(bodies, ropes=[line | parting])


def fallen(run: Run) -> float:
    """How far the weight has gone down in the end [m]."""
    return -float(run.joint("weight")[-1])


@pytest.mark.parametrize("drum_too", [False, True])
def test_a_rope_that_breaks_bore_its_breaking_force_at_most(drum_too: bool) -> None:
    """It breaks at m g of its first swing, below the 2 m g of that; then the weight falls freely."""
    force = MASS * G
    run = adaptive(hung(drum_too, breaking_force=force), 1.0, tension_tolerance=1.0)
    ((at, _),) = run.events("broken")
    # ½ g (1 s)², and the rope would be stretched by 24 %: 2.4 MN.
    assert fallen(run) > 4.0
    assert run.peak("r") == pytest.approx(force, abs=1.0)
    assert run.columns["rope_peak_time"][0] == pytest.approx(at, abs=1e-4)


@pytest.mark.parametrize("by_a_step", [False, True])
def test_a_rope_that_goes_bore_what_it_did_before(by_a_step: bool) -> None:
    """Cut, or taken off by a step of the plan: as without that up to then, and as by `del` in steps of 10 µs.

    Those are late by a step at most: the tension grows by m g ω sin ωt < 0.13 MN/s, ω² = EA/m half the
    length for a sheave that holds, of which 10 µs are 1.3 N.
    """
    at = 0.02
    off = {"name": "off", "until": {"type": "duration", "duration": 0.0}, "start_at": at, "detaches": ["r"]}
    system = hung() | {"plan": [off]} if by_a_step else hung(cut_at=at)
    run = adaptive(system, 1.0, tension_tolerance=1.0)
    whole = adaptive(hung(), at, tension_tolerance=1.0)
    assert run.peak("r") == pytest.approx(whole.peak("r"), abs=1.0)
    fixed = simulate(system, 0.03, step=1e-5)
    assert run.peak("r") == pytest.approx(fixed.peak("r"), abs=1.3)
