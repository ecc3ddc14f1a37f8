"""A load that comes down on its supports between samples.

Forces of supports were those of samples. A module of 100 t that comes down at 10 m/min is stopped by four
stiff supports within 60 ms, and each bears 440 kN, 112 % of its capacity. With samples 0.1 s apart it was
369 kN, and the check `support_force_of_capacity` was ok with 94 %. What several contacts of a landing
guide bear together is still that of samples: a bump that these miss is told.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.results.loads.guides import Guide
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.run_warnings import missed_bumps
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

SPEED, MASS, STIFFNESS = 10.0 / 60.0, 100e3, 200e6
LIFT = """
format: 1
lift: {{title: Set down}}
duration: 4 s
ground: {{level: 0 m, friction: 0.5}}
ropes: {{sling: {{axial_stiffness: 100 MN, mass: none, damping_time: 10 ms}}}}
load:
  name: module
  shape: {{box: [6 m, 4 m, 3 m]}}
  position: [0 m, 0 m, 1.3 m]
  weight: {{calculated: 100 t, contingency: 1.0}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs:
    A: {{at: [2 m, 1.5 m, 3 m]}}
    B: {{at: [2 m, -1.5 m, 3 m]}}
    C: {{at: [-2 m, 1.5 m, 3 m]}}
    D: {{at: [-2 m, -1.5 m, 3 m]}}
supports:
  stools:
    under: module
    grid: {{x: [-2 m, 2 m], y: [-1.5 m, 1.5 m]}}
    height: 1 m
    stiffness: 200 MN/m
    damping: 0.2 MN s/m
    friction: 0.3
    capacity: 40 t
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 12 m], hoist: {{speed: 10 m/min, acceleration: 0.1 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
  A: {{from: hook, to: module.A, length: 8.09 m}}
  B: {{from: hook, to: module.B, length: 8.09 m}}
  C: {{from: hook, to: module.C, length: 8.09 m}}
  D: {{from: hook, to: module.D, length: 8.09 m}}
plan:
  - {{step: lower, lower: hook, speed: 10 m/min, by: 0.5 m}}
simulation: {{sample_interval: {apart}}}
"""


def run_of(apart: str) -> Recording:
    return simulate(parse_scenario(LIFT.format(apart=apart)))


def test_a_set_down_between_samples_counts() -> None:
    """What comes with v on four springs k presses each with v √(4 k m)/4 = 373 kN beside its weight."""
    fine, coarse = run_of("2 ms"), run_of("0.1 s")
    assert max(float(coarse.column("contact_force", one.name).max()) for one in coarse.rig.supports) < 375e3
    for run in (fine, coarse):
        (over,) = checks_of(run, "support_force_of_capacity")
        assert over.verdict is Verdict.FAILED and over.value is not None
        assert over.value > SPEED * math.sqrt(4 * STIFFNESS * MASS) / 4 / (40e3 * 9.81)
        assert over.value * 40e3 * 9.81 == pytest.approx(439.8e3, rel=1e-3)
    assert not [one for one in coarse.attributes["warnings"] if one.startswith("samples")]


def test_a_recording_from_before_has_its_samples() -> None:
    run = run_of("0.1 s")
    kept = {name: one for name, one in run.variables.items() if not name.startswith("contact_peak")}
    old = Recording(kept, run.coordinates, run.attributes)
    (within,) = checks_of(old, "support_force_of_capacity")
    assert within.verdict is Verdict.OK and within.value == pytest.approx(0.94, abs=0.01)


@pytest.mark.parametrize(
    ("forces", "share", "is_told"),
    [
        ([0.0, 0.0, 0.5, 0.9, 0.5, 0.0, 0.0], 0.5, True),
        ([0.0, 0.0, 0.5, 0.9, 0.5, 0.0, 0.0], 0.06, True),
        ([0.0, 0.0, 0.5, 0.9, 0.5, 0.0, 0.0], 0.04, False),
        ([0.0, 0.45, 0.8, 0.9, 0.8, 0.45, 0.0], 0.5, False),
        ([0.9, 0.9, 0.9, 0.0, 0.0, 0.0, 0.0], 0.5, False),
        ([0.9, 0.9, 0.9, 0.6, 0.3, 0.0, 0.0], 0.5, False),
        ([0.0, 0.2, 0.7, 0.0, 0.0, 0.9, 0.9], 0.5, False),
    ],
    ids=["bump", "mostly of one", "of one contact", "followed", "taken away", "lifted", "less than 71 %"],
)
def test_bumps_and_what_is_none(forces: list[float], share: float, is_told: bool) -> None:
    """Forces over a capacity of 1 N, of a wall that guides, of which one of its two contacts has a share."""
    rig = Rig(guides=[Guide("post", "module", {"wall": ["wall/1", "wall/2"]}, capacity=1.0)])
    pressed = np.array([[share * force, (1.0 - share) * force] for force in forces])
    columns = {"time": 0.1 * np.arange(len(forces)), "contact_force": pressed}
    found = missed_bumps(rig, columns, {"contact": ["wall/1", "wall/2"]})
    assert bool(found) is is_told
    assert all(one.startswith("samples 0.10 s apart miss the peaks of landing guides: ") for one in found)
