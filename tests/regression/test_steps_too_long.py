"""Fixed steps of seconds, for milliseconds.

`step: 10 s` damps all that rings away: a lift of four slings had a dynamic factor of 1.000, its energy
balance closed, and it was GO.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario


@pytest.mark.parametrize(("step", "is_told"), [(10.0, True), (0.06, True), (0.05, False)])
def test_steps_that_damp_everything_are_told(step: float, is_told: bool) -> None:
    recording = gantline.simulate(parse_scenario(LIFT), integrator="del", step=step)
    said = [one for one in recording.attributes["warnings"] if one.startswith(f"steps of {step:g} s: ")]
    assert len(said) == is_told
