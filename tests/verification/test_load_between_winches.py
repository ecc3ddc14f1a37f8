"""A load that one winch hands over to another, held by a third of constant tension, against equations of
their own.

The load is a point between three ropes. With s what a drum has paid out, L the unstretched length outside and
ℓ the distance, ε = (ℓ − L)/L and w = √(L₀/L), as in `test_winches_in_motion.py` with one layer,

    T = w EA/L₀ max(0, w (ℓ − L) + τ w (ℓ̇ − (1 + ε/2) L̇))        L̇ = ṡ/(1 + ε_d)
    I s̈ = EA ε + (T − EA ε)(1 + ε/2)/(1 + ε_d) − F

ε_d is ε while a drum hauls in, and what was wound before the start while it pays out; none pays out here what
it has hauled in before. F holds ṡ at the speed u of the plan with at most F̂, and P/|ṡ| where it hauls:
F = bound (ṡ − u)/√((ṡ − u)² + v₀²), which creeps by some v₀ where it should hold. scipy's LSODA solves that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, drum, end, flow, point, rope

MASS, TAU, INERTIA = 4000.0, 0.02, 400.0
WEIGHT = MASS * G
START = np.array([-2.0, 0.5, -10.0])
#: v₀ [m/s].
CREEP = 2e-6


@dataclass(frozen=True)
class Winch:
    """Where it stands, T/EA at the start and as wound, EA [N], motor, and a ramp to a speed [m/s]."""

    at: Floats
    strain: float
    laid: float
    stiffness: float
    capacity: float
    power: float
    begins: float
    speed: float

    @property
    def length(self) -> float:
        """Unstretched at the start [m]."""
        return float(np.linalg.norm(START - self.at)) / (1 + self.strain)

    def asked(self, time: float) -> float:
        """Speed [m/s], after a ramp of 0.3 s."""
        return self.speed * min(1.0, max(0.0, (time - self.begins) / 0.3))


WINCHES = (
    Winch(np.array([-3.0, 0, 0]), 6e-3, 5e-3, 130 * WEIGHT, 3 * WEIGHT, math.inf, 0.1, 0.8),
    Winch(np.array([4.0, 0.5, 1]), 2e-3, 2e-3, 100 * WEIGHT, 1.5 * WEIGHT, 0.25 * WEIGHT, 0.0, -1.2),
    Winch(np.array([-6.0, -5, -8]), 1e-3, 2e-3, 50 * WEIGHT, 0.1 * WEIGHT, math.inf, 0.0, -0.05),
)


def pulls(winch: Winch, state: Floats, drummed: Floats) -> tuple[Floats, float, float]:
    """Pull on the load [N], what the rim feels [N], and L̇ [m/s]."""
    _, length, pays = drummed
    way = winch.at - state[:3]
    span = float(np.linalg.norm(way))
    strain, share = span / length - 1, math.sqrt(winch.length / length)
    wound = winch.laid if pays > 0 else max(0.0, strain)
    fed = pays / (1 + wound)
    rate = -float(way @ state[3:6]) / span - (1 + strain / 2) * fed
    tension = share**2 * winch.stiffness / winch.length * max(0.0, span - length + TAU * rate)
    elastic = winch.stiffness * max(0.0, strain)
    rim = elastic + (tension - elastic) * (1 + strain / 2) / (1 + wound)
    return tension * way / span, rim, fed


def rates(time: float, state: Floats) -> Floats:
    """Of place and velocity of the load, s, L, ṡ of each drum, and the work of all drives."""
    force, changes, work = np.array([0, 0, -WEIGHT]), [], 0.0
    for winch, drummed in zip(WINCHES, state[6:-1].reshape(-1, 3), strict=True):
        pull, rim, fed = pulls(winch, state, drummed)
        force = force + pull
        pays, slips = drummed[2], drummed[2] - winch.asked(time)
        bound = min(winch.capacity, winch.power / max(-pays, 1e-9)) if slips > 0 else winch.capacity
        holds = bound * slips / math.hypot(slips, CREEP)
        changes += [pays, fed, (rim - holds) / INERTIA]
        work -= holds * winch.asked(time)
    return np.concatenate([state[3:6], force / MASS, changes, [work]])


def test_a_load_that_is_handed_over() -> None:
    """Way of the load, of all drums, their tensions, and what the drives do, over 1.5 s."""
    duration, speed = 1.5, [0.0, 0.2, 0.0]
    times = np.linspace(0, duration, 1501)
    start = np.concatenate([START, speed, *([0.0, winch.length, 0.0] for winch in WINCHES), [0.0]])
    own = solve_ivp(rates, (0, duration), start, "LSODA", times, rtol=1e-9, atol=1e-11, max_step=1e-3).y.T
    bodies, ropes, drives = [body("load", point(START, speed), MASS)], [], []
    for k, winch in enumerate(WINCHES):
        motor = {"capacity": winch.capacity} | ({"power": winch.power} if winch.power < math.inf else {})
        bodies.append(flow(f"drum{k}", INERTIA, drive=f"winch{k}", **motor))
        winds = drum(None, winch.at.tolist(), f"drum{k}")
        winds["drum"]["laid_under"] = winch.laid * winch.stiffness
        ropes.append(rope(f"rope{k}", winch.length, [winds, end("load")], winch.stiffness, TAU))
        ramps = [{"at": winch.begins, "duration": 0.3, "velocity": winch.speed}]
        drives.append({"name": f"winch{k}", "ramps": ramps})
    run = adaptive(
        document(bodies, ropes=ropes, drives=drives),
        duration,
        tension_tolerance=1.0,
        position_tolerance=1e-8,
        sample_interval=0.1,
    )
    seen = own[::100]
    # 2e-6 m/s of creep, more where the bound is near.
    assert np.abs(run.body("load") - seen[:, :3]).max() < 1e-5
    for k, winch in enumerate(WINCHES):
        found = run.joint(f"drum{k}")
        assert np.abs(found - seen[:, 6 + 3 * k]).max() < 1e-5
        turns = np.diff(own[:, 6 + 3 * k])
        assert not (turns[np.argmax(turns < -1e-5) :] > 1e-5).any() or not (turns < -1e-5).any()
        pulled = [np.linalg.norm(pulls(winch, y, y[6 + 3 * k : 9 + 3 * k])[0]) for y in seen]
        # 1e-5 m of rope of up to 130 m g over some 10 m.
        assert run.tension(f"rope{k}") == pytest.approx(np.array(pulled), abs=1e-5 * winch.stiffness / 8)
    assert {name for _, name in run.events("drum_slips")} >= {"drum1", "drum2"}
    assert run.energy("drive_work")[-1] == pytest.approx(own[-1, -1], rel=1e-4)
    assert run.energy_remainder < 1e-8
