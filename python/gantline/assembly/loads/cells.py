"""What of a load is where in water: lattices of cells for the core, of boxes and of round loads."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.assembly.loads.round_body import cells_along
from gantline.assembly.parts import Json
from gantline.assembly.spatial import Array
from gantline.cad.assumptions import STEEL
from gantline.scenario.loads.cylinder import Cylinder, segment_area, segment_moment
from gantline.scenario.loads.in_water import InWater
from gantline.scenario.loads.load import Load

__all__ = ["displaced_volume", "lattices", "seen"]

#: Layers of cells over the height of a box, and of what is round.
_LAYERS, _ROUND_LAYERS = 8, 16
#: Of the two places of Gauss on each side of the middle, in halves of a length: exact for cubics.
_GAUSS = 1.0 / np.sqrt(3.0)


def displaced_volume(given: InWater, load: Load) -> float:
    """What it displaces, wholly wet, with the inside of its tanks [m^3]."""
    of_steel = load.weight.simulated / STEEL + load.room_volume
    return of_steel if given.displaced_volume is None else given.displaced_volume


def seen(load: Load, box: Array) -> Array:
    """Areas that a load shows along x, y, z (3,) [m^2]: the sides of its box, or what is round of it.

    Args:
        load: The load.
        box: Its least and largest x, y, z (2, 3) [m].
    """
    if load.shape.seen is not None:
        return np.array(load.shape.seen)
    length, breadth, height = np.ptp(box, axis=0)
    return np.array([breadth * height, length * height, length * breadth])


def lattices(given: InWater, load: Load, box: Array, centre: Array, density: float) -> Iterator[Json]:
    """Its cells, from its centre of gravity: layers of four, of tanks too, and of what slams where it does.

    What a tank displaces is where the tank is: full of the water around it weighs nothing there.

    Args:
        given: What water does to it.
        load: The load.
        box: Its least and largest x, y, z from its datum (2, 3) [m].
        centre: Of gravity, from its datum (3,) [m].
        density: Of the water [kg/m^3].
    """
    sides = seen(load, box)
    drag = 0.5 * density * np.array(given.drag_coefficients) * sides
    added = np.array(given.added_mass)
    depth = given.slamming_depth(float(sides[2]), density)
    slamming = np.zeros(3) if depth is None else added * [0.0, 0.0, 1.0]
    members = displaced_volume(given, load) - load.room_volume
    nothing = np.zeros(3)
    if load.shape.cylinder is None:
        yield _of_box(box - centre, float(np.ptp(box[:, 2])), members, added - slamming, drag)
    else:
        yield from _of_round(load.shape.cylinder, centre, members, added - slamming, drag)
    for tank in (load.tanks or {}).values():
        (x, y, z), sizes = tank.bottom, np.array(tank.box)
        least = np.array([x - sizes[0] / 2, y - sizes[1] / 2, z])
        inside = np.array([least, least + sizes]) - centre
        yield _of_box(inside, tank.box[2], math.prod(tank.box), nothing, nothing)
    if depth is not None:
        yield _of_box(box - centre, depth, 0.0, slamming, nothing)


def _of_box(box: Array, height: float, volume: float, added: Array, drag: Array) -> Json:
    """Cells that share out what a load has, in layers over a height above its underside.

    Args:
        box: Its least and largest x, y, z (2, 3) [m].
        height: Of all layers [m].
        volume: That it displaces [m^3].
        added: Added mass along x, y, z (3,) [kg].
        drag: Force over speed squared along them (3,) [N s^2/m^2].
    """
    thick = height / _LAYERS
    x, y, _ = box.mean(axis=0)
    at = np.array([x, y, box[0, 2] + thick / 2])
    return _lattice(at, _GAUSS * np.ptp(box, axis=0)[:2] / 2, (thick, _LAYERS), volume, added, drag)


def _of_round(given: Cylinder, centre: Array, volume: float, added: Array, drag: Array) -> Iterator[Json]:
    """The same of a round load, each layer with what its section has there, by (RL11).

    Args:
        given: Its shape.
        centre: Of gravity, from its bottom centre (3,) [m].
        volume: That it displaces [m^3]: of the wall of a tube, or of all that is within it, whichever is
            nearer.
        added: Added mass along x, y, z (3,) [kg].
        drag: Force over speed squared along them (3,) [N s^2/m^2].
    """
    of_wall = given.moments.volume
    bores = given.bores if volume < (of_wall + given.enclosed) / 2 else (0.0, 0.0)
    pieces = _ROUND_LAYERS if given.along == "z" else cells_along(given)
    middles = (np.arange(pieces) + 0.5) / pieces
    outer, inner = (first + (last - first) * middles for first, last in (given.radii, bores))
    shares, wide = outer**2 - inner**2, outer / outer.sum()
    shares = shares / shares.sum()
    for middle, radius, bore, share, part in zip(middles, outer, inner, shares, wide, strict=True):
        own = share * volume, part * added, part * drag
        if given.along == "z":
            half, thick = math.hypot(radius, bore) / 2, given.length / pieces
            at = np.array([0.0, 0.0, given.length * middle]) - centre
            yield _lattice(at, np.array([half, half]), (thick, 1), *own)
        else:
            at = np.array([given.length * (middle - 0.5), 0.0, given.widest]) - centre
            yield from _lying(at, (float(radius), float(bore)), given.length / pieces, *own)


def _lying(
    middle: Array, radii: tuple[float, float], length: float, volume: float, added: Array, drag: Array
) -> Iterator[Json]:
    """Layers of a lying piece with its middle there [m], its outer radius and that of its bore [m]."""
    radius, bore = radii
    thick = 2 * radius / _ROUND_LAYERS
    levels = thick * np.arange(_ROUND_LAYERS + 1)
    areas, moments = (
        np.diff([of(radius, level) - of(bore, level - radius + bore) for level in levels])
        for of in (segment_area, segment_moment)
    )
    for level, area, moment in zip(levels, areas, moments, strict=False):
        at = middle + np.array([0.0, 0.0, level + thick / 2 - radius])
        half = np.array([_GAUSS * length / 2, math.sqrt(moment / area)])
        share = area / areas.sum()
        yield _lattice(at, half, (thick, 1), share * volume, added / _ROUND_LAYERS, drag / _ROUND_LAYERS)


def _lattice(
    at: Array, half: Array, layers: tuple[float, int], volume: float, added: Array, drag: Array
) -> Json:
    """Cells: middle of the lowest layer, half their distances, thickness [m] and number of layers."""
    thick, number = layers
    count = 4 * number
    return {
        "at": [float(part) for part in at],
        "half": [float(part) for part in half],
        "height": float(thick),
        "layers": number,
        "volume": float(volume) / count,
        "added_mass": (added / count).tolist(),
        "quadratic": (drag / count).tolist(),
    }
