"""Lines and fenders between two barges: rest, sway against each other, a bump, a line that sags.

Boxes side by side, barge `one` along y = 0 and `two` to port of it, afloat with their centres of gravity at
the same height, lines and fenders there too. Water pushes a box without drag up and down alone, so nothing
but lines and fenders moves them level.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import fsolve

import gantline
from gantline.scenario import parse_scenario
from mechanics import Floats

DENSITY, G = 1025.0, 9.81
#: Length, breadth, depth [m], and draft of both [m].
SIZES, DRAFT = ((90.0, 30.0, 6.5), (60.0, 20.0, 5.0)), 3.0
MASSES = tuple(DENSITY * length * breadth * DRAFT for length, breadth, _ in SIZES)
#: Of all centres of gravity, fairleads and fenders above the keels [m].
HIGH = 3.5
#: Between the sides, the fenders thick as that [m].
GAP = 1.0
#: EA of the lines [N], stiffness of a fender [N/m].
EA, FENDER = 8e6, 3e6
#: How exact `adaptive` is.
FINE = "tension_tolerance: 1 N, position_tolerance: 0.001 mm"


def pair(more: str, *, second: str = "", start: str = "rest", duration: float = 1.0) -> str:
    """Two barges, `two` at `second` where that is not right beside."""
    aside = SIZES[0][1] / 2 + GAP + SIZES[1][1] / 2
    text = f"""\
format: 1
lift: {{title: Two barges}}
duration: {duration!r} s
start: {start}
water: {{density: {DENSITY} kg/m^3, level: 0 m}}
simulation: {{sample_interval: 0.05 s, gravity: {G} m/s^2, {FINE}}}
ropes:
  nylon: {{axial_stiffness: {EA} N, damping_time: 0 s, mass: none}}
  steel: {{axial_stiffness: 60 MN, damping_time: 0.1 s, mass: 20 kg/m, minimum_breaking_force: 2 MN}}
