"""Ropes whose tension is a curve over their strain, against closed forms and an integration of their own.

Equations (R2) and (R5) of docs/concepts/rope.md. A rope of 10 m gets stiffer, or softer, at 1 and 2 %.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from mechanics import Floats, G, Json, adaptive, body, document, end, point, rope, simulate, slider

LENGTH = 10.0
STRAINS = (0.01, 0.02, 0.03)
STIFFENS, SOFTENS = (1e5, 3e5, 7e5), (4e5, 6e5, 7e5)
CURVES = pytest.mark.parametrize("tensions", [STIFFENS, SOFTENS])


def pull(strain: float, tensions: tuple[float, ...]) -> float:
    """Tension [N], along the last line beyond the last point."""
    if strain > STRAINS[-1]:
        slope = (tensions[-1] - tensions[-2]) / (STRAINS[-1] - STRAINS[-2])
        return tensions[-1] + slope * (strain - STRAINS[-1])
    return float(np.interp(strain, (0.0, *STRAINS), (0.0, *tensions)))


def energy(strain: float, tensions: tuple[float, ...]) -> float:
    """Its integral [N], exact: trapezoids up to each point."""
    places = [0.0, *(one for one in STRAINS if one < strain), strain]
    forces = [pull(one, tensions) for one in places]
    return math.fsum(
        0.5 * (low + high) * (after - before)
        for before, after, low, high in zip(places, places[1:], forces, forces[1:], strict=False)
    )


def strain_under(tension: float, tensions: tuple[float, ...]) -> float:
    """The inverse of `pull`, within the points."""
    return float(np.interp(tension, (0.0, *tensions), (0.0, *STRAINS)))


def curved(tensions: tuple[float, ...], damping_time: float = 0.0) -> Json:
    points = [list(one) for one in zip(STRAINS, tensions, strict=True)]
    return {"type": "curved", "points": points, "damping_time": damping_time}


def hung(mass: float, material: Json, drop: float) -> Json:
    """A mass `m` under a rope `r`, at rest a `drop` [m] above where that is taut."""
    ends = [end(None, (0, 0, LENGTH)), end("m")]
    one = rope("r", LENGTH, ends, 1.0) | {"material": material}
    return document([body("m", slider(), mass, position=(0, 0, drop))], ropes=[one])


@CURVES
@pytest.mark.parametrize(("method", "close"), [("adaptive", 2e-5), ("del", 2e-3)])
def test_a_dropped_mass_turns_back_where_the_rope_has_taken_its_energy(
    tensions: tuple[float, ...], method: str, close: float
) -> None:
    """m g (h + x) = L u(x/L), and the peak is the tension there: beyond the last point of both curves.

    `adaptive` to 10 N; `del` of the first order in steps of 0.1 ms.
    """
    mass, drop = 20e3, 0.6
    low, high = 0.0, 1.0
    while high - low > 1e-12:
        deep = 0.5 * (low + high)
        is_held = LENGTH * energy(deep / LENGTH, tensions) > mass * G * (drop + deep)
        low, high = (low, deep) if is_held else (deep, high)
    assert low / LENGTH > STRAINS[-1]
    system = hung(mass, curved(tensions), drop)
    if method == "adaptive":
        found = adaptive(system, 0.8, tension_tolerance=10.0, position_tolerance=1e-6, sample_interval=1e-3)
    else:
        found = simulate(system, 0.8, step=1e-4)
    assert found.peak("r") == pytest.approx(pull(low / LENGTH, tensions), rel=close)
    # Energy stored is that of the curve wherever it is: its books close with it.
    total = found.columns["energy"].sum(axis=1)
    assert abs(found.energy_remainder) < (1e-9 if method == "adaptive" else 1e-6) * np.abs(total).max() + 1e-3


@CURVES
def test_a_swinging_mass_against_an_integration_of_its_own(tensions: tuple[float, ...]) -> None:
    """A mass on the rope thrown aside, with damping: T = G(s) + τ G²/2u ds/dt, by Runge-Kutta of order 8."""
    mass, damping = 30e3, 0.02
    begin, velocity = (0.3, 0.0, 0.0), (2.0, 1.0, 0.0)

    def rates(_: float, state: Floats) -> Floats:
        way = np.array((0.0, 0.0, LENGTH)) - state[:3]
        length = float(np.linalg.norm(way))
        along = way / length
        strain, rate = length / LENGTH - 1.0, -float(along @ state[3:]) / LENGTH
        tension = 0.0
        if strain > 0.0:
            force = pull(strain, tensions)
            tension = max(0.0, force + damping * force**2 / (2.0 * energy(strain, tensions)) * rate)
        return np.array([*state[3:], *(along * tension / mass - (0.0, 0.0, G))])

    time = np.arange(0.0, 3.0, 0.01)
    expected = solve_ivp(
        rates,
        (0.0, 3.0),
        (*begin, *velocity),
        method="LSODA",
        t_eval=time,
        rtol=1e-10,
        atol=1e-9,
        max_step=1e-3,
    ).y.T
    ends = [end(None, (0, 0, LENGTH)), end("m")]
    one = rope("r", LENGTH, ends, 1.0) | {"material": curved(tensions, damping)}
    system = document([body("m", point(begin, velocity), mass)], ropes=[one])
    found = adaptive(system, 3.0, tension_tolerance=30.0, position_tolerance=1e-6, sample_interval=0.01)
    # Corners of the curve cost both orders; 1e-5 m of ways of 8 m.
    assert np.abs(found.body("m")[: len(time)] - expected[:, :3]).max() < 1e-5


@CURVES
def test_one_line_is_a_rope_of_one_stiffness(tensions: tuple[float, ...]) -> None:
    """A curve with points on one line moves its mass as `axial_stiffness` does, to rounding."""
    ea = tensions[-1] / STRAINS[-1]
    elastic = {"type": "elastic", "axial_stiffness": ea, "damping_time": 5e-3}
    line = {"type": "curved", "points": [[one, ea * one] for one in STRAINS], "damping_time": 5e-3}
    first, second = (adaptive(hung(20e3, one, 0.1), 0.5, tension_tolerance=10.0) for one in (elastic, line))
    assert second.tension("r") == pytest.approx(first.tension("r"), rel=1e-9, abs=1e-3)


@CURVES
def test_a_rope_breaks_at_its_force_on_any_line(tensions: tuple[float, ...]) -> None:
    """A mass let go with a rope just taut breaks it at 250 kN, where it is L s(250 kN) down."""
    mass, force = 20e3, 250e3
    system = hung(mass, curved(tensions), 0.0)
    system["ropes"][0]["breaking_force"] = force
    found = adaptive(system, 0.8, tension_tolerance=10.0, position_tolerance=1e-6, sample_interval=1e-4)
    [(when, name)] = found.events("broken")
    depth = LENGTH * strain_under(force, tensions)
    place = float(np.interp(when, found.time, found.body("m")[:, 2]))
    assert name == "r"
    # Linear between samples of 0.1 ms: g h²/8 and less.
    assert place == pytest.approx(-depth, abs=1e-6)
    assert found.peak("r") == pytest.approx(force, rel=1e-6)


LIFT = """\
format: 1
lift: {{title: A load under two ropes with a curve}}
duration: 1 s
start: rest
ropes:
  fibre: {{curve: {{strain: [1 %, 2 %, 3 %], tension: {tensions}}}}}
