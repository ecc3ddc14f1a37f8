"""Warnings of steps that keep falls plumb and would have to go faster than they may."""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed
from luffing_along import BOOM, LUG, by_a_boom, heel_of, luffed_along
from luffing_along import LINE as LUGS
from upending import LINE, between_trolleys, by_crawlers, upended


def warned(text: str) -> list[str]:
    return [one for one in assemble(parse_scenario(text)).warnings if "falls behind" in one]


@pytest.mark.parametrize("by", [17.0, 10.0])
def test_from_where_on_it_falls_behind(by: float) -> None:
    """v tan(t): behind from atan(2/4) on, and asin(by/l) in the end."""
    (warning,) = warned(between_trolleys(upended(by, follow=2.0)))
    end = math.asin(by / LINE)
    assert f"step 'follow' falls behind from {math.degrees(math.atan(0.5)):.1f} deg of the lugs" in warning
    needed = f"4.0 m/min x tan {math.degrees(end):.1f} deg = {4.0 * math.tan(end):.1f} m/min"
    assert f"would have to go {needed}, and may go 2.0 m/min; hoist slower there" in warning


@pytest.mark.parametrize(
    ("by", "hoist", "told"),
    [("by: 17.0 m", 4.0, False), ("by: 18.9 m", 4.0, True), ("by: 18.9 m", 1.0, False)],
)
def test_it_is_told_where_the_way_needs_it(by: str, hoist: float, told: bool) -> None:
    """Of 10 m/min: 4 tan 63.5 deg = 8.0 m/min, 4 tan 84.1 deg = 38.8 m/min, 1 tan 84.1 deg = 9.7 m/min."""
    text = changed(between_trolleys(upended(hoist=hoist)), ("by: 17.0 m", by))
    assert bool(warned(text)) is told


@pytest.mark.parametrize(
    ("end", "told"),
    [
        ("to: 55 m", False),
        ("to: 56.9 m", True),
        ("until: {load_tilt: {above: 60 deg}}", False),
        ("until: {load_tilt: {above: 70 deg}}", True),
        ("brake_from: 200 s", False),  # nothing is known of where it ends
    ],
)
def test_ends_that_tell_the_angle(end: str, told: bool) -> None:
    """4 tan 68.2 deg = 10 m/min; hook A is at 38 m, 17 m higher it is 63.5 deg and 18.9 m higher 84.1 deg."""
    assert bool(warned(changed(between_trolleys(upended()), ("by: 17.0 m", end)))) is told


def test_hooks_that_are_hoisted_alike_turn_nothing() -> None:
    plan = """\
{step: lift, hoist: [main.H, tail.H], speed: 2 m/min, by: 40 m}
{step: follow, travel: tail, starts: with_previous, speed: 0.1 m/min, keep_plumb: tail.H}"""
    assert not warned(by_crawlers(plan))


@pytest.mark.parametrize(("heading", "askew"), [(180, None), (150, None), (130, 50), (90, 90)])
def test_a_crane_that_goes_across_the_lugs_is_told(heading: int, askew: int | None) -> None:
    """The lugs lie along x; the crane goes along its heading, there and back."""
    plan = """\
{step: upend, hoist: main.H, speed: 2 m/min, by: 10 m}
{step: follow, travel: tail, starts: with_previous, speed: 1 km/h, keep_plumb: tail.H}"""
    text = changed(
        by_crawlers(plan),
        ("heading: 180 deg", f"heading: {heading} deg"),
        ("slew: -270 deg", f"slew: {-90 - heading} deg"),
    )
    told = [one for one in assemble(parse_scenario(text)).warnings if "between the lugs" in one]
    expected = f"step 'follow': 'tail' goes at {askew} deg to the line between the lugs as it starts"
    assert [one.partition(";")[0] for one in told] == ([] if askew is None else [expected])


def of_boom(text: str) -> list[str]:
    told = assemble(parse_scenario(text)).warnings
    return [one for one in told if one.startswith("step 'follow'")]


@pytest.mark.parametrize(("inwards", "by", "end"), [(True, 17.0, 65.56), (False, 8.0, 57.52)])
def test_a_boom_that_falls_behind_is_told(inwards: bool, by: float, end: float) -> None:
    """v sin t/(l sin(p + t)), or of one that luffs out sin(p - t), at the end of the hoist.

    There sin t = (h - l (sin p - sin 60 deg))/L; p is that of the run, which comes there in verification.
    """
    boom = math.radians(end)
    lugs = math.asin((by - BOOM * (math.sin(boom) - math.sin(math.radians(60.0)))) / LUGS)
    most = 4.0 * math.sin(lugs) / (BOOM * math.sin(boom + lugs if inwards else boom - lugs))
    for share, told in ((1.01, False), (0.9, True)):
        follow = share * math.degrees(most)
        text = by_a_boom(luffed_along(by, follow=follow), inwards=inwards, angle=60.0)
        warnings = of_boom(text)
        assert bool(warnings) is told
    assert (
        f"would have to go {math.degrees(most):.1f} deg/min, and may go {follow:.1f} deg/min" in warnings[0]
    )


@pytest.mark.parametrize(
    ("inwards", "by", "within"),
    [(True, 17.0, (40.0, 62.0)), (False, 16.0, (15.0, 85.0)), (False, 8.0, (59.0, 85.0))],
)
def test_a_boom_that_does_not_reach_is_told(inwards: bool, by: float, within: tuple[float, float]) -> None:
    """l (cos 60 deg - cos p) = L (1 - cos t) in, and out l (cos p - cos 60 deg): t of the end of the range.

    Luffing out ends where boom and line of lugs come in line, l cos 60 deg + L = (l + L) cos t.
    """
    ends = [BOOM * abs(math.cos(math.radians(60.0)) - math.cos(math.radians(end))) for end in within]
    of_range = math.acos(1.0 - (ends[1] if inwards else ends[0]) / LUGS) if within[0] != 15.0 else math.pi
    in_line = math.acos((BOOM * 0.5 + LUGS) / (BOOM + LUGS)) if not inwards else math.pi
    reach = math.degrees(min(of_range, in_line))
    (warning,) = of_boom(by_a_boom(luffed_along(by), inwards=inwards, angle=60.0, within=within))
    assert f"falls do not stay plumb from {reach:.1f} deg of the lugs over level on" in warning
    assert f"begin with it {'less steep' if inwards else 'steeper'}" in warning


def test_a_boom_across_the_lugs_is_told() -> None:
    """The lugs lie along x, and the boom is turned by 50 deg from there."""
    reach, turned = BOOM * math.cos(math.radians(60.0)), math.radians(50.0)
    stands = f"[{LUG - reach * math.cos(turned)} m, {-reach * math.sin(turned)} m, 0 m]"
    text = changed(
        by_a_boom(luffed_along(4.0), inwards=True, angle=60.0),
        ("heading: 0.0 deg", "heading: 50 deg"),
        (f"[{heel_of(60.0, inwards=True)} m, 0 m, 0 m]", stands),
    )
    assert any("'fc.boom' goes at 50 deg to the line between the lugs" in one for one in of_boom(text))
