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
from collections.abc import Callable, Sequence

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.radiation import memory_of
from gantline.assembly.spatial import Array, inertia_matrix
from gantline.assembly.vessels import upright_hydrostatics
from gantline.assembly.water import frozen
from gantline.cad.mass_properties import point_inertia
from gantline.hydro import Hydrostatics, Tank, free_surface_correction
from gantline.scenario import Scenario
from gantline.scenario.tanks import pumped_tanks
from gantline.scenario.vessel import CriticalDamping, Vessel
from gantline.scenario.water import MOTIONS, BallastTank

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
        mass, centre, own = _aboard(parts, name, _pumped(scenario, name, vessel))
        inertia = np.zeros((6, 6))
        inertia[:3, :3], inertia[3:, 3:] = mass * np.eye(3), own
        for force in parts.forces:
            if force["type"] == "added_mass" and force["body"] == name:
                inertia += _about(force, centre)
        stiffness, heights = _stiffness(scenario, name, vessel, centre)
        for motion, height in heights.items():
            if getattr(given, motion) and height <= 0.0:
                sentence = f"nothing restores {motion} upright at this draft: GM is {height:.3g} m"
                path = ("vessels", name, "water_damping", "critical", motion)
                raise scenario.error(path, f"{sentence}; give '{motion}' itself, such as '100 MN m s'")
        damping = _damping(given, stiffness, _inertia_at(scenario, name, inertia, centre)).tolist()
        named = {"type": "drag", "name": f"{name}.critical_damping", "body": name, "at": centre.tolist()}
        parts.forces.append({**named, "damping": damping, "quadratic": [0.0] * 6})


def _aboard(parts: Parts, vessel: str, pumped: Sequence[BallastTank]) -> tuple[float, Array, Array]:
    """Mass [kg], centre of gravity (3,) [m], inertia about it (3, 3) [kg m^2] of a vessel and all on it."""
    position, turn = parts.pose(vessel)
    masses, centres, inertias = [], [], []
    for name, body in parts.bodies.items():
        above: str | None = name
        while above not in (None, vessel):
            above = parts.bodies[above]["parent"]
        if above is None or body["mass"] == 0.0:
            continue
        place, orientation = parts.pose(name)
        own = turn.T @ orientation
        masses.append(float(body["mass"]))
        centres.append(turn.T @ (place - position) + own @ np.array(body["centre_of_gravity"]))
        inertias.append(own @ inertia_matrix(body["inertia"]) @ own.T)
    for tank in pumped:
        at, own = frozen(tank)
        masses.append(tank.content)
        centres.append(np.array(at))
        inertias.append(own)
    total = math.fsum(masses)
    centre = np.average(centres, axis=0, weights=masses)
    inertia = sum(
        (
            own + point_inertia(mass, at - centre)
            for own, mass, at in zip(inertias, masses, centres, strict=True)
        ),
        start=np.zeros((3, 3)),
    )
    return total, centre, inertia


def _pumped(scenario: Scenario, name: str, vessel: Vessel) -> list[BallastTank]:
    """Tanks whose liquid is no body's mass, with some in them."""
    pumped = pumped_tanks(scenario)
    tanks = (vessel.tanks or {}).items()
    return [tank for one, tank in tanks if f"{name}.{one}" in pumped and tank.content > 0.0]


def _about(added: Json, centre: Array) -> Array:
    """An added mass (6, 6) about another point: the velocity of its own is v - r × ω, r from there to it."""
    x, y, z = np.array(added["at"]) - centre
    moved = np.eye(6)
    moved[:3, 3:] = -np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    about: Array = moved.T @ np.array(added["matrix"]) @ moved
    return about


def _stiffness(
    scenario: Scenario, name: str, vessel: Vessel, centre: Array
) -> tuple[Array, dict[str, float]]:
    """Stiffness by the water about a point (6, 6) [N/m, N, N m]; GM of roll and pitch [m]."""
    found, heights = _hydrostatics(scenario, name, vessel, centre)
    per_metre = found.per_metre * scenario.simulation.gravity
    weight = found.mass * scenario.simulation.gravity
    ahead, aside = found.centre_of_flotation[:2] - centre[:2]
    rises = np.array([0.0, 0.0, 1.0, aside, -ahead, 0.0])  # of the waterplane's middle, by each motion
    stiffness: Array = per_metre * np.outer(rises, rises) + weight * np.diag([0, 0, 0, *heights, 0])
    return stiffness, {"roll": heights[0], "pitch": heights[1]}


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
        return inertia + _about({"at": list(vessel.radiation.at), "matrix": added.tolist()}, centre)

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


def _hydrostatics(
    scenario: Scenario, name: str, vessel: Vessel, centre: Array
) -> tuple[Hydrostatics, tuple[float, float]]:
    """Hydrostatics upright at the draft of the start; GM for heel and trim less free surfaces [m]."""
    found = upright_hydrostatics(scenario, name, vessel)
    slack = [
        Tank(tank.box[0], tank.box[1], tank.density)
        for tank in (vessel.tanks or {}).values()
        if tank.is_slack
    ]
    return found, found.gm(centre, free_surface_correction(slack, found.mass))
