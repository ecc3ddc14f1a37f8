"""A fixed hook went past its rated capacity without an event: only hooks of trolleys and booms had one."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import BASE


@pytest.mark.parametrize(("rated", "is_passed"), [("60 t", True), ("100 t", False)])
def test_a_fixed_hook_past_its_rated_capacity_is_an_event(rated: str, is_passed: bool) -> None:
    """60 t and gear on a hook for 60 t: at the first moment at which more hangs, between two samples."""
    text = BASE.replace("rated_capacity: 100 t", f"rated_capacity: {rated}")
    text = text.replace("speed: 3 m/min, start_at: 0 s, brake_from: 10 s", "speed: 6 m/min, by: 2.5 m")
    run = simulate(parse_scenario(text.replace("duration: 20 s", "duration: 40 s")))
    events = run.events("overload")
    assert bool(events) is is_passed
    if is_passed:
        first = int(np.argmax(run.column("hoist_load", "hook") > 60e3 * 9.81))
        time, _, name = events[0]
        assert name == "hook" and run.time[first - 1] <= time <= run.time[first]
