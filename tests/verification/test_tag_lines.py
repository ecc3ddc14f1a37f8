"""Tag lines: loads that turn and swing under constant pulls, against equations of their own.

A tugger with the mass m and the pull P that has paid out s obeys

    m s̈ = T - P,   T = EA (ℓ/L - 1) + damping,   L̇ = ṡ/(1 + ε),   ε = ℓ/L - 1,

(WI1) and (WI2) of the page on winches; the damper pulls with √(L₀/L) EA τ g'/L₀, g = (ℓ - L) √(L₀/L) as in
(F3) of that on flows, and with 1 + ε/2 of it on the tugger, (F4). At rest it is T = P.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

from gantline.results.series import load_yaw
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from mechanics import G

Floats = npt.NDArray[np.float64]

MASS, INERTIA = 30e3, 120e3
EA, TAU = 150e3, 0.2
SLING_EA, SLING_TAU, SLING = 50e6, 0.02, 10.0
PULL, TUGGER = 3e3, 40.0
HOOK = 15.0
"""Height of the hook [m]."""
LUG = 2.0
"""Height of the lug above the centre of gravity [m]."""


def lift(tag_lines: str, load: str = "", start: str = "as_given", sling_ea: float = SLING_EA) -> str:
    """A load on one sling, its centre of gravity at (0, 0, 3 m) before the sling stretches."""
    return f"""
format: 1
lift: {{title: A load on tag lines}}
duration: 40 s
start: {start}
ropes:
  tag: {{axial_stiffness: {EA} N, damping_time: {TAU} s, mass: none}}
  steel: {{axial_stiffness: {sling_ea} N, damping_time: {SLING_TAU} s, mass: none}}
load:
  name: module
  shape: {{box: [6 m, 3 m, 2 m]}}
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: {MASS} kg}}
  inertia: {{xx: {INERTIA} kg m^2, yy: {INERTIA} kg m^2, zz: {INERTIA} kg m^2}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{L: {{at: [0 m, 0 m, {1 + LUG} m]}}}}
  {load}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, {HOOK} m], hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
slings:
  S: {{from: crane, to: module.L, length: {SLING} m, rope: steel}}
