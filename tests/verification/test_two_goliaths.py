"""Two Goliath cranes hold one load on three hooks, traverse, travel and hoist, against own equations.

A hook block is a point m h̄ that hangs in n ropes of p parts, with ū the way up its falls, of length ℓ; the
load is a rigid body on slings S; girders bend under more than their hook blocks (docs: goliath, flows):

    m h̄¨ = n p T ū + Σ S − m g        M r̈ = Σ S − M g        I ω̇ = Σ a × S − ω × I ω (its axes)
    μ ẅ = −k w − c ẇ − Σ n p (T u_z − T₀)      μ = 17/35 girder + trolleys,  c = 2 ζ √(k μ)
    T = EA/L (Λ − L + τ (p ℓ˙ − (1 + ε/2) L̇))      Λ = p ℓ + arcs + lead line,  L̇ = −p v/(1 + ε)

v how fast a hook is hoisted, upper sheaves where trolleys, travel and girder have them. Half turns of the
upper sheaves go on to the next lane, 0.15 m aside. scipy's LSODA solves that, and corners bear by moments
about the rails: of weights, and of the pulls −n p T ū with all their parts, where they act.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from mechanics import Floats, G
from rigid import axes, cross, moments, turning

DURATION = 4.0
#: Heights of upper sheaves and of hooks, bearing to sheaves of the hook block; diameter, lane, lead line [m].
TOP, HOOK, TO_SHEAVES, DIAMETER, LANE, LEAD = 60.0, 30.0, 2.0, 1.0, 0.15, 15.0
PARTS, ROPES, EA, TAU, HOOK_BLOCK = 4, 2, 100e6, 0.01, 8e3
SLING_EA = 150e6
LOAD, INERTIA = 280e3, np.array([[9e6, 0, -0.4e6], [0, 14e6, 0], [-0.4e6, 0, 21e6]])
CENTRE = np.array([0.3, -0.5, 15.0])
#: Crane, trolley, x, across, y of the crane, of each hook [m].
HOOKS = {
    "A.H1": ("A", "A1", -10.0, 1.5, 15.0),
    "A.H2": ("A", "A2", 9.0, 0.0, 15.0),
    "B.H3": ("B", "B1", 0.0, -1.0, -15.0),
}
#: Place of a lug from the centre of gravity [m], and its hook.
LUGS = {
    "a": ((-13.0, 13.0, 2.5), 0),
    "b": ((-7.0, 16.0, 2.5), 0),
    "c": ((6.0, 14.0, 2.5), 1),
    "d": ((12.0, 13.0, 2.3), 1),
    "e": ((-3.0, -14.0, 2.5), 2),
    "f": ((4.0, -16.0, 2.4), 2),
}
#: Of each crane: girder, its stiffness [N/m] and damping, fixed and hinged leg, bogies [kg], base [m].
CRANES = {
    "A": (2000e3, 40e6, 0.02, 600e3, 400e3, 500e3, 20.0),
    "B": (1500e3, 35e6, 0.02, 500e3, 300e3, 400e3, 16.0),
}
SPAN, TROLLEYS = 100.0, {"A1": 200e3, "A2": 150e3, "B1": 180e3}
#: Way [m], speed and acceleration of what moves, all from the start.
TRAVERSE, TRAVEL, HOIST = (1.2, 0.6, 0.6), (1.0, 0.5, 0.5), (0.8, 0.4, 0.4)

ARCS = math.pi / 2 * (2 * DIAMETER + 2 * math.hypot(DIAMETER, LANE))
REST = HOOK_BLOCK * G / (PARTS * ROPES)
NATURAL = (PARTS * (TOP - HOOK - TO_SHEAVES) + ARCS + LEAD) / (1 + REST / EA)
START = np.array([(x, y + across, HOOK) for _, _, x, across, y in HOOKS.values()])
PLACES = np.array([place for place, _ in LUGS.values()])
AT = np.array([hook for _, hook in LUGS.values()])
LENGTHS = np.array(
    [round(math.dist(START[h], CENTRE + p) + 0.002, 3) for p, h in zip(PLACES, AT, strict=True)]
)
OF = np.array([list(CRANES).index(crane) for crane, *_ in HOOKS.values()])
BENDS = np.array(
    [
        17 / 35 * values[0] + sum(mass for name, mass in TROLLEYS.items() if name[0] == crane)
        for crane, values in CRANES.items()
    ]
)
STIFF = np.array([values[1] for values in CRANES.values()])
DAMPS = 2 * np.array([values[2] for values in CRANES.values()]) * np.sqrt(STIFF * BENDS)


def ramp(t: float, move: tuple[float, float, float]) -> tuple[float, float]:
    """Way and speed of a move that speeds up, goes on and brakes."""
    way, speed, acceleration = move
    up, brakes = speed / acceleration, way / speed
    left = max(0.0, brakes + up - t)
    if t < up:
        return acceleration * t**2 / 2, acceleration * t
    if t < brakes:
        return speed * (t - up / 2), speed
    return way - acceleration * left**2 / 2, acceleration * left


class Now:
    """A state: places of hooks, load and girders, their rates, and unstretched lengths; and what pulls."""

    def __init__(self, t: float, y: Floats) -> None:
        self.hooks, self.hook_rates = y[:9].reshape(3, 3), y[9:18].reshape(3, 3)
        self.place, self.attitude, self.velocity, self.spin = y[18:21], y[21:25], y[25:28], y[28:31]
        length, self.sag, sag_rate = y[31:34], y[34:36], y[36:38]
        self.sag_rate, self.turned = sag_rate, axes(self.attitude)

        top, rate = START.copy(), np.zeros((3, 3))
        top[:, 2], rate[:, 2] = TOP + self.sag[OF], sag_rate[OF]
        for hook, axis, move in ((0, 0, TRAVERSE), (2, 1, TRAVEL)):
            way, rate[hook, axis] = ramp(t, move)
            top[hook, axis] += way
        self.top = top
        falls = top - self.hooks - (0.0, 0.0, TO_SHEAVES)
        long = np.linalg.norm(falls, axis=1)
        self.up = falls / long[:, None]
        lengthens = np.einsum("ij,ij->i", self.up, rate - self.hook_rates)
        way = PARTS * long + ARCS + LEAD
        strain = (way - length) / length
        self.hauled = -PARTS * np.array([0.0, 0.0, ramp(t, HOIST)[1]]) / (1 + strain)
        stretch = way - length + TAU * (PARTS * lengthens - (1 + strain / 2) * self.hauled)
        self.tension = EA / length * np.maximum(0.0, stretch)
        self.pull = ROPES * PARTS * self.tension[:, None] * self.up

        self.arms = PLACES @ self.turned.T
        slings = self.place + self.arms - self.hooks[AT]
        long = np.linalg.norm(slings, axis=1)
        down = slings / long[:, None]
        moves = self.velocity + np.cross(self.turned @ self.spin, self.arms) - self.hook_rates[AT]
        stretch = long - LENGTHS + TAU * np.einsum("ij,ij->i", down, moves)
        self.slings = np.maximum(0.0, SLING_EA / LENGTHS * stretch)
        self.drawn = self.slings[:, None] * down


def rates(t: float, y: Floats) -> Floats:
    """Of the whole state."""
    now = Now(t, y)
    weight = np.array([0.0, 0.0, -G])
    hooks = now.pull / HOOK_BLOCK + weight
    np.add.at(hooks, AT, now.drawn / HOOK_BLOCK)
    moment = now.turned.T @ moments(now.arms, -now.drawn)
    spins = np.linalg.solve(INERTIA, moment - cross(now.spin, INERTIA @ now.spin))
    hangs = np.bincount(OF, now.pull[:, 2] - ROPES * PARTS * REST)
    bends = (-STIFF * now.sag - DAMPS * now.sag_rate - hangs) / BENDS
    load = np.concatenate(
        [now.velocity, turning(now.attitude, now.spin), weight - now.drawn.sum(0) / LOAD, spins]
    )
    return np.concatenate([now.hook_rates.ravel(), hooks.ravel(), load, now.hauled, now.sag_rate, bends])


def corners(t: float, now: Now) -> list[float]:
    """Fixed leg at larger and at smaller y, hinged leg likewise, of each crane [N]."""
    found = []
    for crane, (girder, _, _, fixed, hinged, bogies, base) in CRANES.items():
        centre = 15.0 if crane == "A" else -15.0 + ramp(t, TRAVEL)[0]
        carried = girder * G
        along = across = 0.0  # moments about mid-span and the girder's centre line, at rail level
        for trolley, mass in TROLLEYS.items():
            if trolley[0] == crane:
                x = {"A1": -10.0 + ramp(t, TRAVERSE)[0], "A2": 9.0, "B1": 0.0}[trolley]
                carried, along = carried + mass * G, along + mass * G * x
        twist = 0.0  # how much more of the moment across is on the hinged leg, by where it acts
        for k in np.flatnonzero(np.equal(OF, list(CRANES).index(crane))):
            (x, y, z), (fx, fy, fz) = now.top[k], -now.pull[k]
            carried -= fz
            along += -fz * x + fx * z
            moment = -fz * (y - centre) + fy * z
            across += moment
            twist += moment * (x - z * fx / fz)
        for side, own in ((-1, fixed), (1, hinged)):
            leg = own * G + bogies * G / 2 + carried / 2 + side * along / SPAN
            turns = (across / 2 + side * twist / SPAN) / base
            found += [leg / 2 + turns, leg / 2 - turns]
    return found


def lift() -> str:
    """The lift file."""
    hook = (
        f"height: {HOOK} m, highest: 50 m, block: {{mass: {HOOK_BLOCK} kg, height: {TO_SHEAVES} m}}, "
        f"reeving: {{ropes: {ROPES}, parts_each: {PARTS}, rope: hoist, sheave_diameter: {DIAMETER} m, "
        f"upper_sheaves_at: {TOP} m, lead_line: {LEAD} m}}, drum: {{diameter: 1.5 m}}, "
        "hoist: {speed: 0.5 m/s, acceleration: 0.5 m/s^2}"
    )
    cranes = []
    for crane, (girder, stiff, damps, fixed, hinged, bogies, base) in CRANES.items():
        y = next(of[4] for of in HOOKS.values() if of[0] == crane)
        cranes.append(
            f"  {crane}:\n    type: goliath\n    span: {SPAN} m\n    position: {y} m\n"
            f"    girder: {{underside: 52 m, mass: {girder} kg, vertical_stiffness: {stiff} N/m, "
            f"damping: {damps}}}\n"
            f"    legs: {{fixed: {fixed} kg, hinged: {hinged} kg, bogies: {bogies} kg, base: {base} m}}\n"
            "    travel: {speed: 1 m/s, acceleration: 1 m/s^2, range: [-90 m, 90 m]}\n    trolleys:"
        )
        for name, (of, trolley, x, across, _) in HOOKS.items():
            if of == crane:
                cranes.append(
                    f"      {trolley}:\n        mass: {TROLLEYS[trolley]} kg\n        position: {x} m\n"
                    "        traverse: {speed: 1 m/s, acceleration: 1 m/s^2, range: [-40 m, 40 m]}\n"
                    f"        hooks: {{{name[2:]}: {{across: {across} m, {hook}}}}}"
                )
    x, y, z = CENTRE
    lugs = [f"    {name}: {{at: [{a} m, {b} m, {c + 2.5} m]}}" for name, ((a, b, c), _) in LUGS.items()]
    slings = [
        f"  {name}: {{from: {list(HOOKS)[hook]}, to: block.{name}, length: {length} m, rope: sling}}"
        for (name, (_, hook)), length in zip(LUGS.items(), LENGTHS, strict=True)
    ]
    moves = [
        f"{drive}, starts: with_previous, by: {way} m, speed: {speed} m/s, acceleration: {faster} m/s^2}}"
        for drive, (way, speed, faster) in (
            ("travel: B", TRAVEL),
            ("hoist: B.H3", HOIST),
        )
    ]
    way, speed, faster = TRAVERSE
    return "\n".join(
        [
            f"format: 1\nlift: {{title: Two cranes}}\nduration: {DURATION} s\nstart: as_given",
            f"ropes:\n  sling: {{axial_stiffness: {SLING_EA} N, damping_time: {TAU} s}}",
            f"  hoist: {{axial_stiffness: {EA} N, damping_time: {TAU} s, diameter: 40 mm}}",
            f"load:\n  name: block\n  shape: {{box: [28 m, 34 m, 5 m]}}\n  "
            f"position: [{x} m, {y} m, {z - 2.5} m]",
            f"  weight: {{calculated: {LOAD} kg}}\n  centre_of_gravity: {{at: [0 m, 0 m, 2.5 m]}}",
            f"  inertia: {{xx: {INERTIA[0, 0]} kg m^2, yy: {INERTIA[1, 1]} kg m^2, "
            f"zz: {INERTIA[2, 2]} kg m^2, xz: {INERTIA[0, 2]} kg m^2}}\n  lugs:",
            *lugs,
            "cranes:",
            *cranes,
            "slings:",
            *slings,
            f"plan:\n  - {{step: one, traverse: A.A1, by: {way} m, speed: {speed} m/s, "
            f"acceleration: {faster} m/s^2}}",
            *(f"  - {{step: with {k}, {move}" for k, move in enumerate(moves)),
            "simulation: {tension_tolerance: 2 N, position_tolerance: 0.00001 mm}",
        ]
    )


@pytest.fixture(scope="module")
def recording() -> Recording:
    return simulate(parse_scenario(lift()))


@pytest.fixture(scope="module")
def own(recording: Recording) -> Floats:
    """States at the samples, shape (time, state)."""
    start = [*START.ravel(), *[0.0] * 9, *CENTRE, 1.0, *[0.0] * 9, *[NATURAL] * 3, *[0.0] * 4]
    solved = solve_ivp(
        rates, (0, DURATION), start, "LSODA", recording.time, rtol=1e-11, atol=1e-12, max_step=5e-3
    )
    return np.asarray(solved.y.T)


def test_a_load_between_two_cranes(recording: Recording, own: Floats) -> None:
    """Places of load and hooks, its attitude, tensions and balance over 4 s of falls up to 5.9° out of plumb.

    They leave 3e-9 m and 0.007 N; ten times the tolerances 3e-8 m and 0.06 N, a tenth 2e-10 m and 0.001 N.
    """
    states = [Now(t, y) for t, y in zip(recording.time, own, strict=True)]
    assert np.abs(recording.column("body_position", "block") - own[:, 18:21]).max() < 1e-8
    assert np.abs(recording.column("body_orientation", "block") - own[:, 21:25]).max() < 1e-9
    for k, hook in enumerate(HOOKS):
        assert np.abs(recording.column("body_position", hook) - own[:, 3 * k : 3 * k + 3]).max() < 1e-8
        tension = [now.tension[k] for now in states]
        assert np.abs(recording.column("rope_tension", f"hoist.{hook}.1") - tension).max() < 0.05
    for k, lug in enumerate(LUGS):
        tension = [now.slings[k] for now in states]
        assert np.abs(recording.column("rope_tension", f"sling.{lug}") - tension).max() < 0.05
    assert np.rad2deg(recording["falls_out_of_plumb"].values.max()) > 5.0
    assert recording.metrics()["energy_remainder"] < 1e-11


def test_corners_bear_by_moments(recording: Recording, own: Floats) -> None:
    """Of 6.3 to 10.5 MN that change by 0.5 to 0.7 MN: what 2 mN of tension leave, times parts and levers."""
    by_hand = [corners(t, Now(t, y)) for t, y in zip(recording.time, own, strict=True)]
    assert np.ptp(by_hand, axis=0).min() > 0.5e6
    assert np.abs(recording["corner_load"].values - by_hand).max() < 0.1
