"""Booms that luff, and cranes that slew, to keep falls plumb: their way by geometry, and how late.

A column of two lugs, L apart, hangs from a hook that hoists and from a boom of the length l. With plumb falls
the lug under the boom goes on the circle of the boom head, let down by the falls, and L from the other: it is
where two circles meet. With the boom at p over level and the lugs at t the rates are those that keep L:
p' = v sin t/(l sin(p + t)) of a boom that luffs in, and -v sin t/(l sin(p - t)) of one that luffs out.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from numpy.polynomial import Chebyshev

import gantline
from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.results.progress import spans
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.scenario.cranes.luffing import LuffingGear
from lift_text import changed
from luffing_along import (
    BOOM,
    HEEL,
    LINE,
    LOW,
    SLING,
    SPEED,
    TOP,
    WAIT,
    boom_by_circles,
    by_a_boom,
    hoisted,
    luffed_along,
    steady,
    way_by_circles,
)
from mechanics import G
from upending import by_crawlers

#: Time between looks [s], as `crates/gantline-core/src/plan/follow.rs` has it.
LOOK = 1.0
#: What a hook bears, half of the column and its hook block, and EA of hoist ropes and slings [N].
BORNE, STIFF = 0.55e6, 2e11
#: Angle of the boom at the start [deg], whether it luffs in, how far the other hook hoists [m].
CASES = [(60.0, True, 17.0), (40.0, True, 17.0), (78.0, True, 17.0), (60.0, False, 8.0), (70.0, False, 10.0)]


@cache
def run(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


def lugs_at(boom: FloatArray, hoisted: FloatArray, angle: float) -> FloatArray:
    """Sine of the angle of the lugs: one hoisted, the other lifted with the boom head."""
    lifted = BOOM * (np.sin(boom) - math.sin(math.radians(angle)))
    sine: FloatArray = (hoisted - lifted) / LINE
    return sine


def behind(place: Chebyshev, hoisted: FloatArray) -> tuple[FloatArray, FloatArray]:
    """How far a drive is behind a place by hoisted height, and the next term, which that leaves out."""
    second, third, fourth = (place.deriv(order)(hoisted) * SPEED**order for order in (2, 3, 4))
    late: FloatArray = 13 / 4 * second * LOOK**2 - 31 / 4 * third * LOOK**3
    return late, np.abs(631 / 48 * fourth * LOOK**4)


@pytest.mark.parametrize("case", CASES)
def test_rates_of_the_boom_are_those_of_the_circles(case: tuple[float, bool, float]) -> None:
    """v sin t/(l sin(p + t)) in and -v sin t/(l sin(p - t)) out, against the slope of a polynomial of p."""
    angle, inwards, by = case
    up = np.linspace(0.1, by, 50)
    place = way_by_circles(angle, inwards=inwards, by=by)
    boom = place(up)
    lugs = np.arcsin(lugs_at(boom, up, angle))
    rate = np.sin(lugs) / (BOOM * np.sin(boom + lugs if inwards else boom - lugs))
    assert place.deriv()(up) == pytest.approx(rate if inwards else -rate, rel=1e-9)


@pytest.mark.parametrize("settings", ["", ", integrator: del, step: 10 ms"], ids=["adaptive", "del"])
@pytest.mark.parametrize("case", CASES)
def test_the_boom_luffs_as_two_circles_meet(case: tuple[float, bool, float], settings: str) -> None:
    """Behind that by 13/4 p'' T^2 - 31/4 p''' T^3, as a trolley is; 631/48 p'''' T^4 may be missing.

    The 0.55 MN that the boom bears stretch its sling and four parts of falls of 200 GN, and as much of the
    other sling: a lug that is lower by s is as if the other were hoisted by s, which makes s dp/dz. 10 um at
    the head for what the load swings.
    """
    angle, inwards, by = case
    recording = run(by_a_boom(luffed_along(by), inwards=inwards, angle=angle, settings=settings))
    during, up = steady(recording, by), hoisted(recording)
    place = way_by_circles(angle, inwards=inwards, by=by)
    late, left_out = behind(place, up)
    falls = HEEL + BOOM - LOW - SLING
    stretch = BORNE / STIFF * (falls / 4 + 2 * SLING) * np.abs(place.deriv()(up))
    error = np.abs(recording.column("boom_angle", "fc") - (place(up) - late))
    assert BOOM * np.abs(late[during]).max() > 0.8e-3
    assert np.all(error[during] < (left_out + stretch + 1e-5 / BOOM)[during])


@pytest.mark.parametrize("case", [(60.0, True, 17.0), (60.0, False, 8.0)])
def test_a_boom_in_tackles_luffs_as_two_circles_meet(case: tuple[float, bool, float]) -> None:
    """Its drive counts rope, D = d(p0) - d(p), and is behind as that accelerates; dp = dD/(dD/dp).

    Under the load its ropes stretch, which the winch makes good: the boom stands where it does without. 0.2
    mm at the head for a boom that swings in its tackles as well.
    """
    angle, inwards, by = case
    recording = run(by_a_boom(luffed_along(by), inwards=inwards, angle=angle, tackles=True))
    during, up = steady(recording, by), hoisted(recording)
    back, over = TOP
    start = math.radians(angle)
    gear = LuffingGear(math.hypot(back, over), math.atan2(over, back), BOOM, start)

    def rope(z: FloatArray) -> FloatArray:
        return np.array([gear.taken_up(one) for one in boom_by_circles(z, angle, inwards=inwards)])

    late, left_out = behind(Chebyshev.interpolate(rope, 60, [0.0, by]), up)
    boom = boom_by_circles(up, angle, inwards=inwards)
    rate = np.array([gear.rate(one, one) for one in boom])
    error = np.abs(recording.column("boom_angle", "fc") - (boom - late / rate))
    pulls = recording.column("luffing_pull", "fc")
    assert np.ptp(pulls[during]) > 0.05 * pulls.max()
    assert np.all(error[during] < (left_out / rate + 0.2e-3 / BOOM)[during])


def test_the_boom_lifts_its_hook_as_it_luffs() -> None:
    """The hook goes up with the boom head, l (sin p - sin p0), and is told.

    Falls of 30 m that lean by b lift it by 30 m b^2/2 more; what the load's swing changes in their stretch, a
    share of b^2 of 20 um, is no more than a micron.
    """
    recording = run(by_a_boom(luffed_along(17.0), inwards=True, angle=60.0))
    boom = recording.column("boom_angle", "fc")
    height = recording.column("hook_height", "fc.B")
    up = BOOM * (np.sin(boom) - np.sin(boom[0]))
    assert up[-1] > 3.0
    leans = recording.column("falls_out_of_plumb", "fc.B").max()
    assert height - height[0] == pytest.approx(up, abs=30.0 * leans**2 / 2.0 + 1e-6)
    said = summary(recording, check_recording(recording), lambda verdict: verdict.value)
    (told,) = (line for line in said if "luffed to keep plumb" in line)
    assert (
        f"fc from 60.0 deg to {math.degrees(boom[-1]):.1f} deg, fc.B 38.0 m to {height[-1]:.1f} m high"
        in told
    )


def lowered_along(by: float) -> str:
    """Its own hook is lowered meanwhile as fast as its boom head comes up in the mean."""
    beside = f"{{step: lower, lower: fc.B, starts: with_previous, speed: 1 m/min, by: {by} m}}"
    return changed(luffed_along(17.0), ("{step: follow", f"{beside}\n{{step: follow"))


def test_its_own_hoist_makes_good_what_the_boom_lifts() -> None:
    """Lowered by u in all, the lug is where the circles meet whose other hook is hoisted by u more."""
    recording = run(by_a_boom(lowered_along(1.5), inwards=True, angle=60.0))
    up = hoisted(recording)[-1] + 1.5
    expected = boom_by_circles(np.array([up]), 60.0, inwards=True)[0]
    # At rest again, as near as falls of 30 m are plumb within 0.05 deg.
    assert recording.column("boom_angle", "fc")[-1] == pytest.approx(
        expected, abs=30 * math.radians(0.05) / BOOM
    )


def test_falls_stay_plumb_that_lean_without() -> None:
    """Behind by e on falls and slings of 33 m and 8 m; both accelerate with less than the boom head."""
    text = by_a_boom(luffed_along(17.0), inwards=True, angle=60.0)
    stands = changed(luffed_along(17.0), (", keep_plumb: fc.B", ", by: 0.001 deg"))
    led, held = run(text), run(by_a_boom(stands, inwards=True, angle=60.0))
    until = led.time < WAIT + 17.0 / SPEED
    worst = np.degrees(led.column("falls_out_of_plumb", "fc.B")[until].max())
    assert worst < 0.004
    assert np.degrees(held.column("falls_out_of_plumb", "fc.B")).max() > 4.0


@pytest.mark.parametrize("most", [2.0, 1.0])
def test_it_keeps_its_speed(most: float) -> None:
    """A boom that may luff at 1 or 2 deg/min goes no faster, and falls behind."""
    recording = run(by_a_boom(luffed_along(17.0, follow=most), inwards=True, angle=60.0))
    boom, every = np.degrees(recording.column("boom_angle", "fc")), float(np.diff(recording.time)[0])
    assert np.abs(np.diff(boom) / every).max() == pytest.approx(most / 60.0, rel=1e-6)


@pytest.mark.parametrize(("inwards", "tackles"), [(True, False), (True, True), (False, False)])
def test_it_stops_at_the_end_of_its_range(inwards: bool, tackles: bool) -> None:
    """At 62 deg, or 59 deg. The column turns on, and falls lean.

    In tackles it stands lower or higher by what their ropes stretch more or less than as it began: by less
    than they stretch in all, which are 24 parts of 2 GN between top and head.
    """
    limits = (50.0, 62.0) if inwards else (59.0, 70.0)
    recording = run(
        by_a_boom(
            luffed_along(17.0 if inwards else 8.0),
            inwards=inwards,
            angle=60.0,
            within=limits,
            tackles=tackles,
        )
    )
    boom = np.degrees(recording.column("boom_angle", "fc"))
    end = boom.max() if inwards else boom.min()
    stretch = 0.0
    if tackles:
        (back, over), at = TOP, math.radians(60.0)
        apart = math.hypot(BOOM * math.cos(at) - back, BOOM * math.sin(at) - over)
        gear = LuffingGear(math.hypot(back, over), math.atan2(over, back), BOOM, at)
        pull = recording.column("luffing_pull", "fc").max()
        stretch = math.degrees(pull * apart / (24 * 2e9) / abs(gear.rate(at, at)))
    assert end == pytest.approx(limits[1] if inwards else limits[0], abs=stretch + 1e-7)
    assert np.degrees(recording.column("falls_out_of_plumb", "fc.B")).max() > 1.0


def test_it_stands_where_no_luffing_brings_it_nearer() -> None:
    """Luffing out, boom and line of lugs come in line at 52.7 deg: the head goes along that line.

    There p = t, and l cos p0 + L = (l + L) cos p. It goes no farther out, and the column stands up from there
    with falls that lean.
    """
    recording = run(by_a_boom(luffed_along(17.0), inwards=False, angle=60.0))
    boom = recording.column("boom_angle", "fc")
    in_line = math.acos((BOOM * math.cos(math.radians(60.0)) + LINE) / (BOOM + LINE))
    assert boom.min() == pytest.approx(in_line, abs=math.radians(0.5))
    assert np.all(np.isfinite(recording.column("falls_out_of_plumb", "fc.B")))


SLEWS = "    slewing: {speed: 60 deg/min, acceleration: 0.1 deg/s^2}\n"
TRAVELS = "    travel: {speed: 1 km/h, acceleration: 0.05 m/s^2, range: [-10 m, 50 m]}\n"


def slewed_along(tilt: float, also: str = "") -> str:
    """A tail crane on hard ground, its boom across the column, that slews along as the main crane hoists."""
    plan = f"""\
{{step: lift, hoist: [main.H, tail.H], speed: 2 m/min, by: 4 m}}
{{step: upend, hoist: main.H, speed: 3 m/min, until: {{load_tilt: {{above: {tilt} deg}}}}}}
{{step: follow, slew: tail, starts: with_previous, speed: 60 deg/min, keep_plumb: tail.H}}
{also}{{step: rest, hold: 20 s}}"""
    hard = ("mats: 6 m}", "mats: 6 m, stiffness: 1000000 MN/m}")
    return changed(by_crawlers(plan), (TRAVELS, SLEWS), hard)


def test_a_crane_slews_along_on_its_circle() -> None:
    """Heads are L cos t = sqrt((L - R sin s)^2 + R^2 (1 - cos s)^2) apart: that is s by t. R = 16 m.

    The load turns so that its lugs are below the heads. So falls lean along the line between the heads, at
    the angle b to the way of the boom head: less by cos b along that way, and a radian of slewing makes good
    less by cos b as well. A drive that makes good only k = cos^2 b of what it counts on is behind by
    (13/4 s'' T^2 - 31/4 s''' T^3)/k by the recursion in the theory; the next term is below 14/k^2 s'''' T^4.

    The lug goes across that line with the acceleration a = R (s'' sin b + s'^2 cos b), for which it leans by
    up to aH/g on H = 57 m of falls and slings, and as much again as it swings. That is seen with tan b.
    """
    recording = run(slewed_along(25.0))
    line, radius, speed = 38.0, 16.0, 0.05
    (begins, ends) = spans(recording)["upend"]
    slewed = recording.column("joint_position", "tail.upper")
    slewed = slewed[0] - slewed
    up = line * np.sin(recording.column("load_tilt", "column"))

    def circle(hoisted: FloatArray) -> FloatArray:
        """(d - R sin s)^2 + R^2 (1 - cos s)^2 = (L cos t)^2."""
        along, across = 2 * line * radius, 2 * radius**2
        less = line**2 + 2 * radius**2 - (line**2 - hoisted**2)
        found: FloatArray = np.arcsin(less / math.hypot(along, across)) - math.atan2(across, along)
        return found

    place = Chebyshev.interpolate(circle, 60, [0.0, line * math.sin(math.radians(26.0))])
    during = (recording.time > begins + 15.0) & (recording.time < ends - 2.5)
    up, slewed = up[during], slewed[during]
    first, second, third, fourth = (place.deriv(order)(up) * speed**order for order in (1, 2, 3, 4))
    askew = slewed + np.arctan2(radius * (1 - np.cos(slewed)), line - radius * np.sin(slewed))
    kept = np.cos(askew) ** 2
    late = (13 / 4 * second * LOOK**2 - 31 / 4 * third * LOOK**3) / kept
    across = radius * (second * np.sin(askew) + first**2 * np.cos(askew))
    leans = 2 * across * 57.0 / G * np.tan(askew) / np.cos(askew)
    error = radius * np.abs(slewed - (place(up) - late))
    assert kept.min() < 0.97
    assert np.all(error < radius * 14 / kept**2 * np.abs(fourth) * LOOK**4 + leans + 1e-6)


def test_a_crane_that_slews_may_luff_as_well() -> None:
    """At 60 deg slewing alone goes across the line of lugs, and no nearer; with luffing falls stay plumb."""
    also = "{step: too, luff: tail, starts: with_previous, speed: 3 deg/min, keep_plumb: tail.H}\n"
    both, alone = run(slewed_along(60.0, also)), run(slewed_along(60.0))
    worst: list[float] = []
    for recording in (both, alone):
        (begins, ends) = spans(recording)["upend"]
        during = (recording.time > begins) & (recording.time < ends - 2.5)
        worst.append(float(np.degrees(recording.column("falls_out_of_plumb", "tail.H")[during].max())))
    assert worst[0] < 0.1
    assert worst[1] > 2.0
