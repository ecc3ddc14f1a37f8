"""Messages that sent strangers the wrong way, or said what is not so.

Engineers wrote lifts from the pages alone. A speed of strand jacks in m/h was told that "units are metric".
A crane that upends a column about its foot was told that "falls of one hook alone come plumb by themselves",
which they do not while the foot stands. A hook block without reeving was refused, and not told that
'hook_block_mass' weighs it; and supports that a load slides onto later were "not under the load", with no
word on where else to put them.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario

LIFT = """\
format: 1
lift: {title: A module}
duration: 20 s
ground: {friction: 0.5}
ropes:
  sling: {axial_stiffness: 100 MN, mass: none}
load:
  name: module
  shape: {box: [6 m, 4 m, 3 m]}
  position: [0 m, 0 m, 1 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: keel
  lugs: {A: {at: [-2 m, 0 m, 3 m]}, B: {at: [2 m, 0 m, 3 m]}}
supports:
  keel: {under: module, grid: {x: [-2 m, 2 m], y: [-1 m, 1 m]}, height: 1 m, stiffness: 100 MN/m}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 11 m]
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
slings:
  A: {from: hook, to: module.A, length: 7.4 m, rope: sling}
  B: {from: hook, to: module.B, length: 7.4 m, rope: sling}
plan:
  - {step: hoist, hoist: hook, speed: 3 m/min, by: 2 m}
  - {step: hold, hold: until_end}
"""


def _refused(old: str, new: str) -> str:
    assert old in LIFT
    with pytest.raises(ScenarioError) as refusal:
        parse_scenario(LIFT.replace(old, new))
    return str(refusal.value)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "speed: 3 m/min, by",
            "speed: 20 m/h, by",
            "'20 m/h' is 0.33333 m/min; a speed is written like '3",
        ),
        (
            "    hoist: {",
            "    block: {mass: 6 t, height: 2 m}\n    hoist: {",
            "without 'reeving', the ropes that the hook hangs in; 'hook_block_mass' says what it weighs",
        ),
        (
            "x: [-2 m, 2 m], y",
            "x: [-2 m, 2 m, 8 m], y",
            "; what it comes down on elsewhere is a group with 'measured_from: world', places in the world",
        ),
    ],
)
def test_it_says_what_would_be_right(old: str, new: str, says: str) -> None:
    assert says in _refused(old, new)


def test_supports_in_the_world_are_what_the_message_says() -> None:
    """A second group, 8 m on, which the load does not stand on at the start."""
    later = "  later: {under: module, measured_from: world, grid: {x: [6 m, 10 m], y: [-1 m, 1 m]}"
    text = f"{later}, height: 1 m, stiffness: 100 MN/m}}\ncranes:\n"
    scenario = parse_scenario(LIFT.replace("cranes:\n", text))
    assert set(scenario.supports or {}) == {"keel", "later"}
