"""A load on one sling over an extension sheave turned over, and its run was a GO as long as it was short.

A girder of 20 t hung by lugs 6 m apart on one sling of 16 m that slides through its extension sheave. Seen
from the girder the sheave goes along an ellipse with the lugs as foci; with c half their distance and b how
far the sheave is above them, a sling that slides lets the load seem to hang from

    h_t = h - c^2/b

over its centre of gravity, which is h below the lugs: -0.8 m here. A run of 22 s tilted by 0.08 deg and was a
GO without a warning, since nothing was said of loads on extension sheaves; `gantline statics` called the
same lift unstable. Of a load in a basket of `mechanics` a run said nothing either, GO too; how it rests a run
now asks of statics, see `test_baskets_roll_in_a_run.py`.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.loads.upright import top_heavy
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

HALF, SLING = 3.0, 16.0  # c, and the length of the sling over the sheave [m]
HEAD = """\
format: 1
lift: {title: A girder on slings that slide}
duration: 20 s
ropes: {sling: {axial_stiffness: 500 MN, damping_time: 10 ms, mass: none, minimum_breaking_force: 1000 kN}}
load:
  name: girder
  shape: {box: [8 m, 1 m, 4 m]}
  position: [0 m, 0 m, 1 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
"""
HOOK = """\
  hook: {type: fixed_hook, at: [X m, 0 m, HIGH m], rated_capacity: 30 t,
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
"""
TAIL = """\
plan: [{step: hold, hold: until_end}]
limits: {rule: yard, load_tilt: 5 deg}
"""


def over_the_lugs() -> float:
    """How far the sheave is over the lugs, unstretched [m]: b of the ellipse."""
    return float(np.sqrt((SLING / 2) ** 2 - HALF**2))


def lugs_at(height: float, *places: float) -> str:
    """Lugs of the girder, L1 and so on, at places along it [m]."""
    each = (
        f"    L{number}: {{at: [{x} m, 0 m, {height} m], capacity: 30 t}}\n"
        for number, x in enumerate(places, start=1)
    )
    return "  lugs:\n" + "".join(each)


def on_one_sheave(depth: float) -> str:
    """The girder with its lugs a depth above its centre of gravity [m]."""
    lugs = 1.5 + depth
    return (
        HEAD
        + lugs_at(lugs, -HALF, HALF)
        + "cranes:\n"
        + HOOK.replace("X m", "0 m").replace("HIGH", repr(1.0 + lugs + over_the_lugs() + 3.0))
        + "extension_sheaves: {X1: {mass: 150 kg}}\n"
        + "slings:\n"
        + "  S1: {from: hook, to: X1, length: 3 m, rope: sling}\n"
        + f"  S2: {{over: X1, to: [girder.L1, girder.L2], length: {SLING} m, rope: sling}}\n"
        + TAIL
    )


def on_three_sheaves(depth: float) -> str:
    """The girder by four lugs in a line, on two sheaves that hang on one sling over a third."""
    lugs = 1.5 + depth
    return (
        HEAD
        + lugs_at(lugs, -3.5, -1.5, 1.5, 3.5)
        + "cranes:\n"
        + HOOK.replace("X m", "0 m").replace("HIGH", repr(1.0 + lugs + 13.0))
        + "extension_sheaves: {X1: {mass: 150 kg}, X2: {mass: 150 kg}, X3: {mass: 150 kg}}\n"
        + "slings:\n"
        + "  S1: {from: hook, to: X1, length: 3.5 m, rope: sling}\n"
        + "  S2: {over: X1, to: [X2, X3], length: 12 m, rope: sling}\n"
        + "  S3: {over: X2, to: [girder.L1, girder.L2], length: 10 m, rope: sling}\n"
        + "  S4: {over: X3, to: [girder.L3, girder.L4], length: 10 m, rope: sling}\n"
        + TAIL
    )


def run(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


def checked(recording: Recording) -> list[Check]:
    return checks_of(recording, "hangs_stably")


@pytest.mark.parametrize("depth", [0.4, 1.1, 1.2])
def test_one_that_slides_fails(depth: float) -> None:
    """By h_t = h - c^2/b, with b to the stretch of the sling: 3.4 mm of 16 m."""
    recording = run(on_one_sheave(depth))
    assert np.degrees(recording.column("load_tilt", "girder").max()) < 1.0
    [check] = checked(recording)
    assert (check.element, check.verdict) == ("girder", Verdict.FAILED)
    assert verdict_of(check_recording(recording)).startswith("NO-GO")
    too_high = HALF**2 / over_the_lugs() - depth
    assert top_heavy(recording)[0].too_high == pytest.approx(too_high, abs=2e-3)


def test_nothing_is_said_of_one_that_hangs_low() -> None:
    assert HALF**2 / over_the_lugs() < 1.25
    assert not checked(run(on_one_sheave(1.25)))


@pytest.mark.parametrize("lift", [on_one_sheave, on_three_sheaves])
@pytest.mark.parametrize("depth", [0.2, 0.8, 1.1, 1.3, 1.6, 2.4])
def test_agrees_with_statics(lift, depth: float) -> None:  # type: ignore[no-untyped-def]
    """An equilibrium is unstable where a run is told so: the core's own curvature of all coordinates."""
    text = lift(depth)
    rest = gantline.Statics(parse_scenario(text)).equilibrium()
    assert rest.is_stable is not bool(top_heavy(run(text)))
