"""A lift that ended while its load was hoisted: static values were means over that motion, without a word.

Static forces are means over the time at which the load hung still for 5 s. Where it never did, they are those
of the time since it came clear, moving or not, which is documented and was told nowhere in the lift's own
results: factors, utilisations and dynamic factors stood there as if it had been held.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

_LIFT = """\
format: 1
lift: {{title: A load that is never held}}
duration: {duration} s
ropes:
  sling: {{axial_stiffness: 40 MN, damping_time: 50 ms, mass: none}}
load:
  name: box
  shape: {{box: [4 m, 4 m, 2 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 20 t}}
  inertia: homogeneous
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-1 m, 1 m, 2 m]}}, B: {{at: [-1 m, -1 m, 2 m]}}, C: {{at: [1 m, 1 m, 2 m]}},
    D: {{at: [1 m, -1 m, 2 m]}}}}
ground: {{level: 0 m}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 12 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling, length: 10.2 m}}
slings:
  A: {{from: hook, to: box.A}}
  B: {{from: hook, to: box.B}}
  C: {{from: hook, to: box.C}}
  D: {{from: hook, to: box.D}}
plan:
  - {{step: hoist, hoist: hook, speed: 0.1 m/s, acceleration: 0.05 m/s^2, brake_from: 12 s}}
  - {{step: hold, hold: until_end}}
"""


def _lifted(duration: float) -> Recording:
    return simulate(parse_scenario(_LIFT.format(duration=duration)))


def _told(recording: Recording) -> dict[str, Check]:
    return {check.name: check for check in check_recording(recording)}


@pytest.mark.parametrize(("duration", "is_told"), [(18.9, True), (19.1, False)])
def test_static_values_of_motion_are_told(duration: float, is_told: bool) -> None:
    """The hook stands 2 s after its brake at 12 s, 0.1 m/s by 0.05 m/s^2, and at 19 s has for 5 s."""
    told = _told(_lifted(duration))
    assert ("hangs_still" in told) == is_told
    if is_told:
        check = told["hangs_still"]
        assert check.verdict is Verdict.WARNING
        assert "to 18.9 s, in which the plan moves it: hold the load still for 5 s" in str(check.remark)
