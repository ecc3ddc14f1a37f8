"""Damping of vessels by shares of what is critical for each motion, from hydrostatics and inertia.

Upright at its draft a vessel displaces the mass Δ and has the waterplane A. About the centre of gravity of
all that is on it, each motion by itself has a stiffness and an inertia with the added one,

    heave   k = ρ g A           m + a₃₃
    roll    k = Δ g GM_T        I_x + a₄₄
    pitch   k = Δ g GM_L        I_y + a₅₅

GM less free surfaces, and its critical damping is 2 √(k m). Of surge, sway and yaw, that only moorings
restore, it is 2 m 2π/T with the period T that the lift file says. See docs/concepts/vessels.md.
"""

from __future__ import annotations

import math

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array, inertia_matrix, point_inertia
from gantline.assembly.water import hull_mesh
from gantline.hydro import Attitude, Hull, Hydrostatics, Tank, free_surface_correction, hydrostatics
from gantline.scenario import Scenario
from gantline.scenario.vessel import Vessel
from gantline.scenario.water import MOTIONS, Water

__all__ = ["add_critical_damping"]


def add_critical_damping(parts: Parts, scenario: Scenario) -> None:
    """Add the damping of vessels that is given as shares; all that is on them is there, with its mass.

    Raises:
        ScenarioError: if nothing restores a motion for which a share is given.
    """
    for name, vessel in (scenario.vessels or {}).items():
        if vessel.water_damping is None or vessel.water_damping.critical is None:
            continue
        mass, centre, inertia = _aboard(parts, name)
        inertias = [mass] * 3 + np.diag(inertia).tolist() + np.zeros(6)
        for force in parts.forces:
            if force["type"] == "added_mass" and force["body"] == name:
                inertias = inertias + np.diag(_about(force, centre))
        damping = np.diag(_critical(scenario, name, vessel, inertias, centre)).tolist()
        named = {"type": "drag", "name": f"{name}.critical_damping", "body": name, "at": centre.tolist()}
        parts.forces.append({**named, "damping": damping, "quadratic": [0.0] * 6})


def _aboard(parts: Parts, vessel: str) -> tuple[float, Array, Array]:
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


def _about(added: Json, centre: Array) -> Array:
    """An added mass (6, 6) about another point: the velocity of its own is v - r × ω, r from there to it."""
    x, y, z = np.array(added["at"]) - centre
    moved = np.eye(6)
    moved[:3, 3:] = -np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    about: Array = moved.T @ np.array(added["matrix"]) @ moved
    return about


def _critical(scenario: Scenario, name: str, vessel: Vessel, inertias: Array, centre: Array) -> list[float]:
    """Damping of each motion [N s/m, N m s]."""
    assert vessel.water_damping is not None and vessel.water_damping.critical is not None
    given, gravity = vessel.water_damping.critical, scenario.simulation.gravity
    found, heights = _hydrostatics(scenario, name, vessel, centre)
    weight = found.mass * gravity
    stiffness = {
        "heave": found.per_metre * gravity,
        "roll": weight * heights[0],
        "pitch": weight * heights[1],
    }
    damping = []
    for motion, inertia in zip(MOTIONS, inertias, strict=True):
        share = getattr(given, motion) or 0.0
        if share == 0.0:
            damping.append(0.0)
            continue
        if motion not in stiffness:
            rate = 2 * math.pi / getattr(given.periods, motion)
        elif stiffness[motion] > 0.0:
            rate = math.sqrt(stiffness[motion] / inertia)
        else:
            sentence = (
                f"nothing restores {motion} upright at this draft: GM is {stiffness[motion] / weight:.3g} m"
            )
            path = ("vessels", name, "water_damping", "critical", motion)
            raise scenario.error(path, f"{sentence}; give '{motion}' itself, such as '100 MN m s'")
        damping.append(2 * share * float(inertia) * rate)
    return damping


def _hydrostatics(
    scenario: Scenario, name: str, vessel: Vessel, centre: Array
) -> tuple[Hydrostatics, tuple[float, float]]:
    """Hydrostatics upright at the draft of the start; GM for heel and trim less free surfaces [m]."""
    mesh = hull_mesh(vessel.hull)
    hull = Hull(name, np.array(mesh["vertices"]), np.array(mesh["triangles"]))
    density = (scenario.water or Water()).density
    found = hydrostatics(hull, Attitude(vessel.draft, middle=float(np.mean(hull.box[:, 0]))), density)
    slack = [
        Tank(tank.box[0], tank.box[1], tank.density)
        for tank in (vessel.tanks or {}).values()
        if tank.is_slack
    ]
    return found, found.gm(centre, free_surface_correction(slack, found.mass))
