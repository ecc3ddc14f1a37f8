"""Damping of vessels by shares of what is critical for their natural motions.

Upright at its draft a vessel has, about the centre of gravity of all that is on it, a stiffness K by the
water and an inertia M with the added one. Its natural motions φ with K φ = ω² M φ and φᵀ M φ = 1 are damped
by themselves, each with the share ζ of what is critical for it, if

    C = Σ 2 ζ ω (M φ)(M φ)ᵀ

A motion that is part heave and part pitch has of each share as much as of its energy is in each. Surge, sway
and yaw, e, that only moorings restore, have the period T that the lift file says: φ = e/√(eᵀ M e), ω = 2π/T.
They are orthogonal to the others over M, and so change nothing about them. Where water remembers, M has for
each motion the added mass of its own frequency. See docs/concepts/vessels.md.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from gantline.assembly.afloat.by_itself import about_point, mass_aboard, pumped_content, stiffness_by_water
from gantline.assembly.afloat.radiation import memory_of
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.afloat.vessel import CriticalDamping
from gantline.scenario.afloat.water import MOTIONS

__all__ = ["add_critical_damping"]

#: Squares of frequencies below this share of the largest belong to motions that nothing restores.
_NEUTRAL = 1e-9
#: Rounds in which a natural motion finds its own frequency, and the share to which it does.
_ROUNDS = 50
_SAME = 1e-10


def add_critical_damping(parts: Parts, scenario: Scenario) -> None:
    """Add the damping of vessels that is given as shares; all that is on them is there, with its mass.

    Raises:
        ScenarioError: if nothing restores a motion for which a share is given.
    """
    for name, vessel in (scenario.vessels or {}).items():
        if vessel.water_damping is None or vessel.water_damping.critical is None:
            continue
        given = vessel.water_damping.critical
        mass, centre, own = mass_aboard(parts, name, pumped_content(scenario, name, vessel))
        inertia = np.zeros((6, 6))
        inertia[:3, :3], inertia[3:, 3:] = mass * np.eye(3), own
        for force in parts.forces:
            if force["type"] == "added_mass" and force["body"] == name:
                inertia += about_point(force, centre)
        stiffness, heights = stiffness_by_water(scenario, name, vessel, centre)
        for motion, height in heights.items():
            if getattr(given, motion) and height <= 0.0:
                sentence = f"nothing restores {motion} upright at this draft: GM is {height:.3g} m"
                path = ("vessels", name, "water_damping", "critical", motion)
                raise scenario.error(path, f"{sentence}; give '{motion}' itself, such as '100 MN m s'")
        damping = _damping(given, stiffness, _inertia_at(scenario, name, inertia, centre)).tolist()
        named = {"type": "drag", "name": f"{name}.critical_damping", "body": name, "at": centre.tolist()}
        parts.forces.append({**named, "damping": damping, "quadratic": [0.0] * 6})


def _inertia_at(
    scenario: Scenario, name: str, inertia: Array, centre: Array
) -> Callable[[float | None], Array]:
    """Inertia (6, 6) by frequency [rad/s] from that of infinite frequency, which None stands for."""
    vessel = (scenario.vessels or {})[name]
    memory = memory_of(scenario, name, vessel)

    def at(frequency: float | None) -> Array:
        if frequency is None or memory is None or vessel.radiation is None:
            return inertia
        added = memory.added_mass(np.array([frequency]))[0] - memory.infinite_added_mass
        return inertia + about_point({"at": list(vessel.radiation.at), "matrix": added.tolist()}, centre)

    return at


def _natural(
    stiffness: Array, inertia_at: Callable[[float | None], Array], place: int
) -> tuple[float, Array, Array] | None:
    """ω², φ and M at its own frequency of the natural motion `place`; None where nothing restores it."""
    frequency: float | None = None
    for _ in range(_ROUNDS):
        inertia = inertia_at(frequency)
        half = np.linalg.inv(np.linalg.cholesky(inertia))
        squares, scaled = np.linalg.eigh(half @ stiffness @ half.T)
        square = float(squares[place])
        if square <= _NEUTRAL * squares.max():
            return None
        last, frequency = frequency, math.sqrt(square)
        if last is not None and abs(frequency - last) <= _SAME * frequency:
            break
    return square, (half.T @ scaled)[:, place], inertia


def _damping(given: CriticalDamping, stiffness: Array, inertia_at: Callable[[float | None], Array]) -> Array:
    """C (6, 6) for shares of critical damping, stiffness (6, 6) and inertia by frequency."""
    shares = np.array([getattr(given, motion) or 0.0 for motion in MOTIONS])
    damping = np.zeros((6, 6))
    for place in range(6):
        natural = _natural(stiffness, inertia_at, place)
        if natural is None:
            continue
        square, shape, inertia = natural
        energies = np.diag(stiffness) * shape**2
        share = float(shares @ energies / energies.sum())
        damping += 2 * share * math.sqrt(square) * np.outer(inertia @ shape, inertia @ shape)
    for place, motion in enumerate(MOTIONS):
        period = getattr(given.periods, motion, None)
        if period is not None:
            column = inertia_at(2 * math.pi / period)[:, place]
            damping += shares[place] * (4 * math.pi / period) * np.outer(column, column) / column[place]
    return damping
