"""A step that ended with the run was told to go on: NO VERDICT, "the run ends at 40 s in 'up'".

A plan acts on what is due before the end of an interval, and after the last there is none. So the hoist of a
lift whose steps add up to its duration, 19 s + 2 m / (0.1 m/s) + 0.1 m/s / (0.1 m/s²) = 40 s, came to rest
with the last sample, and its step never ended: no event, none of what it reports at its end, and exit code 4.
"""

from __future__ import annotations

import pytest

from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

LIFT = """\
format: 1
lift: {title: Ends as it ends}
duration: 40 s
ground: {level: 0 m}
ropes: {sling: {axial_stiffness: 50 MN, damping_time: 10 ms}}
load:
  name: load
  shape: {box: [4 m, 3 m, 2 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {A: {at: [-1 m, 0 m, 2 m]}, B: {at: [1 m, 0 m, 2 m]}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 12 m]
    rated_capacity: 50 t
    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}
slings:
  A: {from: hook, to: load.A, length: 5.1 m, rope: sling}
  B: {from: hook, to: load.B, length: 5.1 m, rope: sling}
plan:
  - {step: wait, hold: 19 s}
  - {step: up, hoist: hook, speed: 6 m/min, by: BY m, report: [hook_load]}
"""


def lifted(by: float, integrator: str) -> Recording:
    return simulate(parse_scenario(LIFT.replace("BY", str(by))), integrator=integrator)


@pytest.mark.parametrize("integrator", ["adaptive", "del", "explicit"])
def test_it_ends_with_the_run(integrator: str) -> None:
    recording = lifted(2.0, integrator)
    time, _, name = recording.events("step_end")[-1]
    assert name == "up" and time == pytest.approx(40.0, abs=1e-9)
    assert time <= recording.time[-1]
    assert "plan_finished" not in {one.name for one in check_recording(recording)}


@pytest.mark.parametrize("integrator", ["adaptive", "del", "explicit"])
def test_one_that_would_end_later_has_not_ended(integrator: str) -> None:
    """10 µm are 0.1 ms at 0.1 m/s."""
    recording = lifted(2.00001, integrator)
    assert [name for *_, name in recording.events("step_end")] == ["wait"]
    assert "plan_finished" in {one.name for one in check_recording(recording)}