plan: [{{step: end, hold: until_end}}]
vessels:
"""
    places = "", second or f"    position: [15 m, {aside} m]\n"
    for name, (length, breadth, depth), mass, place in zip(
        ("one", "two"), SIZES, MASSES, places, strict=True
    ):
        text += (
            f"  {name}:\n{place}    draft: {DRAFT} m\n"
            f"    hull: {{box: [{length} m, {breadth} m, {depth} m]}}\n"
            f"    masses: {{all: {{mass: {mass!r} kg, at: [{length / 2} m, 0 m, {HIGH} m]}}}}\n"
            f"    radii_of_gyration: [{breadth / 3} m, {length / 4} m, {length / 4} m]\n"
        )
    return text + more


def across(x: float, pull: str) -> str:
    """A line from `two`, x [m] from its stern, straight across to the far side of `one`."""
    fairlead, to = f"[{x} m, -10 m, {HIGH} m]", f"[{x + 15} m, -15 m, {HIGH} m]"
    return f"{{vessel: two, fairlead: {fairlead}, to: {to}, held_by: one, rope: nylon, type: spring, {pull}}}"


def alongside(pull: float, friction: float = 0.0) -> str:
    """Two lines and two fenders, whose points just touch at the start."""
    lines = "\n".join(
        f"  {name}: {across(x, f'pretension: {pull} N')}" for name, x in (("fore", 55), ("aft", 5))
    )
    of = f"wall: [0 m, 15 m], wall_of: one, facing: 90 deg, thickness: {GAP} m, stiffness: {FENDER} N/m"
    fenders = "\n".join(
        f"  {name}: {{vessel: two, at: [{x} m, -10 m, {HIGH} m], {of}, friction: {friction}}}"
        for name, x in (("fore", 45), ("aft", 15))
    )
    return f"mooring_lines:\n{lines}\nfenders:\n{fenders}\n"


def test_lines_press_on_fenders_between_two_barges() -> None:
    """At rest they have come closer by x = P/(k + k_f): each line pulls P - k x, each fender presses so.

    Straight lines along the way they come closer by: nothing is left out. They sway against each other with
    w^2 = 2 (k + k_f) (1/m1 + 1/m2), all at one height with the centres of gravity.
    """
    pull = 60e3
    statics = gantline.Statics(parse_scenario(pair(alongside(pull))))
    rest = statics.equilibrium(0.0)
    span = 30.0 + GAP
    stiffness = EA / (span / (1.0 + pull / EA))
    closer = pull / (stiffness + FENDER)
    for line in ("fore", "aft"):
        found = float(rest.recording.column("mooring_tension", line)[-1])
        assert found == pytest.approx(pull - stiffness * closer, rel=1e-7)
        assert float(rest.recording.column("fender_force", line)[-1]) == pytest.approx(
            FENDER * closer, rel=1e-7
        )
    expected = 2 * math.pi / math.sqrt(2 * (stiffness + FENDER) * sum(1 / mass for mass in MASSES))
    periods = np.array([mode.period for mode in statics.modes() if mode.period is not None])
    assert np.abs(periods / expected - 1.0).min() < 1e-6


def test_two_barges_bump() -> None:
    """Lines pull them together until fenders 0.2 m away stop them: when they touch, and the largest force.

    With the reduced mass m and the way x that they have come closer, m x'' = 2 (P - k x): they touch when
    x = P/k (1 - cos wt) is the gap. Where they are nearest the lines are slack, and all that was in them,
    P^2/2k each, is in the fenders: P sqrt(k_f/k).
    """
    pull, gap = 60e3, 0.2
    text = pair(alongside(pull).replace(f"thickness: {GAP} m", f"thickness: {GAP - gap} m"), start="as_given")
    text = text.replace("sample_interval: 0.05 s", "sample_interval: 0.01 s")
    recording = gantline.simulate(parse_scenario(text.replace("duration: 1.0 s", "duration: 8 s")))
    stiffness = EA / ((30.0 + GAP) / (1.0 + pull / EA))
    mass = 1.0 / sum(1.0 / one for one in MASSES)
    frequency = math.sqrt(2 * stiffness / mass)
    touch = math.acos(1.0 - gap * stiffness / pull) / frequency
    largest = pull * math.sqrt(FENDER / stiffness)
    assert gap + largest / FENDER > pull / stiffness, "lines are slack by then"
    for fender in ("fore", "aft"):
        force = recording.column("fender_force", fender)
        assert recording.time[np.flatnonzero(force)[0]] == pytest.approx(touch, abs=0.011), "a sample later"
        # Samples are within 5 ms of the peak of a half wave of 1.3 rad/s.
        assert force.max() == pytest.approx(largest, rel=5e-5)
    assert recording.attributes["energy_remainder"] < 1e-6


def test_a_bump_takes_no_momentum() -> None:
    """One line pulls barge `two` round onto the fenders of `one`, where they rub: all momenta stay nothing.

    Forces of lines and fenders on both act at one point, however both turn. What is left, over the momentum
    of one barge, goes with the tolerance, 2.2e-6 at ten times of it, and at `del` with the step.
    """
    line = f"mooring_lines:\n  aft: {across(5, 'pretension: 300 kN').replace('[20 m,', '[60 m,')}\n"
    fenders = alongside(1.0, friction=0.5).partition("fenders:\n")[2]
    near = fenders.replace(f"thickness: {GAP} m", f"thickness: {GAP - 0.1} m")
    text = pair(f"{line}fenders:\n{near}", start="as_given", duration=20.0)
    text = text.replace("damping_time: 0 s", "damping_time: 0.1 s")

    def left(settings: str) -> tuple[float, float]:
        """Momentum over that of one barge, and moment of momentum over that at the length of the other."""
        recording = gantline.simulate(parse_scenario(text.replace(FINE, settings)))
        assert recording.column("fender_force", "aft").max() > 100e3
        velocity = recording.column("body_velocity", "two")
        assert np.abs(velocity[:, 0]).max() > 0.1, "it is pulled along, and rubs"
        momentum = MASSES[1] * float(np.linalg.norm(velocity[:, :2], axis=1).max())
        of_all, moment = recording["momentum"].values[:, :2], recording["angular_momentum"].values[:, 2]
        return float(np.abs(of_all).max()) / momentum, float(np.abs(moment).max()) / momentum / SIZES[0][0]

    assert max(left(FINE)) < 5e-7
    coarse, fine = (left(f"integrator: del, step: {step} ms") for step in (10, 5))
    for more, less in zip(coarse, fine, strict=True):
        assert more < 2e-4
        assert more / less == pytest.approx(2.0, rel=0.05)


def test_a_line_of_nodes_between_barges_is_a_catenary() -> None:
    """A hawser of 120 m pulls as told at its fairlead; at both ends as an elastic catenary of its length.

    To 1e-5 with 50 nodes, of which the page on the weight of ropes has 1e-6 for lines that sag less steeply.
    """
    pull, weight, stiffness = 150e3, 20.0 * G, 60e6
    hawser = (
        "mooring_lines:\n  hawser: {vessel: two, fairlead: [0 m, 0 m, 4 m], to: [90 m, 0 m, 6 m], "
        f"held_by: one, rope: steel, type: distributed, pretension: {pull} N}}\n"
    )
    text = pair(hawser, second="    position: [210 m, 0 m]\n", start="as_given")
    recording = gantline.simulate(parse_scenario(text))
    ends = recording.column("rope_end_tension", "mooring.hawser")[0]
    assert float(ends[0]) == pytest.approx(pull, rel=1e-9)
    length = next(rope.mass for rope in recording.rig.ropes if rope.name == "mooring.hawser") / 20.0

    def apart(forces: Floats) -> Floats:
        """(RW3): how far the upper end is aside of and above the lower one, less 120 m and 2 m."""
        level, upper = forces
        lower = upper - weight * length
        steep = math.asinh(upper / level) - math.asinh(lower / level)
        aside = level * length / stiffness + level / weight * steep
        above = (upper**2 - lower**2) / (2 * stiffness * weight)
        above += (math.hypot(level, upper) - math.hypot(level, lower)) / weight
        return np.array([aside - 120.0, above - 2.0])

    level, upper = fsolve(apart, [pull, weight * length / 2], xtol=1e-13)
    assert float(ends[0]) == pytest.approx(math.hypot(level, upper - weight * length), rel=1e-5)
    assert float(ends[1]) == pytest.approx(math.hypot(level, upper), rel=1e-5)
    assert upper / level > 0.07, "it sags"
