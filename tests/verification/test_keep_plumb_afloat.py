"""Booms afloat that keep falls plumb: what they look at is a mean, in which pitch and waves are none.

A look is the mean of n glances, T/n apart, and of a place P that accelerates it knows less: it is behind by
A P'' T^2 + B P''' T^3 + C P'''' T^4 with the numbers of the recursion of looks, A = 13/4 for one glance.
"""

from __future__ import annotations

import json
import math
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

import gantline
from gantline._core import Simulation
from gantline.assembly import assemble
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from luffing_along import (
    BOOM,
    HEEL,
    LOW,
    SLING,
    SPEED,
    WAIT,
    afloat,
    by_a_boom,
    hoisted,
    luffed_along,
    steady,
    way_by_circles,
)
from luffing_in_waves import in_waves

#: Glances of a look afloat, as `python/gantline/assembly/plan/followed.py` has it.
GLANCES = 10


@cache
def lags(glances: int) -> tuple[float, float, float]:
    """A, B and C, by looks at t^2/2, t^3/6, t^4/24 until only these are left: errors halve at each look."""
    found: list[Fraction] = []
    looks = 40
    for power in (2, 3, 4):

        def place(t: Fraction, power: int = power) -> Fraction:
            return t**power / math.factorial(power)

        drive, speed = Fraction(0), Fraction(0)
        before: tuple[Fraction, Fraction] | None = None
        behind = Fraction(0)
        for look in range(-looks, looks + 1):
            times = [look - Fraction(k, glances) for k in range(glances)]
            mean = (sum(times, Fraction(0)) / glances, sum(map(place, times), Fraction(0)) / glances)
            along = Fraction(0) if before is None else (mean[1] - before[1]) / (mean[0] - before[0])
            seen = mean[1] + along * (look - mean[0]) - drive
            behind = place(Fraction(look)) - drive
            wanted = along + (seen + (along - speed) / 2) / 2
            drive, speed, before = drive + (speed + wanted) / 2, wanted, mean
        known = sum((term * place_of(looks, power - 2 - k) for k, term in enumerate(found)), Fraction(0))
        found.append(behind - known)
    a, b, c = map(float, found)
    return a, b, c


def place_of(time: int, power: int) -> Fraction:
    """t^m/m!, which a lag of t^(m + 2)/(m + 2)! goes with."""
    return Fraction(time**power, math.factorial(power))


def test_glances_are_late_by_their_recursion() -> None:
    """13/4, -31/4, 631/48 of one. Of n with mean age c, mean square m: A = (3 + 2c) - m/2 + (c + 1/2)^2."""
    assert lags(1) == pytest.approx((13 / 4, -31 / 4, 631 / 48), rel=1e-9)
    for n in (2, GLANCES):
        c, m = (n - 1) / (2 * n), (n - 1) * (2 * n - 1) / (6 * n**2)
        assert lags(n)[0] == pytest.approx(3 + 2 * c - m / 2 + (c + 0.5) ** 2, rel=1e-9)


@pytest.mark.parametrize("glances", [2, GLANCES])
def test_a_boom_that_glances_luffs_as_two_circles_meet(glances: int) -> None:
    """Ashore, looks of 1 s with several glances: behind by A p'' T^2 + B p''' T^3.

    C p'''' T^4 may be missing. The load stretches sling and falls of 200 GN, as if the other end were hoisted
    by as much; 10 um at the head for what it swings.
    """
    assembly = assemble(parse_scenario(by_a_boom(luffed_along(17.0), inwards=True, angle=60.0)))
    (until,) = (step["until"] for step in assembly.document["plan"] if step["until"]["type"] == "follow")
    until["glances"] = glances
    simulation = Simulation(json.dumps(assembly.document), json.dumps(assembly.settings))
    simulation.run()
    columns, names = simulation.columns(), simulation.names()
    time, height = columns["time"], columns["body_position"][:, names["body"].index("far"), 2]
    up, boom = height - height[0], columns["joint_position"][:, names["joint"].index("fc.boom")]
    place = way_by_circles(60.0, inwards=True, by=17.0)
    second, third, fourth = (place.deriv(order)(up) * SPEED**order for order in (2, 3, 4))
    a, b, c = lags(glances)
    stretch = 0.55e6 / 2e11 * ((HEEL + BOOM - LOW - SLING) / 4 + 2 * SLING) * np.abs(place.deriv()(up))
    error = np.abs(boom - (place(up) - a * second - b * third))
    # The last look knows that the hoist slows down before the next one.
    during = (time > WAIT + 10.0) & (time < WAIT + 17.0 / SPEED - 1.0)
    assert BOOM * np.abs(a * second[during]).max() > 1e-3
    assert np.all(error[during] < (c * np.abs(fourth) + stretch + 1e-5 / BOOM)[during])


