"""A load on a compensator under a crane barge in regular waves, against two masses of its own.

The barge of the scenario `crane_barge_in_swell` heaves its hook; below it the cylinder (m₁) hangs on a sling,
and the load with the rod (m₂) on the gas, all plumb but for what swings, which is second order. With the
height h of the hook as the run has it

    m₁ a₁ = k (h - z₁ - L) - F(x) - m₁ g,    m₂ a₂ = F(x) - m₂ g,    x = z₁ - ℓ - z₂,

z₁ and z₂ the bearings of cylinder and rod, and k of the sling; slings below the rod are a thousand times as
stiff as the gas.
"""

from __future__ import annotations

import math
import re
from bisect import bisect_right
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from compensated import BARGE
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from lift_text import changed
from mechanics import G

HOOK = "sheerleg.H1"
CYLINDER, ROD, LOAD = 6e3, 2e3, 120e3
STROKE, IN, OUT, POWER, REACH = 4.0, 1000e3, 1350e3, 1.1, 6.0
COLUMN = STROKE / (1.0 - (IN / OUT) ** (1.0 / POWER))
EA, GROMMET = 400e6, 4.0
DAMPER, SHACKLE = 30e3, 27.0
WORDS = """\
compensators:
  PHC:
    length: 6 m
    stroke: 4 m
    cylinder: {mass: 6 t, length: 5 m, diameter: 0.8 m}
    rod: {mass: 2 t, diameter: 0.3 m}
    pull: {rod_in: 1000 kN, rod_out: 1350 kN}
    gas_exponent: 1.1
    damping: 30 kN s/m
"""


def gas(x: Any) -> Any:
    """(PC1) of two pulls [N]."""
    return IN * (COLUMN / (COLUMN - x)) ** POWER


def afloat(period: float) -> Scenario:
    """The barge holds the module in waves of 1 m that are all alike, ahead onto its bow."""
    text = BARGE.read_text(encoding="utf-8")
    plan = "plan:\n  - {step: hold, hold: until_end}\n"
    for section, instead in (("plan", plan), ("watch", ""), ("cases", ""), ("limits", ""), ("waves", "")):
        text, count = re.subn(
            rf"^{section}:.*?(?=^\w)", instead, text, count=1, flags=re.DOTALL | re.MULTILINE
        )
        assert count == 1, section
    waves = f"waves:\n  swell: {{height: 1 m, period: {period} s, direction: 180 deg}}\n"
    ropes = "ropes:\n  grommet: {axial_stiffness: 400 MN, damping_time: 10 ms, mass: none}\n"
    text = changed(
        text,
        ("duration: 300 s", "duration: 120 s"),
        ("ropes:\n", waves + ropes),
        ("H1: {type: hook_300, height: 30 m}", "H1: {type: hook_300, height: 40 m}"),
        ("slings:\n", f"{WORDS}slings:\n"
         "  G: {rope: grommet, from: sheerleg.H1, to: PHC, length: 4 m}\n"),
    )  # fmt: skip
    for sling in "ABCD":
        text = changed(text, (f"{sling}: {{from: sheerleg.H1,", f"{sling}: {{from: PHC,"))
    return parse_scenario(text, str(BARGE))


def masses_of(run: Recording) -> Any:
    """Of what moves with cylinder, the shackle below the grommet too, and with the rod [kg]."""
    on_rod = run.rig.compensators[0].weight / G - CYLINDER - SHACKLE
    return np.array([CYLINDER + SHACKLE, on_rod + run.rig.loads[0].weight / G])


def by_pieces(spline: CubicSpline) -> Callable[[float], tuple[float, float]]:
    """Value and slope of a spline at one time, without numpy, which takes ten times as long for one."""
    knots, pieces = spline.x.tolist(), spline.c.T.tolist()

    def at(time: float) -> tuple[float, float]:
        which = min(bisect_right(knots, time), len(pieces)) - 1
        a, b, c, d = pieces[which]
        after = time - knots[which]
        return ((a * after + b) * after + c) * after + d, (3 * a * after + 2 * b) * after + c

    return at


def bodies(run: Recording) -> Any:
    """Way out of the rod [m] by the two masses below the hook of a run."""
    hook = by_pieces(CubicSpline(run.time, run.column("body_position", HOOK)[:, 2]))
    masses = masses_of(run).tolist()

    def rates(t: float, y: Any) -> Any:
        z, x, v, u = y.tolist()
        height, speed = hook(t)
        pull = max(0.0, EA / GROMMET * (height - z - GROMMET + 0.01 * (speed - v)))
        force = gas(x) + DAMPER * u
        up = (pull - force) / masses[0] - G
        return [v, u, up, up - (force / masses[1] - G)]

    x = COLUMN * (1.0 - (IN / (masses[1] * G)) ** (1.0 / POWER))
    start = [hook(0.0)[0] - GROMMET - sum(masses) * G * GROMMET / EA, x, 0.0, 0.0]
    # Within 4e-7 m of Radau's answer, in an eighth of its time.
    found = solve_ivp(rates, (0.0, run.time[-1]), start, "LSODA", run.time, rtol=1e-8, atol=1e-9)
    assert found.success
    return found.y[1]


@pytest.fixture(scope="module", params=[4.0, 5.5])
def run(request: pytest.FixtureRequest) -> Recording:
    return simulate(afloat(request.param))


def test_the_rod_follows_two_masses_below_the_hook(run: Recording) -> None:
    """Below and near its own period of 7.1 s, all of the course from rest as the waves grow. The run is off
    by the chords of (PC4), 1e-4 of the pull over the slope of 93 kN/m, and by 1 % of how the rod moves.
    """
    assert "stop_hit" not in run.coordinates.get("event_kind", ())
    out, expected = run.column("rod_out", "PHC"), bodies(run)
    chords = 1e-4 * (ROD + LOAD) * G / 93e3
    assert np.ptp(expected) > 0.15
    assert out == pytest.approx(expected, abs=chords + 0.01 * np.ptp(expected))


def test_how_much_of_the_heave_of_its_hook_a_load_has(run: Recording) -> None:
    """(PC6) with a damper: |H|² = (1 + d²)/((1 - mω²/k)² + d²), d = cω/k, on the slope k of the gas at rest.
    Heights over the last whole periods; gas of another slope than at rest and what swings are second order.
    """
    (train,) = run.rig.sea.trains if run.rig.sea is not None else ()
    omega, mass = 2.0 * math.pi / train.period, float(masses_of(run)[1])
    pull = mass * G
    slope = POWER * pull / COLUMN * (pull / IN) ** (1.0 / POWER)
    d, inertia = DAMPER * omega / slope, mass * omega**2 / slope
    expected = math.sqrt((1.0 + d * d) / ((1.0 - inertia) ** 2 + d * d))
    last = run.time >= run.time[-1] - 8.0 * train.period
    heaves = [np.ptp(run.column("body_position", name)[last, 2]) for name in (HOOK, "module")]
    assert heaves[1] / heaves[0] == pytest.approx(expected, rel=0.02)
    assert (expected < 1.0) == (train.period < 5.0)
