"""Goliath cranes: swing after traverse and travel, sag of the girder, by closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from goliath_lift import FALLS, HOOK, HOOK_BLOCK, HUNG, PARTS, goliath_lift
from mechanics import G

SPEED, ACCELERATION, WAY = 0.5, 0.03, 30.0  # 30 m/min
#: When a move of `WAY` ends, and when its three phases change [s].
RAMP = SPEED / ACCELERATION
CRUISE = WAY / SPEED - RAMP
CHANGES = ((0.0, 1.0), (RAMP, -1.0), (RAMP + CRUISE, -1.0), (2 * RAMP + CRUISE, 1.0))


def run(text: str) -> Recording:
    return Simulation(parse_scenario(text)).run()


def moved(recording: Recording, body: str, axis: int) -> FloatArray:
    """Way of a body from its start along an axis [m]."""
    place = recording.column("body_position", body)[:, axis]
    way: FloatArray = place - place[0]
    return way


@pytest.mark.parametrize(("verb", "what", "axis"), [("traverse", "one", 0), ("travel", "gol", 1)])
def test_swing_after_a_trapezoidal_move_is_that_of_a_pendulum(verb: str, what: str, axis: int) -> None:
    """u'' + g/L u = -a(t) from rest: every jump c of a adds -(c L/g)(1 - cos omega (t - t_c))."""
    recording = run(
        goliath_lift(
            f"{{step: move, {verb}: {what}, speed: 30 m/min, by: {WAY} m}}\n{{step: end, hold: until_end}}"
        )
    )
    time = recording.time
    trolley = moved(recording, "gol.one", axis)
    assert trolley[-1] == pytest.approx(WAY, abs=1e-9)
    swing = moved(recording, "gol.A", axis) - trolley
    # u'' + omega^2 u = -a(t), omega^2 = g/L, from rest: every change of the acceleration by c adds
    # -c/omega^2 (1 - cos omega (t - t_c))
    omega = math.sqrt(G / FALLS)
    closed = np.zeros_like(time)
    for at, sign in CHANGES:
        since = np.maximum(time - at, 0.0)
        closed -= sign * ACCELERATION / omega**2 * (1 - np.cos(omega * since))
    amplitude = np.abs(closed[time > 2 * RAMP + CRUISE]).max()
    # The closed form is for small angles: the angle is up to 2 a/g = 0.006, its square 4e-5. Lines from row
    # to row of sheaves lean, by 0.3 m on 50 m, so that falls are longer than the height by 2e-5. Over ten
    # swings the phase takes these up to 2 pi 10 (4e-5/16 + 1e-5) = 8e-4 of the amplitude.
    assert np.abs(swing - closed).max() < 2e-3 * amplitude
    # what the acceptance asks for: the amplitude of the swing that stays, within 1 %
    after = np.abs(swing[time > 2 * RAMP + CRUISE]).max()
    assert after == pytest.approx(amplitude, rel=1e-3)


def test_a_load_on_slings_swings_as_a_double_pendulum() -> None:
    """Four plumb ropes keep the load level: hook block and load are two point masses, one above the other."""
    length = 20.0
    corners = [(x, y) for x in (-2, 2) for y in (-2, 2)]
    hung = (
        f"    hung: {{joint: {{type: free, position: [-20 m, 0 m, {HOOK - length} m]}}, mass: 88 t, "
        "inertia: {xx: 400 t m^2, yy: 400 t m^2, zz: 400 t m^2}}"
    )
    routes = "  ropes:\n" + "\n".join(
        f"    S{n}: {{rope: hoist, length: as_routed, route: [{{type: end, body: gol.A, at: {at}}}, "
        f"{{type: end, body: hung, at: {at}}}]}}"
        for n, at in enumerate(f"[{x} m, {y} m, 0 m]" for x, y in corners)
    )
    plan = f"{{step: move, traverse: one, speed: 30 m/min, by: {WAY} m}}\n{{step: end, hold: until_end}}"
    recording = run(goliath_lift(plan, bodies=hung, ropes=routes + "\n", start="rest", stiffness=1e5))
    time = recording.time
    trolley = moved(recording, "gol.one", 0)
    # Small swings: u of the hook, w of the load, both against the trolley,
    # m1 u'' = -(m1 + m2) g u/L1 + m2 g (w - u)/L2 - m1 a,  m2 w'' = -m2 g (w - u)/L2 - m2 a
    stiffness = np.array(
        [
            [(HOOK_BLOCK + HUNG) * G / FALLS + HUNG * G / length, -HUNG * G / length],
            [-HUNG * G / length, HUNG * G / length],
        ]
    )
    root = np.sqrt([HOOK_BLOCK, HUNG])
    squares, shapes = np.linalg.eigh(stiffness / np.outer(root, root))
    shares = shapes.T @ root
    closed = np.zeros((len(time), 2))
    for at, sign in CHANGES:
        since = np.maximum(time - at, 0.0)
        modes = [
            -sign * ACCELERATION * share / square * (1 - np.cos(math.sqrt(square) * since))
            for share, square in zip(shares, squares, strict=True)
        ]
        closed += (np.array(modes).T @ shapes.T) / root
    for place, body in enumerate(("gol.A", "hung")):
        swing = moved(recording, body, 0) - trolley
        after = time > 2 * RAMP + CRUISE
        amplitude = np.abs(closed[after, place]).max()
        assert np.abs(swing - closed[:, place]).max() < 0.01 * amplitude


def test_the_girder_sags_by_what_hangs_on_it() -> None:
    """Nothing moves before the plan does; 88 t more on a girder of 60 MN/m bring 14.4 mm."""
    girder = ", vertical_stiffness: 60 MN/m"
    still = run(goliath_lift("{step: look, hold: until_end}", girder=girder, duration=5.0))
    assert np.abs(moved(still, "gol.girder", 2)).max() < 1e-9
    assert np.abs(moved(still, "gol.A", 2)).max() < 1e-9
    # A weight that the girder did not carry when its spring was set: 88 t on ropes from the hook.
    hung = (
        "    hung: {joint: {type: free, position: [-20 m, 0 m, 15 m]}, mass: 88 t, "
        "inertia: {xx: 1 t m^2, yy: 1 t m^2, zz: 1 t m^2}}"
    )
    ends = "[{type: end, body: gol.A}, {type: end, body: hung}]"
    routes = f"  ropes:\n    S: {{rope: hoist, length: as_routed, route: {ends}}}\n"
    text = goliath_lift("{step: look, hold: until_end}", girder=girder, bodies=hung, ropes=routes)
    rest = Statics(parse_scenario(text)).equilibrium().recording
    sag = rest.column("body_position", "gol.girder")[-1, 2] - 80.0
    # the hook block was there before: only the 88 t are new
    assert sag == pytest.approx(-HUNG * G / 60e6, rel=1e-6)


def test_girder_and_falls_bounce_as_two_masses_on_two_springs() -> None:
    """17/35 of the girder with its trolley on 60 MN/m, hook and load below it on eight parts of rope."""
    girder = ", vertical_stiffness: 60 MN/m"
    text = goliath_lift("{step: look, hold: until_end}", girder=girder, stiffness=100.0, start="rest")
    statics = Statics(parse_scenario(text))
    statics.equilibrium()
    upper, lower = 17 / 35 * 2600e3 + 300e3, HOOK_BLOCK + HUNG
    # lead line and half turns stretch too: one rope, of all its length
    half_turns = PARTS * math.pi * 0.5
    length = PARTS * FALLS + half_turns + 5.0
    falls = 100e6 * PARTS**2 / length
    stiffness = np.array([[60e6 + falls, -falls], [-falls, falls]])
    root = np.sqrt([upper, lower])
    expected = np.sqrt(np.linalg.eigvalsh(stiffness / np.outer(root, root))) / (2 * math.pi)
    found = np.array([math.sqrt(max(mode.square, 0.0)) / (2 * math.pi) for mode in statics.modes()])
    for one in expected:
        # the stretched rope is longer by 1e-3, and the sideways lines take 2e-5
        assert np.abs(found / one - 1).min() < 1e-3
