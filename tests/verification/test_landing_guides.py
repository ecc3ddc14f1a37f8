"""Landing guides at rest and in motion: what presses on them, against a pendulum's own equations.

A load on slings that do not stretch is a rigid pendulum about its hook, in the plane of hook and guide.
Turned by θ, a point that hung at (x, z) from the hook is at (x cos θ + z sin θ, z cos θ − x sin θ). A force
N along n at the point p and the weight W at the centre of gravity c balance about the hook where

    N (p_z n_x − p_x n_z) + W c_x = 0,      N = −k gap(θ)

with the gap of (LG1) or (LG2) of the page on landing guides.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import brentq

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from guided_lift import HOOK, MASS, guided_lift
from mechanics import G

Floats = npt.NDArray[np.float64]

WEIGHT, STIFFNESS = MASS * G, 20e6
#: Post: radius, height of its shoulder, length of its cone, radius of its tip [m].
POST, SHOULDER, CONE, TIP = 0.2, 1.0, 0.5, 0.1
ALPHA = math.atan2(POST - TIP, CONE)
#: Frame: where its middle is on the load [m], clearance [m], length of the flare [m], its lean.
FRAME, CLEARANCE, FLARE, BETA = 3.5, 0.03, 0.4, math.radians(30.0)


def turned(theta: float, x: float, z: float) -> Floats:
    """Where a point of the load is, from its hook."""
    return np.array([x * math.cos(theta) + z * math.sin(theta), z * math.cos(theta) - x * math.sin(theta)])


def balance(contact: Callable[[float], tuple[Floats, Floats, float]]) -> tuple[float, float]:
    """Force N and turn θ at rest; a contact is its place from the hook, the way it pushes, its gap."""

    def missing(theta: float) -> float:
        place, way, gap = contact(theta)
        force = -STIFFNESS * gap
        moment = force * (place[1] * way[0] - place[0] * way[1])
        return float(moment + WEIGHT * turned(theta, 0.0, 1.0 - HOOK)[0])

    theta = float(brentq(missing, -0.1, 0.1, xtol=1e-15))
    return -STIFFNESS * contact(theta)[2], theta


def at_rest(guides: str, at: float, height: float) -> Recording:
    """The load at rest, in a lift that hangs at x = `at`, its underside at a height [m]."""
    text = guided_lift(guides, at=(at, 0.0), height=height)
    return Statics(parse_scenario(text, "x.yaml")).equilibrium().recording


def bucket(sides: str, friction: float = 0.2, post: float = 0.0, more: str = "") -> str:
    """A guide whose post stands at x = `post` [m]; its frame is at the aft end of the load."""
    return (
        f"  g: {{post: {{at: [{post} m, 0 m, 0 m], diameter: {2 * POST} m, height: {SHOULDER} m, "
        f"cone: {{length: {CONE} m, tip_diameter: {2 * TIP} m}}}}, "
        f"frame: {{at: [-{FRAME} m, 0 m, 0 m], sides: {sides}, "
        f"clearance: {CLEARANCE} m, height: 0.6 m, flare: {{length: {FLARE} m, angle: {BETA} rad}}}}, "
        f"friction: {friction}, stiffness: {STIFFNESS} N/m, capacity: 60 kN{more}}}\n"
    )


def test_bumper_is_pushed_by_its_wall() -> None:
    """A load that would hang 0.1 m in a wall: the upper end of its bumper presses, N (z_hook − z) = W x."""
    out, long = 3.4, 0.5
    wall = (
        "  g: {wall: {at: [0 m, 0 m, 0 m], faces: 0 deg, breadth: 2 m, height: 3 m}, "
        "bumper: {at: [-3.2 m, 0 m, 0 m], "
        f"diameter: 0.4 m, length: {long} m}}, friction: 0.2, stiffness: {STIFFNESS} N/m}}\n"
    )
    deep = 0.1
    recording = at_rest(wall, out - deep, 1.0)

    def contact(theta: float) -> tuple[Floats, Floats, float]:
        place = turned(theta, -out, long - HOOK)
        return place, np.array([1.0, 0.0]), float(place[0]) + out - deep

    force, theta = balance(contact)
    assert recording.column("guide_force", "g")[-1] == pytest.approx(force, rel=1e-5)
    moved = recording.column("body_position", "module")[-1, 0] - (out - deep)
    assert moved == pytest.approx(turned(theta, 0.0, 1.0 - HOOK)[0], abs=1e-7)
    # The first guess of a yard, W/L times the way aside, with L from the hook to the centre of gravity: to
    # the share of L by which the bumper is off that height.
    assert force == pytest.approx(WEIGHT / (HOOK - 1.0) * deep, rel=0.1)


@pytest.mark.parametrize("height", [1.05, 1.2, 1.35])
def test_knee_on_the_cone(height: float) -> None:
    """The knee of a frame on the cone: pushed along (cos α, sin α) by the depth across the cone, (LG2)."""
    deep = 0.15
    post = -FRAME + deep
    recording = at_rest(bucket("[fore]", post=post), 0.0, height)

    def contact(theta: float) -> tuple[Floats, Floats, float]:
        place = turned(theta, POST + CLEARANCE - FRAME, -HOOK)
        out, up = float(place[0]) - post - POST, float(place[1]) + height + HOOK - SHOULDER
        way = np.array([math.cos(ALPHA), math.sin(ALPHA)])
        return place, way, float(np.array([out, up]) @ way)

    force, theta = balance(contact)
    assert force > 0.0
    assert recording.column("guide_force", "g")[-1] == pytest.approx(force, rel=1e-5)
    moved = recording.column("body_position", "module")[-1, 0]
    assert moved == pytest.approx(turned(theta, 0.0, 1.0 - HOOK)[0], abs=1e-7)


def test_tip_on_the_flare() -> None:
    """The rim of the tip on a flare: pushed across the flare, which has turned with the load, (LG1)."""
    deep, height = 0.3, 1.7
    post = -FRAME + deep
    recording = at_rest(bucket("[fore]", post=post), 0.0, height)
    rim = np.array([post + TIP, SHOULDER + CONE - height - HOOK])

    def contact(theta: float) -> tuple[Floats, Floats, float]:
        way = turned(theta, math.cos(BETA), math.sin(BETA))
        knee = turned(theta, POST + CLEARANCE - FRAME, -HOOK)
        return rim, way, float((knee - rim) @ way)

    force, theta = balance(contact)
    assert force > 0.0
    assert recording.column("guide_force", "g")[-1] == pytest.approx(force, rel=1e-5)
    moved = recording.column("body_position", "module")[-1, 0]
    assert moved == pytest.approx(turned(theta, 0.0, 1.0 - HOOK)[0], abs=1e-7)


def test_a_rope_presses_the_load_on_its_post() -> None:
    """A pull P along d at l presses the knee of a frame at p on its post: N p_z = P (l × d) + W x."""
    pull, level, height = 20e3, 1.5, 0.3
    ends = f"at: [-3 m, 0 m, {level} m], to: [-500 m, 0 m, 1.8 m]"
    lines = f"tag_lines: {{t: {{{ends}, rope: tag, pull: {pull} N}}}}\n"
    tag = "tag: {axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}"
    text = guided_lift(bucket("[fore, aft]", post=-FRAME), height=height, more=lines)
    text = text.replace("ropes: {", f"ropes: {{{tag}, ")
    recording = Statics(parse_scenario(text, "x.yaml")).equilibrium().recording
    lug_at, anchor = (-3.0, level - HOOK), np.array([-500.0, 1.8 - height - HOOK])

    def balanced(theta: float) -> tuple[float, float]:
        """Force by the moments, and by the gap."""
        lug, knee = turned(theta, *lug_at), turned(theta, POST + CLEARANCE - FRAME, -HOOK)
        way = anchor - lug
        way *= pull / np.linalg.norm(way)
        moment = lug[1] * way[0] - lug[0] * way[1] + WEIGHT * turned(theta, 0.0, 1.0 - HOOK)[0]
        return -moment / knee[1], -STIFFNESS * (knee[0] + FRAME - POST)

    theta = float(brentq(lambda one: float(np.subtract(*balanced(one))), 0.0, 0.01, xtol=1e-15))
    force = balanced(theta)[0]
    # Less than the pull by what the load takes as a pendulum, 30 mm aside.
    assert force == pytest.approx(pull * (HOOK - level) / HOOK - WEIGHT * CLEARANCE / HOOK, rel=0.01)
    assert recording.column("guide_force", "g")[-1] == pytest.approx(force, rel=1e-4)
