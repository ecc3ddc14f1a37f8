"""`residual_complementarity` was 0 throughout with `adaptive`, however far forces were from their laws.

Within a step a taut rope stays a spring, even if its tension runs through zero, by up to five tolerances.
"""

from __future__ import annotations

import json

from gantline import _core
from mechanics import body, document, end, rope, slider


def test_what_a_rope_pushed_before_it_went_slack_is_told() -> None:
    """A weight is thrown up on its rope, which goes slack: more than nothing, and no more than it may."""
    load = body("load", slider(velocity=2.0), 1000.0, position=(0, 0, -5))
    system = document([load], ropes=[rope("sling", 4.99, [end(None), end("load")], 5e6)])
    tolerance = 50.0
    integrator = {"type": "adaptive", "tension_tolerance": tolerance, "position_tolerance": 1e-4}
    settings = json.dumps({"integrator": integrator, "duration": 1.0, "sample_interval": 0.001})
    run = _core.Simulation(json.dumps(system), settings)
    run.run()
    assert 0.0 < run.columns()["residual_complementarity"].max() <= 5.0 * tolerance
