"""Moving sheaves that no frame guides: where they hang, what they carry, and what guides change."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import fsolve

import gantline
from gantline import Statics, parse_scenario
from mechanics import G

Floats = npt.NDArray[np.float64]

#: Pitch radius; depth of the moving sheaves below dead ends and fixed sheave at the start [m].
RADIUS, DROP = 0.4, 2.0
#: Mass of load and of a moving sheave [kg], length of a sling [m], EA of sling and equalizing rope [N].
LOAD, SHEAVE, SLING, EA_SLING, EA_ROPE = 100e3, 300.0, 12.0, 150e6, 80e6
#: From the middle of the frame to a moving sheave at the start, with plumb rope [m].
ALONG = 2 * RADIUS

LIFT = """\
format: 1
lift: {{title: Two sheaves that hang free}}
duration: 6 s
start: {start}
ropes:
  sling: {{axial_stiffness: {EA_SLING} N, damping_time: 20 ms, mass: none}}
  equalizing: {{axial_stiffness: {EA_ROPE} N, damping_time: 20 ms, mass: none}}
load:
  name: beam
  shape: {{box: [12 m, 2 m, 1 m]}}
  datum: bottom_centre
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: {LOAD} kg, contingency: 1}}
  centre_of_gravity: {{at: [0 m, 0 m, 0.5 m]}}
  lugs:
    A: {{at: [-{lug} m, 0 m, 1 m]}}
    B: {{at: [{lug} m, 0 m, 1 m]}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, {hook} m], rated_capacity: 200 t,
         hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
equalizers:
  e:
    hangs_from: hook
    heading: 0 deg
    rated_capacity: 200 t
    frame: {{mass: 4 t, length: 6 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 3 m}}
    hinge: {{axis: vertical}}
    rope: equalizing
    rope_ends:      {{along: [-{end} m, {end} m], below_hook: 4 m}}
    fixed_sheaves:  {{along: [0 m], below_hook: 4 m, pitch_diameter: 0.8 m}}
    moving_sheaves: {{along: [-{ALONG} m, {ALONG} m], below_hook: 6 m, pitch_diameter: 0.8 m,
                     mass: {SHEAVE} kg, guided: {guided}}}
    travel: {{up: 1 m, down: 2 m}}
slings:
  A: {{from: e.1, to: beam.A, length: {SLING} m, rope: sling}}
  B: {{from: e.2, to: beam.B, length: {length} m, rope: sling}}
plan:
  - {{step: up, hoist: hook, speed: 6 m/min, by: 0.2 m, start_at: 0 s}}
  - {{step: hold, hold: until_end}}