mechanics:
  bodies:
    load: {{joint: {{type: free, position: [0 m, 0 m, 0 m]}}, mass: {mass} t,
      inertia: {{xx: 20 t m^2, yy: 20 t m^2, zz: 20 t m^2}}}}
  ropes:
    a:
      rope: fibre
      length: {length} m
      route:
        - {{type: end, body: world, at: [{a} m, 0 m, 11 m]}}
        - {{type: end, body: load, at: [{a} m, 0 m, 1 m]}}
    b:
      rope: fibre
      length: 10 m
      route:
        - {{type: end, body: world, at: [1 m, 0 m, 11 m]}}
        - {{type: end, body: load, at: [1 m, 0 m, 1 m]}}
"""


def _statics(
    tensions: tuple[float, ...], mass: float = 40.0, length: float = 10.0, scale: float = 1.0, a: float = -1.6
) -> Statics:
    listed = ", ".join(f"{scale * one!r} N" for one in tensions)
    return Statics(parse_scenario(LIFT.format(tensions=f"[{listed}]", mass=mass, length=length, a=a)))


@CURVES
def test_equilibria_hang_as_the_curve_has_them(tensions: tuple[float, ...]) -> None:
    """Each rope is as long as the curve has it under its tension, and both bear the load."""
    question = _statics(tensions)
    recording = question.equilibrium().recording
    found = []
    for name in "ab":
        tension = float(recording.column("rope_tension", name)[-1])
        path = recording["rope_point"].values[-1][recording.points_of_ropes[name]]
        strain = float(np.linalg.norm(path[1] - path[0])) / LENGTH - 1.0
        assert pull(strain, tensions) == pytest.approx(tension, rel=1e-9)
        found.append(tension)
    # They lean by less than 2 mrad.
    assert sum(found) == pytest.approx(40e3 * G, rel=4e-6)
    assert found[1] > 1.5 * found[0]  # by moments 1.6, and what it is askew


@CURVES
def test_a_small_motion_rings_with_the_slope_of_the_curve(tensions: tuple[float, ...]) -> None:
    """Up and down, both ropes alike: ω² = 2 G'(s)/(L m), s under half of the weight."""
    question = _statics(tensions, mass=90.0, a=-1.0)
    strain = strain_under(45e3 * G, tensions)
    place = int(np.searchsorted(STRAINS, strain))
    assert place == 2 if tensions == STIFFENS else place == 1
    slope = (tensions[place] - tensions[place - 1]) / 0.01
    omega = math.sqrt(2.0 * slope / (LENGTH * 90e3))
    question.equilibrium()
    assert min(abs(math.tau / (mode.period or 1.0) / omega - 1.0) for mode in question.modes()) < 1e-9


