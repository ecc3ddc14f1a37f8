"""A load that hung from an equalizer alone for a while was told to have no tilt stiffness, as if all along.

A ship block of 800 t was turned over by two hooks with equalizers and a third without: "the slings of E1, E2
give it no tilt stiffness" stood on its first page, beside its tilt of 176 degrees, at which the third hook
held it. It holds while the slings of the third are off; now it says from when on.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.results.loads.tilting import loose_tilt

LIFT = """
format: 1
lift: {title: A beam under an equalizer and a hook}
duration: 60 s
ground: {level: 0 m, friction: 0.5}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 3 MN}
  equalizing: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 3 MN}
load:
  name: beam
  shape: {box: [10 m, 2 m, 1 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 0.5 m]}
  lugs:
    E1: {at: [-1 m, 0 m, 1 m]}
    E2: {at: [1 m, 0 m, 1 m]}
    H: {at: [4 m, 0 m, 1 m]}
cranes:
  main: {type: fixed_hook, at: [0 m, 0 m, 18 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
  third: {type: fixed_hook, at: [4 m, 0 m, 12 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
equalizers:
  e1:
    hangs_from: main
    heading: 0 deg
    rated_capacity: 100 t
    frame: {mass: 1 t, length: 3 m, width: 1 m, height: 1 m, centre_of_gravity_below_hook: 1.5 m}
    hinge: {axis: vertical, friction: 1 kN m}
    rope: equalizing
    rope_ends: {along: [-1.5 m, 1.5 m], below_hook: 2 m}
    fixed_sheaves: {along: [0 m], below_hook: 2 m, pitch_diameter: 1 m}
    moving_sheaves: {along: [-1 m, 1 m], below_hook: 4 m, pitch_diameter: 1 m, mass: 100 kg, guided: vertical}
    travel: {up: 1.5 m, down: 1.5 m}
sling_defaults: {rope: sling}
slings:
  E1: {from: e1.1, to: beam.E1, length: 11 m}
  E2: {from: e1.2, to: beam.E2, length: 11 m}
  H: {from: third, to: beam.H, length: 9 m}
plan:
  - {step: hang, hold: 10 s}
  - {step: let go, lower: third, by: 1 m, speed: 3 m/min}
  - {step: off, hold: until_end, detach: sling.H}
"""


def test_it_says_from_when_on() -> None:
    """1 m at 3 m/min, with ramps of 1 s, takes 21 s: the third hook's sling is off at 31 s."""
    recording = gantline.simulate(gantline.parse_scenario(LIFT))
    loose = loose_tilt(recording, recording.rig.loads[0])
    assert loose is not None and loose.since == pytest.approx(31.0, abs=0.1)
    alone = f"from {loose.since:.2f} s on, when it hangs from them alone, "
    assert str(loose).startswith(f"{alone}the slings of e1 give beam no tilt stiffness")


def test_one_that_hangs_so_from_the_first_needs_no_time() -> None:
    head, tail = LIFT.split("  H: {from: third")
    alone = head + "plan:" + tail.split("plan:")[1].split("  - {step: let go")[0]
    alone = alone.replace("    H: {at: [4 m, 0 m, 1 m]}\n", "")
    recording = gantline.simulate(gantline.parse_scenario(alone))
    loose = loose_tilt(recording, recording.rig.loads[0])
    assert loose is not None and loose.since is None
    assert str(loose).startswith("the slings of e1 give beam no tilt stiffness")
