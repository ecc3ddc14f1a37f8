"""Same lift, same bytes: of two runs, of two processes, and of a run that was saved and taken up again."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest

import gantline
from gantline import _core
from gantline.simulation import Simulation
from mechanics import body, contact, document, free
from saved_states import with_digest

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
#: Duration and time of the break [s]: while slings bounce, while a step waits for its condition, and after
#: bodies that touch have met in other places.
LIFTS = {
    "pulleys": (5.0, 1.2345),
    "equalizer": (40.0, 7.7777),
    "equalizer_yard": (90.0, 78.9012),
    "reeved_hoist": (60.0, 41.0),
    "goliath": (360.0, 333.3),
}
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
#: Of the longest another process says the same, and more.
short_lifts = pytest.mark.parametrize("name", [name for name in LIFTS if name != "goliath"])


def unbroken_run(name: str, folder: Path) -> bytes:
    """The saved recording of a run from start to end in this process, each time anew."""
    simulation = Simulation(SCENARIOS / name, duration=LIFTS[name][0])
    return simulation.run().save(folder / "whole.nc").read_bytes()


def other_process(name: str, folder: Path, state: Path | None = None) -> bytes:
    """The saved recording of a run in a process of its own, from the start or from a saved state."""
    path = folder / "other.nc"
    words = [SCENARIOS / name, LIFTS[name][0], "" if state is None else state, path]
    command = [sys.executable, "-c", PROCESS, *map(str, words)]
    subprocess.run(command, check=True, env={**os.environ, "PYTHONHASHSEED": "77"})
    return path.read_bytes()


@cache
def run_with_a_break(name: str) -> tuple[bytes, bytes]:
    """The state of a run at its break, and its saved recording, with which all others are compared."""
    duration, pause = LIFTS[name]
    simulation = Simulation(SCENARIOS / name, duration=duration)
    reached = simulation.run(until=pause).time[-1]
    assert pause - 0.021 < reached < duration, "it pauses at the end of the step that reaches the break"
    state = simulation.save()
    with TemporaryDirectory() as folder:
        return state, simulation.run().save(Path(folder) / "whole.nc").read_bytes()


@short_lifts
def test_two_runs_give_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Recordings of a run from start to end and of one that pauses on its way, byte by byte."""
    assert unbroken_run(name, tmp_path) == run_with_a_break(name)[1]


@lifts
def test_two_processes_give_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Recordings of this process, with a pause, and of another one with another hash seed, byte by byte."""
    assert other_process(name, tmp_path) == run_with_a_break(name)[1]


@short_lifts
def test_a_run_taken_up_again_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Recordings of a run that went on and of one saved in the middle and restored, byte by byte."""
    state, whole = run_with_a_break(name)
    other = Simulation(SCENARIOS / name, duration=LIFTS[name][0])
    other.restore(state)
    assert other.run().save(tmp_path / "other.nc").read_bytes() == whole


@lifts
def test_a_run_taken_up_by_another_process_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    """The same with the state restored in another process, byte by byte."""
    saved, whole = run_with_a_break(name)
    state = tmp_path / "state"
    state.write_bytes(saved)
    assert other_process(name, tmp_path, state) == whole


METHODS = [
    {"type": "adaptive", "tension_tolerance": 1.0, "position_tolerance": 1e-6},
    {"type": "del", "step": 2e-4},
    {"type": "explicit", "step": 2e-4},
]


@pytest.mark.parametrize("integrator", METHODS, ids=lambda one: one["type"])
def test_what_slides_goes_on_as_it_slid(integrator: dict[str, Any]) -> None:
    """A box that slides and turns: where `del` begins to look for its friction is the friction of before."""
    corners = [(x, y, -0.5) for x in (0.5, -0.5) for y in (0.5, -0.5)]
    law = {"stiffness": 1e6, "friction": 0.3, "damping_time": 0.002}
    box = free((0, 0, 0.5), velocity=[1, 0.4, 0], angular_velocity=[0, 0, 2])
    system = document(
        [body("box", box, 100.0, inertia=(20, 20, 20))],
        contacts=[contact(f"c{k}", "box", at, **law) for k, at in enumerate(corners)],
    )
    settings = json.dumps({"integrator": integrator, "duration": 0.5, "sample_interval": 0.01})
    whole, first, second = (_core.Simulation(json.dumps(system), settings) for _ in range(3))
    whole.run()
    first.run(None, 0.1)
    second.restore(first.save())
    second.run()
    for column in ("body_position", "contact_force"):
        assert np.array_equal(whole.columns()[column][-40:], second.columns()[column][-40:])


def test_restoring_goes_back(tmp_path: Path) -> None:
    """A state restored into a run that went further gives the bytes of a run without a break."""
    duration, pause = LIFTS["equalizer"]
    simulation = Simulation(SCENARIOS / "equalizer", duration=duration)
    simulation.run(until=pause)
    state = simulation.save()
    simulation.run(until=pause + 15.0)
    simulation.restore(state)
    assert simulation.run().save(tmp_path / "back.nc").read_bytes() == unbroken_run("equalizer", tmp_path)


def test_a_state_of_another_lift_is_refused() -> None:
    """A state belongs to its lift and settings: anything else is an error, not a different motion."""
    state = Simulation(SCENARIOS / "equalizer").save()
    for other in (
        Simulation(SCENARIOS / "pulleys"),
        Simulation(SCENARIOS / "equalizer", tension_tolerance=7.0),
    ):
        with pytest.raises(ValueError, match="saved state"):
            other.restore(state)
    for damaged in (state[:-10], state.replace(b"0", b"1", 1), b""):
        with pytest.raises(ValueError, match="it is no state of a run, or is damaged or cut off"):
            Simulation(SCENARIOS / "equalizer").restore(damaged)


def test_one_byte_that_has_changed_is_found_wherever_it_is() -> None:
    """Each of 60 bytes over the length of a state, digest included: refused, and nothing is taken up."""
    run = Simulation(SCENARIOS / "equalizer")
    run.run(until=2.0)
    state = run.save()
    assert with_digest(state) == state
    other = Simulation(SCENARIOS / "equalizer")
    for place in np.linspace(0, len(state) - 1, 60).astype(int):
        damaged = bytearray(state)
        damaged[place] ^= 1
        with pytest.raises(ValueError, match="it is no state of a run, or is damaged or cut off"):
            other.restore(bytes(damaged))
    assert other.time == 0.0 and len(other.recording().time) == 0


def test_a_state_of_another_version_is_refused_and_said_to_be_one() -> None:
    """Whole, with the digest of what it is: of the form before, of another version, with other parts."""
    run = Simulation(SCENARIOS / "equalizer")
    run.run(until=0.5)
    state = run.save()
    first, rest = state.split(b"\n", 1)
    assert first == f"gantline {gantline.__version__} state 5".encode()
    assert rest[8:].startswith(b'{"fingerprint":') and b'"ledger":' in rest
    others = [
        rest[8:],  # a state was nothing but this
        state.replace(first, b"gantline 0.0.9 state 5", 1),
        state.replace(b'"ledger":', b'"leger_":', 1),
    ]
    for other in others:
        with pytest.raises(ValueError, match="it was saved by another version of gantline, and the version"):
            Simulation(SCENARIOS / "equalizer").restore(with_digest(other))
    # Samples that are not those of this lift, as only another version can have left them: too long.
    longer = with_digest(state[:-16] + bytes(16) + state[-16:])
    untouched = Simulation(SCENARIOS / "equalizer")
    with pytest.raises(ValueError, match="its samples cannot be read"):
        untouched.restore(longer)
    assert untouched.time == 0.0