tag_lines:
{tag_lines}
simulation: {{tension_tolerance: 0.1 N}}
"""


def line(
    length: float, rate: float, paid: float, paid_rate: float, natural: float
) -> tuple[float, float, float]:
    """Tension of a line, what turns its tugger, rate of the unstretched length, `paid` of which came off."""
    unstretched = natural + paid
    strain = length / unstretched - 1.0
    supply = paid_rate / (1.0 + strain)
    share = natural / unstretched
    # g' by ℓ and L, of g = (ℓ - L) √(L₀/L).
    stretch_rate = math.sqrt(share) * (rate - supply - 0.5 * (length - unstretched) / unstretched * supply)
    spring, damper = EA * strain, math.sqrt(share) * EA * TAU * stretch_rate / natural
    return spring + damper, spring + damper * (1.0 + strain / 2.0), supply


def test_load_turns_between_two_pulls() -> None:
    """Pure yaw: I φ̈ = -2 T c D sin φ/ℓ, ℓ² = D² + c² - 2 D c cos φ; T is P but for what tuggers take."""
    c, d, start = 1.5, 12.0, math.radians(20.0)
    lines = "".join(
        f"  {name}: {{at: [0 m, {side * c} m, 1 m], to: [0 m, {side * d} m, 3 m], rope: tag, pull: {PULL} N, "
        f"rotating_mass: {TUGGER} kg, speed: 1 m/s}}\n"
        for name, side in (("port", 1.0), ("starboard", -1.0))
    )
    # The load drops into its sling; with a stiff one the lines stay level.
    recording = simulate(parse_scenario(lift(lines, f"heading: {start} rad", sling_ea=5e9), "x.yaml"))
    yaw = load_yaw(recording, recording.rig.loads[0])
    assert yaw is not None

    def length(angle: float) -> float:
        return math.sqrt(d * d + c * c - 2.0 * d * c * math.cos(angle))

    natural = length(start) / (1.0 + PULL / EA)

    def motion(_: float, y: Floats) -> list[float]:
        angle, spin, _paid, paid_rate, supplied = y
        now = length(angle)
        arm = d * c * math.sin(angle) / now
        tension, turns, supply = line(now, arm * spin, supplied, paid_rate, natural)
        return [spin, -2.0 * tension * arm / INERTIA, paid_rate, (turns - PULL) / TUGGER, supply]

    own = solve_ivp(motion, (0.0, 40.0), [start, 0, 0, 0, 0], "LSODA", recording.time, rtol=1e-9, atol=1e-11)
    # The tolerance of 0.1 N is 3e-5 of the pull; with 1 N the largest difference is 2e-5.
    np.testing.assert_allclose(start + yaw, own.y[0], atol=5e-6)
    # The period of small angles is 2π √(I (D - c)/(2 P c D)) = 21.5 s; the load comes back as far as it was.
    assert own.y[0].min() == pytest.approx(-start, abs=0.01)
    assert recording.attributes["energy_remainder"] < 1e-8


def test_load_swings_under_a_pull_that_is_cut() -> None:
    """In the plane: load, sling and tugger, integrated; from 15 s on the load is free of its line."""
    at, anchor, cut = (2.0, -0.5), (25.0, 0.0), 15.0
    lines = (
        f"  west: {{at: [{at[0]} m, 0 m, {1 + at[1]} m], to: [{anchor[0]} m, 0 m, {anchor[1]} m], rope: tag, "
        f"pull: {PULL} N, rotating_mass: {TUGGER} kg, speed: 1 m/s, cut_at: {cut} s}}\n"
    )
    recording = simulate(parse_scenario(lift(lines), "x.yaml"))

    def end(y: Floats, arm: tuple[float, float]) -> tuple[Floats, Floats]:
        """Place and velocity of a point of the load; it turns from x to z by y[2]."""
        cosine, sine = math.cos(y[2]), math.sin(y[2])
        away = np.array([cosine * arm[0] - sine * arm[1], sine * arm[0] + cosine * arm[1]])
        return y[:2] + away, y[3:5] + y[5] * np.array([-away[1], away[0]])

    first = np.array([0.0, 3.0])
    natural = math.dist(first + at, anchor) / (1.0 + PULL / EA)

    def motion(time: float, y: Floats, is_whole: bool) -> list[float]:
        force, moment = np.array([0.0, -MASS * G]), 0.0
        lug, lug_rate = end(y, (0.0, LUG))
        way = np.array([0.0, HOOK]) - lug
        now = float(np.linalg.norm(way))
        sling = SLING_EA * (now - SLING - SLING_TAU * float(way @ lug_rate) / now) / SLING
        pulls = [(lug, max(0.0, sling) * way / now)]
        paid_rate, paid_twice, supply = y[7], 0.0, 0.0
        if is_whole:
            corner, rate = end(y, at)
            way = np.array(anchor) - corner
            now = float(np.linalg.norm(way))
            tension, turns, supply = line(now, -float(way @ rate) / now, y[8], paid_rate, natural)
            paid_twice = (turns - PULL) / TUGGER
            pulls.append((corner, tension * way / now))
        for place, pull in pulls:
            force = force + pull
            arm = place - y[:2]
            moment += arm[0] * pull[1] - arm[1] * pull[0]
        return [*y[3:6], *(force / MASS), moment / INERTIA, paid_rate, paid_twice, supply]

    times = recording.time
    before, after = times[times <= cut], times[times >= cut]
    own = solve_ivp(
        motion, (0.0, cut), [*first, *[0.0] * 7], "LSODA", before, args=(True,), rtol=1e-10, atol=1e-11
    )
    later = solve_ivp(
        motion, (cut, 40.0), own.y[:, -1], "LSODA", after, args=(False,), rtol=1e-10, atol=1e-11
    )
    place = recording.column("body_position", "module")[:, [0, 2]]
    # 1e-5 m is a ten thousandth of the swing.
    np.testing.assert_allclose(place[times <= cut], own.y[:2].T, atol=1e-5)
    np.testing.assert_allclose(place[times >= cut], later.y[:2].T, atol=1e-5)
    assert float(np.abs(place[:, 0]).max()) > 0.1
    tension = recording.column("rope_tension", "tag.west")
    assert np.all(tension[times > cut] == 0.0)


def test_rest_under_unequal_pulls() -> None:
    """Forces and moments of weight, sling and two constant pulls in balance: six equations."""
    ends = {
        "a": ((2.5, 1.0, 0.4), (20.0, 6.0, 1.0), 2500.0),
        "b": ((-2.0, -1.2, 1.5), (-9.0, -16.0, 0.0), 4000.0),
    }
    lines = "".join(
        f"  {name}: {{at: {[f'{x} m' for x in at]}, to: {[f'{x} m' for x in to]}, "
        f"rope: tag, pull: {pull} N}}\n"
        for name, (at, to, pull) in ends.items()
    ).replace("'", "")
    recording = Statics(parse_scenario(lift(lines, start="rest"), "x.yaml")).equilibrium().recording

    def missing(y: Floats) -> Floats:
        """Force and moment about the centre of gravity that balance lacks."""
        turn = Rotation.from_rotvec(y[3:])
        lug = y[:3] + turn.apply([0.0, 0.0, LUG])
        way = np.array([0.0, 0.0, HOOK]) - lug
        now = float(np.linalg.norm(way))
        pulls = [(lug, SLING_EA * (now / SLING - 1.0) * way / now)]
        for at, to, pull in ends.values():
            point = y[:3] + turn.apply(np.array(at) - [0.0, 0.0, 1.0])
            pulls.append((point, pull * (to - point) / math.dist(to, point)))
        force = sum((pull for _, pull in pulls), np.array([0.0, 0.0, -MASS * G]))
        return np.concatenate([force, sum(np.cross(point - y[:3], pull) for point, pull in pulls)])

    own = fsolve(missing, [0.0, 0.0, 3.0, 0.0, 0.0, 0.0], xtol=1e-13)
    assert np.abs(missing(own)).max() < 1e-3
    place = recording.column("body_position", "module")[-1]
    np.testing.assert_allclose(place, own[:3], atol=1e-7)
    # Statics ends where forces balance to a billionth; a motor that pulls all it can excuses no rounding.
    for name, (_, _, pull) in ends.items():
        assert recording.column("rope_tension", f"tag.{name}")[-1] == pytest.approx(pull, rel=1e-9)


@pytest.mark.parametrize(("said", "expected"), [("pretension: 2 kN", 2000.0), ("length: as_routed", 0.0)])
def test_lines_made_fast_start_as_said(said: str, expected: float) -> None:
    """The length follows from the tension, L = ℓ/(1 + T/EA); `as_routed` is just taut."""
    lines = f"  west: {{at: [3 m, 0 m, 1 m], to: [25 m, 0 m, 0 m], rope: tag, {said}}}\n"
    recording = simulate(parse_scenario(lift(lines), "x.yaml"))
    assert recording.column("rope_tension", "tag.west")[0] == pytest.approx(expected, abs=1e-6)


def test_line_goes_along_with_what_holds_it() -> None:
    """Its end moves by 4 m within 20 s: T stays P but for m s̈, 40 kg times no more than 0.3 m/s²."""
    ship = """
