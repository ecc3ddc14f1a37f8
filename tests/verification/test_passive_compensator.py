"""The passive compensator of docs/guides/mechanics_in_a_lift_file.md against an integration of its own.

Upright, with the way of the hook as given: the cylinder (6 t) on its grommet, the rod (2 t), which slides
out of it by x, and the load (70 t) on two slings from the rod. Between cylinder and rod the gas pulls by its
curve, friction and damper act against ẋ, and stops push at both ends.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from gantline.results.recording import Recording
from gantline.simulation import simulate
from gantline.statics import Statics
from mechanics import G
from shown import MECHANICS, lift_on

TITLE = "A manifold under a passive compensator"
CYLINDER, ROD, LOAD = 6e3, 2e3, 70e3
GAS = 4.412
STRAIN = np.array([0.0, 0.02, 0.1333, 0.2467, 0.36, 0.4733, 0.5867, 0.7])
PULL = 1e3 * np.array([0.0, 600.0, 635.9, 676.0, 721.3, 772.8, 831.8, 900.0])
SEALS, DAMPER = 20e3, 20e3
SLOW = 1e-6
"""Speed over which the friction of the integration turns round [m/s]: what it holds creeps by microns."""


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "compensator.yaml"
    path.write_text(lift_on(MECHANICS, TITLE), encoding="utf-8")
    return path


def way_out(run: Recording) -> Any:
    """How far the rod is out [m]."""
    cylinder, rod = (run.coordinates["body"].index(name) for name in ("cylinder", "rod"))
    height = run.variables["body_position"].values[:, :, 2]
    return height[:, cylinder] - height[:, rod] - 2.5


def pushed(stiffness: float, damping: float, over: float, rate: float) -> float:
    """Force of a spring and damper that only pull, or only push, (R2) and (N1) [N]."""
    return max(0.0, stiffness * over + damping * rate)


def upright(hook: CubicSpline, resting: float, times: Any) -> tuple[Any, Any]:
    """Force of the grommet [N] and way out of the rod [m] at `times`, by the equations of motion.

    The rod starts at `resting`: its friction leaves that open.
    """

    def forces(t: float, y: Any) -> tuple[float, float, float, float]:
        cylinder, x, load, v, u, w = y
        top = hook(t) - (cylinder + 2.0)
        grommet = pushed(100e6, 1e6, top - 2.0, hook(t, 1) - v)
        strain = (4.5 + x) / GAS - 1.0
        between = np.interp(strain, STRAIN, PULL) + SEALS * math.tanh(u / SLOW) + DAMPER * u
        between += pushed(100e6, 1e6, x - 3.0, u) - pushed(100e6, 1e6, -x, -u)
        drop = cylinder - 2.5 - x - (load + 1.5)
        long = math.hypot(drop, 2.0)
        leg = pushed(100e6 / 9.8, 2e6 / 9.8, long - 9.8, (v - u - w) * drop / long)
        ground = pushed(800e6, 8e6, 1.5 - load, -w)
        return grommet, between, 2.0 * leg * drop / long, ground

    def rates(t: float, y: Any) -> Any:
        grommet, between, slings, ground = forces(t, y)
        v, u, w = y[3:]
        up = (grommet - between) / CYLINDER - G
        down = G + (slings - between) / ROD  # of the rod
        return [v, u, w, up, up + down, (slings + ground) / LOAD - G]

    start = [15.0 - (CYLINDER + ROD) * G / 100e6, resting, 1.5 - LOAD * G / 800e6, 0.0, 0.0, 0.0]
    found = solve_ivp(rates, (0.0, times[-1]), start, "Radau", times, rtol=1e-7, atol=1e-9, max_step=0.02)
    assert found.success
    pulls = [forces(t, y)[0] for t, y in zip(found.t, found.y.T, strict=True)]
    return np.array(pulls), found.y[1]


def test_a_lift_off_against_its_own_equations(lift: Path) -> None:
    """Peak, way out of the rod, and all of the course; the page has the first two. The run is right to its
    tolerance, 0.1 % of what hangs there.
    """
    run = simulate(lift, duration=14.0)
    hook = run.coordinates["body"].index("hook")
    height = CubicSpline(run.time, run.variables["body_position"].values[:, hook, 2])
    out = way_out(run)
    pull, way = upright(height, out[0], run.time)
    grommet = run.variables["rope_tension"].values[:, run.coordinates["rope"].index("grommet")]
    weight = (CYLINDER + ROD + LOAD) * G
    assert grommet.max() == pytest.approx(pull.max(), rel=1e-4)
    assert out == pytest.approx(way, abs=1e-4)
    assert np.sqrt(np.mean((grommet - pull) ** 2)) < 1e-3 * weight
    assert grommet.max() == pytest.approx(779e3, abs=0.5e3)
    assert out.max() == pytest.approx(1.26, abs=5e-3)


def test_the_same_with_the_rod_held_in(lift: Path) -> None:
    """The peak without a compensator on the page."""
    text = lift.read_text(encoding="utf-8")
    assert text.count("upper: 3 m") == 1
    lift.write_text(text.replace("upper: 3 m", "upper: 0.001 mm"), encoding="utf-8")
    run = simulate(lift, duration=5.0)
    assert run.variables["hook_load"].values.max() == pytest.approx(931e3, abs=0.5e3)


def test_its_rest_and_its_own_period(lift: Path) -> None:
    """The rod has come out against its seals, which hold the rest. Load and rod rise and sink on the slope of
    the curve between 1 m and 1.5 m, in a row with slings and grommet; the cylinder takes part by 1e-3.
    """
    statics = Statics(lift)
    assert statics.equilibrium().tension("gas") == pytest.approx((ROD + LOAD) * G - SEALS, rel=1e-9)
    slings = 2.0 * 100e6 / 9.8 * (1.0 - (2.0 / 9.8) ** 2)
    gas = (PULL[4] - PULL[3]) / (GAS * (STRAIN[4] - STRAIN[3]))
    stiffness = 1.0 / (1.0 / gas + 1.0 / slings + 1.0 / 100e6)
    (mode,) = (mode for mode in statics.modes() if mode.motion == "manifold moves along z")
    assert mode.period == pytest.approx(2.0 * math.pi * math.sqrt((ROD + LOAD) / stiffness), rel=1e-3)
