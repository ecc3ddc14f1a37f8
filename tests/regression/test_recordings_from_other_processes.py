"""Lifts that are simulated by other processes could not send back what they had found.

A recording cannot be changed, and the mapping proxies that see to it cannot be pickled: a pool of processes
ended with `cannot pickle 'mappingproxy' object`. Errors were worse. One that took more than a message could
be pickled and not unpickled, so that a lift file with a mistake in it brought the whole pool down:
`BrokenProcessPool`, and not a word of the mistake.
"""

from __future__ import annotations

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import gantline
from sample_lift import ringing_lift
from simulated_weight import simulated_weight


@pytest.mark.parametrize("again", [lambda one: pickle.loads(pickle.dumps(one)), copy.deepcopy])
def test_a_recording_stays_what_it_is(again) -> None:  # type: ignore[no-untyped-def]
    """To the last bit, and read-only as before."""
    one = ringing_lift()
    other = again(one)
    assert dict(other.coordinates) == dict(one.coordinates)
    assert dict(other.attributes) == dict(one.attributes)
    for name, variable in one.variables.items():
        assert np.array_equal(other[name].values, variable.values)
        assert (other[name].dims, other[name].unit) == (variable.dims, variable.unit)
        assert not other[name].values.flags.writeable
    assert other.metrics() == one.metrics()


def test_a_pool_of_processes_sends_recordings_back() -> None:
    """Heavier by 2 stretches the rope more; each recording is the one of its own mass."""
    masses = ["100 kg", "200 kg"]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        found = list(pool.map(simulated_weight, masses))
    for mass, recording in zip(masses, found, strict=True):
        assert np.array_equal(recording["rope_tension"].values, simulated_weight(mass)["rope_tension"].values)


def test_a_pool_of_processes_tells_of_a_mistake() -> None:
    """The sentence of the process that met it."""
    with (
        ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool,
        pytest.raises(gantline.ScenarioError, match=r"mechanics\.bodies.weight.mass: '100' has no unit"),
    ):
        list(pool.map(simulated_weight, ["100"]))


def errors() -> list[Exception]:
    with pytest.raises(gantline.ScenarioError) as wrong:
        simulated_weight("100")
    return [
        wrong.value,
        gantline.NoEquilibriumError(1.5, "weight", "nothing holds it"),
        gantline.SimulationError(ringing_lift(), 1.5, "rope", "it diverged", b"state"),
    ]


@pytest.mark.parametrize("error", errors(), ids=lambda one: type(one).__name__)
def test_errors_arrive_whole(error: Exception) -> None:
    """The message, and all that stands beside it."""
    other = pickle.loads(pickle.dumps(error))
    assert type(other) is type(error)
    assert str(other) == str(error)
    known = {name: value for name, value in vars(error).items() if name != "recording"}
    assert {name: vars(other)[name] for name in known} == known
    assert vars(other).keys() == vars(error).keys()
