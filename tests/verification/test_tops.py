"""Bodies that turn in space, in closed form: free of torque by elliptic functions, and a heavy top."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipj

from mechanics import G, adaptive, body, document, free


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
