"""Water around vessels and bodies of `mechanics` and in their tanks, into forces on bodies."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.hulls import afloat_path, box_mesh, hull_mesh
from gantline.assembly.afloat.radiation import add_radiation
from gantline.assembly.afloat.water_matrix import water_matrix
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array, inertia_list, inertia_matrix
from gantline.hydro import Hull
from gantline.scenario import Scenario
from gantline.scenario.afloat.tanks import (
    bodies_afloat,
    changing_tanks,
    has_sea,
    hole_turns,
    load_tanks,
    sea_density,
)
from gantline.scenario.afloat.water import ORIGIN, AddedMass, Afloat, BallastTank, Water, WaterDamping
from gantline.scenario.errors import Doubt

__all__ = ["add_load_tanks", "add_water", "frozen", "hull_name", "pump_drive"]


def pump_drive(tank: str) -> str:
    """Name of the drive of the content of a tank."""
    return f"{tank}/pump"


def hull_name(body: str) -> str:
    """Name of the hull of a body among forces and in recordings."""
    return f"{body}.hull"


def add_water(parts: Parts, scenario: Scenario) -> None:
    """Add what water does to bodies; these are there, with their masses.

    Raises:
        ScenarioError: if the file of a hull or a hydrodynamic database cannot be used.
    """
    water = scenario.water or Water()
    changing = changing_tanks(scenario)
    for name, body in bodies_afloat(scenario).items():
        for tank_name, tank in (body.tanks or {}).items():
            full = f"{name}.{tank_name}"
            if full in changing:
                _let_change(parts, scenario, (name, full), tank, ORIGIN)
            else:
                _fill(parts, name, full, tank)
        _around(parts, scenario, name, body, water)


def add_load_tanks(parts: Parts, scenario: Scenario, centre: Array) -> None:
    """Add what is in tanks of the load, or will be: a weight of its own, so that the load's stays what it is.

    Args:
        parts: With the load, whose frame is at its centre of gravity.
        scenario: The lift.
        centre: That, from its datum (3,) [m].
    """
    load, changing = scenario.load, changing_tanks(scenario)
    for full, tank in load_tanks(scenario).items():
        if load is not None and (full in changing or tank.content > 0.0):
            _let_change(parts, scenario, (load.name, full), tank, centre)


def _around(parts: Parts, scenario: Scenario, name: str, body: Afloat, water: Water) -> None:
    hull = hull_mesh(scenario, name, body)
    if hull is not None:
        # What waves carry is pushed by nothing; how much it displaces is told.
        surface = {"density": 0.0 if body.is_carried else water.density, "level": water.level}
        path = (*afloat_path(scenario, name), "hull")
        parts.doubts += [Doubt(path, doubt) for doubt in hull.doubts]
        named = {"type": "buoyancy", "name": hull_name(name), "body": name}
        parts.forces.append({**named, **hull.document, **surface})
    add_radiation(parts, scenario, name, body)
    for key in ("added_mass", "water_damping"):
        given: AddedMass | WaterDamping | None = getattr(body, key)
        if given is None:
            continue
        path = (*afloat_path(scenario, name), key)
        matrix, doubts = water_matrix(scenario, path, given, water.density)
        parts.doubts += [Doubt(path, f"{key} of {name}: {doubt}") for doubt in doubts]
        force = {"name": f"{name}.{key}", "body": name, "at": list(given.at)}
        if key == "added_mass":
            parts.forces.append({"type": "added_mass", **force, "matrix": matrix})
        else:
            parts.forces.append({"type": "drag", **force, "damping": matrix, "quadratic": [0.0] * 6})


def _fill(parts: Parts, body: str, name: str, tank: BallastTank) -> None:
    """The liquid as mass of the body, where it lies upright; where it has a free surface that is a force."""
    if tank.content == 0:
        return
    centre, own = frozen(tank)
    parts.lump(body, centre, tank.content)
    given = parts.bodies[body]
    given["inertia"] = inertia_list(inertia_matrix(given["inertia"]) + own)
    if tank.is_slack:
        parts.forces.append(_tank(body, name, tank))


def frozen(tank: BallastTank) -> tuple[list[float], Array]:
    """Centre (3,) [m] of what is in a tank, where it lies upright, and inertia about it (3, 3) [kg m^2]."""
    (length, breadth, _), (x, y, z) = tank.box, tank.bottom
    squares = np.array([length, breadth, tank.depth]) ** 2
    return [x, y, z + tank.depth / 2], tank.content / 12 * np.diag(squares.sum() - squares)


def _let_change(
    parts: Parts, scenario: Scenario, names: tuple[str, str], tank: BallastTank, origin: npt.ArrayLike
) -> None:
    """A tank whose content a drive moves: all of the liquid is in the force.

    Args:
        parts: With the body.
        scenario: The lift.
        names: Of the body, and of the tank in full.
        tank: The tank.
        origin: Of the body's frame, in the axes in which the tank is given (3,) [m].
    """
    body, name = names
    content = f"{name}/content"
    parts.add_content(content, body, pump_drive(name))
    parts.add_drive(pump_drive(name))
    pumped: Json = {"content": content, "level": (scenario.water or Water()).level}
    if tank.holes:
        turns = hole_turns(scenario)
        holes = [
            {"at": _seen_from(origin, hole.at), "area": hole.area, "discharge": hole.discharge}
            | {"closed": hole.closed, "turns": turns[f"{name}.{own}"]}
            for own, hole in tank.holes.items()
        ]
        pumped |= {"holes": holes, "outside": sea_density(scenario) if has_sea(scenario) else 0.0}
    moved = tank.model_copy(update={"bottom": _seen_from(origin, tank.bottom)})
    parts.forces.append({**_tank(body, name, moved), "pumped": pumped})


def _seen_from(origin: npt.ArrayLike, place: Sequence[float]) -> tuple[float, ...]:
    return tuple(float(part) for part in np.array(place) - np.array(origin))


def _tank(body: str, name: str, tank: BallastTank) -> Json:
    mesh = box_mesh(tank.box, tank.bottom)
    # The mesh of a box far from the origin encloses less than its sides make, by rounding.
    room = Hull(name, mesh.vertices, mesh.triangles).closure.volume
    liquid = {"density": tank.density, "volume": min(tank.content / tank.density, room)}
    return {"type": "tank", "name": name, "body": body, **mesh.document, **liquid}
