"""A sling that was cut and hung straight from a hook, of which the hook load was no number from then on.

What has parted is drawn as one point at its upper end; the way in which it pulls was that point's distance
from itself over none. The check of the crane's rating stood as `nan %`, and a peak of the hook load after
the cut was lost. Under equalizers, where the scenarios cut their slings, nothing of that happened.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from four_slings import LIFT
from gantline.checks import Check, check_recording
from gantline.scenario import parse_scenario

CUT = LIFT.replace("to: module.A, length: 8.6 m", "to: module.A, length: 8.6 m, cut_at: 15 s")


def test_hook_load_after_a_cut_is_that_of_the_slings_that_are_left() -> None:
    recording = gantline.simulate(parse_scenario(CUT))
    load = recording.column("hook_load", "crane")
    assert np.isfinite(load).all()
    # The load swings. In the mean the hook bears its weight, m Δv/Δt, and the upper halves of slings.
    rig, late = recording.rig, recording.time > 15.5
    time, weight = recording.time[late], rig.loads[0].weight
    speed = recording.column("body_velocity", rig.loads[0].body)[late, 2]
    halves = 0.0
    for sling in rig.slings:
        rope = rig.rope(sling.rope)
        assert rope is not None and sling.length is not None
        halves += rope.mass_per_length * sling.length / 2 * rig.gravity
    lasted = time[-1] - time[0]
    gained = weight / rig.gravity * (speed[-1] - speed[0]) / lasted
    mean = np.trapezoid(load[late], time) / lasted
    assert mean == pytest.approx(weight + halves + gained, rel=1e-4)


def test_no_check_is_held_against_what_is_no_number() -> None:
    checks: list[Check] = check_recording(gantline.simulate(parse_scenario(CUT)))
    assert not [one.name for one in checks if one.value is not None and np.isnan(one.value)]
