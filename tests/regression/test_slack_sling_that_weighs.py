"""A sling with nodes that is slack and is taken off.

`detached_slack` held the weight that hangs at its upper end against 1 % of its largest tension: a grommet of
120 kg/m, 20 m long, failed with the 21.8 kN that it weighs itself where the plan had let it down by 0.6 m.

From then on it falls from its hook, and what whips in it counted as its tension: 423 kN of a sling that had
carried 149 kN, so that factors on breaking force failed by a sling that nobody had on any more.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from mechanics import G
from of_recording import checks_of

PER_LENGTH, LENGTH, NODES, STRENGTH = 120.0, 20.0, 5, 400e3
LIFT = f"""
format: 1
lift: {{title: A heavy sling in the middle is taken off}}
duration: 40 s
ropes:
  steel: {{axial_stiffness: 100 MN, damping_time: 50 ms, mass: none}}
  grommet:
    axial_stiffness: 400 MN
    damping_time: 20 ms
    mass: {PER_LENGTH} kg/m
    minimum_breaking_force: {STRENGTH} N
load:
  name: column
  shape: {{box: [20 m, 3 m, 3 m]}}
  position: [0 m, 0 m, 20 m]
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs: {{a: {{at: [-9 m, 0 m, 3 m]}}, m: {{at: [1 m, 0 m, 3 m]}}, b: {{at: [9 m, 0 m, 3 m]}}}}
cranes:
  A: {{type: fixed_hook, at: [-9 m, 0 m, 43 m], hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}}}
  M: {{type: fixed_hook, at: [1 m, 0 m, 43 m], hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}}}
  B: {{type: fixed_hook, at: [9 m, 0 m, 43 m], hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: steel, length: {LENGTH} m}}
slings:
  A: {{from: A, to: column.a}}
  M: {{from: M, to: column.m, rope: grommet, rope_weight: distributed, rope_nodes: {NODES}}}
  B: {{from: B, to: column.b}}
plan:
  - {{step: wait, hold: 1 s}}
LET_DOWN  - {{step: off, hold: 12 s, detach: sling.M}}
"""
LET_DOWN = """\
  - {step: down, lower: M, speed: 2 m/min, until: {slings: slack, of: sling.M}}
  - {step: further, lower: M, speed: 2 m/min, by: 0.6 m}
  - {step: look, hold: 4 s}
"""


@cache
def run(let_down: str = LET_DOWN) -> Recording:
    return Simulation(parse_scenario(LIFT.replace("LET_DOWN", let_down))).run()


def off(recording: Recording) -> float:
    ((time, _, _),) = recording.events("detached")
    return time


def test_its_own_weight_may_hang_in_it() -> None:
    """At its upper end hangs all but what its lower end bears, 7/16 of a segment (page on rope weight).

    The last segment is slack: that is m g (1 - 7/16/6) = 21.83 kN, and 1 % of the largest is 1.5 kN.
    """
    (check,) = checks_of(run(), "detached_slack")
    assert check.verdict is Verdict.OK
    carried = run().metrics()["detaching_tension.sling.M"]
    weight = PER_LENGTH * LENGTH * G
    assert carried == pytest.approx(weight * (1.0 - 7 / 16 / (NODES + 1)), rel=1e-4)
    assert check.remark == f"it carried {carried / 1e3:.1f} kN and weighs {weight / 1e3:.1f} kN"


def test_one_that_carries_fails() -> None:
    """It bears the load as it did from the start: more than its weight and 1 % of that."""
    (check,) = checks_of(run(""), "detached_slack")
    assert check.verdict is Verdict.FAILED
    assert check.remark.endswith(
        "and weighs 23.5 kN; let its hook down until it is slack, and some decimetres more"
    )


def test_what_whips_in_it_afterwards_is_no_tension() -> None:
    """Its peak is what it carried at rest, upper end included; segments tell that it falls and whips."""
    recording = run()
    when = off(recording)
    tension = recording.column("rope_tension", "sling.M")
    assert np.abs(tension[recording.time > when + 1e-9]).max() == 0.0
    peak, time = series.rope_peak(recording, "sling.M")
    assert time < 2.0 < when
    assert peak == pytest.approx(tension[0], rel=1e-3)
    whips = recording.column("segment_tension", "sling.M/4")[recording.time > when]
    assert whips.max() > peak
    (factor,) = checks_of(recording, "rope_factor_on_breaking_force")
    assert factor.value == pytest.approx(STRENGTH / peak, rel=1e-3)
