"""A key that was indented wrongly was told with a list of keys, and not with the place where it belongs.

`slings` under `simulation` was "not a key of simulation; known here: 'integrator', ...", and `head_gear`
beside the boom of its crane was asked "did you mean 'heading'?", which would have turned the crane.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, load_scenario, parse_scenario


def said(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return [f"{one.path}: {one.sentence}" for one in error.value.problems]


def test_too_far_in() -> None:
    text = LIFT.replace("rules: {", "simulation:\n  rules: {")
    wrong = "simulation.rules: 'rules' is not a key of simulation, but of a lift file: it stands too far in"
    assert said(text) == [wrong]


def test_too_far_out() -> None:
    text = LIFT.replace("  weight: {calculated: 40 t,", "  calculated: 40 t\n  weight: {")
    wrong = "load.calculated: 'calculated' is not a key of the load, but of 'weight' in it"
    assert f"{wrong}: it stands too far out" in said(text)


def test_a_key_of_the_boom_beside_it() -> None:
    """It was asked whether `heading` was meant."""
    text = load_scenario("crane_barge_in_swell").text
    moved = text.replace("      head_gear: 25 t\n", "").replace(
        "    boom:\n      heel_pins", "    head_gear: 25 t\n    boom:\n      heel_pins"
    )
    assert said(moved) == [
        "cranes.sheerleg.head_gear: 'head_gear' is not a key of a floating crane, but of 'boom' in it: it "
        "stands too far out"
    ]


def test_a_misspelt_key_is_asked_for_as_before() -> None:
    text = LIFT.replace("contingency:", "contingecy:")
    assert said(text) == [
        "load.weight.contingecy: 'contingecy' is not a key of the weight of a load; did you mean "
        "'contingency'?"
    ]
