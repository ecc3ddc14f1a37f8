"""Two slings of a load that was set down level came slack at once, and the step waiting for that never ended.

Along the course of a step both were found to carry nothing at a share of it that was 1e-14 s long. At its
end, evaluated where such a step leads, which is where it began, rounding had left 6e-9 N in one of them:
the step waited on, found the same share again, and "1000 steps on end have led nowhere" after 82.4 s. Now a
part that ends on a condition is not shorter than any other step may be, 1e-10 s, in which a sling that goes
slack comes down by more than rounding.
"""

from __future__ import annotations

import gantline
from gantline.scenario import parse_scenario
from of_recording import step_end

LIFT = """\
format: 1
lift: {title: A module slung anew}
duration: 150 s
ground: {level: 0 m, stiffness: 200 MN/m, damping: 10 MN s/m, friction: 0.4}
ropes:
  sling: {axial_stiffness: 150 MN, damping_time: 50 ms, minimum_breaking_force: 6 MN}
load:
  name: module
  shape: {box: [12 m, 6 m, 4 m]}
  position: [0 m, 0 m, 0 m]
  stands_on: ground
  weight: {calculated: 120 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs:
    inner_fore: {at: [3 m, 0 m, 4 m]}
    inner_aft: {at: [-3 m, 0 m, 4 m]}
    outer_fore: {at: [5 m, 0 m, 4 m]}
    outer_aft: {at: [-5 m, 0 m, 4 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 11 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
sling_defaults: {rope: sling}
slings:
  short_fore: {from: hook, to: module.inner_fore, length: 8 m}
  short_aft:  {from: hook, to: module.inner_aft,  length: 8 m}
  long_fore:  {from: hook, to: module.outer_fore, length: 14 m}
  long_aft:   {from: hook, to: module.outer_aft,  length: 14 m}
plan:
  - {step: clear,    hoist: hook, speed: 3 m/min, by: 1.5 m}
  - {step: look,     hold: 30 s}
  - {step: set down, lower: hook, speed: 3 m/min, until: {slings: slack}}
  - {step: further,  lower: hook, speed: 3 m/min, by: 0.5 m}
  - {step: slings off, hold: 30 s, detach: [sling.short_fore, sling.short_aft]}
  - {step: slings on,  hold: until_end, attach: [sling.long_fore, sling.long_aft]}
"""
#: A hook at 3 m/min brakes with 0.1 m/s^2.
BRAKES = 0.05 / 0.1


def test_a_step_that_waits_for_both_ends() -> None:
    """It brakes as the later one goes slack, within the tolerance of times of events, 1e-6 s."""
    recording = gantline.simulate(parse_scenario(LIFT))
    assert recording.attributes["status"] == "done"
    slack = [time for time, _, name in recording.events("slack") if name.startswith("sling.short")]
    end = step_end(recording, "set down")
    assert len(slack) == 2
    assert abs(end - BRAKES - max(slack)) < 1e-6
