"""What two hooks of one crane bore together between two samples was told by nothing.

A beam of 40 t that its hooks lift off at 12 m/min had 589.6 kN in both by samples of 20 ms, and 609.7 kN by
samples of 1 ms: 98.5 % of a capacity of 61 t, without a word, where 101.9 % were used. Peaks of either hook
by itself are kept over all steps; of sums of them the parabola through the largest sample and its neighbours
is told, as of all that is held against a limit sample by sample.
"""

from __future__ import annotations

import pytest

from gantline.checks import check_recording
from gantline.checks.check import Check, Verdict
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

LIFT = """
format: 1
lift: {title: Two hooks of one crane lift off fast}
duration: 3 s
ground: {level: 0 m, stiffness: 2000 MN/m, damping: 4 MN s/m, friction: 0.4}
ropes: {sling: {axial_stiffness: 188 MN, mass: 16.75 kg/m, damping_time: 1 ms}}
load:
  name: beam
  shape: {box: [12 m, 2 m, 2 m]}
  stands_on: ground
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0.7 m, 0 m, 1 m]}
  lugs: {A: {at: [5 m, 0 m, 2 m], capacity: 60 t}, B: {at: [-5 m, 0 m, 2 m], capacity: 60 t}}
cranes:
  h1: {type: fixed_hook, at: [ 5 m, 0 m, 5.99 m], hoist: {speed: 12 m/min, acceleration: 0.5 m/s^2}}
  h2: {type: fixed_hook, at: [-5 m, 0 m, 5.99 m], hoist: {speed: 12 m/min, acceleration: 0.5 m/s^2}}
hook_groups:
  both: {type: trolley, hooks: [h1, h2], rated_capacity: 61 t, rating_includes_hook_block: true}
sling_defaults: {rope: sling, length: 4 m}
slings: {A: {from: h1, to: beam.A}, B: {from: h2, to: beam.B}}
plan:
  - {step: off, hoist: [h1, h2], speed: 12 m/min, by: 0.4 m}
  - {step: hold, hold: until_end}
simulation: {sample_interval: INTERVAL}
"""


def _used(interval: str) -> Check:
    checks = check_recording(simulate(parse_scenario(LIFT.replace("INTERVAL", interval))))
    return next(check for check in checks if check.name == "hoist_load_of_rated_capacity")


def test_what_both_may_have_borne_between_samples_is_told() -> None:
    """Within its capacity by samples, past it by finer ones; the parabola is within 1 % of these."""
    coarse, fine = _used("20 ms"), _used("1 ms")
    assert fine.verdict is Verdict.FAILED
    assert coarse.value is not None and fine.value is not None
    assert coarse.value < 1.0 < fine.value
    said = "between two samples it may have come to "
    assert said in coarse.remark
    told = float(coarse.remark.partition(said)[2].partition(" %")[0]) / 100.0
    assert told == pytest.approx(fine.value, rel=0.01)