mechanics:
  bodies:
    deck:
      at: [20 m, 0 m, 1 m]
      mass: 1 t
      joint:
        type: slider
        axis: [1, 0, 0]
        motion: [{at: 5 s, duration: 2 s, velocity: 0.2 m/s}, {at: 25 s, duration: 2 s, velocity: 0 m/s}]
"""
    line = (
        "  west: {at: [3 m, 0 m, 1 m], to: [0 m, 0 m, 0 m], held_by: deck, rope: tag, "
        f"pull: {PULL} N, rotating_mass: {TUGGER} kg}}"
    )
    recording = simulate(parse_scenario(lift(line, start="rest") + ship, "x.yaml"))
    tension = recording.column("rope_tension", "tag.west")
    np.testing.assert_allclose(tension, PULL, atol=TUGGER * 0.3)
    paid_out = recording.column("joint_position", "tag.west.tugger")
    # Stretched rope goes over the rim: 4 m, but for how the load leans.
    assert paid_out[-1] - paid_out[0] == pytest.approx(4.0, abs=0.1)
    assert recording.metrics()["peak_tag_line_tension.west"] == pytest.approx(PULL, abs=TUGGER * 0.3)


def test_load_is_turned_by_two_winches() -> None:
    """Hauled by 0.5 m at one end and veered at the other it rests where two springs are in balance.

    Lines of 18 m run level along y from x = ±3 m. Of 0.5 m that go over a rim 0.5 m/(1 + ε) are unstretched.
    """
    tension, way = 2e3, 0.5
    lines = "".join(
        f"  {name}: {{at: [{x} m, 0 m, 1 m], to: [{x} m, 18 m, 3 m], rope: tag, "
        f"pretension: {tension} N, "
        "winch: {speed: 6 m/min, acceleration: 0.1 m/s^2}}\n"
        for name, x in (("west", -3.0), ("east", 3.0))
    )
    plan = f"""
