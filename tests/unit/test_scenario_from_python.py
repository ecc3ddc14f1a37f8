"""Lifts that Python builds from dictionaries and lists."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import gantline


def weights(count: int) -> dict[str, Any]:
    """Weights of 10 kg side by side, each on a rope."""
    places = range(count)
    return {
        "format": 1,
        "lift": {"title": 'Weights: "ten" # of them, é'},
        "duration": "0.1 s",
        "ropes": {"thin": {"axial_stiffness": "10 MN", "damping_time": "1 ms"}},
        "mechanics": {
            "bodies": {
                f"b{k}": {
                    "at": [f"{k} m", "0 m", "0 m"],
                    "joint": {"type": "slider", "axis": np.array([0.0, 0.0, 1.0])},
                    "mass": f"{np.float64(10.0)} kg",
                }
                for k in places
            },
            "ropes": {
                f"r{k}": {
                    "rope": "thin",
                    "length": "5 m",
                    "route": (
                        {"type": "end", "body": "world", "at": [f"{k} m", 0, "5 m"]},
                        {"type": "end", "body": f"b{k}"},
                    ),
                }
                for k in places
            },
        },
    }


def test_a_scenario_says_in_a_line_what_it_is() -> None:
    scenario = gantline.parse_scenario(weights(3), source="ten.yaml")
    assert repr(scenario) == str(scenario)
    assert repr(scenario) == "<Scenario 'Weights: \"ten\" # of them, é': ten.yaml, 0.1 s>"


def test_a_mapping_is_a_lift() -> None:
    """T = m g of each, and the recording holds a text that gives the same lift again."""
    scenario = gantline.parse_scenario(weights(3))
    equilibrium = gantline.Statics(scenario).equilibrium()
    assert [equilibrium.tension(f"r{k}") for k in range(3)] == pytest.approx([98.1] * 3, rel=1e-9)
    again = gantline.parse_scenario(scenario.text, scenario.source)
    assert again.text == scenario.text
    assert again == scenario
    assert again.lift.title == 'Weights: "ten" # of them, é'


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"mass": 10}, r"lift.yaml:\d+: mechanics.bodies.b1.mass: '10' has no unit"),
        ({"mass": None}, "lift.yaml: None is no value of a lift file"),
        ({"mass": "nan kg"}, "is not a finite number"),
        ({"weight": "10 kg"}, "mechanics.bodies.b1.weight: 'weight' is not a key"),
    ],
)
def test_mistakes_are_those_of_a_lift_file(wrong: dict[str, Any], message: str) -> None:
    values = weights(2)
    values["mechanics"]["bodies"]["b1"] |= wrong
    with pytest.raises(gantline.ScenarioError, match=message):
        gantline.parse_scenario(values, "lift.yaml")


@pytest.mark.parametrize("given", [3, None, b"format: 1"])
def test_what_is_neither_text_nor_mapping(given: object) -> None:
    with pytest.raises(TypeError, match="a lift file's text or a mapping is needed, not"):
        gantline.parse_scenario(given)  # type: ignore[arg-type]


def test_a_mapping_in_the_place_of_a_path() -> None:
    with pytest.raises(TypeError, match=r"not dict; gantline\.parse_scenario takes"):
        gantline.simulate(weights(1))  # type: ignore[arg-type]
