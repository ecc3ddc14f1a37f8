"""What a crane presses on the ground, and how near it is to tipping, had no contingency in it.

Supports, pins, hinges and charts had the design weight; ground under tracks, tipping lines and corners of
Goliath cranes had what was simulated. A crawler crane holds 255 t at 15 m over its front end, 72 % of what
tips it, within the 75 % for which cranes are rated; with the contingency of 1.1 it is at 79 %. The ground
under the ends of its tracks has two fifths more then, 514 kPa for 366 kPa, since what presses there is a
triangle that becomes shorter.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from crawler_lift import AHEAD, BEHIND, BOOM, CENTRE, HOOK_BLOCK, MATS, TRACK, WEIGHT, own_mass
from crawler_pair import GEAR, MASSES
from gantline.checks import Verdict, highest_pressure, highest_tipping
from gantline.results import series
from gantline.results.cranes.track_pressure import raised_forces
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from mechanics import G
from of_recording import check_of

#: Load, shackles and slings of no mass [kg], contingency, radius [m]; what the ground may bear [Pa].
LOAD, CONTINGENCY, RADIUS, ALLOWED = 255e3, 1.1, 15.0, 400e3
HANGS = """\
load:
  name: module
  shape: {{box: [6 m, 6 m, 4 m]}}
  position: [{radius} m, 0 m, 10 m]
  weight: {{calculated: 255 t, contingency: 1.1, simulate: {simulate}}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  lugs: {{A: {{at: [2 m, 2 m, 4 m]}}, B: {{at: [2 m, -2 m, 4 m]}}, C: {{at: [-2 m, -2 m, 4 m]}},
    D: {{at: [-2 m, 2 m, 4 m]}}}}
sling_defaults: {{rope: sling, length: 11 m}}
slings: {{A: {{from: {hook}, to: module.A}}, B: {{from: {hook}, to: module.B}},
  C: {{from: {hook}, to: module.C}}, D: {{from: {hook}, to: module.D}}}}
plan: [{{step: hold, hold: until_end}}]
simulation: {{tension_tolerance: 10 N}}
"""
CRAWLER = """\
format: 1
lift: {{title: A module over the front end}}
duration: 1 s
{gear}cranes:
  c1:
    type: crawler
    position: [0 m, 0 m]
    heading: {heading} deg
    slew: {slew} deg
    rating_includes_hook_block: true
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, {mats}, allowed_pressure: 400 kPa,
      stiffness: 1e5 MN/m}}
{masses}    rating: {{radius: [12 m, 20 m], rated: [360 t, 250 t]}}
    hooks: {{H: {{type: H, height: 24.6 m}}}}