plan:
  - {{step: turn, haul: tag.west, by: {way} m, speed: 3 m/min}}
  - {{step: turn the other end, veer: east, by: {way} m, speed: 3 m/min, starts: with_previous}}
  - {{step: hold, hold: until_end}}
"""
    scenario = parse_scenario(lift(lines, start="rest", sling_ea=5e9) + plan, "x.yaml")
    rest = Statics(scenario).equilibrium().recording
    turned = load_yaw(rest, rest.rig.loads[0])
    assert turned is not None
    natural = 18.0 / (1.0 + tension / EA)

    def pulls(y: Floats, shorter: float) -> list[tuple[Floats, Floats]]:
        """Arms and forces of west, shorter by so much, and east."""
        found = []
        for x, length in ((-3.0, natural - shorter), (3.0, natural + shorter)):
            arm = x * np.array([math.cos(y[2]), math.sin(y[2])])
            way_there = np.array([x, 18.0]) - (y[:2] + arm)
            now = float(np.linalg.norm(way_there))
            found.append((arm, EA * (now / length - 1.0) * way_there / now))
        return found

    def missing(y: Floats, shorter: float) -> Floats:
        """Forces in the plane and the moment. The sling stays in line with lug and centre of gravity."""
        both = pulls(y, shorter)
        force = sum((pull for _, pull in both), -MASS * G * y[:2] / (SLING + LUG))
        return np.array([*force, sum(arm[0] * pull[1] - arm[1] * pull[0] for arm, pull in both)])

    before = fsolve(missing, [0.0, 0.1, 0.0], args=(0.0,), xtol=1e-12)
    strain = float(np.linalg.norm(pulls(before, 0.0)[0][1])) / EA
    own = fsolve(missing, [0.0, 0.1, -0.1], args=(way / (1.0 + strain),), xtol=1e-12)
    assert own[2] == pytest.approx(-way / 3.0, abs=0.01)
    # The load is 4 mm higher as it swings aside by 0.1 m: less than 1e-4 of what the lines are stretched by.
    assert turned[-1] - turned[0] == pytest.approx(own[2], abs=2e-5)
