"""What the ground carries of a load was "nothing in this lift has one".

A step with `report: [support_force]` of a load that stands on the ground, or on a deck, told nothing: only
`supports` of the lift file counted, though who takes up half of a load at a hold point asks for just that.
"""

from __future__ import annotations

import re

import pytest

import gantline
from four_slings import LIFT
from gantline.cli.hold_points import hold_points
from gantline.scenario import parse_scenario

#: 40 t, and the lower halves of four slings, 8.6 m of 44 mm with about 8 kg/m: 0.14 t [kN].
WEIGHT = (40.0 + 0.14) * 9.81
HALF = """\
plan:
  - {step: half, hoist: crane, speed: 0.3 m/min, acceleration: 0.05 m/s^2, until: {load_transferred: 50 %}}
  - {step: look, hold: 20 s, report: [support_force]}
  - {step: rest, hoist: crane, speed: 1 m/min, by: 0.3 m, report: [support_force]}
"""


def test_a_load_on_the_ground_is_told_by_what_that_carries() -> None:
    """Half of the weight, less what is taken up while it brakes; then nothing."""
    text = re.sub(r"plan:\n(  - .*\n)+", HALF, LIFT)
    recording = gantline.simulate(parse_scenario(text))
    told = [line for line in hold_points(recording) if "support force" in line]
    look, rest = (float(line.split("under module ")[1].split()[0].replace(",", "")) for line in told)
    share = float(recording.column("load_transferred", "module")[recording.time.searchsorted(20.0)])
    assert look == pytest.approx((1.0 - share) * WEIGHT, abs=1.0)
    assert 0.4 * WEIGHT < look < 0.5 * WEIGHT
    assert rest == 0.0
