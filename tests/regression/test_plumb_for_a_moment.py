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
from held_aside import held_aside

#: Centre of gravity below the bearing [m], pull that holds the load aside and weight [N].
DEPTH, PULL, WEIGHT = 13.49, 13.2e3, 60e3 * 9.81
PERIOD = 2 * math.pi * math.sqrt(DEPTH / 9.81)  # 7.4 [s]
#: Of the line [N/m], which gives as the load comes along: (P - k L θ) L = W D θ, L = D less the 0.08 m by
#: which its end, 4 m aside, rises.
STIFFNESS, LEVER = 150e3 / 26.0, DEPTH - 0.08
FARTHEST = math.degrees(PULL * LEVER / (WEIGHT * DEPTH + STIFFNESS * LEVER**2))  # 1.13 [deg]

_LOOK = """\
  - {{step: look, hold: {hold} s, cut: tag.back, report: [load_tilt],
     require: {{load_tilt: below {below} deg}}}}"""

#: Two and a quarter periods from its farthest a load goes through plumb; after two it is farthest.
PLUMB, FAR = 2.25 * PERIOD, 2.0 * PERIOD


def simulated(hold: float, below: float = 0.5, pull: float = PULL) -> Recording:
    look = _LOOK.format(hold=round(hold, 2), below=below)
    ground = "ground: {level: 0 m}\n"
    text = held_aside(look, duration=round(hold + 5, 2), pull=pull / 1e3, more=ground)
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
