"""The radius of a crane that slews counted from its slewing axis at the keel of its vessel.

An axis that leans has another place at each height. Outreach counts at the height of the heel pins, radius at
that of the keel: `revolving_crane` ballasted to heel 0.69 deg away from its boom, whose heel pins are 14 m
over the keel, had its hook at 24.41 m for 24.58 m, and 0.9 % more rated there than its chart has. Heeled
towards its boom it had as much too much.
"""

from __future__ import annotations

import math

import pytest

import gantline

#: From the slewing axis to the heel pins, length of the boom [m]: of scenario `revolving_crane`.
PINS, BOOM = 4.0, 48.0
#: The module hangs over the quay by then, and nothing moves [s].
CLEAR = 140.0


@pytest.mark.parametrize("port", [230.0, 300.0])
def test_a_radius_counts_at_the_height_of_the_heel_pins(port: float) -> None:
    """R = x cos τ + L cos(θ + τ) of a hook that hangs plumb below the head, heel pins x ahead of the axis."""
    lift = gantline.load_scenario("revolving_crane").changed(
        {"vessels.barge.tanks.ps.content": f"{port} t", "vessels.barge.tanks.sb.content": f"{300.0 - port} t"}
    )
    rest = gantline.Statics(lift).equilibrium(CLEAR).recording
    angle, leans = (float(rest.column(name, "rc")[-1]) for name in ("boom_angle", "crane_trim"))
    found, off = (float(rest.column(name, "rc.H1")[-1]) for name in ("crane_radius", "off_lead"))
    radius = PINS * math.cos(leans) + BOOM * math.cos(angle + leans)
    # Away from the boom, which is over the starboard side, and the load clear of its stools hangs plumb.
    assert leans > math.radians(0.1) and abs(off) < 1e-6
    assert found == pytest.approx(radius, abs=1e-3)
