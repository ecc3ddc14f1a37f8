"""Tuggers that cannot follow: lines of constant pull that go slack under a swinging weight, and snatch it.

The motor asks for hauling at u(t) and pulls no more than P. Where it holds, ṡ = u, as long as the line needs
no more than P; where it slips, m s̈ = T − P, until ṡ comes down to u. What winds up is stretched as the line
is, L̇ = ṡ/(1 + max(ε, 0)), (WI2), also while it is slack; what comes off is what went on last, and below that
rope that was wound under P: L is then a function of s. The damper pulls as in (F3) and (F4). scipy's LSODA
goes from one of these events to the next: slack, taut, slips, holds, and turns round.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, Json, adaptive, body, document, drum, end, flow, point, rope

MASS, TUGGER = 2000.0, 20.0
HUNG_EA, HUNG_TAU = 5e6, 0.01
START, VELOCITY, HELD = np.array([3.0, -9.5]), np.array([2.0, 0.0]), np.array([15.0, -10.0])
HUNG = math.hypot(*START) * 0.9995
CHORD = float(np.linalg.norm(HELD - START))
DURATION, STARTS_IN = 20.0, 1.0


def ends(passes: Callable[[float, Floats], float], falls: bool) -> Callable[[float, Floats], float]:
    """An event of scipy's that ends a part where `passes` falls through zero, or rises through it."""
    passes.terminal, passes.direction = True, -1.0 if falls else 1.0  # type: ignore[attr-defined]
    return passes


class Own:
    """Weight and tugger by their own equations: place, velocity, s, ṡ, and the line's unstretched length."""

    def __init__(self, pull: float, speed: float, stiffness: float, damping_time: float) -> None:
        self.pull, self.speed, self.stiffness, self.damping_time = pull, speed, stiffness, damping_time
        self.natural = CHORD / (1.0 + pull / stiffness)
        self.laid = pull / stiffness
        #: Where the drum stood while it wound up, rising, and what L was there.
        self.wound: tuple[Floats, Floats] = (np.array([0.0]), np.array([self.natural]))
        self.holds = False

    def asked(self, time: float) -> float:
        return -self.speed * min(1.0, time / STARTS_IN)

    def strain_of_wound(self, turned: float) -> float:
        places, lengths = self.wound
        after = int(np.searchsorted(places, turned))
        if after >= len(places) or after == 0:
            return self.laid
        over, let_go = places[after] - places[after - 1], lengths[after] - lengths[after - 1]
        return float(over / let_go) - 1.0

    def line(self, time: float, y: Floats) -> tuple[float, float, float, Floats]:
        """Force of the row as if it could push, what turns the tugger, rate of L, and the way of the pull."""
        way = HELD - y[:2]
        length = float(np.linalg.norm(way))
        way = way / length
        turns = self.asked(time) if self.holds else float(y[5])
        strain, share = length / y[6] - 1.0, math.sqrt(self.natural / y[6])
        passing = self.strain_of_wound(float(y[4])) if turns > 0.0 else max(0.0, strain)
        supply = turns / (1.0 + passing)
        rate = -float(way @ y[2:4]) - supply * (1.0 + strain / 2.0)
        spring = self.stiffness * strain
        damper = share * share * self.stiffness * self.damping_time / self.natural * rate
        force = spring + damper
        at_rim = 0.0
        if force > 0.0:
            elastic = max(0.0, spring)
            at_rim = elastic + (force - elastic) * (1.0 + strain / 2.0) / (1.0 + passing)
        return force, at_rim, supply, way

    def rates(self, time: float, y: Floats) -> Floats:
        force, at_rim, supply, way = self.line(time, y)
        far = float(np.linalg.norm(y[:2]))
        hung = HUNG_EA / HUNG * (far - HUNG + HUNG_TAU * float(y[:2] @ y[2:4]) / far)
        acceleration = (max(0.0, force) * way - max(0.0, hung) * y[:2] / far) / MASS - (0.0, G)
        turns = self.asked(time) if self.holds else y[5]
        ramps = -self.speed / STARTS_IN if time < STARTS_IN else 0.0
        spins = ramps if self.holds else (at_rim - self.pull) / TUGGER
        return np.array([*y[2:4], *acceleration, turns, spins, supply])

    def solve(self, times: Floats) -> tuple[Floats, list[tuple[float, str]]]:
        """Place and s at these times, and when the line went slack and taut."""
        time, y = 0.0, np.array([*START, *VELOCITY, 0.0, 0.0, self.natural])
        self.holds = self.line(time, y)[1] < self.pull
        found, told = np.zeros((len(times), 3)), []
        while time < DURATION - 1e-9:
            is_taut = self.line(time, y)[0] > 0.0
            events = [ends(lambda t, y: self.line(t, y)[0], is_taut)]
            if self.holds:
                events.append(ends(lambda t, y: self.pull - self.line(t, y)[1], True))
            else:
                events.append(ends(lambda t, y: y[5] - self.asked(t), True))
                events.append(ends(lambda t, y: y[5], y[5] > 0.0))
            until = STARTS_IN if time < STARTS_IN else DURATION
            part = solve_ivp(
                self.rates, (time, until), y, "LSODA", rtol=1e-8, atol=1e-9, max_step=0.02,
                events=events, dense_output=True,
            )  # fmt: skip
            covered = (times >= time) & (times <= part.t[-1] + 1e-9)
            if covered.any():
                found[covered] = part.sol(times[covered])[[0, 1, 4]].T
            self.remember(part)
            time, y = float(part.t[-1]), part.y[:, -1]
            happened = [bool(len(at)) for at in part.t_events] + [False]
            if happened[0]:
                told.append((time, "slack" if is_taut else "taut"))
            if happened[1]:
                self.holds = not self.holds
            y[5] = self.asked(time) if self.holds else y[5]
            if part.status == 1:  # Beyond the event, by next to nothing.
                y, time = y + 1e-10 * self.rates(time, y), time + 1e-10
        return found, told

    def remember(self, part: object) -> None:
        """What was wound up in this part lies above what was there where it began."""
        grid = np.linspace(part.t[0], part.t[-1], 2000)  # type: ignore[attr-defined]
        turned, _, lengths = part.sol(grid)[4:7]  # type: ignore[attr-defined]
        if turned[-1] < turned[0] - 1e-12:
            places, before = self.wound
            below = places > turned[0]
            self.wound = (
                np.concatenate([turned[::-1], places[below]]),
                np.concatenate([lengths[::-1], before[below]]),
            )


