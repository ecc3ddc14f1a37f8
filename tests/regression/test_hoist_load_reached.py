"""Steps that wait for a hoist load, where falls weigh something.

Hoist load is hook load, hook block and hanging falls, in recordings, checks and tables at hold points. A step
with `until: {hoist_load: ...}` waited for the tensions of the falls at their lower ends alone, without the
upper halves of their weight: at 1602 kN of a floating crane 1702 kN hung, 29 % of its share of a load that
was to be taken over to 25 %.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import BASE, spoiled
from of_recording import step_end

#: Falls of 4 x 18 m and more of 60 kg/m: upper halves of 22 kN.
_CRANE = """at: [0 m, 0 m, 20 m]
    rated_capacity: 100 t
    block: {mass: 2 t, height: 2 m}
    reeving: {parts_each: 4, rope: heavy, sheave_diameter: 0.6 m, upper_sheaves_at: 40 m}
    drum: {diameter: 1 m}"""
_PLAN = """\
  - {step: up, hoist: hook, speed: 0.6 m/min, until: {hoist_load: {hook: hook, above: 400 kN}}}
  - {step: down, lower: hook, speed: 0.6 m/min, until: {hoist_load: {hook: hook, below: 200 kN}}}
"""
_CHANGES = (
    ("at: [0 m, 0 m, 20 m]\n    rated_capacity: 100 t", _CRANE),
    ("ropes:\n", "ropes:\n  heavy: {axial_stiffness: 300 MN, damping_time: 2 ms, mass: 60 kg/m}\n"),
    ("duration: 20 s", "duration: 100 s"),
    (
        "simulation: {integrator: del, step: 1 ms, sample_interval: 20 ms}",
        "simulation: {sample_interval: 5 ms, gravity: 9.7 m/s^2}",
    ),
)


def test_the_hoist_load_is_that_of_recordings() -> None:
    begin, end = BASE.index("  - {step: hoist"), BASE.index("limits:")
    text = BASE[:begin] + _PLAN + BASE[end:]
    for old, new in _CHANGES:
        text = spoiled(old, new, text)
    recording = simulate(parse_scenario(text))
    load = recording.column("hoist_load", "hook")
    assert recording.rig.hooks[0].falls_weight_above > 20e3  # N: otherwise nothing is tested
    for step, wanted in (("up", 400e3), ("down", 200e3)):
        ended = step_end(recording, step)
        # From 0.6 m/min a hoist brakes within 0.01/0.1 = 0.1 s: the condition was met that long before.
        assert np.interp(ended - 0.1, recording.time, load) == pytest.approx(wanted, rel=5e-3)
