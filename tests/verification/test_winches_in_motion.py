"""A load on a drum with layers, whose motor has a limited force and power, against equations of its own.

With s what the drum has paid out on the radius r₁ of its first layer, z how far the load is below its
start and L the unstretched length outside, all zero or L₀ at the start, and n the turns of a layer,

    T = w EA/L₀ (g + τ ġ)     g = w (ℓ − L)     w = √(L₀/L)     T ≥ 0     ε = (ℓ − L)/L
    m z̈ = m g − T             I s̈ = ρ (EA ε + D (1 + ε/2)/(1 + ε_d)) − F     L̇ = ρ ṡ/(1 + ε_d)

D = T − EA ε is what the damper adds: its rate ġ knows L by 1 + ε/2, so its force along the rim does. ε_d
is ε while the drum winds up, and what was laid on it before the start while it pays that out. ρ is the
pitch radius over r₁: it grows by δ/r₁ within half a turn about every n turns. F holds ṡ at the speed u of
the plan with at most min(F̂, P/|ṡ|), P only where ṡ is against T, and at most the brake's force once an
emergency stop is asked for: F = bound (ṡ − u)/√((ṡ − u)² + v₀²) here, which creeps by some v₀ where it
should hold. scipy's LSODA solves that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, drum, end, flow, rope, slider

MASS, INERTIA, FALL = 4000.0, 600.0, 6.0
WEIGHT = MASS * G
EA, TAU = 80 * WEIGHT, 0.02
#: Layers: radius and step [m], turns of a layer, turns at the start.
RADIUS, STEP, TURNS = 0.3, 0.05, 1.5
#: v₀ [m/s].
CREEP = 2e-6


@dataclass(frozen=True)
class Case:
    """A winch, asked for the `speed` [m/s], paying out positive, from `at` on within `lasts` [s]."""

    at: float
    lasts: float
    speed: float
    turns: float
    laid: float
    motor: dict[str, float]
    stop: tuple[float, float, float] | None = None  #: time [s], deceleration [m/s²], brake [N]

    def asked(self, time: float) -> float:
        """Speed [m/s]."""
        if self.stop is not None and time > self.stop[0]:
            at, slowing, _ = self.stop
            return math.copysign(max(0.0, abs(self.asked(at)) - slowing * (time - at)), self.speed)
        return self.speed * min(1.0, max(0.0, (time - self.at) / self.lasts))

    def bound(self, time: float, speed: float, hauls: bool) -> float:
        """What the motor or the brake can hold [N]."""
        if self.stop is not None and time > self.stop[0]:
            return self.stop[2]
        power = self.motor.get("power", math.inf) / max(abs(speed), 1e-9)
        return min(self.motor["capacity"], power) if hauls else self.motor["capacity"]

    def ratio(self, paid: float) -> float:
        """ρ where the drum has paid out so much on its first layer."""
        turns = self.turns - paid / (2 * math.pi * RADIUS)
        climbed = sum(min(1.0, max(0.0, (turns - layer * TURNS) / 0.5 + 0.5)) for layer in range(1, 9))
        return 1 + STEP / RADIUS * climbed

    def rates(self, time: float, state: Floats) -> Floats:
        """Of z, s, L, ż, ṡ."""
        z, s, length, sinks, pays = state
        ratio, strain = self.ratio(s), (FALL + z - length) / length
        wound = self.laid * WEIGHT / EA if pays > 0 else max(0.0, strain)
        fed, share = ratio * pays / (1 + wound), math.sqrt(FALL / length)
        rate = share * (sinks - (1 + strain / 2) * fed)
        tension = max(0.0, share * EA / FALL * (share * (FALL + z - length) + TAU * rate))
        rim = EA * strain + (tension - EA * strain) * (1 + strain / 2) / (1 + wound)
        slips = pays - self.asked(time)
        slips /= math.hypot(slips, CREEP)
        force = slips * self.bound(time, pays, slips > 0 > pays)
        return np.array([sinks, pays, fed, G - tension / MASS, (ratio * rim - force) / INERTIA])


CASES = {
    "hauls up with all its power": Case(
        0.1, 0.4, -1.2, 2.6, 1.0, {"capacity": 2.0 * WEIGHT, "power": 0.6 * WEIGHT}
    ),
    "hauls up with all its force": Case(0.0, 0.1, -1.5, 2.6, 0.5, {"capacity": 1.35 * WEIGHT}),
    "lowers and is stopped": Case(
        0.1, 0.3, 1.1, 5.2, 0.4, {"capacity": 3.0 * WEIGHT}, (1.0, 1000.0, 2.2 * WEIGHT)
    ),
    "is dragged by what its brake cannot hold": Case(
        0.1, 0.2, 0.5, 5.9, 1.2, {"capacity": 2.5 * WEIGHT}, (0.6, 5.0, 0.8 * WEIGHT)
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_a_drum_with_layers_at_its_limits(case: Case) -> None:
    """Ways of load and drum over 1.5 s; 2e-6 m/s of creep, more where the bound is near, leaves 5e-6 m."""
    duration = 1.5
    times = np.linspace(0, duration, 16)
    start = [0.0, 0.0, FALL / (1 + WEIGHT / EA), 0.0, 0.0]
    own = solve_ivp(
        case.rates, (0, duration), start, "LSODA", times, rtol=1e-9, atol=1e-11, max_step=1e-3
    ).y.T
    ramp = {"at": case.at, "duration": case.lasts, "velocity": case.speed}
    winch = drum(None, (0, 0, 0), "drum")
    winch["drum"]["laid_under"] = case.laid * WEIGHT
    winch["drum"]["layers"] = {"radius": RADIUS, "step": STEP, "turns": TURNS, "start": case.turns}
    rest: dict[str, Any] = {}
    if case.stop is not None:
        at, slowing, brake = case.stop
        how = {"drive": "winch", "stop": {"acceleration": slowing, "brake": brake}}
        rest["emergency_stop"] = {"at": {"type": "time", "time": at}, "drives": [how]}
        rest["plan"] = [{"name": "hold", "until": {"type": "end_of_run"}}]
    system = document(
        [
            body("load", slider((0, 0, -1)), MASS, position=(0, 0, -FALL)),
            flow("drum", INERTIA, drive="winch", **case.motor),
        ],
        ropes=[rope("fall", start[2], [winch, end("load")], EA, TAU)],
        drives=[{"name": "winch", "ramps": [ramp]}],
        **rest,
    )
    run = adaptive(system, duration, tension_tolerance=1.0, position_tolerance=1e-8, sample_interval=0.1)
    assert np.abs(run.joint("load") - own[:, 0]).max() < 1e-5
    assert np.abs(run.joint("drum") - own[:, 1]).max() < 1e-5
    assert case.ratio(own[-1, 1]) != case.ratio(0.0), "it must come to another layer"
    assert run.events("drum_slips"), "its motor must be too weak, or its brake slip"
    assert run.energy_remainder < 1e-9
