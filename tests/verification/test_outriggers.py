"""Cranes on outriggers: forces under four feet and pressures under their mats, by moments."""

from __future__ import annotations

import numpy as np
import pytest

from crawler_lift import GAUGE, TRACK, WIDTH, crawler_lift, own_mass, own_moment
from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from mechanics import G

#: Area of a mat [m^2], what the ground bears [Pa], and ground that does not give way [N/m].
AREA, ALLOWED, HARD = 9.0, 150e3, 1e12
LOAD, RADIUS = 50e3, 16.0


def at_rest(text: str) -> Recording:
    lift = text.replace("mats: 6 m", f"outrigger_mats: {AREA} m^2")
    return Statics(parse_scenario(lift)).equilibrium().recording


@pytest.mark.parametrize("slew", [90.0, 30.0, 0.0])
def test_feet_bear_what_moments_say(slew: float) -> None:
    """(CR1) and (CR7): N = W/4 (1 ± 2x/L ± 2y/g), p = N/A, on the mat N over the square of the foot."""
    recording = at_rest(crawler_lift(LOAD, slew=slew, radius=RADIUS, ground=HARD))
    mass = own_mass() + LOAD
    out = (own_moment(RADIUS) + LOAD * RADIUS) / mass
    x, y = out * np.cos(np.radians(slew)), out * np.sin(np.radians(slew))
    signs = np.array([(1, 1), (-1, 1), (1, -1), (-1, -1)])
    force = mass * G / 4 * (1 + 2 * x / TRACK * signs[:, 0] + 2 * y / GAUGE * signs[:, 1])
    assert (force > 0).all()
    names = [f"c1.{corner}" for corner in ("left.front", "left.back", "right.front", "right.back")]
    found = np.array([recording.column("contact_force", name)[-1] for name in names])
    # 14 parts of one rope pull 3 cm aside of the middle of their sheaves: of 50 t that is 15 kN m, 0.9 kN in
    # each foot, two over 8.4 m, 6e-4 of it; and 1 kg of sheaves at the head.
    assert found == pytest.approx(force, abs=2e-3 * force.max())
    for variable, area in (("ground_pressure", AREA), ("track_pressure", WIDTH**2)):
        pressure = np.array([recording.column(variable, name)[-1] for name in names])
        assert pressure == pytest.approx(found / area, rel=1e-12)
    (check,) = (one for one in check_recording(recording) if one.name == "ground_pressure_of_allowed")
    assert check.value == pytest.approx(found.max() / AREA / ALLOWED, rel=1e-12)


def test_it_does_not_travel() -> None:
    """Feet on mats stay where they are: a travel is refused."""
    travel = "    travel: {speed: 1 km/h, acceleration: 0.02 m/s^2, range: [0 m, 5 m]}\n"
    with pytest.raises(ScenarioError, match=r"cranes\.c1\.travel: a crane on outriggers stands"):
        at_rest(crawler_lift(LOAD, crane=travel))