def system(pull: float, speed: float, stiffness: float, damping_time: float) -> Json:
    tugger = drum(None, (HELD[0], 0.0, HELD[1]), "tugger")
    tugger["drum"]["laid_under"] = pull
    weight = point((START[0], 0.0, START[1]), velocity=(VELOCITY[0], 0.0, VELOCITY[1]))
    length = CHORD / (1.0 + pull / stiffness)
    return document(
        [body("weight", weight, MASS), flow("tugger", TUGGER, drive="drive", capacity=pull)],
        ropes=[
            rope("hung", HUNG, [end(None), end("weight")], HUNG_EA, HUNG_TAU),
            {
                **rope("line", length, [end("weight"), tugger], stiffness, damping_time),
                "is_stretched": True,
            },
        ],
        drives=[{"name": "drive", "ramps": [{"at": 0.0, "duration": STARTS_IN, "velocity": -speed}]}],
    )


@pytest.mark.parametrize(
    ("pull", "speed", "stiffness", "damping_time", "times_taut"),
    [(3e3, 0.1, 150e3, 0.2, 3), (3e3, 0.1, 150e3, 0.0, 4), (8e3, 0.3, 2e6, 0.01, 1)],
)
def test_weight_and_tugger_through_slack_and_snatch(
    pull: float, speed: float, stiffness: float, damping_time: float, times_taut: int
) -> None:
    """Place of the weight and what the tugger has paid out to 5 µm; when it goes slack and taut to 10 µs."""
    run = adaptive(
        system(pull, speed, stiffness, damping_time),
        DURATION,
        tension_tolerance=1e-3,
        position_tolerance=1e-8,
        sample_interval=0.05,
    )
    own, told = Own(pull, speed, stiffness, damping_time).solve(run.time)
    assert np.abs(run.body("weight")[:, [0, 2]] - own[:, :2]).max() < 5e-6
    assert np.abs(run.joint("tugger") - own[:, 2]).max() < 5e-6
    for kind in ("slack", "taut"):
        mine = [time for time, what in told if what == kind]
        found = [time for time, name in run.events(kind) if name == "line" and time > 0.0]
        assert found == pytest.approx(mine, abs=1e-5)
    assert len(run.events("taut")) >= times_taut
    assert run.energy_remainder < 1e-7
