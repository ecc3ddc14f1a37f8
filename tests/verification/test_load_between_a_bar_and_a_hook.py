"""A module hangs from a spreader bar and from a second hook; one hook hoists as the other lowers, until a
sling is cut: against Newton's and Euler's equations of bar and module.

Both are rigid bodies that turn as they like, 66° in the end; slings are of unequal length and stiffness, and

    T = EA/L max(0, e + τ ė)

acts between the points at their ends, of which hooks move by ramps of velocity. scipy's DOP853 solves that
from one kink to the next; where slings go slack and taut it finds its own steps.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from mechanics import Floats
from rigid import points_of, rates_of

#: Module and bar: mass [kg], inertia about the centre of gravity [kg m²].
MODULE, BAR = 80e3, 4e3
INERTIA = 1e3 * np.array([[213.0, 20.0, -30.0], [20.0, 1813.0, 0.0], [-30.0, 0.0, 1813.0]])
SIZE = np.array([0.4, 3.6, 0.5])
BAR_INERTIA = BAR / 12 * (SIZE @ SIZE * np.eye(3) - np.diag(SIZE**2))
CENTRE = np.array([0.6, 0.1, 2.0])
#: What each sling hangs from and holds, its ends there [m], length [m], EA [N], τ [s].
SLINGS = {
    "T1": ("h1", (0, 0, 0), "bar", (0, 1.5, 0.25), 4.0, 40e6, 6e-3),
    "T2": ("h1", (0, 0, 0), "bar", (0, -1.5, 0.25), 4.03, 40e6, 6e-3),
    "A": ("bar", (0, 1.6, -0.25), "module", (-7, 1.5, 4), 7.0, 25e6, 12e-3),
    "B": ("bar", (0, -1.6, -0.25), "module", (-7, -1.5, 4), 7.02, 25e6, 12e-3),
    "C": ("h2", (0, 0, 0), "module", (7, 0.2, 4), 8.1, 15e6, 10e-3),
}
LENGTHS, STIFFNESSES, DAMPINGS = np.array([sling[4:] for sling in SLINGS.values()]).T
#: Which ends are on a hook or body, 0 above and 1 below, and of which slings.
ENDS_ON = {
    body: np.nonzero(np.array([(sling[0] == body, sling[2] == body) for sling in SLINGS.values()]).T)
    for body in ("h1", "h2", "module", "bar")
}
#: Where they are from the centre of gravity, that of the bar in its middle (n, 3) [m].
ENDS_FROM = np.array(
    [[sling[1] for sling in SLINGS.values()], [sling[3] for sling in SLINGS.values()]], float
)
PLACES = {"module": ENDS_FROM[ENDS_ON["module"]] - CENTRE, "bar": ENDS_FROM[ENDS_ON["bar"]]}
#: Where hooks start [m], how far up each goes [m] and how fast [m/s], from when [s]; all with 0.5 m/s².
HOOKS = {"h1": ((-7.0, 0.0, 20.0), 7.0, 0.8), "h2": ((7.0, 0.0, 17.0), -5.6, 0.6)}
BEGINS, ACCELERATION, CUT, LASTS = 1.0, 0.5, 11.0, 14.0

LIFT = """\
format: 1
lift: {title: A module between a bar and a hook}
duration: 14 s
start: as_given
ropes:
  upper: {axial_stiffness: 40 MN, damping_time: 6 ms}
  lower: {axial_stiffness: 25 MN, damping_time: 12 ms}
  single: {axial_stiffness: 15 MN, damping_time: 10 ms}
