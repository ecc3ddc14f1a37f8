"""An extension sheave that hangs aside of its hook leant on the sling below it, and the lift was refused.

A sheave of 80 kg whose two lugs are 11 m beside the hook is pulled aside by the sling that runs over it, with
less than it weighs. The message was "the sling is 18 m, but from 'panel.A1' over 'X1' to 'panel.A2' it is
18.000097 m at the start; lower the hook or make the sling longer", and it was as much with a sling of 18.3 m:
no length but one of twice that would have helped.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.statics import Statics

LIFT = """
format: 1
lift: {title: A panel on extension sheaves}
duration: 20 s
ground: {level: 0 m, friction: 0.4}
ropes:
  sling: {axial_stiffness: 47 MN, damping_time: 10 ms, mass: none, minimum_breaking_force: 700 kN}
load:
  name: panel
  shape: {box: [30 m, 6 m, 0.6 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 0.3 m]}
  stands_on: ground
  lugs:
    A1: {at: [-13 m, 0 m, 0.6 m]}
    A2: {at: [-9 m, 0 m, 0.6 m]}
    A3: {at: [9 m, 0 m, 0.6 m]}
    A4: {at: [13 m, 0 m, 0.6 m]}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 20.6 m]
    rated_capacity: 60 t
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
extension_sheaves:
  X1: {mass: 80 kg}
  X2: {mass: 80 kg}
sling_defaults: {rope: sling}
slings:
  H1: {from: hook, to: X1, length: 15.5 m}
  H2: {from: hook, to: X2, length: 15.5 m}
  E1: {over: X1, to: [panel.A1, panel.A2], length: 18 m}
  E2: {over: X2, to: [panel.A3, panel.A4], length: 18 m}
plan:
  - {step: hoist, hoist: hook, by: 0.1 m, speed: 3 m/min}
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize("length", ["18 m", "18.3 m"])
def test_a_sling_that_holds_its_sheave_aside(length: str) -> None:
    """It pulls with no more than sheaves weigh, which are 160 kg, and the load stands all the same."""
    lift = gantline.parse_scenario(LIFT.replace("18 m}", f"{length}}}"))
    rest = Statics(lift).equilibrium(0.0)
    assert 0.0 < rest.recording.column("rope_tension", "sling.E1")[-1] < 160.0 * 9.81
    assert rest.recording.column("load_transferred", "panel")[-1] < 0.01


def test_a_hook_too_high_for_them_is_refused_as_before() -> None:
    with pytest.raises(gantline.ScenarioError, match="lower the hook or make the sling longer"):
        gantline.Simulation(gantline.parse_scenario(LIFT.replace("20.6 m]", "24.6 m]")))
