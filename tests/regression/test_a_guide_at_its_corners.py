"""A post and a side of a frame that are in each other at a corner: knee over shoulder, flare on the tip.

Of all rims on faces and edges on sides the two that were deepest pressed, whatever their directions. A knee
that came from the cone to the cylinder had the shoulder on its flare and on its upright face, and a guide
that pressed with 1.36 kN had 4.85 kN there for a moment. A flare that stood on the tip of its post pressed
with its face, and from one millisecond to the next with its lower end as well: 130 kN became 337 kN. That
only what goes the same way presses is held by the tests of `crates/gantline-core/src/contact/landing.rs`.
"""

from __future__ import annotations

import numpy as np

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift

POST = (
    "post: {at: [3.6 m, 0 m, 0 m], diameter: 0.4 m, height: 1 m, cone: {length: 0.5 m, tip_diameter: 0.2 m}}"
)
"""Its shoulder is 0.2 m from its axis and 1 m up, its tip 0.1 m and 1.5 m."""
FLARE = "height: 0.6 m, flare: {length: 0.4 m, angle: 30 deg}"
PLAN = "  - {step: lower, lower: crane, speed: 6 m/min, by: 0.8 m}\n  - {step: rest, hold: until_end}\n"


def test_a_knee_passes_the_shoulder() -> None:
    """Down the cone it presses with what pushes the load aside, and along the cylinder with no more.

    The knee is 0.23 m before the middle of its frame, and 1 m below the centre of gravity.
    """
    guide = f"  g: {{{POST}, frame: {{at: [3.5 m, 0 m, 0 m], clearance: 30 mm, {FLARE}}}, friction: 0.2}}\n"
    run = simulate(parse_scenario(guided_lift(guide, plan=PLAN, duration=0.9)), sample_interval=1e-3)
    force = run.column("guide_force", "g")
    turned = 2.0 * np.arcsin(run.column("body_orientation", "module")[:, 2])
    knee = run.column("body_position", "module")[:, 2] - np.cos(turned) - 3.73 * np.sin(turned)
    passes = float(run.time[np.argmax(knee < 1.0)])
    assert 0.7 < passes < 0.85
    about = np.abs(run.time - passes) < 0.06
    before = float(np.interp(passes - 0.02, run.time, force))
    assert before > 1e3
    assert force[about].max() < 1.05 * before
