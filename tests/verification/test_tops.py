"""Bodies that turn in space, in closed form: free of torque by elliptic functions, a top, a wheel hung up."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipj

from mechanics import Floats, G, Json, Run, adaptive, body, document, end, free, rope, simulate


def test_a_body_free_of_torque_turns_by_elliptic_functions() -> None:
    """ω = (a₁ cn, a₂ sn, a₃ dn) of τ = t sqrt((I₃ − I₂)(L² − 2 E I₁)/(I₁ I₂ I₃)), L² > 2 E I₂.

    I₁ < I₂ < I₃, a₁² = (2 E I₃ − L²)/(I₁ (I₃ − I₁)), a₂² = (2 E I₃ − L²)/(I₂ (I₃ − I₂)),
    a₃² = (L² − 2 E I₁)/(I₃ (I₃ − I₁)),
    k² = (I₂ − I₁)(2 E I₃ − L²)/((I₃ − I₂)(L² − 2 E I₁)) (Landau and Lifshitz, Mechanics, section 37).
    """
    one, two, three = inertia = (4.0, 7.0, 9.0)
    spin = (1.2, 0.0, 1.6)
    twice_energy = one * spin[0] ** 2 + three * spin[2] ** 2
    square = (one * spin[0]) ** 2 + (three * spin[2]) ** 2
    assert square > twice_energy * two
    below, above = square - twice_energy * one, twice_energy * three - square
    modulus = (two - one) * above / ((three - two) * below)
    rate = math.sqrt((three - two) * below / (one * two * three))
    system = {
        **document([body("b", free((0, 0, 0), angular_velocity=list(spin)), 5.0, inertia=inertia)]),
        "gravity": [0, 0, 0],
    }
    run = adaptive(system, 30.0, position_tolerance=1e-10, sample_interval=0.1)
    sn, cn, dn, _ = ellipj(rate * run.time, modulus)
    # sn counts as (ω₂)' does at the start: (I₃ − I₁) ω₃ ω₁/I₂ > 0.
    expected = np.stack([spin[0] * cn, math.sqrt(above / (two * (three - two))) * sn, spin[2] * dn], axis=1)
    found, momentum = run.spin("b", inertia)
    # Tolerance of 1e-10 in a step, over 30 s and ten turns.
    assert np.abs(found - expected).max() < 1e-6
    assert np.abs(momentum - momentum[0]).max() < 1e-6 * math.sqrt(square)


@pytest.mark.parametrize("slow", [True, False])
def test_a_heavy_top_precesses(slow: bool) -> None:
    """A Ω² cos θ − C ω₃ Ω + m g l = 0 has two rates Ω at which its centre goes round a level circle."""
    mass, arm, lean, spinning = 20.0, 0.4, 0.7, 60.0
    across, along = 1.1, 1.6
    about_tip = across + mass * arm**2
    half = along * spinning / (2 * about_tip * math.cos(lean))
    root = math.sqrt(half**2 - mass * G * arm / (about_tip * math.cos(lean)))
    rate = half - root if slow else half + root
    tip = {
        "type": "ball",
        "orientation": [math.cos(lean / 2), 0, math.sin(lean / 2), 0],
        "angular_velocity": [-rate * math.sin(lean), 0, spinning],
    }
    top = body("top", tip, mass, centre_of_gravity=(0, 0, arm), inertia=(across, across, along))
    run = adaptive(document([top]), 2.0, position_tolerance=1e-10)
    turned = rate * run.time
    circle = arm * math.sin(lean) * np.stack([np.cos(turned), np.sin(turned)], axis=1)
    # 20 turns of the spin, some thousand steps of 1e-10 m.
    assert np.abs(run.body("top")[:, :2] - circle).max() < 1e-6
    assert np.abs(run.body("top")[:, 2] - arm * math.cos(lean)).max() < 1e-6
    # What the tip bears: weight, and m Ω² l sin θ towards the axis.
    force = run.columns["joint_force"][:, run.names["body"].index("top")]
    assert force[:, 2] == pytest.approx(np.full(len(force), mass * G), rel=1e-6)
    assert np.hypot(force[:, 0], force[:, 1]) == pytest.approx(
        np.full(len(force), mass * rate**2 * arm * math.sin(lean)), rel=1e-5
    )


#: Rope [m], from the wheel's middle to its end of the axle [m], mass [kg], about the axle and across [kg m²].
LONG, AXLE, WHEEL, ABOUT, ACROSS = 6.0, 0.8, 300.0, 40.0, 25.0


def precession(spin: float) -> tuple[float, float, float]:
    """Ω = m g a/(I ω) [rad/s], lean of the rope [rad], its tension [N].

    g tan α = Ω² (L sin α + a) bears the middle on its circle; beyond √(g/L) the rope leans the other way.
    """
    rate = WHEEL * G * AXLE / (ABOUT * spin)
    sides = (0.0, 1.2) if rate < math.sqrt(G / LONG) else (-1.2, 0.0)
    lean = float(
        brentq(
            lambda a: G * math.tan(a) - rate**2 * (LONG * math.sin(a) + AXLE), *sides, xtol=1e-15, rtol=1e-14
        )
    )
    return rate, lean, WHEEL * G / math.cos(lean)


def wheel_on_a_rope(spin: float) -> Json:
    """A wheel with a level axle, held by a rope at one end of it, that goes round from the start."""
    rate, lean, _ = precession(spin)
    out, down = LONG * math.sin(lean) + AXLE, LONG * math.cos(lean)
    start = free((out, 0, -down), velocity=[0, rate * out, 0], angular_velocity=[spin, 0, rate])
    wheel = body("wheel", start, WHEEL, inertia=(ABOUT, ACROSS, ACROSS))
    return document([wheel], ropes=[rope("r", LONG, [end(None), end("wheel", (-AXLE, 0, 0))], None)])


def errors_of_precession(run: Run, spin: float) -> tuple[float, Floats]:
    """Of its place [m], and of the tension in every sample after the first, relative."""
    rate, lean, tension = precession(spin)
    out, turned = LONG * math.sin(lean) + AXLE, rate * run.time
    height = np.full(len(turned), -LONG * math.cos(lean))
    circle = np.stack([out * np.cos(turned), out * np.sin(turned), height], axis=1)
    return float(np.abs(run.body("wheel") - circle).max()), run.tension("r")[1:] / tension - 1


#: Spins of a wheel that goes round slower, and faster, than it would swing on the rope [rad/s].
SPINS = pytest.mark.parametrize("spin", [60.0, 25.0], ids=["slower than its swing", "faster than its swing"])


@SPINS
@pytest.mark.parametrize(
    # 10 s are 95 and 40 turns of the spin. At 0.1 mm in a step 0.45 mm and 9e-4 of the tension were found,
    # at 10 nm 0.55 µm and 3e-6.
    ("tolerances", "way", "share"),
    [((None, None), 1e-3, 2e-3), ((1e-2, 1e-8), 1e-6, 1e-5)],
    ids=["default", "tight"],
)
def test_a_wheel_on_a_rope_precesses(
    spin: float, tolerances: tuple[float | None, float | None], way: float, share: float
) -> None:
    """Ω = m g a/(I ω), since T cos α = m g turns I ω about plumb; g tan α = Ω² (L sin α + a)."""
    force, place = tolerances
    run = adaptive(wheel_on_a_rope(spin), 10.0, tension_tolerance=force, position_tolerance=place)
    apart, pulled = errors_of_precession(run, spin)
    assert apart < way
    assert np.abs(pulled).max() < share
    assert run.energy_remainder < 1e-11


@SPINS
def test_a_wheel_on_a_rope_converges_with_the_step(spin: float) -> None:
    """T = m g/cos α by `del`: half the step has half the error; the circle comes closer at least as fast.

    Its kinetic energy stays to 1e-4 of itself.
    """
    found = []
    for step in (1e-3, 5e-4):
        run = simulate(wheel_on_a_rope(spin), 10.0, step=step, sample_interval=0.02)
        apart, pulled = errors_of_precession(run, spin)
        found.append((apart, float(np.abs(pulled).max())))
        assert run.energy("kinetic") == pytest.approx(run.energy("kinetic")[0], rel=1e-4)
    # In a step of 1 ms it turns by 0.06 rad, and 0.9 % of the tension is off, 2.6 mm of the circle.
    assert found[0][1] < 1e-2
    assert found[0][0] < 3e-3
    assert found[0][1] / found[1][1] == pytest.approx(2, abs=0.05)
    assert found[0][0] / found[1][0] > 2
