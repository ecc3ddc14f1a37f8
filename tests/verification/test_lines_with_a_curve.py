"""Mooring lines and tag lines of tension over strain, against closed forms and an integration of their own.

Equation (R5) of docs/concepts/rope.md. The line is as soft at first as nylon: 30 % of stretch at 900 kN.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import gantline
from gantline.scenario import parse_scenario
from mechanics import Floats

G = 9.81
STRAINS = (0.05, 0.10, 0.20, 0.30)
TENSIONS = (30e3, 90e3, 350e3, 900e3)
NYLON = f"curve: {{strain: [5 %, 10 %, 20 %, 30 %], tension: [{', '.join(f'{one} N' for one in TENSIONS)}]}}"
#: Slope of each line of the curve [N].
SLOPES = (6e5, 1.2e6, 2.6e6, 5.5e6)
#: Of the barge [kg]: 60 m by 20 m, 3 m deep in sea water.
MASS = 1025.0 * 60 * 20 * 3


def pull(strain: float) -> float:
    """Tension [N]; the last line goes on."""
    if strain > STRAINS[-1]:
        return TENSIONS[-1] + SLOPES[-1] * (strain - STRAINS[-1])
    return float(np.interp(strain, (0.0, *STRAINS), (0.0, *TENSIONS)))


def stored(strain: float) -> float:
    """Energy per length [N], by trapezoids that meet at the points."""
    at = [0.0, *(one for one in STRAINS if one < strain), strain]
    return math.fsum(0.5 * (pull(low) + pull(high)) * (high - low) for low, high in pairwise(at))


def strain_under(tension: float) -> float:
    """The inverse of `pull`."""
    return float(brentq(lambda strain: pull(strain) - tension, 0.0, 1.0, xtol=1e-16, rtol=1e-15))


def barge(wind: float, pretension: float) -> str:
    """A barge between two level lines of 40 m, ahead and astern; wind from astern, C A = 330 m²."""
    line = f"rope: nylon, type: spring, pretension: {pretension} N"
    return f"""\
format: 1
lift: {{title: A barge between two lines}}
duration: 1 s
start: rest
water: {{density: 1025 kg/m^3, level: 0 m}}
wind: {{speed: {wind} m/s, direction: 0 deg}}
ropes:
  nylon: {{{NYLON}, mass: none}}
vessels:
  barge:
    draft: 3 m
    hull: {{box: [60 m, 20 m, 5 m]}}
    masses: {{all: {{mass: {MASS} kg, at: [30 m, 0 m, 3 m]}}}}
    radii_of_gyration: [7 m, 15 m, 15 m]
    wind_areas: {{front: {{area: 300 m^2, coefficient: 1.1, along: x, at: [30 m, 0 m, 3 m]}}}}
mooring_lines:
  bow: {{vessel: barge, fairlead: [60 m, 0 m, 3 m], to: [100 m, 0 m, 0 m], {line}}}
  stern: {{vessel: barge, fairlead: [0 m, 0 m, 3 m], to: [-40 m, 0 m, 0 m], {line}}}
plan: [{{step: hold, hold: until_end}}]
"""


@pytest.mark.parametrize(("wind", "pretension"), [(15.0, 60e3), (25.0, 60e3), (40.0, 60e3), (20.0, 200e3)])
def test_a_barge_in_wind_lies_where_both_lines_have_it(wind: float, pretension: float) -> None:
    """T(40 m + x) - T(40 m - x) = ρ/2 C A v², by brentq, all level; the bow line is slack at 40 m/s.

    The surge about it has the slopes there: ω² m = Σ G'(s)/L of the lines that are taut.
    """
    statics = gantline.Statics(parse_scenario(barge(wind, pretension)))
    rest = statics.equilibrium()
    force = 0.5 * 1.225 * 330.0 * wind**2
    length = 40.0 / (1.0 + strain_under(pretension))

    def strains(way: float) -> tuple[float, float]:
        return (40.0 - way) / length - 1.0, (40.0 + way) / length - 1.0

    def missing(way: float) -> float:
        bow, stern = strains(way)
        return force + pull(max(bow, 0.0)) - pull(stern)

    way = brentq(missing, 0.0, 12.0, xtol=1e-12)
    bow, stern = strains(way)
    assert (bow < 0.0) == (wind == 40.0)
    for name, strain in (("bow", bow), ("stern", stern)):
        found = float(rest.recording.column("mooring_tension", name)[-1])
        # The lines are level to 0.1 mrad: they are made fast at the height of the centre of gravity.
        assert found == pytest.approx(pull(max(strain, 0.0)), rel=1e-7, abs=1e-3)
    slopes = [SLOPES[int(np.searchsorted(STRAINS, strain))] for strain in (bow, stern) if strain > 0.0]
    stiffness = sum(slopes) / length
    period = math.tau * math.sqrt(MASS / stiffness)
    assert min(abs((mode.period or math.inf) / period - 1.0) for mode in statics.modes()) < 1e-7


def between(more: str, *, velocity: float = 0.0, duration: float = 12.0, damping: float = 0.0) -> str:
    """A mass of 500 t on a slide along x between two level lines of 30 m, each with `more`."""
    line = f"vessel: mass, fairlead: [0 m, 0 m, 0 m], rope: nylon, type: spring, {more}"
    return f"""\
