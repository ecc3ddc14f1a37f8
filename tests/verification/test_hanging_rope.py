"""A rope of distributed weight that hangs by its upper end: its first swing, and waves along it.

The lower end is a body of a millionth of the rope's mass. The rope starts at rest with the velocities of one
mode, small enough that it stays linear: 1 mm/s in 100 m.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from mechanics import G, Json, Run, adaptive, period

LENGTH, MASS = 100.0, 10.0  # m, kg/m
#: First zero of the Bessel function J0.
FIRST_ZERO = 2.404825557695773


def bessel_j0(x: float) -> float:
    """J0(x) = 1/pi integral of cos(x sin t) over 0 ... pi; the trapezoidal rule is exact to rounding here."""
    return float(np.mean(np.cos(x * np.sin(np.arange(64) * math.pi / 64))))


def hanging(nodes: int, stiffness: float, velocity: Callable[[float], tuple[float, float]]) -> Json:
    """The rope at rest, except for velocities along x and z by share of its length from the top [m/s]."""
    bottom = -LENGTH - MASS * G * LENGTH**2 / (2 * stiffness)
    text = f"""\
format: 1
lift: {{title: A rope that hangs by one end}}
duration: 1 s
ropes:
  kind: {{axial_stiffness: {stiffness!r} N, mass: {MASS!r} kg/m}}
mechanics:
  bodies:
    tip: {{at: [0 m, 0 m, {bottom!r} m], mass: {1e-6 * MASS * LENGTH!r} kg, joint: {{type: point}}}}
  ropes:
    rope:
      rope: kind
      length: {LENGTH!r} m
      rope_weight: distributed
      rope_nodes: {nodes}
      route: [{{type: end, body: world}}, {{type: end, body: tip}}]
"""
    document = assemble(parse_scenario(text)).document
    bodies = {body["name"]: body["joint"] for body in document["bodies"]}
    for place, name in enumerate([*(f"rope/{node}" for node in range(1, nodes + 1)), "tip"], start=1):
        sideways, up = velocity(place / (nodes + 1))
        bodies[name]["velocity"] = [sideways, 0.0, up]
    return document


def swing(nodes: int) -> tuple[float, Run]:
    """Period of the first swing over the closed form, T = 2 pi/omega, omega = (j/2) sqrt(g/L)."""
    exact = 2 * math.pi / (FIRST_ZERO / 2 * math.sqrt(G / LENGTH))
    mode = hanging(nodes, 1e10, lambda share: (1e-3 * bessel_j0(FIRST_ZERO * math.sqrt(1 - share)), 0.0))
    run = adaptive(
        mode, 4 * exact, tension_tolerance=0.1, position_tolerance=1e-8, sample_interval=exact / 200
    )
    return period(run.time, run.body("tip")[:, 0]) / exact, run


def wave(nodes: int) -> tuple[float, Run]:
    """Period of the first wave along the rope over the closed form, T = 4 L/c, c = sqrt(EA/m)."""
    stiffness = 1e8
    exact = 4 * LENGTH / math.sqrt(stiffness / MASS)
    mode = hanging(nodes, stiffness, lambda share: (0.0, 1e-3 * math.sin(math.pi / 2 * share)))
    run = adaptive(
        mode, 8 * exact, tension_tolerance=1e-2, position_tolerance=1e-9, sample_interval=exact / 200
    )
    height = run.body("tip")[:, 2]
    return period(run.time, height, about=float(height[0])) / exact, run


def test_first_swing_of_a_hanging_rope() -> None:
    """omega = 1.2024 sqrt(g/L), half the first zero of J0 (Bernoulli): 50 nodes to 1e-4.

    Their own error is 6e-5 by the order below; the swing of 1 mm/s over 100 m, the tip's millionth and
    the stretch of EA = 1e10 N are below 1e-5.
    """
    assert pytest.approx(1.2024, abs=5e-5) == FIRST_ZERO / 2
    ratio, run = swing(50)
    assert ratio == pytest.approx(1.0, abs=1e-4)
    assert run.energy_remainder < 1e-8


def test_first_wave_along_a_hanging_rope() -> None:
    """omega = pi/2 c/L with c = sqrt(EA/m), one end fixed and one free: 50 nodes to 1e-4.

    A chain of N equal masses has omega lower by (pi/(4 N))^2/6 (Born and von Karman), 4e-5 at N = 51.
    """
    ratio, run = wave(50)
    assert ratio == pytest.approx(1.0, abs=1e-4)
    assert ratio - 1 == pytest.approx((math.pi / (4 * 51)) ** 2 / 6, rel=0.05)
    assert run.energy_remainder < 1e-8


@pytest.mark.parametrize("periods", [swing, wave], ids=["swing", "wave"])
def test_motion_is_of_second_order_in_the_length_of_segments(
    periods: Callable[[int], tuple[float, Run]],
) -> None:
    """The error of the period falls with the square of the number of segments: 10, 20 and 40 of them."""
    error = np.array([abs(periods(segments - 1)[0] - 1) for segments in (10, 20, 40)])
    assert np.log2(error[:-1] / error[1:]) == pytest.approx([2.0, 2.0], abs=0.2)
