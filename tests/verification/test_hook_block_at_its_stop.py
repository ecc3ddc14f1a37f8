"""A hook block in four parts of line that is hauled against its stop by a motor of limited force and power.

Against equations of their own: with the drum's turning s, paying out positive, the unstretched length L of
the rope and the height z of the hook block

    L' = s'/(1 + ε_d)        T = max(0, EA/L (e + τ ė))        e = ℓ₀ − 4 z − L
    m z'' = 4 T − m g − N        N = max(0, k (z − z₁ + τ₁ z'))        I s'' = T − F

ε_d is ε where rope winds up and that of the rope wound last where it comes off, F what holds s' at the
speed asked for, or while that takes more than min(F̂, P/|s'|) just this. A Runge–Kutta scheme of fixed
steps solves it; rope on the drum is a heap of pieces.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from mechanics import Floats, G, adaptive, body, document, drum, end, flow, half_turn, rope, slider

MASS, PARTS, INERTIA, EA, TAU = 6000.0, 4, 900.0, 3e7, 0.01
DEPTH, LEAD, RADIUS = 12.0, 20.0, 0.3
#: Where the stop begins above the start [m], its stiffness [N/m] and damping time [s].
ROOM, STOP, STOP_TAU = 0.3, 5e7, 0.004
PULL = MASS * G / PARTS
CAPACITY = 1.6 * PULL
POWER = 0.9 * CAPACITY
#: The speeds asked for [m/s], and their ramps from and to [s].
RAMPS = ((0.2, 0.5, -1.2), (3.0, 3.2, 0.0), (3.6, 3.9, 0.8))
DURATION, STEP = 4.4, 1e-4
ROUTE = PARTS * DEPTH + LEAD + PARTS * math.pi * RADIUS


def asked(time: float) -> tuple[float, float]:
    """Speed [m/s] and acceleration [m/s²] of the drive."""
    speed = 0.0
    for begin, stop, to in RAMPS:
        if time < begin:
            break
        if time < stop:
            rate = (to - speed) / (stop - begin)
            return speed + rate * (time - begin), rate
        speed = to
    return speed, 0.0


def bound(speed: float) -> float:
    """What the motor has at most [N] at a speed of the drum, positive paying out."""
    return min(CAPACITY, POWER / -speed) if -speed * CAPACITY > POWER else CAPACITY


@dataclass
class Winch:
    """State: z, z', s, L, s'; rope on the drum as pieces of unstretched length and strain; sign of F."""

    state: Floats = field(default_factory=lambda: np.array([0, 0, 0, ROUTE / (1 + PULL / EA), 0.0]))
    pieces: list[list[float]] = field(default_factory=lambda: [[math.inf, PULL / EA]])
    slips: float = 0.0

    def rates(self, time: float, state: Floats) -> tuple[Floats, float]:
        """Of the state, and the tension [N]; `slips` is the sign of F while it is at its bound, else 0."""
        height, rising, _, length, turning = state
        speed, acceleration = asked(time)
        speed = turning if self.slips else speed
        way = ROUTE - PARTS * height
        strain = way / length - 1.0 if speed < 0.0 else self.pieces[-1][1]
        supply = speed / (1.0 + strain)
        tension = max(0.0, EA / length * (way - length + TAU * (-PARTS * rising - supply)))
        stop = max(0.0, STOP * (height - ROOM + STOP_TAU * rising))
        if self.slips:
            acceleration = (tension - self.slips * bound(speed)) / INERTIA
        lifting = (PARTS * tension - stop) / MASS - G
        return np.array([rising, lifting, speed, supply, acceleration]), tension

    def step(self, time: float) -> None:
        """One step of Runge and Kutta's; ramps begin and end with steps."""
        early, late = time + 1e-9, time + STEP - 1e-9
        before, h = self.state, STEP
        k1 = self.rates(early, before)[0]
        k2 = self.rates(time + h / 2, before + h / 2 * k1)[0]
        k3 = self.rates(time + h / 2, before + h / 2 * k2)[0]
        k4, tension = self.rates(late, before + h * k3)
        self.state = before + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        self.wind(self.state[3] - before[3])
        speed, acceleration = asked(time + h + 1e-9)
        lag = self.state[4] - speed
        if not self.slips:
            self.state[4] = speed
            needed = tension - INERTIA * acceleration
            if abs(needed) > bound(speed):
                self.slips = math.copysign(1.0, needed)
        elif lag * (before[4] - asked(early)[0]) < 0.0:
            self.slips, self.state[4] = 0.0, speed

    def wind(self, paid_out: float) -> None:
        """Lays rope on the drum as it is, or takes it off again."""
        if paid_out < 0.0:
            self.pieces.append([-paid_out, (ROUTE - PARTS * self.state[0]) / self.state[3] - 1.0])
            return
        while paid_out > 0.0:
            taken = min(paid_out, self.pieces[-1][0])
            paid_out -= taken
            self.pieces[-1][0] -= taken
            if self.pieces[-1][0] == 0.0:
                self.pieces.pop()