"""


def lift(guided: str, lug: float, *, length: float = SLING, start: str = "rest") -> gantline.Scenario:
    """Two slings from the sheaves to lugs `lug` [m] off the middle, the second of them `length` [m] long."""
    values = globals() | {"guided": guided, "lug": lug, "length": length, "start": start}
    # Just taut with the sheaves where the lift file has them.
    hook = 1.0 + math.sqrt(SLING**2 - (lug - ALONG) ** 2) + 6.0
    return parse_scenario(LIFT.format(**values, hook=hook, end=ALONG + RADIUS))


def half_rope(x: float, z: float) -> tuple[float, float, float]:
    """From a dead end at (3 r, 0) under a sheave at (x, z) to the top of one at (0, 0) [m], and ∂ℓ/∂x, ∂ℓ/∂z.

    One part touches the moving circle from a point, √(d² − r²) long; the other crosses over from circle to
    circle, √(D² − 4r²) long. The rope lies on each for as far as its direction turns there. The sheave makes
    the first part longer along its direction, and the second shorter along its own.
    """
    end, centre = np.array([3 * RADIUS, 0.0]), np.array([x, z])
    down, up = centre - end, -centre
    near, far = float(np.hypot(*down)), float(np.hypot(*up))
    first = math.atan2(down[1], down[0]) + math.asin(RADIUS / near)
    second = math.atan2(up[1], up[0]) - math.asin(2 * RADIUS / far)
    straight = math.sqrt(near**2 - RADIUS**2) + math.sqrt(far**2 - 4 * RADIUS**2)
    length = straight + RADIUS * (first - second + 2 * math.pi) + RADIUS * (math.pi - second)
    return length, math.cos(first) - math.cos(second), math.sin(first) - math.sin(second)


@pytest.mark.parametrize("lug", [0.8, 2.5, 5.0])
def test_where_a_sheave_hangs_that_its_sling_draws_aside(lug: float) -> None:
    """F u = T ∇ℓ + m g z for the sheave, 2 F cos φ = W for the load, ropes by EA: solved here by itself."""
    taut, _, _ = half_rope(ALONG, -DROP)

    def forces(place: Floats) -> tuple[float, float, Floats]:
        """Tension of sling and rope with the sheave at x, z and a lug as low as said; what is left over."""
        x, z, low = place
        length, slope_x, slope_z = half_rope(x, z)
        way = math.hypot(lug - x, low - z)
        sling, rope = EA_SLING * (way / SLING - 1), EA_ROPE * (length / taut - 1)
        along, up = sling * (lug - x) / way, sling * (low - z) / way
        left = [along - rope * slope_x, up - SHEAVE * G - rope * slope_z, -2 * up - LOAD * G]
        return sling, rope, np.array(left) / (LOAD * G)

    height = math.sqrt(SLING**2 - (lug - ALONG) ** 2)
    start = np.array([ALONG + 0.02 * (lug - ALONG), -DROP, -DROP - height - 0.05])
    found = fsolve(lambda place: forces(place)[2], start, xtol=1e-12)
    sling, rope, left = forces(found)
    assert np.abs(left).max() < 1e-9

    recording = Statics(lift("none", lug)).equilibrium().recording
    assert recording.column("rope_tension", "sling.A")[-1] == pytest.approx(sling, rel=1e-7)
    assert recording.column("rope_tension", "e.equalizing")[-1] == pytest.approx(rope, rel=1e-7)
    # Down is positive, from where the lift file has it.
    assert recording.column("sheave_travel", "e.2")[-1] == pytest.approx(-DROP - found[1], abs=1e-7)
    assert recording.column("joint_position", "e.2/along")[-1] == pytest.approx(found[0] - ALONG, abs=1e-7)
    assert recording.column("joint_position", "e.2/across")[-1] == pytest.approx(0.0, abs=1e-9)


def test_below_plumb_slings_guides_change_nothing() -> None:
    """Nothing draws a sheave aside: hoisted with slings of two lengths, both carry and travel the same."""
    free, guided = (
        gantline.simulate(lift(words, ALONG, length=SLING + 0.3, start="as_given"))
        for words in ("none", "vertical")
    )
    assert guided.column("rope_tension", "sling.B").max() > 0.4 * LOAD * G
    for variable, name in (
        ("rope_tension", "sling.A"),
        ("rope_tension", "sling.B"),
        ("sheave_travel", "e.1"),
    ):
        one, other = (
            np.interp(guided.time, each.time, each.column(variable, name)) for each in (free, guided)
        )
        # Ten times the tolerances of a step: 50 N and 0.1 mm.
        assert np.abs(one - other).max() < (500.0 if variable == "rope_tension" else 1e-3)


def remainder(**settings: Any) -> float:
    """Of a beam that drops into slings that lean outward by 20 degrees and draw their sheaves aside."""
    found = gantline.simulate(lift("none", 5.0, start="as_given"), **settings)
    assert np.ptp(found.column("joint_position", "e.2/along")) > 0.1
    return float(found.metrics()["energy_remainder"])


def test_books_close_while_sheaves_swing() -> None:
    """No energy is lost or made, to the bound of the default tolerances."""
    assert remainder() < 1e-8


def test_del_closes_its_books_in_proportion_to_its_step() -> None:
    """A method of first order: half the step leaves at most 1/1.6 of it, twice over."""
    left = [remainder(integrator="del", step=step) for step in (2e-3, 1e-3, 0.5e-3)]
    assert left[0] > 1.6 * left[1] > 1.6**2 * left[2]


def test_locked_for_a_comparison_they_hang_as_in_guides() -> None:
    """What pins hold does not move, so guides change nothing: the same numbers."""
    free, guided = (
        gantline.simulate(lift(words, 2.5), equalizers="locked") for words in ("none", "vertical")
    )
    tension = free.column("rope_tension", "sling.A")
    assert tension.max() > 0.4 * LOAD * G
    assert np.array_equal(tension, guided.column("rope_tension", "sling.A"))
