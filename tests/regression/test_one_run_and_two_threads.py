"""A second thread that ran a simulation which was running brought a panic of the core, `Already borrowed`.

One that only looked, to draw how far it had got, was answered `Already mutably borrowed`, as it happened.
Later it was answered `zip() argument 2 is longer than argument 1` where an event came between the columns
that it took and the names of their events.
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


class _GoesOn:
    """A core that has come to the end once its columns have been taken."""

    def __init__(self, core: Any) -> None:
        self._core = core

    def __getattr__(self, name: str) -> Any:
        return getattr(self._core, name)

    def columns(self, **how: bool) -> Any:
        found = self._core.columns(**how)
        self._core.run()
        return found


def test_events_between_columns_and_names(monkeypatch: pytest.MonkeyPatch) -> None:
    """The load has not come off when the columns are taken, and hangs when the names are."""
    run = Simulation(LIFT)
    run.run(until=1.0)
    monkeypatch.setattr(run, "_core", _GoesOn(run._core))
    recording = run.recording()
    assert recording.time[-1] <= 1.0 and run.time > 5.0
    assert all(time <= 1.0 for time, *_ in recording.events())


@pytest.mark.parametrize("until", [float("nan"), -1.0, "1 s", True])
def test_a_pause_is_at_a_time(until: object) -> None:
    """NaN went on to the end without a word; -1 s gave a recording without samples."""
    with pytest.raises(ValueError, match=r"until: .* is no time in seconds from 0 on"):
        Simulation(LIFT).run(until=until)  # type: ignore[arg-type]
