"""An edge of a load that leaves the top of a support, and one that turns over tops that stand askew to it.

A side carried at 95 % of the way to the rim, but its edge up to the rim itself, and that it had passed it
was seen within 10 mm only. So a load at 45° whose edge slid off a top dropped by 15 to 25 mm at once,
without a word, and hit the support again. On tops turned against the edge the two sides beside it carried at
places of it up to 0.2 m apart, of which rounding chose one at every step: two supports bore 86 and 70 kN of a
load that was on both alike. Both had been there since supports carry on all sides of a load.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from box_on_tops import INERTIA, MASS, SIZE, STIFFNESS, force, support, turn
from mechanics import G, adaptive, body, document, free, slider

SPEED, HALF = 0.05, 0.3


@pytest.mark.parametrize("askew", [0.0, 8.0, 45.0])
def test_a_load_follows_its_edge_over_the_rim(askew: float) -> None:
    """Guided at 45° over one top, slowly: its height is that of the edge, then of the side over the rim.

    The side carries where (SU1) is least: x = -h, and y = -h where it rises by more than 0.5 along y too,
    0 where by less than 0.2. From where the edge has come past that all goes down as fast as the edge goes
    on. It sags by m g/k - τ v while it goes down with v. That the edge has passed is seen within 1 mm,
    and a load whose support begins to go down at 0.05 m/s is thrown off by less: 0.05² m²/s²/2g.
    """
    edge = np.array([SIZE[0] / 2, 0.0, -SIZE[2] / 2])
    angle = math.radians(45.0)
    c, s = math.cos(angle), math.sin(angle)
    low = np.array([edge[0] * c + edge[2] * s, 0.0, edge[2] * c - edge[0] * s])
    start = np.array([0.2, 0.0, -MASS * G / STIFFNESS]) - low
    cart = body("cart", slider((1, 0, 0), velocity=SPEED), mass=1e7, position=start.tolist())
    box = body("box", slider(), mass=MASS, parent="cart", inertia=INERTIA)
    box["placement"]["orientation"] = turn(1, angle)
    # A slider's axis is given in the frame of its own joint.
    box["joint"] = slider((-s, 0, c))
    turned = math.radians(askew)
    along = [math.cos(turned), math.sin(turned), 0.0]
    top = support("top", 0.0, 0.0, friction=0.0, along=along)
    done = adaptive(document([cart, box], supports=[top]), 6.0)
    x, _, z = (done.body("box") + low).T
    assert z[0] == pytest.approx(-MASS * G / STIFFNESS, abs=1e-9)
    rises = math.sin(turned) > 0.5
    rim = HALF * (math.cos(turned) + (math.sin(turned) if rises else 0.0))
    expected = -MASS * G / STIFFNESS - np.maximum(0.0, x - rim)
    assert x[-1] > rim + 0.05
    # 1 mm at the rim, τ v = 1 mm, and as it bounces at most as much again.
    assert np.abs(z - expected).max() < 3e-3
    # Within a step the place goes along with the box, here by less than 0.2 mm: 8 kN of this support.
    assert force(done, "top")[-1] == pytest.approx(MASS * G, abs=STIFFNESS * 2e-4)


def rolled(askew: float) -> tuple[np.ndarray, np.ndarray]:
    """Attitudes of a load that rolls over its edge on two tops, and their forces [N]."""
    edge, angle, spin = np.array([SIZE[0] / 2, 0.0, -SIZE[2] / 2]), math.radians(30.0), 1.0
    c, s = math.cos(angle), math.sin(angle)
    arm = np.array([edge[0] * c + edge[2] * s, 0.0, edge[2] * c - edge[0] * s])
    x, y, z = -arm - (0.0, 0.0, MASS * G / (2 * STIFFNESS))
    speed = [-spin * arm[2], 0.0, spin * arm[0]]
    joint = free((x, y, z), orientation=turn(1, angle), velocity=speed, angular_velocity=[0.0, spin, 0.0])
    along = [math.cos(math.radians(askew)), math.sin(math.radians(askew)), 0.0]
    tops = [support(name, 0.0, y, friction=2.0, along=along) for name, y in (("left", 1.2), ("right", -1.2))]
    done = adaptive(document([body("box", joint, mass=MASS, inertia=INERTIA)], supports=tops), 0.8)
    return done.body("box", "body_orientation"), np.array([force(done, name) for name in ("left", "right")])


def test_an_edge_bears_on_tops_askew_as_on_others() -> None:
    """It lies level over the middles of both tops: the way these are turned changes nothing."""
    attitude, forces = rolled(0.0)
    askew, others = rolled(30.0)
    assert np.abs(askew - attitude).max() < 1e-5
    assert np.abs(others - forces).max() < 1e-3 * MASS * G
    assert np.abs(others[0] - others[1]).max() < 1e-3 * MASS * G
