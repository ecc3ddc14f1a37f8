"""Wave forces of one body of a file of several were those beside neighbours that are held fast.

A wave program gives these, and beside them what each body does to the others by moving. Files of several
bodies were read, their off-diagonal numbers left out without a word, and forces taken as they were: a barge
of 40 × 12 × 2 m in the lee of one of 60 × 20 × 3 m, 6 m apart, beam on to waves of 8 s heaved with 0.47 m per
metre, where all twelve motions together give 1.01 m, and 1.02 m alone; held fast, the larger keeps waves off
that it goes along with when it floats. In waves as long as 12 s it was 0.78 m in place of 1.00 m.

In very long waves, A(ω) and B(ω) of no matter what, all that floats goes up and down with the water.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import two_hulls
import waves
from gantline.assembly import assemble
from gantline.scenario import load_scenario

OMEGA = 0.3
SWELL = {"height": "1 m", "period": f"{2 * math.pi / OMEGA!r} s", "direction": "60 deg"}


def forces(path: Path) -> dict[str, Any]:
    """Of both vessels in the waves of the lift from the directions of the file (directions, 6) [N/m, N]."""
    found = {}
    for force in assemble(load_scenario(path)).document["forces"]:
        if force["type"] == "wave":
            real, imaginary = np.moveaxis(np.array(force["phasors"])[0, :, 0], -1, 0)
            found[force["body"]] = real + 1j * imaginary
    return found


def test_forces_are_those_beside_neighbours_that_float(tmp_path: Path) -> None:
    """Y = (−ω²(M + A) − iωB + C) ξ of each by itself, ξ of all twelve together, phases from its middle:
    with A and B of the file's period to rounding.
    """
    two_hulls.database(tmp_path / "two.nc")

    def constants(by_file: dict[str, Any]) -> dict[str, Any]:
        at_period = {**by_file, "period": f"{2 * math.pi / OMEGA!r} s"}
        return {"added_mass": at_period, "water_damping": at_period}

    found = forces(two_hulls.in_waves(tmp_path, SWELL, water=constants))
    added, damping = waves.radiated(np.array([OMEGA]))
    alone = waves.impedance(OMEGA, added[0], damping[0])
    for k, body in enumerate(two_hulls.BODIES):
        wanted = []
        for direction in two_hulls.DIRECTIONS:
            towards = np.array([math.cos(direction), math.sin(direction)])
            way = OMEGA**2 / waves.G * float(two_hulls.REFERENCES[k, :2] @ towards)
            moved = two_hulls.response(OMEGA, float(direction))[6 * k : 6 * k + 6]
            wanted.append(alone @ moved * np.exp(-1j * way))
        scale = np.abs(wanted).max(axis=0)
        assert np.abs(found[body] - wanted) / scale == pytest.approx(np.zeros((12, 6)), abs=1e-9)


def test_what_others_do_is_no_trifle(tmp_path: Path) -> None:
    """Held fast, heave of the left one is 0.73 of Froude and Krylov's, |0.7 + 0.2i|; it is another force."""
    two_hulls.database(tmp_path / "two.nc")
    found = forces(two_hulls.in_waves(tmp_path, SWELL))["left"][:, 2]
    held = [two_hulls.excitation(OMEGA, float(direction))[2] for direction in two_hulls.DIRECTIONS]
    assert (np.abs(np.abs(found) / np.abs(held) - 1.0) > 0.02).all()
