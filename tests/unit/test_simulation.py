"""From a lift to a recording around a core that is told what to do."""

import os
import signal
from typing import Any

import numpy as np
import pytest

from fake_core import SETTINGS, FakeCore, core
from gantline.overrides import SettingError
from gantline.scenario import ScenarioError
from gantline.simulation import Simulation, SimulationError, simulate

__all__ = ["core"]


def test_a_lift_runs_to_its_end(core: type[FakeCore]) -> None:
    recording = simulate("lift.yaml")
    assert recording.time[-1] == 4.0
    assert recording.attributes["status"] == "done"
    assert recording.attributes["scenario"] == "format: 1\n"
    assert recording.attributes["settings"] == {**SETTINGS, "start": "as_given"}
    assert recording.attributes["counters"] == {"steps": 4, "unconverged": 0}
    assert recording.attributes["warnings"] == []
    assert recording.title == "One equalizer lifts a 300 t load"


def test_progress_is_told_and_may_stop(core: type[FakeCore]) -> None:
    told: list[float] = []

    def stop_at_two(now: float) -> bool:
        told.append(now)
        return now < 2.0

    recording = simulate("lift.yaml", on_progress=stop_at_two)
    assert told == [1.0, 2.0]
    assert recording.attributes["status"] == "stopped"
    assert recording.time[-1] == 2.0


def test_progress_that_answers_nothing_goes_on(core: type[FakeCore]) -> None:
    assert simulate("lift.yaml", on_progress=lambda now: None).attributes["status"] == "done"


def test_the_step_under_way_can_be_asked_for_meanwhile(core: type[FakeCore]) -> None:
    simulation = Simulation("lift.yaml")
    steps: list[str | None] = []
    simulation.run(on_progress=lambda now: steps.append(simulation.current_step))
    assert steps == ["hoist", "hoist", None, None]


def test_an_interrupt_stops_and_keeps_what_there_is(core: type[FakeCore]) -> None:
    before = signal.getsignal(signal.SIGINT)

    def interrupt(now: float) -> None:
        if now == 3.0:
            os.kill(os.getpid(), signal.SIGINT)

    recording = simulate("lift.yaml", on_progress=interrupt)
    assert recording.attributes["status"] == "stopped"
    assert recording.time[-1] <= 4.0
    assert signal.getsignal(signal.SIGINT) is before


def test_settings_in_place_of_those_of_the_lift_file(core: type[FakeCore]) -> None:
    recording = simulate("lift.yaml", step=5e-4, paper=True, duration=2, geometric_stiffness=None)
    assert recording.attributes["settings"] == {
        "integrator": {"type": "del", "step": 5e-4, "paper": True, "geometric_stiffness": True},
        "duration": 2.0,
        "sample_interval": 1.0,
        "start": "as_given",
    }
    assert recording.time[-1] == 2.0
    assert SETTINGS["duration"] == 4.0


def test_settings_may_be_numbers_of_numpy(core: type[FakeCore]) -> None:
    """Studies take them from arrays; what the core and recordings get are plain numbers."""
    two: Any = np.int64(2)
    overrides: Any = {"duration": two, "step": np.float32(0.5), "paper": np.bool_(True)}
    settings = simulate("lift.yaml", **overrides).attributes["settings"]
    assert settings["duration"] == 2.0 and settings["integrator"]["step"] == 0.5
    assert type(settings["integrator"]["step"]) is float
    assert settings["integrator"]["paper"] is True
    assert Simulation("lift.yaml").run(until=two).time[-1] == 2.0


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ({"step": 0.0}, "step: 0.0 is not a time above zero"),
        ({"duration": float("nan")}, "duration: nan is not a time above zero"),
        ({"sample_interval": "20 ms"}, "sample_interval: '20 ms' is not a time above zero"),
        ({"steps": 3}, "steps: not a setting of the integrator del; there are integrator, step"),
        (
            {"tension_tolerance": 5.0},
            "tension_tolerance: not a setting of the integrator del; adaptive has it",
        ),
        ({"type": "explicit"}, "type: not a setting of the integrator del; there are integrator, step"),
        ({"duration": 10**400}, "duration: 10+ is not a time above zero"),
        ({"step": True}, "step: True is not a time above zero"),
        ({"paper": "yes"}, "paper: 'yes' is neither True nor False"),
        ({"geometric_stiffness": 1}, "geometric_stiffness: 1 is neither True nor False"),
        ({"integrator": ["del"]}, r"integrator: \['del'\] is none; there are adaptive, del and explicit"),
    ],
)
def test_settings_that_are_not_right(core: type[FakeCore], override: dict[str, Any], message: str) -> None:
    with pytest.raises(SettingError, match=message):
        simulate("lift.yaml", **override)


def test_a_failure_carries_what_was_recorded(core: type[FakeCore]) -> None:
    core.fails_at = 2
    with pytest.raises(
        SimulationError, match=r"could not go on at t = 2\.000 s at sling\.S1: a pivot is zero"
    ) as failure:
        simulate("lift.yaml")
    assert failure.value.recording.time[-1] == 2.0
    assert failure.value.recording.attributes["status"] == "failed"
    assert (failure.value.time, failure.value.element, failure.value.cause) == (
        2.0,
        "sling.S1",
        "a pivot is zero",
    )
    assert failure.value.state == b"2"


def test_what_the_core_refuses_is_an_error_of_the_lift_file(core: type[FakeCore]) -> None:
    core.refuses = "rope r1 is redundant"
    with pytest.raises(ScenarioError, match=r"lift\.yaml: rope r1 is redundant"):
        simulate("lift.yaml")


def test_an_open_energy_balance_is_a_warning_in_the_recording(core: type[FakeCore]) -> None:
    core.remainder = 2e-3  # the bound is 1e-3
    recording = simulate("lift.yaml")
    assert recording.metrics()["energy_remainder"] == 2e-3
    (warning,) = recording.attributes["warnings"]
    assert warning == "the energy balance does not close: remainder 0.002 of the largest energy, bound 0.001"


def test_a_simulation_pauses_is_saved_and_goes_on(core: type[FakeCore]) -> None:
    simulation = Simulation("lift.yaml")
    assert simulation.run(until=2.0).time[-1] == 2.0
    state = simulation.save()
    other = Simulation("lift.yaml")
    other.restore(state)
    assert other.run().time[-1] == 4.0
    assert other.duration == 4.0
    assert other.integration_time > 0.0
