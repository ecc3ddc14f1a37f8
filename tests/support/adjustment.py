"""The sequence of Fig. 6 of Ham, Roh and Lee (2016): three moving sheaves whose slings take force in turn.

Three equal sheaves of weight w hang in one equalizing rope of tension T that does not stretch, guided
with a viscous damping c; xᵢ is the travel of sheave i, down positive, so Σ xᵢ = 0. Sling i, a spring k,
pulls sheave i down by fᵢ and is held by a lug that is pulled down by yᵢ and lies gᵢ lower than the sling
reaches at the start. Quasi-static means without inertia:

    c ẋᵢ = fᵢ + w − 2T,  Σ xᵢ = 0   ⇒   2T − w = f̄ := (f₀ + f₁ + f₂)/3,   c ẋᵢ = fᵢ − f̄
    fᵢ = k (yᵢ − xᵢ − gᵢ) while that is positive

So a sheave goes down where its sling pulls more than the mean, and up where it pulls less. With n taut
slings, s the mean of their forces and dᵢ = fᵢ − s, and lugs that move at constant speeds uᵢ (ū their mean
over the taut):

    ṡ = k ū − (1 − n/3) (k/c) s          ḋᵢ = k (uᵢ − ū) − (k/c) dᵢ

that is exponentials of the rates (1 − n/3) k/c, zero for three taut slings, and k/c. Slack sheaves go up
alike, by what the others go down. A sling goes taut where yᵢ − xᵢ = gᵢ. The end: all fᵢ = k/3 Σ (yⱼ − gⱼ),
and each sheave has travelled by its own yᵢ − gᵢ less the mean of the three.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from mechanics import Floats, Json, body, document, end, half_turn, rope, slider

#: Stiffness of a sling [N/m], damping of a guide [N s/m], mass of a sheave [kg]: c/k = 2 s, m/c = 5 µs.
STIFFNESS, DAMPING, MASS = 1e5, 2e5, 1.0
#: How far each lug lies below the reach of its sling at the start [m]; sling p1 is just taut.
GAP = (0.10, 0.0, 0.24)
#: Pulls: lug, from and to [s], speed [m/s]. First p1, then p0 and harder.
PULLS = ((1, 1.0, 3.0, 0.10), (0, 6.0, 7.5, 0.30))
DURATION = 24.0
#: Time in which a lug reaches its speed [s]; it then is where one would be that starts at once in the middle
#: of it, and meanwhile at most k u/8 times this away: 0.04 N.
RAMP = 1e-5

_RADIUS, _LENGTH = 0.2, 10.0


def system() -> Json:
    """The same with bodies: sheaves as damped sliders, lugs that are driven, one equalizing rope."""
    bodies, ropes, drives = [], [], []
    route = [end(None, (-_RADIUS, 0, 0))]
    for i in range(3):
        x = 4 * _RADIUS * i
        bodies.append(body(f"p{i}", slider((0, 0, -1), damping=DAMPING), MASS, position=(x, 0, -5)))
        lug = slider((0, 0, -1), drive=f"pull{i}")
        bodies.append(body(f"lug{i}", lug, 1.0, position=(x, 0, -5 - _LENGTH)))
        pulls = [pull for pull in PULLS if pull[0] == i]
        ramps = [
            {"at": at - RAMP / 2, "duration": RAMP, "velocity": velocity}
            for _, start, stop, speed in pulls
            for at, velocity in ((start, speed), (stop, 0.0))
        ]
        drives.append({"name": f"pull{i}", "ramps": ramps})
        length = _LENGTH + GAP[i]
        ropes.append(rope(f"f{i}", length, [end(f"p{i}"), end(f"lug{i}")], STIFFNESS * length))
        route.append(half_turn(f"p{i}", (0, 0, 0), _RADIUS, False))
        if i < 2:
            route.append(half_turn(None, (x + 2 * _RADIUS, 0, 0), _RADIUS, True))
    route.append(end(None, (8 * _RADIUS + _RADIUS, 0, 0)))
    return document(bodies, ropes=[rope("equalizing", None, route, 1e12, 1e-3), *ropes], drives=drives)


@dataclass(frozen=True)
class Course:
    """The closed form.

    Attributes:
        time: (time,) [s].
        force: fᵢ (time, 3) [N].
        travel: xᵢ (time, 3) [m].
        taut: when each sling went taut (3,) [s].
    """

    time: Floats
    force: Floats
    travel: Floats
    taut: tuple[float, ...]


@dataclass(frozen=True)
class _Phase:
    """From `start` on, with the same taut slings and constant speeds of the lugs."""

    start: float
    force: Floats
    travel: Floats
    lug: Floats
    speed: Floats
    taut: tuple[int, ...]

    def at(self, time: float) -> tuple[Floats, Floats, Floats]:
        """Forces, travels and ways of the lugs at `time`."""
        t, rate = time - self.start, STIFFNESS / DAMPING
        lug = self.lug + self.speed * t
        taut, n = list(self.taut), len(self.taut)
        force, travel = np.zeros(3), np.zeros(3)
        if n:
            mean, speed = self.force[taut].mean(), self.speed[taut].mean()
            slow = (1 - n / 3) * rate
            grown = t if n == 3 else -math.expm1(-slow * t) / slow
            s = mean + (STIFFNESS * speed - slow * mean) * grown
            eased = -math.expm1(-rate * t) / rate
            d = self.force[taut] - mean
            force[taut] = s + d + (STIFFNESS * (self.speed[taut] - speed) - rate * d) * eased
            travel[taut] = lug[taut] - np.array(GAP)[taut] - force[taut] / STIFFNESS
        loose = [i for i in range(3) if i not in taut]
        if loose:
            moved = travel[taut].sum() - self.travel[taut].sum()
            travel[loose] = self.travel[loose] - moved / len(loose)
        return force, travel, lug


def course(time: Floats) -> Course:
    """The closed form at every time of `time`, ascending from 0 [s]."""
    breaks = sorted(moment for _, start, stop, _ in PULLS for moment in (start, stop))
    phase = _Phase(0.0, np.zeros(3), np.zeros(3), np.zeros(3), _speeds(0.0), ())
    phases, went_taut = [phase], [math.inf] * 3
    while True:
        stop = next((moment for moment in breaks if moment > phase.start), DURATION)
        found = min((_reach(phase, i, stop), i) for i in range(3))
        at = min(found[0], stop)
        if at >= DURATION:
            break
        taut = phase.taut
        if found[0] <= stop:
            taut, went_taut[found[1]] = (*taut, found[1]), found[0]
        phase = _Phase(at, *phase.at(at), _speeds(at), taut)
        phases.append(phase)
    starts = [phase.start for phase in phases]
    own = [phases[int(np.searchsorted(starts, moment, side="right")) - 1].at(moment) for moment in time]
    force, travel = (np.array([one[k] for one in own]) for k in (0, 1))
    return Course(time, force, travel, tuple(went_taut))


def _speeds(time: float) -> Floats:
    speeds = np.zeros(3)
    for lug, start, stop, speed in PULLS:
        speeds[lug] += speed if start <= time < stop else 0.0
    return speeds


def _reach(phase: _Phase, sling: int, stop: float) -> float:
    """When a slack sling goes taut, by halving down to the last bit; infinity if not before `stop`."""

    def missing(time: float) -> float:
        _, travel, lug = phase.at(time)
        return float(lug[sling] - travel[sling] - GAP[sling])

    if sling in phase.taut or missing(stop) <= 0.0:
        return math.inf
    low, high = phase.start, stop
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if missing(middle) <= 0.0 else (low, middle)
    return high
