"""What a lift file may say of spreaders, and what it is told."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.errors import StartError
from spreader_lifts import one_bar


def told(old: str, new: str) -> str:
    text = one_bar()
    assert old in text
    with pytest.raises(ScenarioError) as error:
        assemble(parse_scenario(text.replace(old, new)))
    return str(error.value)


OF_LUG = "{at: [-4 m, 0 m, 0.2 m], capacity: 60 t}"
INERTIA = "mass: 3 t\n    inertia: {xx: 1 t m^2, yy: 1 t m^2, zz: 9 t m^2}"
OUTSIDE = "centre_of_gravity: [0 m, 0 m, 3 m]\n    size: [8.4"
NODES = "sling_defaults: {rope: sling, rope_weight: distributed, rope_nodes: 5}"
NO_TOP = "is no moving sheave, no hook and no lug of a spreader"


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("to: bar.A2", "to: bar.A3", "slings.up_2.to: 'bar.A3' is not a lug; did you mean 'bar.A2'?"),
        ("from: bar.B1", "from: bar.B9", f"slings.down_1.from: 'bar.B9' {NO_TOP}"),
        ("from: bar.B1", "from: bar", f"slings.down_1.from: 'bar' {NO_TOP}"),
        ("[-4 m, 0 m, 0.2 m]", "[-40 m, 0 m, 0.2 m]", "A1.at: this lug is 35.8 m outside the spreader's box"),
        ("size: [8.4", OUTSIDE, "spreaders.bar.centre_of_gravity: (0, 0, 3) m is outside the spreader's box"),
        ("mass: 3 t", "mass: 0 t", "spreaders.bar.mass"),
        ("mass: 3 t", INERTIA, "spreaders.bar.inertia: no body has such an inertia"),
        (OF_LUG, "{at: [-4 m, 0 m, 0.2 m], type: X}", "A1.type: 'X' is not a name of 'lug_types'"),
        ("axial_stiffness: 100 MN, damping_time: 20 ms", "inextensible: true", "a spreader hangs on it"),
        ("sling_defaults: {rope: sling}", NODES, "a spreader hangs on it or carries it"),
        ("  bar:\n", "  module:\n", "'module' is already the name of"),
    ],
)
def test_mistakes(old: str, new: str, sentence: str) -> None:
    assert sentence in told(old, new)


def test_nothing_holds_it() -> None:
    text = one_bar()
    text = text.replace("{from: hook, to: bar.A1", "{from: hook, to: module.P1")
    text = text.replace("{from: hook, to: bar.A2", "{from: hook, to: module.P2")
    with pytest.raises(ScenarioError, match=r"spreaders\.bar: no sling holds it; a sling 'to' one"):
        parse_scenario(text)


def test_nothing_hangs_from_it() -> None:
    text = one_bar().replace("{from: bar.B1", "{from: hook").replace("{from: bar.B2", "{from: hook")
    with pytest.raises(ScenarioError, match=r"spreaders\.bar: nothing hangs from it"):
        parse_scenario(text)


def test_a_circle() -> None:
    text = one_bar().replace("{from: hook, to: bar.A1", "{from: bar.B1, to: bar.A1")
    text = text.replace("{from: hook, to: bar.A2", "{from: bar.B2, to: bar.A2")
    with pytest.raises(ScenarioError, match=r"hangs in a circle \(bar -> bar\); at the top there is"):
        parse_scenario(text)


def test_slings_that_are_too_short() -> None:
    """Above and below share what is missing; the first of them in the lift file is named."""
    text = one_bar().replace("to: module.L1, length: 6 m", "to: module.L1, length: 5 m")
    text = text.replace("to: module.L2, length: 6 m", "to: module.L2, length: 5 m")
    with pytest.raises(
        StartError, match=r"slings\.up_1: the sling is 8 m, but from 'hook' to 'bar\.A1' it is"
    ):
        assemble(parse_scenario(text))


def test_a_unit_that_has_slipped() -> None:
    warnings = assemble(parse_scenario(one_bar().replace("mass: 3 t", "mass: 3 kg"))).warnings
    told = "spreader bar weighs 3 kg and may carry 80 t; a unit has slipped, kg for t"
    assert told in warnings
    assert told not in assemble(parse_scenario(one_bar())).warnings


def test_its_heading_is_that_of_the_load() -> None:
    text = one_bar().replace("position: [0 m, 0 m, 0 m]", "position: [0 m, 0 m, 0 m]\n  heading: 90 deg")
    bar = next(body for body in assemble(parse_scenario(text)).document["bodies"] if body["name"] == "bar")
    assert bar["joint"]["orientation"] == pytest.approx([0.5**0.5, 0.0, 0.0, 0.5**0.5], abs=1e-9)
