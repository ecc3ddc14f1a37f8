"""Inertia and stiffness of vessels by themselves, upright at their drafts, with all that is fixed to them."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

import numpy as np

from gantline.assembly.afloat.vessels import upright_hydrostatics
from gantline.assembly.afloat.water import frozen
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array, inertia_matrix
from gantline.cad.mass_properties import point_inertia
from gantline.hydro import Hydrostatics, Tank, free_surface_correction
from gantline.scenario import Scenario
from gantline.scenario.afloat.tanks import changing_tanks
from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.afloat.water import BallastTank

__all__ = ["about_point", "mass_aboard", "pumped_content", "stiffness_by_water"]


def mass_aboard(
    parts: Parts, vessel: str, pumped: Sequence[BallastTank], standing: Collection[str] = ()
) -> tuple[float, Array, Array]:
    """Mass [kg], centre of gravity (3,) [m], inertia about it (3, 3) [kg m^2] of a vessel and all on it.

    Args:
        parts: With all bodies.
        vessel: Its name.
        pumped: Tanks whose liquid is no body's mass.
        standing: Names of free bodies that stand aboard.
    """
    position, turn = parts.pose(vessel)
    masses, centres, inertias = [], [], []
    for name, body in parts.bodies.items():
        above: str | None = name
        while above is not None and above not in (vessel, *standing):
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


def pumped_content(scenario: Scenario, name: str, vessel: Vessel) -> list[BallastTank]:
    """Tanks whose liquid is no body's mass, with some in them."""
    pumped = changing_tanks(scenario)
    tanks = (vessel.tanks or {}).items()
    return [tank for one, tank in tanks if f"{name}.{one}" in pumped and tank.content > 0.0]


def about_point(added: Json, centre: Array) -> Array:
    """A `matrix` (6, 6) `at` a point about another: the velocity there is v - r × ω, r from here to it."""
    x, y, z = np.array(added["at"]) - centre
    moved = np.eye(6)
    moved[:3, 3:] = -np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    about: Array = moved.T @ np.array(added["matrix"]) @ moved
    return about


def stiffness_by_water(
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
