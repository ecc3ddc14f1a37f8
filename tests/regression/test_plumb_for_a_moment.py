"""A hold that ends as the load swings through plumb: its swing read as 8 mm, and what it requires was `ok`.

The hooks of an engine of 420 t swung by 122 mm under their trolley for the minute of a hold, which reported
`load swing engine 0.008 m`: the sample at its end. Requirements of tilt and falls out of plumb looked at that
moment alone too. The engine then came down on the edge of its hatch.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.cli.hold_points import hold_points
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

#: Centre of gravity below the bearing [m], pull that holds the load aside and weight [N].
DEPTH, PULL, WEIGHT = 13.49, 13.2e3, 60e3 * 9.81
PERIOD = 2 * math.pi * math.sqrt(DEPTH / 9.81)  # 7.4 [s]
#: Of the line [N/m], which gives as the load comes along: (P - k L θ) L = W D θ, L = D less the 0.08 m by
#: which its end, 4 m aside, rises.
STIFFNESS, LEVER = 150e3 / 26.0, DEPTH - 0.08
FARTHEST = math.degrees(PULL * LEVER / (WEIGHT * DEPTH + STIFFNESS * LEVER**2))  # 1.13 [deg]

_LIFT = """\
format: 1
lift: {{title: A box on a hook that is let go of}}
duration: {end} s
ground: {{level: 0 m}}
ropes:
  sling: {{axial_stiffness: 188 MN, damping_time: 10 ms, mass: none}}
  tag: {{axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 4 m, 6 m]}}
  position: [0 m, 0 m, 6 m]
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 3 m]}}
  lugs: {{A: {{at: [-3 m, 1.5 m, 6 m]}}, B: {{at: [-3 m, -1.5 m, 6 m]}}, C: {{at: [3 m, 1.5 m, 6 m]}},
    D: {{at: [3 m, -1.5 m, 6 m]}}}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 22.43 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling, length: 11 m}}
slings: {{A: {{from: hook, to: box.A}}, B: {{from: hook, to: box.B}}, C: {{from: hook, to: box.C}},
  D: {{from: hook, to: box.D}}}}
tag_lines:
  back: {{at: [-4 m, 0 m, 3 m], to: [-30 m, 0 m, 9 m], rope: tag, pretension: {pull} kN}}
plan:
  - {{step: look, hold: {hold} s, cut: tag.back, report: [load_tilt],
     require: {{load_tilt: below {below} deg}}}}
  - {{step: end, hold: until_end}}
"""

#: Two and a quarter periods from its farthest a load goes through plumb; after two it is farthest.
PLUMB, FAR = 2.25 * PERIOD, 2.0 * PERIOD


def simulated(hold: float, below: float = 0.5, pull: float = PULL) -> Recording:
    text = _LIFT.format(hold=round(hold, 2), below=below, pull=pull / 1e3, end=round(hold + 5, 2))
    return simulate(parse_scenario(text))


def required(recording: Recording) -> Check:
    return next(one for one in check_recording(recording) if one.step == "look")


def test_a_swing_through_plumb_at_the_end_of_a_hold_is_a_warning() -> None:
    recording = simulated(PLUMB)
    found = required(recording)
    assert found.verdict is Verdict.WARNING
    assert "at the end alone: it is 1." in found.remark and "swings; hold it longer" in found.remark
    (reading,) = [line for line in hold_points(recording) if "load tilt" in line]
    farthest = float(reading.split("(up to ")[1].split(" deg in this hold)")[0])
    assert farthest == pytest.approx(FARTHEST, rel=0.01)  # read with two decimals


@pytest.mark.parametrize(
    ("hold", "below", "pull", "verdict"),
    [
        (FAR, 0.5, PULL, Verdict.FAILED),
        (PLUMB, 1.5, PULL, Verdict.OK),
        (PLUMB, 0.5, 100.0, Verdict.OK),
    ],
    ids=["farthest at the end", "within all along", "next to still"],
)
def test_what_the_end_tells_is_told_as_before(
    hold: float, below: float, pull: float, verdict: Verdict
) -> None:
    found = required(simulated(hold, below, pull))
    assert (found.verdict, found.remark) == (verdict, "")