"""


def held(simulate: str = "calculated", slew: float = 0.0, mats: str = "mats: 6 m") -> Recording:
    """The module in the hook of the crane, at rest; of the boom `slew` [deg] aside of the tracks."""
    crane = CRAWLER.format(
        gear=GEAR, masses=MASSES.replace("16 m", "15 m"), mats=mats, heading=-slew, slew=slew
    )
    text = crane + HANGS.format(hook="c1.H", radius=RADIUS, simulate=simulate)
    return Statics(parse_scenario(text)).equilibrium(time=0.0).recording


def moment(mass: float) -> float:
    """Of the crane and of what hangs, about the slewing axis towards the boom [kg m]."""
    return BOOM * (AHEAD + CENTRE * (RADIUS - AHEAD)) - WEIGHT * BEHIND + mass * RADIUS


def tipping_used(mass: float) -> float:
    """(CR4) over the front end, half a track ahead of the axis [1]."""
    return mass * (RADIUS - TRACK / 2) / (own_mass() * TRACK / 2 - moment(0.0))


def pressure(mass: float) -> float:
    """Under the front end of one of two tracks that share alike: a triangle, e > L/6 [Pa]."""
    total = own_mass() + mass
    out = moment(mass) / total
    assert TRACK / 6 < out < TRACK / 2
    return total / 2 * G * 2 / (3 * (TRACK / 2 - out)) / MATS


def test_the_moment_that_tips_it_is_that_of_the_design_weight() -> None:
    recording = held()
    check = check_of(recording, "moment_of_tipping_moment")
    simulated, design = (tipping_used(HOOK_BLOCK + LOAD * times) for times in (1.0, CONTINGENCY))
    assert simulated < 0.75 < design
    assert recording.column("tipping_utilisation", "c1")[-1] == pytest.approx(simulated, rel=2e-3)
    assert check.value == pytest.approx(design, rel=2e-3)
    assert check.verdict is Verdict.WARNING
    assert check.formula == "78.5 % with the design weight, 71.6 % simulated"
    assert highest_tipping(recording, recording.rig.crawlers[0], series.everywhere(recording)) == check.value


def test_the_ground_bears_the_design_weight() -> None:
    recording = held()
    check = check_of(recording, "ground_pressure_of_allowed")
    simulated, design = (pressure(HOOK_BLOCK + LOAD * times) for times in (1.0, CONTINGENCY))
    assert simulated < ALLOWED < design
    assert recording.column("ground_pressure", "c1.left.front")[-1] == pytest.approx(simulated, rel=5e-3)
    assert check.value == pytest.approx(design / ALLOWED, rel=5e-3)
    assert check.verdict is Verdict.FAILED
    crane = recording.rig.crawlers[0]
    largest = highest_pressure(recording, crane, series.everywhere(recording))
    assert largest == pytest.approx((check.value or 0.0) * ALLOWED)


@pytest.mark.parametrize("slew", [0.0, 30.0, 90.0])
@pytest.mark.parametrize("mats", ["mats: 6 m", "outrigger_mats: 6 m^2"])
def test_as_if_the_design_weight_were_simulated(slew: float, mats: str) -> None:
    """Over an end, a corner, a side; three corners bear it where one is clear."""
    as_checked, simulated = held("calculated", slew, mats), held("design", slew, mats)
    for name in ("moment_of_tipping_moment", "ground_pressure_of_allowed"):
        raised, asked = (check_of(one, name) for one in (as_checked, simulated))
        assert raised.value == pytest.approx(asked.value, rel=2e-3), name
        assert raised.element == asked.element
    hooks = [one.column("hook_load", "c1.H")[-1] for one in (as_checked, simulated)]
    assert hooks[1] == pytest.approx(CONTINGENCY * hooks[0], rel=1e-3)


def test_forces_of_three_corners_and_of_two() -> None:
    """600 kN in the middle and 300 kN at (6, 3) m of tracks of 8 m and a gauge of 6 m, raised by a half.

    The right end behind is clear from the start: with 450 kN there 2700 kN m about the middle line across,
    1350 kN m about the other, of 1050 kN. With 900 kN it tips: both at the back are clear.
    """
    level, middle, size = np.full(1, 600.0), np.zeros((1, 2)), (8.0, 6.0)
    of = np.array([[300.0 * 6.0 / 4.0, 300.0, 150.0, 0.0]])
    assert of.sum() == 900.0
    raised = raised_forces(of, level, middle, size, np.array([1.5]))[0]
    assert raised.sum() == pytest.approx(1050.0)
    assert raised[3] == 0.0
    assert (raised[0] - raised[1] + raised[2] - raised[3]) * 4.0 == pytest.approx(1.5 * 300.0 * 4.0)
    assert (raised[0] + raised[1] - raised[2] - raised[3]) * 3.0 == pytest.approx(1.5 * 600.0 * 3.0)
    tipped = raised_forces(of, level, middle, size, np.array([4.0]))[0]
    assert tipped.min() == 0.0
    assert raised_forces(of, level, middle, size, np.ones(1))[0] == pytest.approx(of[0])


GOLIATH = """\
format: 1
lift: {title: A module under a Goliath crane}
duration: 1 s
ropes:
  hoist: {axial_stiffness: 1e4 MN, damping_time: 10 ms, mass: none, diameter: 42 mm}
  sling: {axial_stiffness: 1e4 MN, damping_time: 10 ms, mass: none}
hook_types:
  H:
    block: {mass: 12 t, height: 3 m}
    reeving: {parts_each: 8, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 88 m}
    drum: {diameter: 1.6 m}
    hoist: {speed: 10 m/min, acceleration: 0.05 m/s^2}
cranes:
  gol:
    type: goliath
    rated_capacity: 400 t
    span: 148 m
    girder: {underside: 80 m, mass: 2600 t}
    legs: {fixed: 700 t, hinged: 450 t, bogies: 700 t, base: 32 m}
    travel: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-100 m, 100 m]}
    trolleys:
      one:
        mass: 300 t
        position: 10 m
        traverse: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-60 m, 60 m]}
        hooks: {A: {type: H, height: 24.6 m}}
"""


def test_corners_of_a_goliath_crane_bear_the_design_weight() -> None:
    """Each leg bears half of what hangs, but for 10 m of 148 m of span, and each corner half of that."""
    text = GOLIATH + HANGS.format(hook="gol.A", radius=10.0, simulate="calculated")
    recording = Statics(parse_scenario(text)).equilibrium(time=0.0).recording
    check = check_of(recording, "corner_load")
    corners = {one: recording.column("corner_load", one)[-1] for one in recording.coordinates["corner"]}
    heaviest = max(corners, key=lambda one: corners[one])
    share = (0.5 + math.copysign(10.0 / 148.0, 1.0 if "hinged" in heaviest else -1.0)) / 2
    if recording.rig.cranes[0].fixed_leg_at > 0:
        share = 0.5 - share
    more = (CONTINGENCY - 1.0) * LOAD * G * share
    assert check.value == pytest.approx(corners[heaviest] + more, rel=1e-6)
