"""Ground and supports of which a unit has slipped: passed, or told as something else.

Supports of 20 kN/m for 20 MN/m under a load of 60 t were told as "the load would tip over: its centre of
gravity ... is not well within the supports", and so were tracks on 200 kN/m: a crane that stands 0.00 m
beside the middle of its tracks was to be moved there. `allowed_pressure: 150 MPa` was in order and used by
0.1 %: GO. A corner of a crane 0.5 m lower for 5 mm was in order too.
"""

from __future__ import annotations

import pytest

from crawler_lift import BALLAST, BASE, BOOM, HOOK_BLOCK, WEIGHT, crawler_lift
from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from mechanics import G

_STANDS = """\
format: 1
lift: {{title: A load on supports}}
duration: 1 s
load:
  name: box
  shape: {{box: [12 m, 4 m, 6 m]}}
  position: [0 m, 0 m, 0.5 m]
  weight: {{calculated: 60 t}}
  inertia: homogeneous
  centre_of_gravity: {{at: [0.4 m, -0.1 m, 3 m]}}
  stands_on: stands
  lugs: {{a: {{at: [0 m, 0 m, 6 m]}}}}
supports:
  stands: {{under: box, grid: {{x: [-5 m, 5 m], y: [-1.5 m, 1.5 m]}}, height: 0.5 m, stiffness: {stiffness}}}
"""


def told(text: str) -> str:
    with pytest.raises(ScenarioError) as error:
        assemble(parse_scenario(text))
    (problem,) = error.value.problems
    return f"{problem.path}: {problem.sentence}"


def warned(text: str) -> list[str]:
    return [one for one in assemble(parse_scenario(text)).warnings if "the ground under c1" in one]


def test_supports_that_are_too_soft() -> None:
    """60 t on four supports of 20 kN/m: 60e3 * 9.81 / (4 * 20e3) = 7.36 m."""
    said = told(_STANDS.format(stiffness="20 kN/m"))
    assert said.startswith("supports.stands.stiffness: the load of 60 t would sink 7.36 m into 'stands'")
    assemble(parse_scenario(_STANDS.format(stiffness="2 MN/m")))  # 74 mm


def test_ground_that_is_too_soft_for_tracks() -> None:
    """All of the crane on four corners of 200 kN/m."""
    mass = BASE + BALLAST + WEIGHT + BOOM + HOOK_BLOCK
    said = told(crawler_lift(50e3, ground=200e3))
    sinks = mass * G / (4 * 200e3)
    assert f"cranes.c1.tracks.stiffness: 'c1' of 602 t would sink {sinks:.3g} m into this ground" in said


@pytest.mark.parametrize(
    ("tracks", "said"),
    [
        (", allowed_pressure: 10 MPa", ""),
        (", allowed_pressure: 150 MPa", "bears 150000 kPa, more than sound rock, 10000 kPa"),
        (", levels: {left.front: 0.2 m, right.back: -0.2 m}", ""),
        (", levels: {left.front: 0.5 m}", "differs by 0.500 m over tracks 8.4 m long or apart"),
        (", levels: {left.front: -9 m, left.back: -9 m, right.front: -9 m, right.back: -9 m}", ""),
    ],
    ids=["rock", "steel", "uneven", "a step", "a dock"],
)
def test_ground_as_none_is(tracks: str, said: str) -> None:
    """The bounds are 10 MPa, and 5 % of a gauge of 8.4 m, 0.42 m."""
    text = crawler_lift(50e3, tracks=tracks)
    if "allowed" in tracks:
        text = text.replace(", allowed_pressure: 150 kPa", "", 1)
    found = warned(text)
    assert len(found) == bool(said) and all(said in one for one in found)
