"""Forces raised to the design weight, against (K6) and what docs/concepts/checks.md says of ropes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks.design_weight import design_ratio, largest_ratios
from gantline.checks.forces import rope_force
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from sample_lift import ALONG, HOOK, LUGS, WEIGHT, sample_recording, sample_rig

G = 9.81
CONTINGENCY = 1.05
DENSITY = 1025.0
TENSION = 300e3  # of each of the five slings [N]
#: What their vertical parts bear together [N].
BORNE = sum(
    TENSION * (HOOK - 13.65) / math.hypot(x - along, y, HOOK - 13.65)
    for along, (x, y) in zip(ALONG, LUGS, strict=True)
)


def in_water(left: float) -> Recording:
    """The sample lift at rest, of whose load water leaves so much [N], whatever its slings bear."""
    rig = sample_rig()
    rig["loads"][0] |= {"simulated_mass": 300e3, "design_mass": CONTINGENCY * 300e3}
    rig["loads"][0] |= {"in_water": "block", "water_density": DENSITY}
    rest = sample_recording(np.zeros(1), tension=np.full((1, 5), TENSION), rig=rig)
    volume = np.full((1, 1), (WEIGHT - left) / (DENSITY * G))
    displaced = Variable(("time", "hull"), volume, "m^3", "displaced volume")
    variables = {**rest.variables, "displaced_volume": displaced}
    return Recording(variables, {**rest.coordinates, "hull": ["block"]}, rest.attributes)


@pytest.mark.parametrize(("left", "counts"), [(50e3, BORNE), (2.0e6, 2.0e6)])
def test_of_two_values_of_what_water_leaves_the_larger_counts(left: float, counts: float) -> None:
    """(K6), 1 + (c - 1) W/N: N by its weight is next to nothing of a load that floats, and that of slings
    is no less than what they bear; of one that is let down faster than it falls that of its weight is more.
    """
    recording = in_water(left)
    ratio = 1.0 + (CONTINGENCY - 1.0) * WEIGHT / counts
    assert largest_ratios(recording, ["block"]) == pytest.approx([ratio], rel=1e-9)
    assert design_ratio(recording, "block", series.everywhere(recording)) == pytest.approx(ratio, rel=1e-9)


LIFT = """\
format: 1
lift: {title: A box in the air}
duration: 10 s
ropes:
  sling: {axial_stiffness: 300 MN, mass: none}
  hoist: {axial_stiffness: 60 MN, mass: none}
load:
  name: box
  shape: {box: [4 m, 4 m, 4 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 100 t, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs: {T: {at: [0 m, 0 m, 4 m]}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 12 m]
    block: {mass: 6 t, height: 2 m}
    reeving: {ropes: 1, parts_each: 4, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 40 m}
    drum: {diameter: 1 m, layers: 1, wraps_at_start: 20}
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
slings: {T: {from: hook, to: box.T, length: 6 m, rope: sling}}
plan: [{step: hang, hold: until_end}]
"""


def test_a_hoist_rope_in_the_air_is_raised_as_a_whole() -> None:
    """c (W + hook block)/4 parts of line: the hook block is raised with the load, on the safe side."""
    rest = Statics(parse_scenario(LIFT)).equilibrium().recording
    force = rope_force(rest, "hoist.hook.1", series.everywhere(rest))
    assert force.static == pytest.approx(CONTINGENCY * (100e3 + 6e3) * G / 4.0, rel=1e-6)


def test_of_a_rope_over_sheaves_with_losses_the_tightest_segment_counts() -> None:
    """404 kN on one side of the sheave, 400 kN on the other: by the rule 1.2 x 404 kN."""
    rig = sample_rig()
    segments = ["sling.S1/0", "sling.S2/0"]
    rig["sheaves"] = [{"name": "e1.1", "rope": "e1.equalizing", "segments": segments, "ratio": 1.02}]
    rig["factors"] = {"dynamic_amplification_factor": {"value": 1.2, "source": "a test"}}
    tension = np.array([[400e3, 404e3, 400e3, 400e3, 400e3]])
    rest = sample_recording(np.zeros(1), tension=tension, rig=rig)
    force = rope_force(rest, "e1.equalizing", series.everywhere(rest))
    assert (force.static, force.rule) == pytest.approx((404e3, 1.2 * 404e3), rel=1e-12)