@CURVES
@pytest.mark.parametrize(("kind", "size"), [("length", 1e-5), ("stiffness", 1e-4), ("mass", 1e-3)])
def test_sensitivities_are_those_of_lifts_that_are_changed(
    tensions: tuple[float, ...], kind: str, size: float
) -> None:
    """Central differences of lifts solved anew, of the second order: 1e-6 of what changes."""
    question = _statics(tensions)
    rest = question.equilibrium().recording
    name = {"length": "a", "stiffness": "a", "mass": "load"}[kind]
    [answer] = question.sensitivities([(kind, name)])
    if kind == "stiffness":
        # Both ropes are of one kind here: what both together change.
        [other] = question.sensitivities([(kind, "b")])
    changed = []
    for sign in (1.0, -1.0):
        by = {
            "length": {"length": LENGTH + sign * size},
            "stiffness": {"scale": 1.0 + sign * size},
            "mass": {"mass": 40.0 + sign * size},
        }[kind]
        found = _statics(tensions, **by).equilibrium().recording
        changed.append([float(found.column("rope_tension", one)[-1]) for one in "ab"])
    ea = float(rest.attributes["axial_stiffness"]["a"])
    whole = {"length": 2.0 * size, "stiffness": 2.0 * size * ea, "mass": 2.0 * size * 1e3}[kind]
    for place, one in enumerate("ab"):
        difference = (changed[0][place] - changed[1][place]) / whole
        expected = answer.of(one) + (other.of(one) if kind == "stiffness" else 0.0)
        floor = 1e-6 * {"length": ea / LENGTH, "stiffness": 1e-3, "mass": G}[kind]
        assert expected == pytest.approx(difference, rel=1e-5, abs=floor)
