"""A girder on two trestles, one under each end.

It was told that its centre of gravity, 1 m along it from the middle between trestles 34 m apart, is not well
within them and should be moved towards the middle, which helps nothing: two points hold nothing upright.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario

_LIFT = """\
format: 1
lift: {{title: A girder on trestles}}
duration: 1 s
load:
  name: girder
  shape: {{box: [42 m, 2.4 m, 2.8 m]}}
  position: [0 m, 0 m, 0.5 m]
  weight: {{calculated: 84 t}}
  centre_of_gravity: {{at: [1 m, 0 m, 1.5 m]}}
  stands_on: trestles
  lugs: {{a: {{at: [0 m, 0 m, 2.8 m]}}}}
supports:
  trestles: {{under: girder, grid: {{x: [-17 m, {end}], y: {y}}}, height: 0.5 m, stiffness: 100 MN/m}}
"""


def told(y: str, end: str = "17 m") -> str:
    with pytest.raises(ScenarioError) as error:
        assemble(parse_scenario(_LIFT.format(y=y, end=end)))
    (problem,) = error.value.problems
    return f"{problem.path}: {problem.sentence}"


def test_supports_in_one_line_are_told_as_that() -> None:
    assert told("[0 m]") == (
        "supports.trestles: the load would tip over: its supports stand in one line, and each carries at one "
        "point; place some to either side of that line, as under both edges of the load"
    )


def test_a_centre_of_gravity_beside_its_supports_is_told_as_that() -> None:
    assert "its centre of gravity, with rigging, is at (1, 0) m" in told("[-0.8 m, 0.8 m]", "0.5 m")


def test_supports_to_either_side_hold_it() -> None:
    """Springs k, four, b from the middle, under W, a from it: W/4k, and W a²/4kb² more below the weight."""
    held = assemble(parse_scenario(_LIFT.format(y="[-0.8 m, 0.8 m]", end="17 m")))
    (girder,) = (body for body in held.document["bodies"] if body["name"] == "girder")
    sinks = 84e3 * 9.81 / (4 * 100e6) * (1 + 1 / 17**2)
    assert girder["joint"]["position"][2] == pytest.approx(0.5 + 1.5 - sinks, abs=1e-9)
