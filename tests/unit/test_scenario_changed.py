"""A lift with other values, in Python."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.statics import Statics

EQUALIZER = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer"


@pytest.fixture(name="lift")
def _lift() -> Scenario:
    return load_scenario(EQUALIZER)


@pytest.mark.parametrize("weight", [280.0, 320.0])
def test_another_weight_hangs_in_the_same_slings(lift: Scenario, weight: float) -> None:
    """By the equalizer each bears a fifth; the frame and five sheaves hang above the slings."""
    other = lift.changed({"load.weight.calculated": f"{weight:g} t"})
    rest = Statics(other).equilibrium()
    vertical = [rest.recording.column("hook_load", hook)[-1] for hook in other.hooks]
    rigging = 20e3 + 5 * 300.0
    assert sum(vertical) == pytest.approx((weight * 1e3 + rigging) * 9.81, rel=1e-9)
    assert lift.load is not None and lift.load.weight.calculated == 300e3


def test_its_text_tells_what_was_changed(lift: Scenario) -> None:
    other = lift.changed({"duration": "50 s", "slings.S1.length": "23.1 m"})
    assert other.duration == 50.0
    assert (
        other.text
        == f"{lift.text.rstrip()}\n# changed: duration: 50 s\n# changed: slings.S1.length: 23.1 m\n"
    )


@pytest.mark.parametrize(
    "values",
    [
        {"load.centre_of_gravity.at": "[0.1 m, 0 m, 3 m]"},
        {"load.centre_of_gravity.at": ["0.1 m", "0 m", "3 m"]},
        {"load.centre_of_gravity": {"at": ("0.1 m", "0 m", "3 m"), "envelope": ["1 m", "0 m", "0 m"]}},
        {"load.centre_of_gravity.at.x": "0.1 m", "load.centre_of_gravity.at.z": "3 m"},
    ],
)
def test_lists_and_mappings_are_values_too(lift: Scenario, values: dict[str, Any]) -> None:
    load = lift.changed(values).load
    assert load is not None and load.centre_of_gravity.at == (0.1, 0.0, 3.0)


def test_numbers_stand_where_a_lift_file_has_them(lift: Scenario) -> None:
    load = lift.changed({"load.weight.contingency": np.float64(1.07)}).load
    assert load is not None and load.weight.contingency == 1.07
    with pytest.raises(ScenarioError, match=r"load\.weight\.calculated: '320' has no unit"):
        lift.changed({"load.weight.calculated": 320})


@pytest.mark.parametrize("path", ["plan.1.speed", "plan[1].speed"])
def test_a_place_in_a_list_is_written_as_messages_have_it(lift: Scenario, path: str) -> None:
    with pytest.raises(ScenarioError, match=r"plan\[1\]\.speed: '1 t' is a mass"):
        lift.changed({path: "1 t"})


def test_what_is_set_in_place_says_how_it_is_done(lift: Scenario) -> None:
    with pytest.raises(AttributeError, match=r"'title' cannot be set: .*Scenario\.changed\("):
        lift.lift.title = "another"  # type: ignore[misc]


def test_a_text_in_place_of_a_file_is_told() -> None:
    with pytest.raises(ScenarioError, match=r"the text of a lift file .* gantline\.parse_scenario\(text\)"):
        load_scenario("format: 1\nlift: {title: a text}\n")


@pytest.mark.parametrize(
    ("values", "says"),
    [
        ({"load.wieght.calculated": "1 t"}, "did you mean 'weight'"),
        ({"load.weight.calculated": "320"}, "load.weight.calculated"),
        ({"load.heading": None}, "None is no value of a lift file; a text such as '320 t'"),
        ({"load.centre_of_gravity.at": "[0 m, 0 m"}, r"'\[0 m, 0 m': a ',' or '\]' is missing"),
    ],
)
def test_what_cannot_be_is_refused(lift: Scenario, values: dict[str, Any], says: str) -> None:
    with pytest.raises(ScenarioError, match=says):
        lift.changed(values)


def test_what_the_file_does_not_have_is_given_whole() -> None:
    """A setting of a lift without `simulation` was answered `did you mean 'duration'?`."""
    lift = load_scenario("equalizer")
    assert "simulation" not in lift.tree
    with pytest.raises(ScenarioError, match="no 'simulation' in this file yet; it is given whole"):
        lift.changed({"simulation.sample_interval": "0.1 s"})
    changed = lift.changed({"simulation": {"sample_interval": "0.1 s"}})
    assert changed.simulation.sample_interval == 0.1
