"""How far moving sheaves travel until their slings carry the same."""

from __future__ import annotations

import json

import pytest

from gantline._core import Simulation
from mechanics import body, document, end, finished, half_turn, rope, slider

RADIUS = 0.2
MASS = 100e3
EA = 1e12


def test_slings_of_two_lengths_under_one_equalizer() -> None:
    """Vertical slings of 23, 26, 26, 26 and 23 m on a level load: a sheave travels by the mean less its own.

    The equalizing rope keeps the sum of travels at zero, the level load that of travel and length the same:
    +1.8, −1.2, −1.2, −1.2, +1.8 m, down positive. Ropes of 1e12 N stretch by 1e-5 m at most.
    """
    lengths = [23.0, 26.0, 26.0, 26.0, 23.0]
    places = [4.0 * RADIUS * place for place in range(len(lengths))]
    sheaves = [
        body(f"m{i}", slider((0, 0, -1), damping=2e3), 200.0, position=(x, 0, -5))
        for i, x in enumerate(places)
    ]
    start = -5.0 - min(lengths)
    load = body("load", slider((0, 0, -1), damping=2e4), MASS, position=(0, 0, start))
    route = [end(None, (-RADIUS, 0, 0))]
    for i, x in enumerate(places):
        route.append(half_turn(f"m{i}", (0, 0, 0), RADIUS, False))
        if i + 1 < len(places):
            route.append(half_turn(None, (x + 2 * RADIUS, 0, 0), RADIUS, True))
    route.append(end(None, (places[-1] + RADIUS, 0, 0)))
    slings = [
        rope(f"s{i}", length, [end(f"m{i}"), end("load", (places[i], 0, 0))], EA, 0.01)
        for i, length in enumerate(lengths)
    ]
    system = document([*sheaves, load], ropes=[rope("equalizing", None, route, EA, 0.01), *slings])
    settings = {
        "integrator": {"type": "adaptive", "tension_tolerance": 100.0, "position_tolerance": 1e-5},
        "duration": 120.0,
        "sample_interval": 1.0,
    }
    run = Simulation(json.dumps(system), json.dumps(settings))
    result = finished(run, run.run())
    mean = sum(lengths) / len(lengths)
    travel = [float(result.joint(f"m{i}")[-1]) for i in range(len(lengths))]
    assert travel == pytest.approx([mean - length for length in lengths], abs=2e-5)
    assert travel == pytest.approx([1.8, -1.2, -1.2, -1.2, 1.8], abs=2e-5)
    tensions = [float(result.tension(f"s{i}")[-1]) for i in range(len(lengths))]
    assert tensions == pytest.approx([sum(tensions) / len(tensions)] * len(tensions), rel=1e-6)