def on_a_barge(plan: str, duration: float) -> Recording:
    """A boom that luffs in, on a barge of 9000 t; ropes as they are."""
    lift = by_a_boom(plan, inwards=True, angle=60.0, tackles=True, rope=200.0, duration=duration)
    return gantline.simulate(parse_scenario(afloat(lift, angle=60.0)))


def test_a_boom_afloat_does_not_shake_its_vessel_up() -> None:
    """The barge pitches with 4.3 s and next to no damping, to which a boom that follows adds nothing.

    One that looked every second went along with that, and brought 0.03 deg to 0.36 deg within 150 s.
    """
    plan = """\
{step: kick, luff: fc, speed: 12 deg/min, by: 0.3 deg}
{step: creep, hoist: far, speed: 0.001 m/min, by: 6 mm}
{step: follow, luff: fc, starts: with_previous, speed: 12 deg/min, keep_plumb: fc.B}"""
    recording = on_a_barge(plan, 400.0)
    trim = np.degrees(recording.column("vessel_trim", "barge"))
    first, last = (np.ptp(trim[(recording.time > at) & (recording.time < at + 40.0)]) for at in (20.0, 340.0))
    assert first > 0.03
    assert last < first


def test_a_boom_afloat_looks_every_10_s_and_is_as_late() -> None:
    """A p'' T^2 of ten glances, T = 10 s, is up to 0.15 m at the head, on 48 m of falls and sling.

    That leans by 0.1 deg; as much again for the swing of a load that is not plumb as it begins.
    """
    recording = on_a_barge(luffed_along(17.0), 345.0)
    during, up = steady(recording, 17.0), hoisted(recording)
    late = lags(GLANCES)[0] * way_by_circles(60.0, inwards=True, by=17.0).deriv(2)(up) * (10.0 * SPEED) ** 2
    most = BOOM * late[during].max() / (HEEL + BOOM * math.sin(math.radians(60.0)) - LOW + SLING)
    falls = recording.column("falls_out_of_plumb", "fc.B")
    assert falls[during].max() < 2.0 * most
    trim = recording.column("vessel_trim", "barge")
    assert np.ptp(np.degrees(trim)) < 0.1


def test_a_boom_in_waves_looks_through_them() -> None:
    """Waves of 7 s, looks of 7 s: their mean is none, and the boom comes to where it comes in calm water.

    A drive that is calm takes its hook along no faster than 1 mm/s, so it is no more than 2 T of that behind:
    14 mm, and 20 mm in calm water with looks of 10 s. One glance sees 0.2 m of heave and pitch.
    """
    calm = gantline.simulate(in_waves("low: {height: 1 mm, period: 10 s, direction: 180 deg}"))
    waves = gantline.simulate(in_waves("swell: {height: 0.8 m, period: 7 s, direction: 180 deg}"))
    ends = [float(one.column("boom_angle", "sheerleg")[one.time > 395.0].mean()) for one in (calm, waves)]
    boom, head = 55.0, 55.0 * math.sin(ends[0])
    assert abs(math.radians(65.0) - ends[0]) * boom > 1.0
    assert abs(ends[1] - ends[0]) * head < 0.034
    hook = waves.column("body_position", "sheerleg.H1")[:, 2]
    assert np.ptp(hook[waves.time > 300.0]) > 0.2
