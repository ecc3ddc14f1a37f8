"""Springs of joints, two stops at one place that the joint starts away from, against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import gantline

#: A disc about a plumb axis: moment of inertia [kg m^2], stiffness of its spring [N m/rad], where it is let
#: go [rad].
INERTIA, STIFFNESS, AWAY = 2.0, 200.0, math.radians(30.0)
OMEGA = math.sqrt(STIFFNESS / INERTIA)
LIFT = """
format: 1
lift: {title: A disc on a torsion spring}
duration: 3 s
mechanics:
  bodies:
    disc:
      joint:
        type: hinge
        axis: [0, 0, 1]
        position: 30 deg
        stops: {lower: 0 deg, upper: 0 deg, stiffness: 200 N m/rad, loaded: true}
      mass: 10 kg
      inertia: {xx: 1 kg m^2, yy: 1 kg m^2, zz: 2 kg m^2}
"""


@pytest.mark.parametrize(
    ("settings", "tolerance"),
    [
        # Fifty tolerances in five swings.
        ({"position_tolerance": 1e-7, "tension_tolerance": 1e-4}, 50 * 1e-7),
        # Of first order: it damps by exp(-h w^2 t/2).
        ({"integrator": "del", "step": 1e-4}, 1e-4 * OMEGA**2 * 3.0 / 2.0 * AWAY),
        # Its velocity is half a step ahead, h w/2 of the swing, and its phase goes on by (h w)^2/24 more.
        (
            {"integrator": "explicit", "step": 1e-3},
            (1e-3 * OMEGA / 2.0 + (1e-3 * OMEGA) ** 2 / 24.0 * OMEGA * 3.0) * AWAY,
        ),
    ],
)
def test_a_disc_swings_on_its_torsion_spring(settings: dict[str, Any], tolerance: float) -> None:
    """(N4): theta = theta_0 cos(w t), w^2 = k/I, from an angle at which the spring is loaded."""
    recording = gantline.simulate(gantline.parse_scenario(LIFT), **settings)
    found = recording.column("joint_position", "disc")
    assert np.abs(found - AWAY * np.cos(OMEGA * recording.time)).max() < tolerance
    assert recording.attributes["energy_remainder"] < 1e-9


def test_nothing_happens_where_it_goes_through_the_middle() -> None:
    """(N3) acts on both sides: ten passes in 3 s, and no event of any."""
    recording = gantline.simulate(gantline.parse_scenario(LIFT))
    assert np.count_nonzero(np.diff(np.sign(recording.column("joint_position", "disc")))) == 10
    assert not recording.events("stop_hit")
    assert not recording.events("stop_left")


def test_its_natural_period() -> None:
    """2 pi sqrt(I/k) of the mode about its rest."""
    statics = gantline.Statics(gantline.parse_scenario(LIFT))
    rest = statics.equilibrium()
    assert rest.recording.column("joint_position", "disc")[-1] == pytest.approx(0.0, abs=1e-9)
    assert statics.modes()[0].period == pytest.approx(2 * math.pi / OMEGA, rel=1e-9)
