"""A floating crane that slews: turned by its slewing or by its heading, its vessel's heel, momentum, swing.

The crane of `boom_lift` on a slewing axis 18 m behind its heel pins.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid
from scipy.optimize import brentq

import gantline
from boom_lift import (
    BELOW,
    BOOM,
    CENTRE,
    HEAD_GEAR,
    HEEL,
    HOOK_BLOCK,
    LENGTH,
    SHEAVE_BLOCK,
    boom_lift,
    simulated,
)
from gantline.scenario import parse_scenario
from mechanics import G

AXIS, LOAD = 80.0, 300e3
WEIGHT, BEHIND, HIGH = 900e3, 25.0, 6.0
ANGLE = math.radians(60.0)
RADIUS = HEEL[0] - AXIS + LENGTH * math.cos(ANGLE)
#: From the pin at the head to the bearing of the hook [m].
FALLS = HEEL[1] + LENGTH * math.sin(ANGLE) - 40.0
#: Of the barge [m], in the middle of which the axis is, and what it weighs without the crane [kg].
SIZE, HULL, HULL_HIGH = (160.0, 46.0, 9.0), 30e6, 5.0
SLEWS = "slewing: {speed: 0.3 rev/min, acceleration: 0.1 deg/s^2, emergency_acceleration: 0.5 deg/s^2}"


def slewing_lift(plan: str, *, slew: float = 0.0, where: str, drive: str = SLEWS, **rest: Any) -> str:
    """The crane with a counterweight on its upper structure, turned [deg] at the start."""
    weight = f"{{mass: {WEIGHT} kg, at: [{AXIS - BEHIND} m, 0 m, {HIGH} m]}}"
    base = (
        f"{where}    slewing_axis: [{AXIS} m, 0 m]\n    slew: {slew} deg\n    {drive}\n"
        f"    upper_masses: {{counterweight: {weight}}}\n"
    )
    text = boom_lift(plan, base=base, **rest)
    assert text.count("    outreach_from: 105.6 m\n") == 1
    return text.replace("    outreach_from: 105.6 m\n", "")


STANDS = "    position: [0 m, 0 m, 0 m]\n"
AFLOAT = f"""\
vessels:
  barge:
    draft: {{draft}} m
    position: [0 m, 0 m]
    hull: {{{{box: [{SIZE[0]} m, {SIZE[1]} m, {SIZE[2]} m]}}}}
    masses: {{{{all: {{{{mass: {HULL} kg, at: [{AXIS} m, 0 m, {HULL_HIGH} m]}}}}}}}}
    radii_of_gyration: [15 m, 40 m, 42 m]
