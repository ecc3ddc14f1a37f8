"""Two vessels of one database in waves: their motions against the solution of all twelve together."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import two_hulls
import waves
from gantline.simulation import simulate

OMEGA = 0.7
PERIOD = 2 * math.pi / OMEGA


def constants(by_file: dict[str, Any]) -> dict[str, Any]:
    """Added mass and damping of the file at the period of the wave."""
    at_period = {**by_file, "period": f"{PERIOD!r} s"}
    return {"added_mass": at_period, "water_damping": at_period}


def by_hand(by_file: dict[str, Any]) -> dict[str, Any]:
    """Others than those of the file; this damping is of a run alone."""
    at = by_file["at"]
    added = {"surge": "500 t", "sway": "4000 t", "heave": "26000 t", "pitch": "14000000 t m^2"}
    damped = {"sway": "1200 kN s/m", "heave": "9000 kN s/m", "roll": "200 MN m s", "pitch": "4000 MN m s"}
    return {"added_mass": {"at": at, **added}, "water_damping": {"at": at, "yaw": "900 MN m s", **damped}}


#: Of roll, on top of that of the file [N m s].
ON_TOP = np.diag([0.0, 0.0, 0.0, 3e8, 0.0, 0.0])


def on_top(by_file: dict[str, Any]) -> dict[str, Any]:
    return {"radiation": by_file, "water_damping": {"at": by_file["at"], "roll": "300 MN m s"}}


@pytest.mark.parametrize(
    ("headings", "bearing", "direction", "water"),
    [
        ((0.0, 0.0), 0.0, 90.0, None),
        ((0.0, 0.0), 0.0, 270.0, constants),
        ((0.0, 0.0), 35.0, 125.0, constants),
        ((0.0, 180.0), 0.0, 60.0, None),
        ((90.0, 0.0), -20.0, 40.0, constants),
        ((0.0, 0.0), 0.0, 120.0, by_hand),
        ((0.0, 0.0), 0.0, 90.0, on_top),
    ],
)
def test_steady_motion_among_each_other(
    tmp_path: Path, headings: tuple[float, float], bearing: float, direction: float, water: Any
) -> None:
    """Twelve complex amplitudes against (−ω²(M + A) − iω(B + D) + C)⁻¹ X, to 1e-5 of the largest shift and
    turn, A and B of the file whole: with memory, whose fit of each by itself misses its file by 1e-3, and
    with numbers by hand, too. The wave is 0.2 mm high: nothing holds heading and place. Both lie as the file
    has them, its axes turned by the bearing about a point aside of the world's origin; one may lie with its
    bow to the other's stern.
    """
    turned, by = (math.radians(headings[0]), math.radians(headings[1])), math.radians(bearing)
    origin = np.array([11.0, 23.0])
    two_hulls.database(tmp_path / "two.nc", turned)
    swell = {"height": "0.2 mm", "period": f"{PERIOD!r} s", "direction": f"{direction} deg"}
    path = two_hulls.in_waves(
        tmp_path,
        swell,
        turned,
        by,
        (float(origin[0]), float(origin[1])),
        water=water,
        duration=f"{60 * PERIOD!r} s",
        simulation={"sample_interval": f"{PERIOD / 16!r} s"},
    )
    run = simulate(path, tension_tolerance=0.1, position_tolerance=1e-9)
    towards = math.radians(direction)
    way = OMEGA**2 / waves.G * float(origin @ [math.cos(towards), math.sin(towards)])
    moved = two_hulls.response(OMEGA, towards - by, turned, ON_TOP if water is on_top else 0.0)
    expected = 1e-4 * np.exp(1j * way) * moved
    for k, heading in enumerate(turned):
        place, lies = (run.variables[f"body_{kind}"].values[:, k] for kind in ("position", "orientation"))
        found = waves.amplitudes(run.time, place, lies, OMEGA, by + heading)
        wanted = expected[6 * k : 6 * k + 6]
        scale = np.repeat([np.abs(wanted[:3]).max(), np.abs(wanted[3:]).max()], 3)
        assert np.abs(found - wanted) / scale == pytest.approx(np.zeros(6), abs=1e-5)
