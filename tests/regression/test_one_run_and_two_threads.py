"""A second thread that ran a simulation which was running brought a panic of the core, `Already borrowed`.

One that only looked, to draw how far it had got, was answered `Already mutably borrowed`, as it happened.
"""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.scenario import load_scenario
from gantline.simulation import Simulation

LIFT = load_scenario("equalizer")
FINE: dict[str, Any] = {"integrator": "del", "step": 1e-4, "duration": 2.0}


def test_two_threads_run_one_simulation() -> None:
    """Both come to the end, and what was recorded is what one alone records."""
    run = Simulation(LIFT, **FINE)
    errors: list[BaseException] = []

    def go() -> None:
        try:
            run.run()
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=go) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == []
    alone = gantline.simulate(LIFT, **FINE)
    assert np.array_equal(run.recording()["rope_tension"].values, alone["rope_tension"].values)


def test_a_thread_looks_on() -> None:
    """Recording, step, largest tension and state, at any time of a run."""
    run = Simulation(LIFT, **FINE)
    thread = threading.Thread(target=run.run)
    thread.start()
    reached = []
    while thread.is_alive():
        recording = run.recording()
        reached.append(float(recording.time[-1]) if len(recording.time) else 0.0)
        assert run.largest_sling_tension is not None
        assert run.current_step in (None, *(step.step for step in LIFT.plan))
        assert run.save()
    thread.join()
    assert reached == sorted(reached)
    assert run.recording().attributes["status"] == "done"


@pytest.mark.parametrize("until", [float("nan"), -1.0, "1 s", True])
def test_a_pause_is_at_a_time(until: object) -> None:
    """NaN went on to the end without a word; -1 s gave a recording without samples."""
    with pytest.raises(ValueError, match=r"until: .* is no time in seconds from 0 on"):
        Simulation(LIFT).run(until=until)  # type: ignore[arg-type]