"""


def afloat(plan: str, **rest: Any) -> str:
    crane = WEIGHT + BOOM + HEAD_GEAR + SHEAVE_BLOCK + HOOK_BLOCK + LOAD
    draft = (HULL + crane) / (1025.0 * SIZE[0] * SIZE[1])
    more = AFLOAT.format(draft=repr(draft))
    return slewing_lift(plan, where="    vessel: barge\n", more=more, **rest)


def test_slewed_is_turned() -> None:
    """A crane that stands, slewed by 37 deg, hoists as one whose axes are turned by 37 deg about its axis."""
    plan = "{step: hoist, hoist: fc.H1, speed: 3 m/min, by: 0.2 m}\n{step: end, hold: until_end}"
    turn = math.radians(37.0)
    one = simulated(slewing_lift(plan, slew=37.0, where=STANDS, duration=8.0))
    at = (AXIS * (1 - math.cos(turn)), -AXIS * math.sin(turn))
    turned = f"    position: [{at[0]!r} m, {at[1]!r} m, 0 m]\n    heading: 37 deg\n"
    other = simulated(slewing_lift(plan, where=turned, duration=8.0))
    for name in ("hook_load", "crane_radius", "off_lead", "side_lead", "boom_angle"):
        first, second = one[name].values, other[name].values
        assert np.abs(first - second).max() <= 1e-8 * max(1.0, np.abs(second).max()), name
    hooks = [recording.column("body_position", "fc.H1") for recording in (one, other)]
    assert np.abs(hooks[0] - hooks[1]).max() < 1e-8
    assert one.column("slew_angle", "fc") == pytest.approx(turn)
    assert other.column("slew_angle", "fc") == pytest.approx(0.0)
    # The falls stretch, and the hook's bearing stays under the pin.
    assert one.column("crane_radius", "fc.H1")[0] == pytest.approx(RADIUS, abs=1e-6)


@pytest.mark.parametrize("slew", [90.0, -90.0])
def test_heel_of_a_barge_whose_crane_is_slewed_to_its_side(slew: float) -> None:
    """A box with vertical sides: B aside by BM tan φ, higher by BM tan² φ/2; (G − B) is plumb.

    Of what hangs the weight pulls at the pin of the sheave blocks.
    """
    rest = gantline.Statics(parse_scenario(afloat("{step: hold, hold: until_end}", slew=slew))).equilibrium(
        0.0
    )
    ahead, high = RADIUS - LENGTH * math.cos(ANGLE), HEEL[1]
    lumps = [  # mass, aside to where the boom points, height
        (HULL, 0.0, HULL_HIGH),
        (WEIGHT, -BEHIND, HIGH),
        (BOOM, ahead + CENTRE * LENGTH * math.cos(ANGLE), high + CENTRE * LENGTH * math.sin(ANGLE)),
        (HEAD_GEAR + SHEAVE_BLOCK + HOOK_BLOCK + LOAD, RADIUS, high + LENGTH * math.sin(ANGLE)),
    ]
    mass = sum(lump for lump, _, _ in lumps)
    aside, height = (sum(lump[0] * lump[axis] for lump in lumps) / mass for axis in (1, 2))
    draft = mass / (1025.0 * SIZE[0] * SIZE[1])
    metacentric = SIZE[1] ** 2 / (12 * draft)

    def off_plumb(heel: float) -> float:
        tan = math.tan(heel)
        return aside - metacentric * tan + tan * (height - draft / 2 - metacentric * tan**2 / 2)

    heel = brentq(off_plumb, 0.0, 0.3, xtol=1e-14)
    assert SIZE[1] / 2 * math.tan(heel) < min(draft, SIZE[2] - draft), "neither deck nor bottom comes through"
    assert math.radians(2.0) < heel
    # Heel is positive to starboard, where y and the slew are negative. Stretched falls move nothing level.
    found = float(rest.recording.column("vessel_heel", "barge")[-1])
    assert found == pytest.approx(-math.copysign(heel, slew), rel=1e-6)
    assert float(rest.recording.column("vessel_trim", "barge")[-1]) == pytest.approx(0.0, abs=1e-9)


def test_a_barge_that_floats_free_turns_against_its_crane() -> None:
    """Water pushes a box without drag up and down alone: nothing turns barge and crane together.

    But that a hook block keeps its heading in the world as the vessel yaws: falls on a radius of no more than
    1 m, twisted by ψ, pull it back by W r² ψ/l. All else of the momentum of the crane is the barge's.
    """
    slewing = "{step: slew, slew: fc, speed: 0.3 rev/min, by: 60 deg}"
    plan = f"{{step: hold, hold: 2 s}}\n{slewing}\n{{step: end, hold: until_end}}"
    recording = simulated(afloat(plan, start="rest", duration=60.0))
    time, momentum = recording.time, recording["angular_momentum"].values[:, 2]
    yaw = yaw_of(recording.column("body_orientation", "barge"))
    assert recording.column("slew_angle", "fc")[-1] == pytest.approx(math.radians(60.0), abs=1e-9)
    twist = (HOOK_BLOCK + LOAD) * G * 1.0**2 * np.abs(yaw) / FALLS
    assert (np.abs(momentum) <= cumulative_trapezoid(twist, time, initial=0.0) + 1.0).all()
    crane = WEIGHT * BEHIND**2 + BOOM * (HEEL[0] - AXIS + 26.4) ** 2 + (HOOK_BLOCK + LOAD) * RADIUS**2
    assert np.abs(momentum).max() < 2e-3 * crane * 0.3 * 2 * math.pi / 60
    # By the shares of inertia: 0.6e9 + 2.9e9 + 1.9e9 of the crane, 53e9 of the barge, kg m^2.
    assert math.radians(-8.0) < yaw[-1] < math.radians(-4.0)
    assert recording.attributes["energy_remainder"] < 1e-5


def yaw_of(orientation: np.ndarray) -> np.ndarray:
    """From quaternions (n, 4) of a body that is near upright."""
    w, x, y, z = orientation.T
    return np.asarray(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))


def test_off_lead_and_energy_of_steady_slewing() -> None:
    """Falls hang out by ω² r'/g; boom, counterweight and what hangs have I ω²/2."""
    drive = "slewing: {speed: 0.3 rev/min, acceleration: 0.002 deg/s^2}"
    plan = "{step: round, slew: fc, speed: 0.3 rev/min, by: 5000 deg}"
    recording = simulated(slewing_lift(plan, where=STANDS, drive=drive, duration=1200.0))
    omega = 0.3 * 2 * math.pi / 60
    steady = recording.time > 1000.0
    reach = RADIUS / (1 - omega**2 * FALLS / G)
    lead = recording.column("off_lead", "fc.H1")[steady]
    # Speeding up by a at the head leaves a swing of 2 a/g at most; the mean over n swings has 1/(pi n) of it.
    swings = 200.0 / (2 * math.pi * math.sqrt(FALLS / G))
    left = 2 * math.radians(0.002) * RADIUS / G / (math.pi * swings)
    assert lead.mean() == pytest.approx(omega**2 * reach / G, abs=left)
    pins, level = HEEL[0] - AXIS, math.cos(ANGLE)
    inertia = WEIGHT * BEHIND**2 + (HOOK_BLOCK + LOAD) * reach**2 + HEAD_GEAR * RADIUS**2
    inertia += BOOM * (pins + CENTRE * LENGTH * level) ** 2 + 1.51e9 * level**2 + BOOM * 28.0**2 / 12
    inertia += SHEAVE_BLOCK * (RADIUS + BELOW * omega**2 * reach / G) ** 2
    kinetic = recording.column("energy", "kinetic")[steady]
    assert kinetic.mean() == pytest.approx(inertia * omega**2 / 2, rel=2e-3)