def test_a_hook_block_is_hauled_against_its_stop() -> None:
    """It stalls at 4 F̂ = m g + N, stays so while the motor is asked to haul, and is let down again."""
    every = round(0.04 / STEP)
    winch, own, sides = Winch(), [], []
    for count in range(round(DURATION / STEP)):
        if count % every == 0:
            own.append([*winch.state[:4], winch.rates(count * STEP + 1e-9, winch.state)[1]])
        slipped = bool(winch.slips)
        winch.step(count * STEP)
        if slipped != bool(winch.slips):
            sides.append(((count + 1) * STEP, winch.slips))
    course = np.array(own)
    route = [end(None, (0, 0, 0))]
    for number in range(PARTS):
        over = number % 2 == 1
        centre = (RADIUS * (1 + 2 * number), 0.0, 0.0)
        route.append(half_turn(None if over else "hook_block", centre, RADIUS, over))
    route.append(drum(None, (2 * PARTS * RADIUS, 0, -LEAD), "drum"))
    stops = {"upper": ROOM, "stiffness": STOP, "damping_time": STOP_TAU}
    bodies = [
        body("hook_block", slider(stops=stops), MASS, position=(0, 0, -DEPTH)),
        flow("drum", INERTIA, drive="winch", capacity=CAPACITY, power=POWER),
    ]
    ramps = [{"at": begin, "duration": stop - begin, "velocity": to} for begin, stop, to in RAMPS]
    system = document(
        bodies,
        ropes=[rope("fall", ROUTE / (1 + PULL / EA), route, EA, TAU)],
        drives=[{"name": "winch", "ramps": ramps}],
    )
    run = adaptive(system, DURATION, tension_tolerance=0.1, position_tolerance=1e-7, sample_interval=0.04)
    count = len(course)
    # The other solution finds where the drum begins and ends to slip to a step of 0.1 ms.
    assert np.abs(run.joint("hook_block")[:count] - course[:, 0]).max() < 3e-5
    assert np.abs(run.joint("drum")[:count] - course[:, 2]).max() < 3e-5
    assert np.abs(run.tension("fall")[:count] - course[:, 4]).max() < 40.0
    events = sorted(
        [(t, 1.0) for t, _ in run.events("drum_slips")] + [(t, 0.0) for t, _ in run.events("drum_holds")]
    )
    assert [kind for _, kind in events] == [kind for _, kind in sides] == [1.0, 0.0, 1.0, 0.0]
    at = zip(events, sides, strict=True)
    assert max(abs(time - other) for (time, _), (other, _) in at) < 2 * STEP
    # Stalled: the rope still swings against the drum, by some per cent, when the motor is let off.
    stalled = (run.time > 2.8) & (run.time < 3.0)
    assert abs(run.tension("fall")[stalled].mean() / CAPACITY - 1.0) < 0.05
    assert run.energy_remainder < 1e-7
