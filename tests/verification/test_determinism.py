"""Same lift, same bytes: of two runs, of two processes, and of a run that was saved and taken up again."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from gantline.simulation import Simulation

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
#: Duration and time of the break [s]: while slings bounce, and while a step waits for its condition.
LIFTS = {"pulleys": (5.0, 1.2345), "equalizer": (40.0, 7.7777), "equalizer_yard": (90.0, 78.9012)}
PROCESS = """
import sys
from gantline.simulation import Simulation

lift, duration, state, path = sys.argv[1:]
simulation = Simulation(lift, duration=float(duration))
if state:
    simulation.restore(open(state, "rb").read())
simulation.run().save(path)
"""

lifts = pytest.mark.parametrize("name", LIFTS)


def whole_run(name: str, folder: Path) -> bytes:
    """The saved recording of a run from start to end in this process."""
    simulation = Simulation(SCENARIOS / name, duration=LIFTS[name][0])
    return simulation.run().save(folder / "whole.nc").read_bytes()


def other_process(name: str, folder: Path, state: Path | None = None) -> bytes:
    """The saved recording of a run in a process of its own, from the start or from a saved state."""
    path = folder / "other.nc"
    words = [SCENARIOS / name, LIFTS[name][0], "" if state is None else state, path]
    command = [sys.executable, "-c", PROCESS, *map(str, words)]
    subprocess.run(command, check=True, env={**os.environ, "PYTHONHASHSEED": "77"})
    return path.read_bytes()


def saved_in_the_middle(name: str, folder: Path) -> Path:
    """The state of a run at its break, in a file."""
    duration, pause = LIFTS[name]
    simulation = Simulation(SCENARIOS / name, duration=duration)
    reached = simulation.run(until=pause).time[-1]
    assert pause - 0.021 < reached < duration, "it pauses at the end of the step that reaches the break"
    path = folder / "state"
    path.write_bytes(simulation.save())
    return path


@lifts
def test_two_runs_give_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Recordings of two runs, byte by byte."""
    assert whole_run(name, tmp_path) == whole_run(name, tmp_path)


@lifts
def test_two_processes_give_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Recordings of this process and of another one with another hash seed, byte by byte."""
    assert whole_run(name, tmp_path) == other_process(name, tmp_path)


@lifts
def test_a_run_taken_up_again_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Recordings of a run without a break and of one saved in the middle and restored, byte by byte."""
    state = saved_in_the_middle(name, tmp_path)
    other = Simulation(SCENARIOS / name, duration=LIFTS[name][0])
    other.restore(state.read_bytes())
    assert other.run().save(tmp_path / "other.nc").read_bytes() == whole_run(name, tmp_path)


@lifts
def test_a_run_taken_up_by_another_process_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    """The same with the state restored in another process, byte by byte."""
    state = saved_in_the_middle(name, tmp_path)
    assert other_process(name, tmp_path, state) == whole_run(name, tmp_path)


def test_restoring_goes_back(tmp_path: Path) -> None:
    """A state restored into a run that went further gives the bytes of a run without a break."""
    duration, pause = LIFTS["equalizer"]
    simulation = Simulation(SCENARIOS / "equalizer", duration=duration)
    simulation.run(until=pause)
    state = simulation.save()
    simulation.run(until=pause + 15.0)
    simulation.restore(state)
    assert simulation.run().save(tmp_path / "back.nc").read_bytes() == whole_run("equalizer", tmp_path)


def test_a_state_of_another_lift_is_refused() -> None:
    """A state belongs to its lift and settings: anything else is an error, not a different motion."""
    state = Simulation(SCENARIOS / "equalizer").save()
    for other in (
        Simulation(SCENARIOS / "pulleys"),
        Simulation(SCENARIOS / "equalizer", tension_tolerance=7.0),
    ):
        with pytest.raises(ValueError, match="saved state"):
            other.restore(state)
    with pytest.raises(ValueError, match="saved state"):
        Simulation(SCENARIOS / "equalizer").restore(state[:-10])