load:
  name: module
  shape: {box: [16 m, 4 m, 4 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 80 t}
  inertia: {xx: 213 t m^2, yy: 1813 t m^2, zz: 1813 t m^2, xy: 20 t m^2, xz: -30 t m^2}
  centre_of_gravity: {at: [0.6 m, 0.1 m, 2 m]}
  lugs: {A: {at: [-7 m, 1.5 m, 4 m]}, B: {at: [-7 m, -1.5 m, 4 m]}, C: {at: [7 m, 0.2 m, 4 m]}}
cranes:
  h1: {type: fixed_hook, at: [-7 m, 0 m, 20 m], hoist: {speed: 1 m/s, acceleration: 0.5 m/s^2}}
  h2: {type: fixed_hook, at: [7 m, 0 m, 17 m], hoist: {speed: 1 m/s, acceleration: 0.5 m/s^2}}
spreaders:
  bar:
    mass: 4 t
    size: [0.4 m, 3.6 m, 0.5 m]
    lugs:
      T1: {at: [0 m, 1.5 m, 0.25 m]}
      T2: {at: [0 m, -1.5 m, 0.25 m]}
      B1: {at: [0 m, 1.6 m, -0.25 m]}
      B2: {at: [0 m, -1.6 m, -0.25 m]}
slings:
  T1: {from: h1, to: bar.T1, length: 4 m, rope: upper}
  T2: {from: h1, to: bar.T2, length: 4.03 m, rope: upper}
  A: {from: bar.B1, to: module.A, length: 7 m, rope: lower, cut_at: 11 s}
  B: {from: bar.B2, to: module.B, length: 7.02 m, rope: lower}
  C: {from: h2, to: module.C, length: 8.1 m, rope: single}
plan:
  - {step: up, hoist: h1, by: 7 m, speed: 0.8 m/s, start_at: 1 s}
  - {step: down, lower: h2, by: 5.6 m, speed: 0.6 m/s, starts: with_previous}
  - {step: hold, hold: until_end}
simulation: {sample_interval: 20 ms, tension_tolerance: 0.1 N, position_tolerance: 0.0001 mm}
"""


def kinks(hook: str) -> tuple[float, float, float, float]:
    """When a hook begins to move, is fast, brakes and stands [s]."""
    _, way, speed = HOOKS[hook]
    ramp, lasts = speed / ACCELERATION, abs(way) / speed
    return BEGINS, BEGINS + ramp, BEGINS + lasts, BEGINS + lasts + ramp


def hook_at(hook: str, time: float) -> tuple[Floats, Floats]:
    """Where a hook is [m] and its velocity [m/s]."""
    place, way, _ = HOOKS[hook]
    # Four ramps of acceleration, each from its kink on.
    ages = [max(0.0, time - kink) for kink in kinks(hook)]
    ramps = [
        (math.copysign(ACCELERATION, sign * way), age) for sign, age in zip((1, -1, -1, 1), ages, strict=True)
    ]
    up, speed = sum(ramp * age**2 / 2 for ramp, age in ramps), sum(ramp * age for ramp, age in ramps)
    return np.array([*place[:2], place[2] + up]), np.array([0.0, 0.0, speed])


def pulls(time: float, state: Floats) -> tuple[Floats, Floats, Floats]:
    """Tensions of slings (5,) [N], their ways down (5, 3), both ends of each in the world (2, 5, 3) [m]."""
    places, speeds = np.empty((2, 5, 3)), np.empty((2, 5, 3))
    for hook in HOOKS:
        places[ENDS_ON[hook]], speeds[ENDS_ON[hook]] = hook_at(hook, time)
    for body, own in (("module", state[:13]), ("bar", state[13:])):
        places[ENDS_ON[body]], speeds[ENDS_ON[body]] = points_of(own, PLACES[body])
    ways, apart = places[1] - places[0], speeds[1] - speeds[0]
    sizes = np.sqrt((ways * ways).sum(axis=1))
    stretches = sizes - LENGTHS + DAMPINGS * (ways * apart).sum(axis=1) / sizes
    tensions = STIFFNESSES / LENGTHS * np.maximum(0.0, stretches)
    if time >= CUT:
        tensions[list(SLINGS).index("A")] = 0.0
    return tensions, ways / sizes[:, None], places


def rates(time: float, state: Floats) -> Floats:
    """Of module and bar."""
    tensions, ways, places = pulls(time, state)
    # Down at the upper ends, up at the lower ones.
    forces = tensions[:, None] * np.stack([ways, -ways])
    on = {body: (forces[at], places[at]) for body, at in ENDS_ON.items()}
    module = rates_of(state[:13], MODULE, INERTIA, *on["module"])
    return np.concatenate([module, rates_of(state[13:], BAR, BAR_INERTIA, *on["bar"])])


@pytest.fixture(scope="module")
def recording() -> Recording:
    return simulate(parse_scenario(LIFT))


def test_module_and_bar_move_as_their_own_equations_say(recording: Recording) -> None:
    """Places, attitudes and tensions over the whole lift; what a sling pulls after its cut is nothing."""
    # Where the bar hangs at the start follows from its slings, see `tests/verification/test_spreaders.py`.
    start = [
        np.concatenate([recording.column(f"body_{what}", body)[0] for what in ("position", "orientation")])
        for body in ("module", "bar")
    ]
    state = np.concatenate([start[0], np.zeros(6), start[1], np.zeros(6)])
    assert state[:3] == pytest.approx([0.6, 0.1, 7.0])
    breaks = sorted({0.0, *kinks("h1"), *kinks("h2"), CUT, LASTS})
    times, states = [0.0], [state]
    for begin, end in pairwise(breaks):
        asked = recording.time[(recording.time > begin) & (recording.time < end - 1e-9)]
        # Longer steps might pass over a sling that goes taut and slack again.
        run = solve_ivp(
            rates, (begin, end), state, "DOP853", [*asked, end], rtol=1e-9, atol=1e-10, max_step=0.02
        )
        state = run.y[:, -1]
        is_sample = np.isin(run.t, recording.time)
        times.extend(run.t[is_sample])
        states.extend(run.y.T[is_sample])
    own = np.array(states)
    assert np.array_equal(times, recording.time)
    # Found: 7e-9 and 1.3e-7 m, 1e-15 and 1e-12 of attitudes.
    for body, first, within in (("module", 0, 1e-7), ("bar", 13, 1e-6)):
        assert recording.column("body_position", body) == pytest.approx(own[:, first : first + 3], abs=within)
        both = recording.column("body_orientation", body) * own[:, first + 3 : first + 7]
        assert np.abs(both.sum(axis=1)).min() > 1 - within**2
    # Found: 2e-7 of the largest. At the cut itself a sample may be of either side.
    clear = np.abs(recording.time - CUT) > 1e-9
    tensions = np.array([pulls(t, y)[0] for t, y in zip(times, own, strict=True)])
    for name, wanted in zip(SLINGS, tensions.T, strict=True):
        found = recording.column("rope_tension", f"sling.{name}")
        assert found[clear] == pytest.approx(wanted[clear], abs=1e-6 * wanted.max())


def test_it_is_turned_and_its_slings_go_slack(recording: Recording) -> None:
    """What the comparison is worth: 66°, slings that go slack and taut, and books that close to rounding."""
    assert recording.metrics()["peak_load_tilt"] == pytest.approx(np.radians(66.0), rel=1e-3)
    assert list(recording["event_kind"].values).count("taut") > 10
    assert recording.metrics()["energy_remainder"] < 1e-12
