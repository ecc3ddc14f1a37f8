"""Compensators: the lift of docs/concepts/compensator.md and a load afloat against equations of their own.

Upright, with the way of the hook as given: the cylinder on its grommet, the rod, which slides out of it by x,
and the load on slings from the rod. Between cylinder and rod the gas pulls by (PC1), friction and damper act
against ẋ, and stops push at both ends.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.interpolate import CubicSpline

from gantline.assembly.cranes.compensators import gas_kind
from gantline.results.recording import Recording
from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from mechanics import G
from shown import ROOT, lift_on

PAGE = ROOT / "docs" / "concepts" / "compensator.md"
TITLE = "A manifold under a passive compensator"
CYLINDER, ROD, LOAD = 6e3, 2e3, 70e3
STROKE, IN, OUT, POWER = 3.0, 600e3, 900e3, 1.1
#: (PC2), by hand.
COLUMN = STROKE / (1.0 - (IN / OUT) ** (1.0 / POWER))
SEALS, DAMPER = 20e3, 20e3
SLOW = 1e-6
"""Speed over which the friction of the integration turns round [m/s]: what it holds creeps by microns."""


def gas(x: Any) -> Any:
    """(PC1) of two pulls [N]."""
    return IN * (COLUMN / (COLUMN - x)) ** POWER


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "compensator.yaml"
    path.write_text(lift_on(PAGE, TITLE), encoding="utf-8")
    return path


def lift_with(*pieces: tuple[str, str]) -> Scenario:
    return parse_scenario(changed(lift_on(PAGE, TITLE), *pieces), "compensator.yaml")


def pushed(stiffness: float, damping: float, over: float, rate: float) -> float:
    """Force of a spring and damper that only pull, or only push, (R2) and (N1) [N]."""
    return max(0.0, stiffness * over + damping * rate)


@dataclass(frozen=True)
class Upright:
    """What hangs plumb below a hook.

    Attributes:
        masses: Of cylinder, rod, load [kg].
        grommet: Stiffness [N/m], length [m] and damping time [s].
        legs: The same of each sling, how many, and how far out a lug is from below the rod [m].
        reach: From bearing to bearing, rod in [m].
        gas: Pull over the way out [N].
        between: Friction and damper of the rod [N, N s/m].
        stops: Stiffness [N/m] and damping time [s] of both, and the stroke [m].
        ground: How the ground pushes the load, by its height and speed [N].
    """

    masses: tuple[float, float, float]
    grommet: tuple[float, float, float]
    legs: tuple[float, float, float, int, float]
    reach: float
    gas: Callable[[float], float]
    between: tuple[float, float]
    stops: tuple[float, float, float]
    ground: Callable[[float, float], float]

    def forces(self, hook: CubicSpline, t: float, y: Any) -> tuple[float, float, float, float]:
        """Of grommet, between cylinder and rod, of all slings upright, of the ground [N]."""
        top, x, lugs, v, u, w = y
        k, length, tau = self.grommet
        grommet = pushed(k, k * tau, hook(t) - top - length, hook(t, 1) - v)
        stiff, slow, stroke = self.stops
        friction, damper = self.between
        between = self.gas(x) + friction * math.tanh(u / SLOW) + damper * u
        between += pushed(stiff, stiff * slow, x - stroke, u) - pushed(stiff, stiff * slow, -x, -u)
        k, length, tau, count, aside = self.legs
        drop = top - self.reach - x - lugs
        long = math.hypot(drop, aside)
        leg = pushed(k, k * tau, long - length, (v - u - w) * drop / long)
        return grommet, between, count * leg * drop / long, self.ground(lugs, w)

    def follow(self, hook: CubicSpline, start: Any, times: Any) -> tuple[Any, Any]:
        """Force of the grommet [N] and way out of the rod [m] at `times`, by the equations of motion."""
        cylinder, rod, load = self.masses

        def rates(t: float, y: Any) -> Any:
            grommet, between, slings, ground = self.forces(hook, t, y)
            v, u, w = y[3:]
            up = (grommet - between) / cylinder - G
            down = G + (slings - between) / rod  # of the rod
            return [v, u, w, up, up + down, (slings + ground) / load - G]

        found = solve_ivp(rates, (0.0, times[-1]), start, "LSODA", times, rtol=1e-7, atol=1e-9, max_step=0.02)
        assert found.success
        pulls = [self.forces(hook, t, y)[0] for t, y in zip(found.t, found.y.T, strict=True)]
        return np.array(pulls), found.y[1]


def manifold(
    between: Callable[[float], float] = gas, seals: float = SEALS, damper: float = DAMPER
) -> Upright:
    """That of the page."""
    return Upright(
        (CYLINDER, ROD, LOAD),
        (100e6, 2.0, 0.01),
        (100e6 / 9.8, 9.8, 0.02, 2, 2.0),
        4.5,
        between,
        (seals, damper),
        (100e6, 0.01, STROKE),
        lambda lugs, w: pushed(800e6, 8e6, 3.0 - lugs, -w),
    )


def from_the_ground(run: Recording, hanging: Upright) -> tuple[Any, Any]:
    """What hangs on the hook of a run follows that; the rod starts where the run has it."""
    hook = CubicSpline(run.time, run.column("body_position", "hook")[:, 2])
    x = float(run.column("rod_out", "PHC")[0])
    start = [17.0 - (CYLINDER + ROD) * G / 100e6, x, 3.0 - LOAD * G / 800e6, 0.0, 0.0, 0.0]
    return hanging.follow(hook, start, run.time)


def test_a_lift_off_against_its_own_equations(lift: Path) -> None:
    """Peak, way out of the rod, and all of the course; the page has the first two. The run is right to its
    tolerance, 0.1 % of what hangs there, and to the chords of (PC4), 1e-4 of the pull.
    """
    run = simulate(lift, duration=14.0)
    pull, way = from_the_ground(run, manifold())
    grommet = run.column("rope_tension", "sling.grommet")
    weight = (CYLINDER + ROD + LOAD) * G
    assert grommet.max() == pytest.approx(pull.max(), rel=2e-4)
    # What a pull is off by moves the rod by that over the slope of the gas, 91 kN/m.
    assert run.column("rod_out", "PHC") == pytest.approx(way, abs=1e-4 * weight / 91e3)
    assert np.sqrt(np.mean((grommet - pull) ** 2)) < 1e-3 * weight
    assert grommet.max() == pytest.approx(779e3, abs=0.5e3)
    assert run.metrics()["largest_rod_out.PHC"] == pytest.approx(1.26, abs=5e-3)


def test_the_same_by_del(lift: Path) -> None:
    """A fixed step of first order, 1 ms: a thousandth of the weight, as its energy balance promises."""
    lift.write_text(
        lift.read_text(encoding="utf-8") + "simulation: {integrator: del, step: 1 ms}\n", encoding="utf-8"
    )
    run = simulate(lift, duration=10.0)
    pull, way = from_the_ground(run, manifold())
    weight = (CYLINDER + ROD + LOAD) * G
    assert run.column("rope_tension", "sling.grommet").max() == pytest.approx(pull.max(), abs=1e-3 * weight)
    assert run.column("rod_out", "PHC") == pytest.approx(way, abs=1e-3 * weight / 91e3)


def test_the_same_with_the_rod_locked() -> None:
    """The peak without a compensator on the page: rod and cylinder in one, the gas of no account. Between
    them the integration has a spring of 100 GN/m, which gives by 6 microns, and a damper that keeps it from
    ringing.
    """
    run = simulate(lift_with(("    seal_friction: 20 kN\n", "    locked: true\n")), duration=5.0)
    pull, way = from_the_ground(run, manifold(lambda x: 1e11 * x, 0.0, 1e7))
    assert run.column("rod_out", "PHC") == pytest.approx(0.0, abs=1e-9)
    assert np.abs(way).max() < 1e-5
    assert run.column("rope_tension", "sling.grommet").max() == pytest.approx(pull.max(), rel=1e-3)
    assert run.column("hook_load", "hook").max() == pytest.approx(940e3, abs=0.5e3)


def test_its_rest_and_its_own_period(lift: Path) -> None:
    """The rod has come out against its seals, which hold the rest: F(x) = (m_rod + m) g - R, and by (PC1)
    x = V (1 - (F0/F)^(1/n)). Load and rod rise and sink on the slope of the gas there, (PC5), in a row with
    slings and grommet; the cylinder takes part by 1e-3.
    """
    statics = Statics(lift)
    pull = (ROD + LOAD) * G - SEALS
    out = COLUMN * (1.0 - (IN / pull) ** (1.0 / POWER))
    rest = statics.equilibrium()
    assert rest.tension("PHC.gas") == pytest.approx(pull, rel=1e-9)
    # A chord that is 1e-4 above the gas has the rod in by that share of the pull over its slope.
    slope = POWER * pull / (COLUMN - out)
    assert rest.recording.column("rod_out", "PHC")[-1] == pytest.approx(out, abs=1e-4 * pull / slope)
    slings = 2.0 * 100e6 / 9.8 * (1.0 - (2.0 / 9.8) ** 2)
    stiffness = 1.0 / (1.0 / slope + 1.0 / slings + 1.0 / 100e6)
    (mode,) = (mode for mode in statics.modes() if mode.motion == "manifold moves along z")
    # The slope of a chord of ratio r differs from that of the gas by up to (n + 1)/2 ln r, half of it in T.
    chord = (POWER + 1.0) / 4.0 * math.sqrt(8e-4 / (POWER * (POWER + 1.0)))
    assert mode.period == pytest.approx(2.0 * math.pi * math.sqrt((ROD + LOAD) / stiffness), rel=chord)


@pytest.mark.parametrize("power", [1.0, 1.1, 1.4])
@pytest.mark.parametrize("given", ["pull: {rod_in: 600 kN, rod_out: 900 kN}", "gas"])
def test_the_curve_is_that_of_the_gas(power: float, given: str) -> None:
    """Isothermal, adiabatic and between: tension over x against p V^n, within 1e-4 and never below; its
    energy against the integral of that. Gas of 6 MPa over 0.1 m^2 and 0.9731 m^3 has the same column as
    600 kN to 900 kN at n = 1.1, and the air outside takes 10.1 kN.
    """
    area, pressure, volume, air = 0.1, 6e6, 0.9731, 101_325.0
    charge = "gas: {charge_pressure: 6 MPa, piston_area: 0.1 m^2, volume: 0.9731 m^3}"
    words = charge if given == "gas" else given
    lift = lift_with(
        ("pull: {rod_in: 600 kN, rod_out: 900 kN}", words), ("gas_exponent: 1.1", f"gas_exponent: {power}")
    )
    (compensator,) = (lift.compensators or {}).values()
    length, kind = gas_kind(compensator)
    assert kind.curve is not None

    def law(x: float) -> Any:
        if given == "gas":
            return area * ((pressure + air) * (volume / (volume - area * x)) ** power - air)
        column = STROKE / (1.0 - (IN / OUT) ** (1.0 / power))
        return IN * (column / (column - x)) ** power

    outside = area * air if given == "gas" else 0.0
    for x in np.linspace(0.0, STROKE, 401):
        above = kind.curve.pull((4.5 + x) / length - 1.0)[0] - law(x)
        assert -1e-9 * law(x) <= above <= 1.0001e-4 * (law(x) + outside)
    energies = [kind.curve.pull((4.5 + x) / length - 1.0)[2] * length for x in (0.0, STROKE)]
    assert energies[1] - energies[0] == pytest.approx(quad(law, 0.0, STROKE)[0], rel=1e-4)
    assert compensator.law.pull(STROKE) == pytest.approx(law(STROKE), rel=1e-12)
    slope = (law(1.0 + 1e-5) - law(1.0 - 1e-5)) / 2e-5
    assert compensator.law.stiffness(1.0) == pytest.approx(slope, rel=1e-6)
    assert compensator.law.out(law(1.0)) == pytest.approx(1.0, rel=1e-9)


def test_its_energy_is_in_the_balance(lift: Path) -> None:
    """The gas takes up the integral of its pull from where the rod started, within its chords, and slings,
    grommet, ground and stop T²/2k each; the inner stop bears what the gas pulls there at the start.
    """
    run = simulate(lift, duration=14.0)
    assert run.attributes["energy_remainder"] < 1e-5
    scenario = load_scenario(lift)
    (compensator,) = (scenario.compensators or {}).values()
    x = run.column("rod_out", "PHC")
    gained = quad(gas, float(x[0]), float(x[-1]))[0]
    assert compensator.law.pull(float(x[-1])) == pytest.approx(gas(float(x[-1])), rel=1e-12)
    grommet, leg = (run.column("rope_tension", f"sling.{name}") for name in ("grommet", "S1"))
    ropes = grommet**2 / 2.0 / 100e6 + 2.0 * leg**2 / 2.0 * 9.8 / 100e6
    stop = 0.5 * 100e6 * np.minimum(x, 0.0) ** 2
    ground = np.array([run.variables["contact_force"].values[0].sum() ** 2 / 2.0 / 800e6, 0.0])
    elastic = run.column("energy", "elastic")
    expected = gained + (ropes + stop)[-1] - (ropes + stop)[0] + ground[1] - ground[0]
    assert elastic[-1] - elastic[0] == pytest.approx(expected, rel=2e-4)
