"""Ropes without stretch keep their length, and one that is slack takes no part in the impact of another."""

from __future__ import annotations

import json

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import Json, adaptive, body, document, end, point, rope

LONG = 3.0


def swinging(place: tuple[float, float, float], *more: Json) -> Json:
    """A mass of 100 kg that starts at rest, on a rope without stretch from the origin."""
    ropes = [rope("stay", LONG, [end(None), end("bob")], None), *more]
    return document([body("bob", point(place), 100.0)], ropes=ropes)


def test_a_rope_that_swings_a_load_keeps_its_length() -> None:
    """Where a step has ended the rope is as long as it is, though steps may miss places by 1 mm.

    What a step has missed, d, is taken back at once along the rope, which leaves d²/2ℓ: 4e-9 m of 0.16 mm.
    """
    place = (LONG * np.sin(1.2), 0.0, -LONG * np.cos(1.2))
    method = {"type": "adaptive", "tension_tolerance": 500.0, "position_tolerance": 1e-3}
    settings = {"integrator": method, "duration": 4.0, "sample_interval": 0.1}
    run = Simulation(json.dumps(swinging(place)), json.dumps(settings))
    for time in (1.0, 2.3, 3.7):
        run.run(until=time)
        assert np.linalg.norm(run.present()["body_position"][-1]) == pytest.approx(LONG, abs=4e-9)


def test_a_slack_rope_takes_no_part_in_the_impact_of_another() -> None:
    """The mass falls into its stay while ropes to both sides and from below are slack: as without them."""
    place = (0.6, 0.2, -LONG + 0.6)
    aside = [
        rope(f"aside{k}", 6.0, [end(None, to), end("bob")], None)
        for k, to in enumerate(((-4.0, 0.0, -4.0), (3.0, 3.0, -4.0), (1.0, -4.0, -3.0)))
    ]
    alone, beside = (adaptive(swinging(place, *more), 1.0) for more in ([], aside))
    hit = [time for time, name in beside.events("taut") if name == "stay"]
    assert len(hit) > 0 and not [name for _, name in beside.events("taut") if name != "stay"]
    assert beside.body("bob") == pytest.approx(alone.body("bob"), abs=1e-7)
    assert beside.energy("impact")[-1] == pytest.approx(alone.energy("impact")[-1], rel=1e-7)
    assert max(beside.tension(f"aside{k}").max() for k in range(3)) == 0.0
