"""Hooks that move as told were pulled aside without a word.

Nothing of a hook of `type: fixed_hook` hangs, so nothing leans: two such hooks 8 m apart on lugs 13 m apart
lifted 40 t with every sling 22 deg outwards, 79 kN aside on each hook. The verdict was GO without a warning.
Falls of a real crane would lean by that angle, until its hooks are over the lugs.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import load_scenario, parse_scenario
from gantline.statics import Statics
from hooked_lift import hooked_lift
from of_recording import checks_of

MASS, ASIDE, LENGTH, EA, G = 40e3, 2.5, 6.7, 200e6, 9.81
RUN = """\
plan:
  - {step: off, hoist: [A, B], speed: 1 m/min, by: 0.1 m}
  - {step: hold, hold: until_end}
"""


def lift(aside: float = ASIDE, more: str = "", hook: str = "") -> str:
    """Two hooks, each with one sling that goes down and outwards by so much [m]."""
    above = 3.0 + math.sqrt(LENGTH**2 - aside**2) - 0.02
    hooks = {"A": (-4.0, 0.0, above), "B": (4.0, 0.0, above)}
    lugs = {"A": (-4.0 - aside, 0.0, 3.0), "B": (4.0 + aside, 0.0, 3.0)}
    slings = {"A": ("A", "A", LENGTH), "B": ("B", "B", LENGTH)}
    box, centre = (14.0, 4.0, 3.0), (0.0, 0.0, 1.5)
    text = hooked_lift(
        hooks, lugs, slings, mass=MASS, centre=centre, box=box, axial_stiffness=EA, more=RUN + more
    )
    return text.replace("type: fixed_hook", f"type: fixed_hook{hook}").replace(
        "duration: 10 s", "duration: 40 s"
    )


def at_rest(aside: float, hook_block: float = 0.0) -> float:
    """Angle of what hangs in a hook from plumb [rad], with a hook block of a mass [kg], by hand.

    A sling bears half of the weight and leans by the angle a: T cos a = m g/2, sin a = aside/(L (1 + T/EA)).
    """
    half, angle = MASS * G / 2, math.asin(aside / LENGTH)
    for _ in range(50):
        angle = math.asin(aside / (LENGTH * (1 + half / math.cos(angle) / EA)))
    return math.atan(half * math.tan(angle) / (half + hook_block * G))


def checked(recording: Recording, name: str = "falls_out_of_plumb") -> list[Check]:
    return checks_of(recording, name)


def rest(text: str) -> Recording:
    return Statics(parse_scenario(text)).equilibrium().recording


def test_warns_past_the_bound_of_hooks_that_hang() -> None:
    """The angle at rest by hand, 21.9 deg; past 2 deg is a warning."""
    found = rest(lift())
    [check] = checked(found)
    assert check.verdict is Verdict.WARNING
    assert check.value is not None
    assert check.value == pytest.approx(at_rest(ASIDE), rel=1e-6)
    assert math.degrees(check.value) == pytest.approx(21.9, abs=0.05)
    half = MASS * G / 2
    assert f"{half * math.tan(at_rest(ASIDE)) / 1e3:.1f} kN aside, {half / 1e3:.1f} kN down" in check.formula
    assert "past a limit that only warns: falls_out_of_plumb" in verdict_of(check_recording(found))


def test_run_warns_too() -> None:
    """The largest of a run is a little more than at rest: what was hoisted sways, and its slings ring."""
    [check] = checked(gantline.simulate(parse_scenario(lift())))
    assert check.verdict is Verdict.WARNING
    assert check.value == pytest.approx(at_rest(ASIDE), rel=5e-3)


def test_limit_of_the_lift_fails() -> None:
    [check] = checked(rest(lift(more="limits: {rule: yard, falls_out_of_plumb: 20 deg}\n")))
    assert check.verdict is Verdict.FAILED
    [check] = checked(rest(lift(more="limits: {rule: yard, falls_out_of_plumb: 23 deg}\n")))
    assert check.verdict is Verdict.OK


def test_hook_block_hangs_too() -> None:
    """The hook block of 5 t makes the falls lean less: 79 kN over 196 + 49 kN."""
    [check] = checked(rest(lift(hook=", hook_block_mass: 5 t")))
    assert check.value == pytest.approx(at_rest(ASIDE, 5e3), rel=1e-6)


def test_requirement_of_a_step() -> None:
    """At the end of a step of 10 s it is at rest but for what is left of its sway, 2 parts in 1000."""
    text = lift(0.1).replace("hold: until_end}", "hold: 10 s, require: {falls_out_of_plumb: below 0.5 deg}}")
    recording = gantline.simulate(parse_scenario(text))
    [check] = [one for one in checked(recording) if one.step == "hold"]
    assert check.verdict is Verdict.FAILED
    assert check.value == pytest.approx(at_rest(0.1), rel=3e-3)


def test_nothing_is_said_of_what_hangs_plumb() -> None:
    assert not checked(rest(lift(0.1)))
    assert not checked(gantline.simulate(parse_scenario(lift(0.1))))


def test_slings_that_come_taut_one_after_another() -> None:
    """Of unlike ropes over a bar one pulls first, 3.2 deg aside at a tenth of the load: no lift askew."""
    lift = load_scenario("spreader_bar").changed({"slings.T1.rope": "sling_36"})
    assert not checked(gantline.simulate(lift))
