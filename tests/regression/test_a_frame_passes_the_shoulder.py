"""A frame that slides down along its post until its upper end has passed the shoulder.

While the shoulder bore on the side of the frame, the upper edge of that side counted as coming down upon the
cone above the shoulder, at v sin α. It never arrives there, since from the shoulder on it runs along the
cylinder; but the damper took it for a blow, of k τ v sin α = 20 MN/m · 10 ms · 0.1 m/s · sin 11.3° = 3.9 kN.
For 13 ms a guide that bore 1.2 kN pressed with up to 4.8 kN at the edge and 0.9 kN at the shoulder, and then
at once with 0.7 kN.
"""

from __future__ import annotations

import math

import numpy as np

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import HOOK, MASS, guided_lift
from mechanics import G

SPEED, FRICTION, STIFFNESS = 0.1, 0.2, 20e6
GUIDE = (
    "  g: {post: {at: [3.6 m, 0 m, 0 m], diameter: 0.4 m, height: 1 m, "
    "cone: {length: 0.5 m, tip_diameter: 0.2 m}}, "
    "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m, flare: {length: 0.4 m, angle: 30 deg}}, "
    f"stiffness: {STIFFNESS} N/m, damping: 200 kN s/m, friction: {FRICTION}}}\n"
)
PLAN = f"  - {{step: lower, lower: crane, speed: {SPEED} m/s, by: 0.8 m}}\n"


def test_the_guide_presses_alike_before_and_after() -> None:
    """By moments about the hook, at the shoulder to 0.1 %, and past it but for a swing.

    N (h + μ x) = W c, h from shoulder or edge up to the hook, x out to the post, c out to the load's weight.
    The load leans by λ = c/16 m, so its side goes outwards by v λ, and its edge along the cylinder does not:
    that speed is stopped, by (LG6) of docs/concepts/landing_guide.md with no more than v λ √(k m).
    """
    lift = parse_scenario(guided_lift(GUIDE, plan=PLAN, duration=8.0))
    run = simulate(lift, sample_interval=0.002)
    one, other = (run.column("contact_force", f"guide.g.fore/{place}") for place in (1, 2))
    pressed = one + other
    aside, _, height = run.column("body_position", "module").T
    lean, out = aside[-1] / (HOOK - 1.0), 3.8
    top = height - 1.0 + 0.6 + out * lean
    up = height + HOOK - 1.0 - np.minimum(top, 1.0)
    rest = MASS * G * aside / (up + FRICTION * out)
    before, after = (top > 1.0 + 2e-4) & (run.time > 6.5), top < 1.0
    assert before.sum() > 200 and after.sum() > 200
    assert np.abs(pressed[before] / rest[before] - 1.0).max() < 1e-3
    inertia = MASS / 12 * (6.0**2 + 2.0**2) + MASS * (HOOK - 1.0) ** 2
    swing = SPEED * lean * math.sqrt(STIFFNESS * inertia) / up[-1]
    assert np.abs(pressed[after] - rest[after]).max() < swing < 0.3 * rest[-1]
