"""Charts of two cranes had no contingency at radii at which their load never hung still.

The design weight was held against the chart of a crane that lifts alone all the way, of cranes that lift
together at their holds only. Two crawler cranes hold 200 t at 16 m, 80 and 120 t by moments, luff out to
19.8 m and come back: with a contingency of 1.15 and 1.2 kept back for two cranes, (138 + 7) t x 1.2 = 174 t
hang by the rule where 170 t are rated. The check had 127 t x 1.2, 89 %, ok, unless the plan held there.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from crawler_pair import GEAR, MASSES
from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import check_of

#: Load, what of it hangs in c2, hook block [kg], contingency, factor of two cranes.
LOAD, SHARE, HOOK_BLOCK, CONTINGENCY, KEPT = 200e3, 0.6, 7e3, 1.15, 1.2
_CRANE = """\
  {name}:
    type: crawler
    position: [{x} m, 16 m]
    heading: 0 deg
    slew: -90 deg
    rating_includes_hook_block: true
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, stiffness: 2000 MN/m}}
{masses}    luffing: {{speed: 3 deg/min, acceleration: 0.005 deg/s^2, range: [30 deg, 82 deg]}}
    rating: {{radius: [12 m, 14 m, 16 m, 18 m, 20 m], rated: [360 t, 283 t, 231 t, 195 t, 168 t]}}
    hooks: {{H: {{type: H, height: 18 m}}}}
"""
_LIFT = """\
format: 1
lift: {{title: Two crawler cranes luff out and back}}
duration: {duration} s
{gear}load:
  name: beam
  shape: {{box: [28 m, 4 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 200 t, contingency: {contingency}}}
  centre_of_gravity: {{at: [2 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-12 m, 0 m, 3 m]}}, B: {{at: [-8 m, 0 m, 3 m]}}, C: {{at: [8 m, 0 m, 3 m]}},
    D: {{at: [12 m, 0 m, 3 m]}}}}
cranes:
{cranes}slings:
  A: {{from: c1.H, to: beam.A, length: {length!r} m, rope: sling}}
  B: {{from: c1.H, to: beam.B, length: {length!r} m, rope: sling}}
  C: {{from: c2.H, to: beam.C, length: {length!r} m, rope: sling}}
  D: {{from: c2.H, to: beam.D, length: {length!r} m, rope: sling}}
plan:
  - {{step: lift off, hoist: [c1.H, c2.H], speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: up, hoist: [c1.H, c2.H], speed: 4 m/min, by: 6 m}}
  - {{step: hold, hold: 15 s}}
  - {{step: out, luff: [c1, c2], speed: 3 deg/min, by: -3.5 deg}}
{there}  - {{step: in, luff: [c1, c2], speed: 3 deg/min, by: 3.5 deg}}
  - {{step: end, hold: until_end}}
rules: {{several_cranes: queensland}}
"""


def lifted(contingency: float = CONTINGENCY, there: str = "") -> Recording:
    """The lift as it was run, with a step between going out and coming in."""
    cranes = "".join(_CRANE.format(name=name, x=x, masses=MASSES) for name, x in (("c1", -10), ("c2", 10)))
    text = _LIFT.format(
        gear=GEAR,
        cranes=cranes,
        length=math.hypot(15.0, 2.0) + 0.01,
        contingency=contingency,
        there=there,
        duration=430 if there else 400,
    )
    return simulate(parse_scenario(text))


def _used_far_out(recording: Recording, contingency: float) -> tuple[float, float]:
    """By hand at the largest radius, as simulated and with contingency: over the chart there [1]."""
    radius = float(recording.column("crane_radius", "c2.H").max())
    assert 19.0 < radius < 20.0
    rated = np.interp(radius, [18.0, 20.0], [195e3, 168e3])
    simulated, design = (KEPT * (LOAD * SHARE * times + HOOK_BLOCK) / rated for times in (1.0, contingency))
    return float(simulated), float(design)


def test_the_design_weight_counts_between_holds() -> None:
    recording = lifted()
    check = check_of(recording, "hoist_load_of_rating")
    simulated, design = _used_far_out(recording, CONTINGENCY)
    assert simulated < 0.9 and design > 1.0
    assert check.element == "crane c2"
    assert check.value == pytest.approx(design, rel=5e-3)
    assert check.verdict is Verdict.FAILED
    assert "to the design weight x 1.2 / " in check.formula
    held = check_of(lifted(there="  - {step: look, hold: 20 s}\n"), "hoist_load_of_rating")
    assert check.value == pytest.approx(held.value, rel=5e-3)


def test_nothing_is_raised_without_contingency() -> None:
    """The peak as simulated: 1.2 times what hangs, over the chart at that moment."""
    recording = lifted(1.0)
    check = check_of(recording, "hoist_load_of_rating")
    rated = recording.rig.rating_charts[1].rated_at(recording.column("crane_radius", "c2.H"))
    hangs = np.where(rated > 0.0, recording.column("hoist_load", "c2.H") / np.maximum(rated, 1.0), 0.0)
    assert check.value == pytest.approx(KEPT * hangs.max(), rel=1e-3)
    assert check.value == pytest.approx(_used_far_out(recording, 1.0)[0], rel=5e-3)
