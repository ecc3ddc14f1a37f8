"""How a run comes to rest where it ends was asked with all of its samples packed beside its last state.

Statics read that state alone. Of three hours of a crane barge in waves, 108 000 samples, the rest took 1.3 s
of processor time, and a copy of them stood in memory beside the recording.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.scenario import load_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.statics.righted import at_end

SCENARIO = "crane_barge_in_swell"


def ended(sample_interval: float, monkeypatch: pytest.MonkeyPatch) -> tuple[Simulation, bytes]:
    """A run of 10 s, and the state of its end that statics were asked about."""
    asked: list[bytes] = []

    def noted(question: Statics, time: float, state: bytes, attitudes: Any) -> Any:
        asked.append(state)
        return at_end(question, time, state, attitudes)

    monkeypatch.setattr("gantline.simulation.at_end", noted)
    simulation = Simulation(SCENARIO, duration=10.0, sample_interval=sample_interval)
    simulation.run()
    (state,) = asked
    return simulation, state


def test_no_samples_go_with_the_state_at_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same run with 11 samples and with 1001: the 990 others would each take 8 bytes at least."""
    (_, few), (_, many) = ended(1.0, monkeypatch), ended(0.01, monkeypatch)
    assert abs(len(many) - len(few)) < 990 * 8


def test_the_state_alone_is_that_of_all_that_is_saved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Statics find the same equilibrium from it, to the last bit, as from what `save` gives."""
    simulation, state = ended(0.1, monkeypatch)
    question = Statics(load_scenario(SCENARIO))
    alone, whole = (question.equilibrium_of(one).recording for one in (state, simulation.save()))
    for name in ("body_position", "body_orientation", "rope_tension"):
        assert np.array_equal(alone[name].values, whole[name].values)
