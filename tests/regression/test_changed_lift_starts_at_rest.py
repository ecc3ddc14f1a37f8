"""A lift changed from Python that started elsewhere than the lift itself.

Cases of statics let slings pull from the start, by `start: as_given`; `Scenario.changed` took that over. A
run of the changed lift began with its load hardly on its supports, a step that waits for load transferred
was over at 0 s, and what came after it was another lift.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.scenario import load_scenario

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer_yard" / "scenario.yaml"


def test_a_value_changed_to_itself_changes_nothing() -> None:
    lift = load_scenario(LIFT)
    assert lift.load is not None
    same = lift.changed({"load.weight.contingency": f"{lift.load.weight.contingency:g}"})
    assert (same.start, same.starts_at_rest) == (lift.start, lift.starts_at_rest)
    before, after = (gantline.simulate(one, duration=20.0) for one in (lift, same))
    assert after.events() == before.events()
    assert np.array_equal(after.time, before.time)
    assert after.metrics()["peak_sling_tension"] == before.metrics()["peak_sling_tension"]


def test_where_it_starts_can_be_changed_too() -> None:
    assert load_scenario(LIFT).changed({"start": "rest"}).starts_at_rest


def test_slings_too_short_for_the_start_are_refused_as_in_a_file() -> None:
    with pytest.raises(gantline.ScenarioError, match="lower the hook or make the sling longer"):
        gantline.simulate(load_scenario(LIFT).changed({"slings.S1.length": "20 m"}))
