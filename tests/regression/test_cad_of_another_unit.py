"""A CAD file in mm that a lift takes for one in m: its weight was told as `+104666666566.7 %` off.

A box of 8 m by 6 m by 3 m, full of steel at 7850 kg/m³, weighs 1130.4 t; written in mm and read in m it has
1e9 times that. The load of the lift file weighs 60 t: 18.84 times as much, or 1.884e10 times.
"""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario
from lift_text import spoiled

SIDES = ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))


def box(unit: float) -> str:
    """An OBJ file of the box, in a unit [1/m]."""
    corners = np.array([*product((-4.0, 4.0), (-3.0, 3.0), (0.0, 3.0))]) * unit
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    return "\n".join([*lines, *(f"f {a} {b} {c} {d}" for a, b, c, d in SIDES)])


@pytest.mark.parametrize(("unit", "said"), [(1.0, "19 times as much"), (1e3, "18,840,000,000 times as much")])
def test_how_many_times_as_much(tmp_path: Path, unit: float, said: str) -> None:
    (tmp_path / "load.obj").write_text(box(unit), encoding="utf-8")
    shape = "shape: {cad: load.obj, units: m}\n  datum: bottom_centre"
    path = tmp_path / "lift.yaml"
    path.write_text(spoiled("shape: {box: [8 m, 6 m, 3 m]}", shape), encoding="utf-8")
    warned = assemble(load_scenario(path)).warnings
    assert any(f"its calculated weight is 60 t ({said}): masses are scaled" in one for one in warned), warned
    assert not any("00.0 %" in one for one in warned)
