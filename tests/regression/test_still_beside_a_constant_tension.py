"""A winch of constant tension under `mechanics` kept a load from ever hanging still.

Its motor asks for hauling in all the time and slips, so its drive works in every sample; only tuggers of
tag lines were excepted. Static values were then means over all of the lift since the load came clear. Two
slings that carry 196.2 kN until a third takes most of it had 158.5 kN, that third 75 kN of 262 kN, and a
lug that is used by 105 % with the design weight was ok at 94 %: GO WITH WARNINGS, where the same lift
without the winch is a NO-GO.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict
from gantline.results import series
from of_recording import check_of

LIFT = """\
format: 1
lift: {title: A third hook takes over beside a winch}
duration: 150 s
simulation: {sample_interval: 50 ms}
ground: {level: 0 m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}
  tag: {axial_stiffness: 1 MN, damping_time: 50 ms, mass: none}
load:
  name: module
  shape: {box: [10 m, 3 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 40 t, contingency: 1.1}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-4 m, 0 m, 3 m], main_plate: xz, capacity: 80 t}
    L2: {at: [4 m, 0 m, 3 m], main_plate: xz, capacity: 23 t}
    L3: {at: [0 m, 0 m, 3 m], main_plate: xz, capacity: 80 t}
cranes:
  H1: {type: fixed_hook, at: [-4 m, 0 m, 12.99 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
  H2: {type: fixed_hook, at: [4 m, 0 m, 12.99 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
  H3: {type: fixed_hook, at: [0 m, 0 m, 12.99 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
slings:
  S1: {from: H1, to: module.L1, length: 10 m, rope: sling}
  S2: {from: H2, to: module.L2, length: 10 m, rope: sling}
  S3: {from: H3, to: module.L3, length: 10.1 m, rope: sling}
mechanics:
  drums:
    winch:
      diameter: 0.8 m
      rotating_mass: 100 kg
      drive: {speed: 0.5 m/s, acceleration: 0.5 m/s^2, capacity: 1 kN}
  ropes:
    tag:
      rope: tag
      length: as_routed
      route:
        - {type: end, body: module, at: [0 m, 1.5 m, 0 m]}
        - {type: end, body: world, at: [0 m, 40 m, 1 m], drum: winch}
plan:
  - {step: pull, haul_in: winch, speed: 0.5 m/s, by: 72.5 m}
  - {step: up, hoist: [H1, H2], speed: 3 m/min, by: 2 m, starts: with_previous}
  - {step: take over, hoist: H3, speed: 3 m/min, by: 2.12 m, start_at: 60 s, starts: with_previous}
  - {step: end, hold: 3 s}
rules: {dynamic_amplification_factor: 1.1}
"""
WEIGHT = 40e3 * 9.81


@pytest.fixture(scope="module")
def recording() -> gantline.Recording:
    return gantline.simulate(gantline.parse_scenario(LIFT))


def test_static_forces_are_those_of_both_holds(recording: gantline.Recording) -> None:
    """W/2 at S1 and S2 before the third takes over; that third holds W less what both have left then."""
    metrics = recording.metrics()
    late = float(
        recording.column("rope_tension", "sling.S1")[-1] + recording.column("rope_tension", "sling.S2")[-1]
    )
    # The winch pulls down and aside with 1 kN over 38.5 m, by 30 mm of every metre at most: below 0.1 kN.
    for sling in ("S1", "S2"):
        assert metrics[f"static_sling_tension.sling.{sling}"] == pytest.approx(WEIGHT / 2, abs=100.0)
    assert metrics["static_sling_tension.sling.S3"] == pytest.approx(WEIGHT - late, abs=200.0)


def test_a_lug_past_its_capacity_at_a_hold_fails(recording: gantline.Recording) -> None:
    """196.2 kN x 1.1 of contingency x 1.1 of the rule over 23 t x 9.81 are 105 %."""
    lug = check_of(recording, "lug_load_of_capacity")
    assert lug.verdict is Verdict.FAILED
    assert lug.value == pytest.approx(WEIGHT / 2 * 1.1 * 1.1 / (23e3 * 9.81), rel=1e-3)


def test_hoisting_beside_the_winch_is_not_hanging_still(recording: gantline.Recording) -> None:
    """No window that lasts from before to after a hoist but the last one, of a run that moves to its end."""
    *still, _ = series.quiet_windows(recording)
    times = [(recording.time[one][0], recording.time[one][-1]) for one in still]
    ends = {step: time for time, _, step in recording.events("step_end")}
    begins = {step: time for time, _, step in recording.events("step_begin")}
    assert [begin >= ends["up"] and end <= begins["take over"] for begin, end in times] == [True, False]
    assert times[1][0] >= ends["take over"]
