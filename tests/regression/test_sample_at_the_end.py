"""The last sample of a run whose duration is no multiple of its `sample_interval`.

Samples were taken at multiples of the interval alone. A run of 1 s with 0.3 s between its samples had none
after 0.9 s: what happened in its last tenth of a second was in no table, plot or check. Fixed steps went the
other way: one of 0.7 s that led over the end left a sample at 1.2 s, of a run of 1 s. A run that could not
go on ended at the last sample before that, and not at its last good state.

A body is thrown along a slope of its own: v0 t - g t²/2, which every method has at the ends of its steps.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from gantline import _core
from gantline.checks.measure import extreme
from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation, SimulationError
from lift_text import PAST_THE_END
from mechanics import (
    G,
    Json,
    adaptive,
    body,
    contact,
    document,
    end,
    finished,
    point,
    rope,
    simulate,
    simulation,
    slider,
)
from sample_lift import sample_recording, sample_rig

UP = 3.0  # [m/s]


def thrown() -> Json:
    return document([body("load", slider(velocity=UP), 10.0)])


def height(time: float) -> float:
    """v0 t - g t²/2 [m]."""
    return UP * time - G * time**2 / 2


def test_the_end_is_a_sample() -> None:
    """Of `adaptive`, which is exact on a parabola: 0, 0.3, 0.6, 0.9 and 1 s."""
    run = adaptive(thrown(), 1.0, sample_interval=0.3)
    assert run.time.tolist() == [0 * 0.3, 1 * 0.3, 2 * 0.3, 3 * 0.3, 1.0]
    assert run.body("load")[:, 2] == pytest.approx([height(time) for time in run.time], abs=1e-9)
    assert run.body("load", "body_velocity")[-1, 2] == pytest.approx(UP - G, rel=1e-9)


def test_a_multiple_has_its_end_once() -> None:
    """0.1 s three times is 0.30000000000000004 s; the end is the duration, and no sample stands twice."""
    run = adaptive(thrown(), 0.3, sample_interval=0.1)
    assert run.time.tolist() == [0.0, 0.1, 0.2, 0.3]
    long = adaptive(thrown(), 7.0, sample_interval=0.07)
    assert len(long.time) == 101 and long.time[-1] == 7.0


@pytest.mark.parametrize("method", ["del", "explicit"])
def test_fixed_steps_have_no_sample_past_the_end(method: str) -> None:
    """Steps of 0.7 s end at 0.7 and 1.4 s. At 1 s the body is 3/7 on the way of the second."""
    settings = {"integrator": {"type": method, "step": 0.7}, "duration": 1.0, "sample_interval": 0.3}
    run = _core.Simulation(json.dumps(thrown()), json.dumps(settings))
    done = finished(run, run.run())
    assert done.time.tolist() == [0 * 0.3, 1 * 0.3, 2 * 0.3, 3 * 0.3, 1.0]
    second = done.body("load", "body_velocity")[-1, 2]
    heights = done.body("load")[:, 2]
    assert heights[-1] - heights[-2] == pytest.approx(0.1 * second, rel=1e-9)


def test_nothing_is_told_of_past_the_end() -> None:
    """A body falls 4.905 m onto the ground, which it meets at 1 s: in a step from 0.7 to 1.4 s."""
    ground = contact("ground", "load", (0, 0, 0), stiffness=1e5)
    falling = document([body("load", slider(position=G / 2), 10.0)], contacts=[ground])
    longer = simulate(falling, 1.5, step=0.7, sample_interval=0.3)
    assert longer.events("set_down")
    run = simulate(falling, 0.9, step=0.7, sample_interval=0.3)
    assert max(run.columns["event_time"], default=0.0) <= 0.9
    bob = body("load", point((0, 0, -2.0), (1.0, 0, 0)), 10.0)
    hung = document([bob], ropes=[rope("r", 2.0, [end(None), end("load")], 1e4)])
    swung = simulate(hung, 1.0, step=0.7, sample_interval=0.3)
    assert swung.columns["rope_peak_time"].max() <= 1.0
    assert swung.peak("r") >= swung.tension("r").max()


def test_a_run_that_fails_ends_at_its_last_good_state() -> None:
    """A sheave falls past the dead end of its rope; samples 50 ms apart ended up to 50 ms before that."""
    run = Simulation(parse_scenario(PAST_THE_END))
    with pytest.raises(SimulationError) as failed:
        run.run()
    time = failed.value.recording.time
    assert time[-1] == run.time and 0.0 < time[-1] - time[-2] <= 0.05
    assert time[:-1] == pytest.approx(0.05 * np.arange(len(time) - 1))
    at_end = failed.value.recording.column("body_position", "sheave")[-1]
    assert at_end == pytest.approx(run.now("body_position", "sheave"), abs=0.0)
    # Whoever tries again from there fails again, and has that sample once.
    with pytest.raises(SimulationError) as again:
        run.run()
    assert again.value.recording.time.tolist() == time.tolist()


def test_a_run_taken_up_has_the_same_samples() -> None:
    whole, paused = (simulation(thrown(), 1.0, step=0.02, sample_interval=0.3) for _ in range(2))
    whole.run()
    paused.run(None, 0.95)
    assert paused.columns()["time"].tolist() == [0 * 0.3, 1 * 0.3, 2 * 0.3, 3 * 0.3]
    other = simulation(thrown(), 1.0, step=0.02, sample_interval=0.3)
    other.restore(paused.save())
    other.run()
    assert other.columns()["time"].tolist() == whole.columns()["time"].tolist()
    assert other.columns()["time"][-1] == 1.0


def test_crests_of_the_last_samples_are_on_their_parabola() -> None:
    """5 - (t - 9.1 s)² at 8, 9 and 9.3 s: 5 at 9.1 s, between the last two samples, which lie 0.3 s apart."""
    time = np.array([*range(10), 9.3])
    curve = 5.0 - (time - 9.1) ** 2
    recording = sample_recording(time, rig=sample_rig(), tension=np.full((11, 5), 600e3))
    (found,) = extreme(recording, curve, np.ones(11, dtype=bool), "load")
    assert found.value == pytest.approx(5.0 - 0.1**2)
    assert found.between == pytest.approx(5.0, abs=1e-12)
    # A fall at the last moment is a kink: what stood at 4 before has no crest there.
    (level,) = extreme(recording, np.array([4.0] * 10 + [3.0]), np.ones(11, dtype=bool), "load")
    assert level.between is None


def test_a_mean_counts_samples_by_how_long_they_last() -> None:
    """1 over 9 s, then linearly to 3 in the last second's tenth: (9 x 1 + 0.1 x 2)/9.1 = 1.0110."""
    time = np.array([0.0, 3.0, 6.0, 9.0, 9.1])
    assert series.mean_over(time, np.array([1.0, 1.0, 1.0, 1.0, 3.0])) == pytest.approx(9.2 / 9.1, rel=1e-12)
    assert series.mean_over(time[-1:], np.array([3.0])) == 3.0
