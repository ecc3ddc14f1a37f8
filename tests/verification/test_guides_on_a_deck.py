"""Landing guides that stand on a body: both of a pair feel the force, and what a load that is struck bears.

A deck of mass M slides without friction down a way that falls by α, and its post or wall comes to rest
against a load that hangs. The way carries what is square to it, so that along it M g sin α = N cos α and
N = M g tan α (upright faces push level). The load hangs aside by (LG5), of which N is the same.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from guided_lift import HOOK, MASS, guided_lift
from mechanics import G

_DECK, _FALLS = 20e3, math.radians(0.2)
#: Stiffness of a place [N/m], height of the bumper over the underside, of the centre of gravity [m].
_STIFFNESS, _BUMPER, _CENTRE = 20e6, 0.5, 1.0
#: About the centre of gravity, along x: of a box 3 m wide and 2 m high [kg m^2].
_INERTIA = MASS / 12.0 * (3.0**2 + 2.0**2)


def _deck(axis: tuple[float, float, float], at: float, motion: str = "") -> str:
    x, y, z = axis
    return f"""\
start: rest
mechanics:
  bodies:
    deck:
      at: [-1 m, {at} m, 0 m]
      joint: {{type: slider, axis: [{x!r}, {y!r}, {z!r}]{motion}}}
      mass: {_DECK} kg
"""


def _wall(low: float, long: float, more: str) -> str:
    """Of a deck whose origin is 1 m aft: a wall to starboard of the load, its face 2 m from that origin."""
    wall = "wall: {at: [1 m, -2 m, 0 m], faces: 90 deg, breadth: 2 m, height: 2.5 m}"
    bumper = f"bumper: {{at: [0 m, -1.5 m, {low} m], diameter: 0.4 m, length: {long} m}}"
    return f"  g: {{held_by: deck, {wall}, {bumper}, friction: 0, stiffness: {_STIFFNESS} N/m{more}}}\n"


_POST = (
    "  g: {held_by: deck, post: {at: [1 m, -2 m, 0 m], diameter: 0.4 m, height: 2.5 m}, "
    "frame: {at: [0 m, -1.8 m, 0.5 m], sides: port, clearance: 0 mm, height: 0.5 m}, friction: 0}\n"
)


@pytest.mark.parametrize(
    ("guide", "at"), [(_wall(_BUMPER, 0.5, ""), 0.301), (_POST, 0.201)], ids=["wall", "post"]
)
def test_a_deck_that_slides_leans_on_a_load(guide: str, at: float) -> None:
    """N = M g tan α, 685 N; and of the load W x / 16 m, (LG5), the place of the force not being known."""
    down = (0.0, math.cos(_FALLS), -math.sin(_FALLS))
    text = guided_lift(guide, height=0.3, more=_deck(down, at))
    recording = Statics(parse_scenario(text, "x.yaml")).equilibrium().recording
    force = float(recording.column("guide_force", "g")[-1])
    assert force == pytest.approx(_DECK * G * math.tan(_FALLS), rel=1e-7)
    x, y, _ = recording.column("body_position", "module")[-1]
    assert abs(x) < 1e-6
    # The force is 0.5 m to 1 m over the underside: about the hook 16 m to 16.5 m down, the weight 16 m.
    assert MASS * G * y / 16.5 <= force <= MASS * G * y / 16.0


def _struck(height: float, speed: float) -> Recording:
    """A wall of a deck that comes at a speed meets a bumper at a height over the underside."""
    motion = f", motion: [{{at: 0 s, duration: 0.1 s, velocity: {speed} m/s}}]"
    guide = _wall(height - 0.01, 0.02, ", damping: 0 N s/m")
    more = _deck((0.0, 1.0, 0.0), 0.0, motion) + "simulation: {sample_interval: 0.5 ms}\n"
    text = guided_lift(guide, height=0.3, more=more, duration=1.8)
    return simulate(parse_scenario(text, "x.yaml"))


@pytest.mark.parametrize("height", [0.5, 1.0, 1.8])
def test_a_load_on_slings_is_struck_as_a_pendulum_about_its_hook(height: float) -> None:
    """(LG6) with both ends of a line, n = 2, at 0.2 m/s: 213, 220 and 231 kN.

    The stroke takes half of 2 π sqrt(m_e / 2k), 86 ms. Gravity, W/L of 18 kN/m beside 2k of 40 MN/m, takes
    half of their ratio, 2.3e-4, of the force at most; samples 0.5 ms apart miss (π 0.25/86)²/2, 4e-5.
    """
    recording = _struck(height, 0.2)
    lever = HOOK - height
    mass = (_INERTIA + MASS * (HOOK - _CENTRE) ** 2) / lever**2
    largest = float(np.max(recording.column("guide_force", "g")))
    assert largest == pytest.approx(0.2 * math.sqrt(2.0 * _STIFFNESS * mass), rel=2.7e-4)
    # Less than for a load that is free, at the same arm from its centre of gravity.
    free = 1.0 / (1.0 / MASS + (height - _CENTRE) ** 2 / _INERTIA)
    assert largest > 0.2 * math.sqrt(2.0 * _STIFFNESS * free)