format: 1
lift: {{title: A mass between two lines}}
duration: {duration} s
start: as_given
ropes:
  nylon: {{{NYLON}, mass: none, damping_time: {damping} s}}
mechanics:
  bodies:
    mass: {{joint: {{type: slider, axis: [1, 0, 0], velocity: {velocity} m/s}}, mass: 500 t}}
mooring_lines:
  right: {{{line}, to: [30 m, 0 m, 0 m]}}
  left: {{{line}, to: [-30 m, 0 m, 0 m]}}
plan: [{{step: hold, hold: until_end}}]
simulation: {{sample_interval: 0.01 s, SETTINGS}}
"""


ADAPTIVE = "tension_tolerance: 1 N, position_tolerance: 0.0001 mm"


@pytest.mark.parametrize("pretension", [12e3, 30e3, 75e3, 200e3, 899e3, 950e3])
def test_a_pretension_is_the_first_tension_to_rounding(pretension: float) -> None:
    """On each line of the curve, at a point of it, and beyond its last: L = 30 m/(1 + s(T))."""
    text = between(f"pretension: {pretension} N", duration=0.1).replace("SETTINGS", ADAPTIVE)
    recording = gantline.simulate(parse_scenario(text))
    for name in ("left", "right"):
        assert recording.column("mooring_tension", name)[0] == pytest.approx(pretension, rel=1e-12)


@pytest.mark.parametrize(
    ("settings", "close", "balanced"),
    [(ADAPTIVE, 1e-5, 1e-7), ("integrator: del, step: 0.5 ms", 4e-3, 3e-6)],
)
def test_a_mass_between_two_lines_against_an_integration_of_its_own(
    settings: str, close: float, balanced: float
) -> None:
    """Thrown at 4 m/s with damping: T = G(s) + τ G²/2u ds/dt, not below 0, by Runge-Kutta of order 8.

    Both lines go slack in turn, and over all four lines of the curve. Way to 1e-5 m of 8 m; `del` is of the
    first order in way and balance, 3.2 mm and 2.3e-6 at this step and half of that at half of it.
    """
    damping, velocity, pretension = 0.05, 4.0, 60e3
    length = 30.0 / (1.0 + strain_under(pretension))

    def tension(strain: float, rate: float) -> float:
        if strain <= 0.0:
            return max(0.0, SLOPES[0] * (strain + damping * rate))
        force = pull(strain)
        return max(0.0, force + damping * force**2 / (2.0 * stored(strain)) * rate)

    def rates(_: float, state: Floats) -> list[float]:
        way, speed = state
        ahead = tension((30.0 - way) / length - 1.0, -speed / length)
        behind = tension((30.0 + way) / length - 1.0, speed / length)
        return [speed, (ahead - behind) / 500e3]

    text = between(f"pretension: {pretension} N", velocity=velocity, damping=damping)
    recording = gantline.simulate(parse_scenario(text.replace("SETTINGS", settings)))
    own = solve_ivp(
        rates,
        (0.0, 12.0),
        (0.0, velocity),
        "LSODA",
        recording.time,
        rtol=1e-11,
        atol=1e-11,
        max_step=5e-3,
    )
    way = recording.column("body_position", "mass")[:, 0]
    assert np.abs(own.y[0]).max() > 30.0 - length, "one is slack"
    assert (30.0 + np.abs(own.y[0]).max()) / length - 1.0 > STRAINS[2], "the other on the last line"
    assert np.abs(way - own.y[0]).max() < close
    assert recording.attributes["energy_remainder"] < balanced


def test_a_line_that_breaks_takes_its_energy_along() -> None:
    """At 500 kN it breaks, L (1 + s) long: L u(s) is booked as parting, to a millionth."""
    velocity, pretension, force = 5.0, 60e3, 500e3
    text = between(f"pretension: {pretension} N, breaks_at: {force} N", velocity=velocity, duration=4.0)
    recording = gantline.simulate(parse_scenario(text.replace("SETTINGS", ADAPTIVE)))
    length = 30.0 / (1.0 + strain_under(pretension))
    [(when, name)] = [(time, name) for time, _, name in recording.events("broken")]
    assert name == "mooring.left"
    way = float(np.interp(when, recording.time, recording.column("body_position", "mass")[:, 0]))
    # Linear between samples of 10 ms: 1 m/s² h²/8.
    assert 30.0 + way == pytest.approx(length * (1.0 + strain_under(force)), abs=2e-5)
    parted = recording.column("energy", "parting")[-1]
    assert parted == pytest.approx(length * stored(strain_under(force)), rel=1e-6)
    assert recording.attributes["energy_remainder"] < 1e-7


def test_two_vessels_between_which_a_line_of_a_curve_leads() -> None:
    """Two masses on one slide, held apart by a spring against the line: ω² = (k + G'(s)/L)(1/m1 + 1/m2)."""
    pretension, push = 75e3, 0.5e6
    text = f"""\
format: 1
lift: {{title: Two masses}}
duration: 1 s
start: rest
ropes:
  nylon: {{{NYLON}, mass: none}}
mechanics:
  bodies:
    one: {{joint: {{type: slider, axis: [1, 0, 0]}}, mass: 500 t}}
    two: {{joint: {{type: slider, axis: [1, 0, 0]}}, mass: 200 t}}
mooring_lines:
  line: {{vessel: one, fairlead: [0 m, 0 m, 0 m], to: [20 m, 0 m, 0 m], held_by: two, rope: nylon,
    type: spring, pretension: {pretension} N}}
fenders:
  strut: {{vessel: one, at: [5 m, 1 m, 0 m], wall: [6 m, 0 m], wall_of: two, facing: 180 deg, thickness: 1 m,
    stiffness: {push} N/m}}
plan: [{{step: hold, hold: until_end}}]
"""
    statics = gantline.Statics(parse_scenario(text))
    rest = statics.equilibrium()
    length = 20.0 / (1.0 + strain_under(pretension))
    closer = brentq(lambda way: pull((20.0 - way) / length - 1.0) - push * way, 0.0, 1.0, xtol=1e-14)
    tension = float(rest.recording.column("mooring_tension", "line")[-1])
    assert tension == pytest.approx(push * closer, rel=1e-7)
    slope = SLOPES[int(np.searchsorted(TENSIONS, tension))]
    period = math.tau / math.sqrt((push + slope / length) * (1.0 / 500e3 + 1.0 / 200e3))
    assert min(abs((mode.period or math.inf) / period - 1.0) for mode in statics.modes()) < 1e-7


def test_a_load_turns_between_four_tag_lines_with_the_slope_of_their_curve() -> None:
    """Two lines forward, two aft, 2 m aside of a plumb sling: I ω² = d²E/dψ², E = Σ L u(ℓ(ψ)/L - 1)."""
    pretension, inertia, aside, out, reach, height = 4e3, 120e3, 2.0, 1.0, 16.0, 3.0
    lines = "".join(
        f"  {name}: {{at: [{x * out} m, {y * aside} m, 1 m], to: [{x * reach} m, {y * aside} m, {height} m], "
        f"rope: tag, pretension: {pretension} N}}\n"
        for name, x, y in (("fp", 1, 1), ("fs", 1, -1), ("ap", -1, 1), ("as", -1, -1))
    )
    text = f"""\
format: 1
lift: {{title: A load on tag lines}}
duration: 1 s
start: rest
ropes:
  tag: {{curve: {{strain: [2 %, 5 %, 12 %], tension: [1 kN, 6 kN, 40 kN]}}, mass: none}}
  steel: {{axial_stiffness: 50 MN, mass: none}}
load:
  name: module
  shape: {{box: [6 m, 5 m, 2 m]}}
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: 30 t}}
  inertia: {{xx: {inertia} kg m^2, yy: {inertia} kg m^2, zz: {inertia} kg m^2}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{L: {{at: [0 m, 0 m, 3 m]}}}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 15 m], hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
slings:
  S: {{from: crane, to: module.L, length: 10 m, rope: steel}}
tag_lines:
{lines}plan: [{{step: hold, hold: until_end}}]
"""
    statics = gantline.Statics(parse_scenario(text))
    recording = statics.equilibrium().recording
    length = (reach - out) / (1.0 + (0.02 + 0.03 * 3e3 / 5e3))  # 1 kN at 2 %, 5 kN more by 5 %
    low = height - float(recording.column("body_position", "module")[-1, 2])

    def tension(strain: float) -> float:
        return 1e3 + 5e3 * (strain - 0.02) / 0.03

    def far(angle: float) -> float:
        """Length of the lines forward on port and aft on starboard; of the others at the opposite angle."""
        x, y = (
            out * math.cos(angle) - aside * math.sin(angle),
            out * math.sin(angle) + aside * math.cos(angle),
        )
        return math.sqrt((reach - x) ** 2 + (aside - y) ** 2 + low**2)

    found = tension(far(0.0) / length - 1.0)
    for name in ("fp", "fs", "ap", "as"):
        assert float(recording.column("rope_tension", f"tag.{name}")[-1]) == pytest.approx(found, rel=1e-6)
    # E″ of each: G'/L ℓ'² + T ℓ″, ℓ′ and ℓ″ by central differences of 1e-3, of the order 1e-6.
    step = 1e-3
    before, here, after = far(-step), far(0.0), far(step)
    first, second = (after - before) / (2 * step), (after - 2 * here + before) / step**2
    stiffness = 4.0 * (5e3 / 0.03 / length * first**2 + found * second)
    period = math.tau * math.sqrt(inertia / stiffness)
    assert min(abs((mode.period or math.inf) / period - 1.0) for mode in statics.modes()) < 1e-5
