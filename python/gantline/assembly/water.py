"""Water around vessels and bodies of `mechanics` and in their tanks, into forces on bodies."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import inertia_list, inertia_matrix
from gantline.scenario import Scenario
from gantline.scenario.water import Afloat, BallastTank, HullShape, Water

__all__ = ["add_water", "bodies_afloat", "hull_mesh", "hull_name"]


def bodies_afloat(scenario: Scenario) -> dict[str, Afloat]:
    """Vessels and bodies of `mechanics` by name: all that water may act on."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    return {**(scenario.vessels or {}), **plain}


def hull_name(body: str) -> str:
    """Name of the hull of a body among forces and in recordings."""
    return f"{body}.hull"


def hull_mesh(hull: HullShape) -> Json:
    """A hull in the axes of its body: vertices and triangles, counter-clockwise from outside."""
    return _box(hull.box, hull.bottom)


def add_water(parts: Parts, scenario: Scenario) -> None:
    """Add what water does to bodies; these are there, with their masses."""
    water = scenario.water or Water()
    for name, body in bodies_afloat(scenario).items():
        for tank_name, tank in (body.tanks or {}).items():
            _fill(parts, name, f"{name}.{tank_name}", tank)
        parts.forces += _around(name, body, water)


def _around(name: str, body: Afloat, water: Water) -> list[Json]:
    found: list[Json] = []
    if body.hull is not None:
        surface = {"density": water.density, "level": water.level}
        named = {"type": "buoyancy", "name": hull_name(name), "body": name}
        found.append({**named, **hull_mesh(body.hull), **surface})
    if body.added_mass is not None:
        matrix = np.diag(body.added_mass.diagonal).tolist()
        point = {"at": list(body.added_mass.at), "matrix": matrix}
        found.append({"type": "added_mass", "name": f"{name}.added_mass", "body": name, **point})
    if body.water_damping is not None:
        damping = np.diag(body.water_damping.diagonal).tolist()
        point = {"at": list(body.water_damping.at), "damping": damping, "quadratic": [0.0] * 6}
        found.append({"type": "drag", "name": f"{name}.water_damping", "body": name, **point})
    return found


def _fill(parts: Parts, body: str, name: str, tank: BallastTank) -> None:
    """The liquid as mass of the body, where it lies upright; where it has a free surface that is a force."""
    if tank.content == 0:
        return
    length, breadth, _ = tank.box
    x, y, z = tank.bottom
    parts.lump(body, [x, y, z + tank.depth / 2], tank.content)
    squares = np.array([length, breadth, tank.depth]) ** 2
    own = tank.content / 12 * np.diag(squares.sum() - squares)
    given = parts.bodies[body]
    given["inertia"] = inertia_list(inertia_matrix(given["inertia"]) + own)
    if tank.is_slack:
        mesh = _box(tank.box, tank.bottom)
        liquid = {"density": tank.density, "volume": tank.content / tank.density}
        parts.forces.append({"type": "tank", "name": name, "body": body, **mesh, **liquid})


def _box(size: Sequence[float], bottom: Sequence[float]) -> Json:
    """A box over the middle of its bottom: vertices and triangles, counter-clockwise from outside."""
    (length, breadth, depth), (x, y, z) = size, bottom
    vertices = [
        [x + i * length, y + j * breadth, z + k * depth]
        for i in (-0.5, 0.5)
        for j in (-0.5, 0.5)
        for k in (0, 1)
    ]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [triangle for a, b, c, d in faces for triangle in ([a, b, c], [a, c, d])]
    return {"vertices": vertices, "triangles": triangles}
