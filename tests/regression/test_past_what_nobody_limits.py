"""Lifts that were GO without a word because their files set no limit.

A crawler crane at 95 % of the load that tips it, falls 4 deg out of plumb, a hoist rope of 28 mm over sheaves
of 200 mm, a load that hung 19 deg askew since one of two cranes went on hoisting: each of these numbers stood
in the table, `not checked` for want of a limit. Past a bound that nobody goes past by intention they warn
now; limits of the lift file, and what a maker says of a chart, come before that.
"""

from __future__ import annotations

import math

import pytest

import gantline
from crawler_lift import crawler_lift, tipping_mass
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario
from of_recording import checks_of

#: Radius [m], gravity [m/s^2], density of air [kg/m3].
RADIUS, G, AIR = 16.0, 9.81, 1.225
#: Of `crawler_lift`: its chart, whose side lead of 1 deg counts before any bound that nobody set.
CHART = (
    "    rating: {radius: [12 m, 14 m, 16 m, 18 m, 20 m, 24 m, 28 m],\n"
    "      rated: [360 t, 283 t, 231 t, 195 t, 168 t, 130 t, 104 t], off_lead: 1 deg, side_lead: 1 deg}\n"
)


def check(text: str, name: str) -> Check:
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return next(one for one in checks if one.name == name)


def near_tipping(share: float, more: str = "") -> str:
    """The crawler crane with this share of the load that tips it, over its side, on ground that is hard."""
    return crawler_lift(share * tipping_mass(RADIUS), ground=20e9, more=more).replace(CHART, "")


@pytest.mark.parametrize(("share", "verdict"), [(0.7, Verdict.OK), (0.8, Verdict.WARNING)])
def test_three_quarters_of_the_tipping_load(share: float, verdict: Verdict) -> None:
    found = check(near_tipping(share), "moment_of_tipping_moment")
    assert found.verdict is verdict
    # The crane leans a little into its ground, which takes the load farther out.
    assert found.value == pytest.approx(share, rel=5e-4)
    if verdict is Verdict.WARNING:
        assert found.limit == 0.75
        assert "ASME B30.5" in found.source
        assert "a limit of its own under 'limits'" in found.remark


def test_a_limit_of_the_lift_file_comes_first() -> None:
    text = near_tipping(0.8, "limits: {moment_of_tipping_moment: 85 %}\n")
    found = check(text, "moment_of_tipping_moment")
    assert (found.verdict, found.limit) == (Verdict.OK, 0.85)


def aside(lead: float) -> str:
    """A crawler crane whose falls stand this many degrees aside, by a steady wind on what hangs there."""
    hoist_load, area = 60e3, 50.0
    # Of the force of the wind, c A rho v^2 / 2, and the weight; shape coefficient 1.
    speed = math.sqrt(math.tan(math.radians(lead)) * hoist_load * G / (0.5 * AIR * area))
    wind = f"wind: {{speed: {speed!r} m/s, direction: 90 deg}}\n"
    side = f"wind_areas: {{side: {{area: {area} m^2, coefficient: 1, along: y, at: [0 m, 0 m, 0 m]}}}}"
    text = crawler_lift(hoist_load, slew=0.0, more=wind)
    return text.replace("mass: 53000.0 kg", f"mass: 53000.0 kg, {side}")


@pytest.mark.parametrize(("lead", "is_told"), [(1.0, False), (1.3, True)])
def test_a_boom_that_is_pulled_aside(lead: float, is_told: bool) -> None:
    """2 % of what hangs are 1.15 deg."""
    found = check(aside(lead).replace(CHART, ""), "side_lead")
    assert found.value == pytest.approx(math.radians(lead), rel=1e-9)
    assert (found.verdict is Verdict.WARNING) is is_told


def test_what_the_chart_says_comes_first() -> None:
    text = aside(1.3).replace("side_lead: 1 deg", "side_lead: 1.5 deg")
    assert check(text, "side_lead").verdict is Verdict.NOT_CHECKED
    assert check(text, "attitude_of_rating").verdict is Verdict.OK


def test_what_the_chart_of_another_crane_says_does_not_count() -> None:
    """Beside a crane without a chart stands one whose chart holds up to 3 deg: that was the bound of both."""
    text = aside(1.3)
    first, last = text.index("  c1:"), text.index("height: 30 m}\n") + len("height: 30 m}\n")
    another = text[first:last].replace("c1:", "c0:").replace("[3 m, -2 m]", "[3 m, 98 m]")
    another = another.replace("side_lead: 1 deg", "side_lead: 3 deg")
    found = check(text[:first] + another + text[first:].replace(CHART, ""), "side_lead")
    assert (found.element, found.verdict) == ("c1.H", Verdict.WARNING)
    assert found.value == pytest.approx(math.radians(1.3), rel=1e-9)
    assert found.limit == pytest.approx(math.atan(0.02), rel=1e-12)


