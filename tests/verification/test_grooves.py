"""Losses on sheaves with true tangents, grooves in which rope slips: docs/concepts/flows.md; `adaptive`."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lossy_rigs import DAMPING_TIME, ON_SHEAVE, SPINNING, STIFF, spun
from mechanics import G, Json, adaptive, body, document, drum, end, flow, rope, sheave, slider

RADIUS = 0.5
CENTRE = (0.0, 0.0, 10.0)


def leaving(wrap: float, way: float = 5.0) -> tuple[float, float, float]:
    """A point `way` [m] along the part that leaves the sheave after a wrap [rad] from a plumb part."""
    radial = (-math.cos(wrap), math.sin(wrap))
    along = (math.sin(wrap), math.cos(wrap))
    x, z = (RADIUS * r + way * a for r, a in zip(radial, along, strict=True))
    return (CENTRE[0] + x, 0.0, CENTRE[2] + z)


def hauled(guide: Json, winch: Json, speed: float, **more: Any) -> Json:
    """1 t plumb under the left side of a sheave, its rope hauled in at `winch` beyond it."""
    ramp = {"at": 0.0, "duration": 0.3, "velocity": -speed, "shape": "smooth"}
    bodies = [
        body("weight", slider(), 1000.0, position=(-RADIUS, 0, 0)),
        flow("over", 0.1),
        flow("winch", 10.0, drive="winch"),
        *more.pop("bodies", []),
    ]
    line = rope("r", None, [end("weight"), guide, winch], STIFF, DAMPING_TIME)
    drives = [{"name": "winch", "ramps": [ramp]}, *more.pop("drives", [])]
    return document(bodies, ropes=[line], drives=drives)


def tangent(**passing: Any) -> Json:
    return sheave(None, CENTRE, (0, 1, 0), RADIUS, flow="over", **passing)


@pytest.mark.parametrize("degrees", [40, 90, 140, 200])
@pytest.mark.parametrize("friction", [None, 0.1])
def test_losses_at_any_wrap(degrees: float, friction: float | None) -> None:
    """Steady slip: T₂/T₁ = 1/η of a bearing at any wrap, e^{μβ} in the groove of a sheave that stands."""
    wrap = math.radians(degrees)
    ratio = 1 / 0.98 if friction is None else math.exp(friction * wrap)
    guide = tangent(ratio=ratio) if friction is None else tangent(groove={"friction": friction})
    run = adaptive(hauled(guide, drum(None, leaving(wrap), "winch"), 0.1), 2.0)
    assert run.columns["wrap_angle"][0] == pytest.approx(wrap, abs=1e-12)
    low, high = run.columns["segment_tension"][-1]
    assert low == pytest.approx(1000 * G, rel=1e-9)
    assert high / low == pytest.approx(ratio, rel=1e-6)
    # (ρ − 1) times what the weight has taken up; the rope's stretch and the flow's own 0.1 kg are 1e-5 of it.
    taken = 1000 * (G * run.joint("over")[-1] + 0.5 * 0.1**2)
    assert run.energy("friction")[-1] == pytest.approx((ratio - 1) * taken, rel=1e-4)
    assert run.energy_remainder < 1e-8


def test_groove_follows_its_wrap() -> None:
    """T₂/T₁ = e^{μβ(t)} while the winch moves round the sheave and hauls: the groove goes by its wrap.

    What is left is the inertia of 0.1 kg of rope at less than 1 m/s²: 1e-5 of 9.8 kN.
    """
    ramp = {"at": 1.0, "duration": 1.0, "velocity": 1.5, "shape": "smooth"}
    trolley = body("trolley", slider((1, 0, 0), drive="travel"), 100.0, position=leaving(math.radians(40)))
    guide = tangent(groove={"friction": 0.2})
    moved = {"bodies": [trolley], "drives": [{"name": "travel", "ramps": [ramp]}]}
    run = adaptive(hauled(guide, drum("trolley", (0, 0, 0), "winch"), 0.3, **moved), 5.0)
    wrap = run.columns["wrap_angle"][:, 0]
    assert np.ptp(wrap) > math.radians(15)
    slipping = run.time > 0.6
    low, high = run.columns["segment_tension"][slipping].T
    assert np.abs(np.log(high / low) - 0.2 * wrap[slipping]).max() < 2e-5
    assert run.energy_remainder < 1e-7


def test_held_by_a_groove_for_an_hour() -> None:
    """10 against 11 kg is less than e^{μβ} = 1.17: the rope does not creep in an hour."""
    wrap = math.radians(180)
    bodies = [
        body("light", slider(), 10.0, position=(-RADIUS, 0, 5)),
        body("heavy", slider(), 11.0, position=(RADIUS, 0, 5)),
        flow("over", 0.1),
    ]
    guide = tangent(groove={"friction": 0.05})
    line = rope("r", None, [end("light"), guide, end("heavy")], 1e9, DAMPING_TIME)
    run = adaptive(document(bodies, ropes=[line]), 3600.0, sample_interval=10.0)
    assert math.exp(0.05 * wrap) > 1.1
    assert np.abs(run.joint("over")).max() < 1e-9
    low, high = run.columns["segment_tension"][-1]
    assert high / low == pytest.approx(1.1, rel=1e-8)


def test_rope_slips_on_a_heavy_sheave() -> None:
    """The sheave lags behind the rope; with σ = tanh(μπ/2) of the groove and σ_b of the bearing,

    m_s a = T₂ (1 − σ) − T₁ (1 + σ), M u̇ = (σ − σ_b)(T₁ + T₂), T₁ = m₁ (g + a), T₂ = m₂ (g − a).
    """
    light, heavy, friction, ratio = 100.0, 130.0, 0.02, 1.01
    share, bearing = math.tanh(friction * math.pi / 2), (ratio - 1) / (ratio + 1)
    pull, hold = heavy * (1 - share), light * (1 + share)
    a = G * (pull - hold) / (pull + hold + ON_SHEAVE)
    low, high = light * (G + a), heavy * (G - a)
    spin = (share - bearing) * (low + high) / SPINNING
    assert 0 < spin < a
    run = adaptive(spun((light, heavy), 0.0, friction, ratio), 1.0, tension_tolerance=1e-5)
    assert run.columns["segment_tension"][-1] == pytest.approx([low, high], rel=1e-6)
    # Both start together with the rope's first stretch, of 1 µm, which takes some 10 ms.
    late = run.time > 0.5
    for name, expected in (("over", a), ("spin", spin)):
        fitted = np.polyfit(run.time[late], run.joint(name)[late], 2)
        assert 2 * fitted[0] == pytest.approx(expected, rel=1e-5)
    assert run.energy_remainder < 1e-8


def test_groove_grips_once_the_sheave_has_the_speed() -> None:
    """Equal weights at speed v and a sheave at rest end at one speed, (2 m + m_s) v/(2 m + m_s + M).

    Until then the groove brakes the rope and drives the sheave with σ (T₁ + T₂) = σ 2 m g.
    """
    mass, speed, friction = 200.0, 1.0, 0.05
    run = adaptive(spun((mass, mass), speed, friction), 8.0, tension_tolerance=1e-4)
    moving = 2 * mass + ON_SHEAVE
    end_speed = moving * speed / (moving + SPINNING)
    rates = [np.polyfit(run.time[-100:], run.joint(name)[-100:], 1)[0] for name in ("over", "spin")]
    assert rates == pytest.approx([end_speed, end_speed], rel=1e-5)
    lost = 0.5 * (moving * speed**2 - (moving + SPINNING) * end_speed**2)
    # The rope is just taut at the start: its first stretch under the weights takes energy too, of 1e-4.
    assert run.energy("friction")[-1] == pytest.approx(lost, rel=1e-3)
    slipped = run.joint("over") - run.joint("spin")
    # Gripped, not a nanometre more.
    assert np.ptp(slipped[-400:]) < 1e-9
    share = math.tanh(friction * math.pi / 2)
    # T₁ + T₂ = 2 m g, the weights' accelerations being opposite; both speeds change at constant rates.
    braking = share * 2 * mass * G * (1 / moving + 1 / SPINNING)
    assert slipped[-1] == pytest.approx(speed**2 / (2 * braking), rel=1e-3)
