"""A module on a cargo barge at another tide began its lift elsewhere, and nothing said so.

Places of a load count from the origin of the world, decks float. With the water 1 m higher the module of
`off_a_barge` was in the lift file 1 m inside its grillage; rest put it on top, and the run began with slings
slacker by 1 m: it snatched its load off 7 s later than planned. With the water 1 m lower the slings began
almost taut. A run told of loads more than 1 m away from where they are in the file, and that is 1 m.
"""

from __future__ import annotations

import pytest

from gantline import simulate
from gantline.scenario import parse_scenario

#: 205 t displace 200 m³, 1 m over a deck of 20 m by 10 m, which is then 2 m above the water; the box of 10 t
#: lets it down by 10/205 m, and 0.05 m along with the box are no other tide.
LIFT = """\
format: 1
lift: {title: Off a deck at another tide}
duration: 1 s
start: rest
water: {density: 1025 kg/m^3, level: %LEVEL m}
ropes: {soft: {axial_stiffness: 20 MN, damping_time: 10 ms}}
load:
  name: box
  shape: {box: [2 m, 2 m, 2 m]}
  position: [%X m, 0 m, 2 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {top: {at: [0 m, 0 m, 2 m]}}
vessels:
  barge:
    draft: 1 m
    hull: {box: [20 m, 10 m, 3 m]}
    masses: {hull: {mass: 205 t, at: [10 m, 0 m, 1 m]}}
    radii_of_gyration: [4 m, 6 m, 7 m]
cranes:
  hook: {type: fixed_hook, at: [%X m, 0 m, 7.4 m], hoist: {speed: 6 m/min, acceleration: 1 m/s^2}}
slings: {S: {from: hook, to: box.top, length: 5 m, rope: soft}}
mechanics:
  bodies:
    deck:
      parent: barge
      at: [10 m, 0 m, 3 m]
      joint: {type: fixed}
      mass: 1 kg
      shape: {box: [20 m, 10 m, 1 m], centre: [0 m, 0 m, -0.5 m]}
  body_contacts:
    on_deck: {between: [box, deck], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
plan:
  - {step: end, hold: until_end}
"""


def told(level: float, along: float = 10.0) -> list[str]:
    """What is said of the place of the box, that far along a barge on water at that level [m]."""
    text = LIFT.replace("%LEVEL", f"{level}").replace("%X", f"{along}")
    warnings = simulate(parse_scenario(text)).attributes["warnings"]
    return [one for one in warnings if one.startswith("box starts")]


@pytest.mark.parametrize(
    ("level", "way", "stood", "slings"),
    [(0.8, "higher", "in", "slacker"), (-0.8, "lower", "above", "tighter")],
)
def test_another_tide(level: float, way: str, stood: str, slings: str) -> None:
    (says,) = told(level)
    assert says == (
        f"box starts 0.80 m {way} than the lift file has it, {stood} what bears it aboard barge: there it "
        f"stands, and its slings are {slings} by that; see its position, the level of the water and the draft"
    )


@pytest.mark.parametrize("level", [-0.2, 0.0, 0.2])
def test_what_is_rough(level: float) -> None:
    assert told(level) == []


def test_a_deck_that_trims_takes_its_load_along() -> None:
    """10 t 4 m from the middle trim the barge by some degrees, and the load goes down with its deck."""
    assert not [one for one in told(0.0, 14.0) if "what bears it" in one]