@pytest.mark.parametrize(("lead", "is_told"), [(1.9, False), (2.2, True)])
def test_falls_out_of_plumb(lead: float, is_told: bool) -> None:
    found = check(aside(lead).replace(CHART, ""), "falls_out_of_plumb")
    assert (found.verdict is Verdict.WARNING) is is_told


@pytest.mark.parametrize(("diameter", "is_told"), [("0.3 m", True), ("0.32 m", False)])
def test_sheaves_too_small_for_their_rope(diameter: str, is_told: bool) -> None:
    """28 mm of rope ask for 11.2 times that, 0.314 m, in the lightest duty."""
    text = crawler_lift(100e3).replace("sheave_diameter: 0.7 m", f"sheave_diameter: {diameter}")
    found = check(text, "sheave_bending_ratio")
    assert (found.verdict is Verdict.WARNING) is is_told


@pytest.mark.parametrize(("length", "is_told"), [("3.30 m", True), ("3.80 m", False)])
def test_slings_that_are_flat(length: str, is_told: bool) -> None:
    """Lugs are 2.92 m from the middle: 60 deg from the vertical are slings of 3.37 m."""
    high = math.sqrt(float(length.split()[0]) ** 2 - 2.5**2 - 1.5**2) + 3.0 - 0.02
    text = LIFT.replace("8.6 m", length).replace("[0 m, 0 m, 11 m]", f"[0 m, 0 m, {high!r} m]")
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    found = next(one for one in checks if one.name == "sling_angle_from_vertical")
    assert (found.verdict is Verdict.WARNING) is is_told
    assert ("sling_angle_from_vertical" in verdict_of(checks)) is (
        is_told and "NO-GO" not in verdict_of(checks)
    )


@pytest.mark.parametrize(("higher", "is_told"), [(0.5, True), (0.2, False)])
def test_a_load_that_hangs_askew(higher: float, is_told: bool) -> None:
    """Two slings to one end of the load are longer: over 5 m between both, 5 deg are 0.44 m."""
    text = LIFT
    for sling in "BD":
        text = text.replace(f"module.{sling}, length: 8.6 m", f"module.{sling}, length: {8.6 + higher} m")
    found = check(text, "load_tilt")
    assert (found.verdict is Verdict.WARNING) is is_told


#: The hook of the lift is as fast as that of a workshop crane, and so are its steps.
FAST = LIFT.replace("speed: 3 m/min, acceleration: 0.05 m/s^2", "speed: 30 m/min, acceleration: 0.5 m/s^2")


@pytest.mark.parametrize(("speed", "is_told"), [("1 m/min", False), ("30 m/min", True)])
def test_a_load_that_is_snatched(speed: str, is_told: bool) -> None:
    """A mass on a spring whose other end goes up at v swings up to W + v sqrt(k m)."""
    found = check(
        FAST.replace("hoist: crane, speed: 1 m/min", f"hoist: crane, speed: {speed}"), "hook_dynamic_factor"
    )
    assert (found.verdict is Verdict.WARNING) is is_told


@pytest.mark.parametrize(("bow", "is_told"), [("43 mm", True), ("45 mm", False)])
def test_a_sling_on_a_shackle_that_is_thinner(bow: str, is_told: bool) -> None:
    """Slings are 44 mm thick."""
    shackle = (
        f"shackles: {{S: {{working_load_limit: 40 t, bow_diameter: {bow}, pin_diameter: 40 mm}}}}\nload:"
    )
    text = LIFT.replace("load:", shackle, 1).replace(
        "rope: sling}", "rope: sling, shackles: {top: S, bottom: S}}"
    )
    found = check(text, "sling_bending_ratio")
    assert (found.verdict is Verdict.WARNING) is is_told


@pytest.mark.parametrize(("diameter", "is_told"), [("18 mm", True), ("20 mm", False)])
def test_ropes_that_are_too_thin(diameter: str, is_told: bool) -> None:
    """By EN 12385-4 0.356 x 1960 N/mm^2 of the diameter's square; a sling has 104 kN and a little on top."""
    found = check(LIFT.replace("diameter: 44 mm", f"diameter: {diameter}"), "rope_factor_on_breaking_force")
    assert (found.limit == 2.3) is is_told
    assert found.value is not None and (found.value < 2.3) is is_told


@pytest.mark.parametrize(("speed", "is_told"), [("5 m/min", False), ("30 m/min", True)])
def test_a_load_that_is_set_down_hard(speed: str, is_told: bool) -> None:
    down = f"  - {{step: down, lower: crane, speed: {speed}, until: {{supports: touched}}}}\nrules:"
    text = FAST.replace("by: 0.2 m", "by: 1 m").replace("rules:", down)
    recording = gantline.simulate(parse_scenario(text))
    found = checks_of(recording, "set_down_softly")
    assert bool(found) is is_told
    for one in found:
        met = float(one.remark.split(" at ")[1].split(" m/min")[0])
        assert met == pytest.approx(30.0, abs=0.05)  # as printed, to a decimal
