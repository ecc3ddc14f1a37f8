"""Whether a hydrodynamic database is of the hull that a lift gives it to, by the longest of its waves.

In waves much longer than a hull the water goes up and down with it. Then heave, pitch and roll per metre
follow from its waterplane A, the middle (x, y) of that from the reference point, and its volume V,

    X₃ = ρ g A − ω² (ρ V + A₃₃),    X₅ = −x X₃,    X₄ = y X₃,

but for what the slope of the waves adds to both moments, a quarter of a period late (Newman 1977, chapter
6). A body beside others that are held has −ω² A_j3 of each of them as well, which is left out of its forces.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from gantline.assembly.afloat.databases import from_database
from gantline.assembly.afloat.hulls import afloat_path
from gantline.assembly.afloat.vessels import upright_hydrostatics, vessel_hull
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.hydro import Hydrostatics
from gantline.hydro.database import HydrodynamicDatabase
from gantline.hydro.waves import wave_number
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import AddedMass, Radiation, WaterDamping, WaveForces
from gantline.scenario.errors import Doubt

__all__ = ["add_doubts_of_hulls"]

ByFile = AddedMass | WaterDamping | Radiation | WaveForces

#: Waves are long up to this wave number times the length of the hull. Of a barge of 90 × 30 × 3 m that is
#: right there to 4 % of the force and a fiftieth of the length.
_LONG = 1.2
#: What is left of its stiffness, at least: near resonance long waves push with nothing.
_STIFF = 0.5
#: Heave forces and volumes that differ by more than this share are of another hull. Files of wave programs
#: are within 1 % of the hulls that they were made from; boxes that stand for ships have a tenth more.
_OTHER_HULL = 0.25
#: Middles of the waterplane further apart than this share of length or breadth are of another place aboard.
_OTHER_PLACE = 0.05
#: Heights of a reference point over the water that differ by more than this [m], and by this share of the
#: draft, are of another place aboard: a lift may float a little deeper or higher than its database.
_OTHER_HEIGHT, _OF_DRAFT = 0.5, 0.25
#: Places that differ by less are one [m], and directions [rad].
_SAME = 1e-3


def add_doubts_of_hulls(parts: Parts, scenario: Scenario) -> None:
    """Warn of hydrodynamic databases of another hull than their vessel's, or for another place aboard.

    Raises:
        ScenarioError: if a database or the file of a hull cannot be used.
    """
    for name, vessel in (scenario.vessels or {}).items():
        told: set[str] = set()
        places: dict[tuple[str | None, str | None], tuple[str, ByFile]] = {}
        for key in ("wave_forces", "radiation", "added_mass", "water_damping"):
            given = getattr(vessel, key)
            if getattr(given, "database", None) is None:
                continue
            hull = upright_hydrostatics(scenario, name, vessel)
            size = np.ptp(vessel_hull(scenario, name, vessel).box[:, :2], axis=0)
            doubts = partial(
                _doubts,
                at=np.array(given.at),
                hull=hull,
                draft=vessel.draft,
                size=size,
                gravity=scenario.simulation.gravity,
            )
            path = (*afloat_path(scenario, name), key)
            found = from_database(scenario, path, (given.database, given.body, given.heading_in_file), doubts)
            found += _elsewhere(places, key, given)
            parts.doubts += [Doubt(path, f"{key} of {name}: {doubt}") for doubt in found if doubt not in told]
            told.update(found)


def _doubts(
    database: HydrodynamicDatabase,
    at: Array,
    hull: Hydrostatics,
    draft: float,
    size: Array,
    gravity: float,
) -> list[str]:
    """Sentences on what a database has of a hull and the lift otherwise.

    Args:
        database: Any.
        at: Where its reference point is aboard (3,) [m].
        hull: The hull upright at the draft of the start.
        draft: That draft [m].
        size: Its length and breadth (2,) [m].
        gravity: g [m/s^2].
    """
    if hull.volume <= 0.0:  # as an open mesh may have, of which its own warning tells
        return []
    found = []
    volume = database.displacement
    if volume is not None and abs(volume / hull.volume - 1.0) > _OTHER_HULL:
        found.append(
            f"{database.source} is of a hull that displaces {volume:.4g} m^3, the vessel's displaces "
            f"{hull.volume:.4g} m^3 at its draft of the lift file"
        )
    return [*found, *_of_heights(database, at, draft), *_of_long_waves(database, at, hull, size, gravity)]


def _of_heights(database: HydrodynamicDatabase, at: Array, draft: float) -> Iterator[str]:
    """That a reference point which a file names is at another height over the water than aboard.

    Heights of wave programs count from the water; a file that says nothing of its water may count otherwise.
    """
    if database.reference is None or database.density is None:
        return
    by_file, aboard = float(database.reference[2]), float(at[2]) - draft
    if abs(aboard - by_file) > max(_OTHER_HEIGHT, _OF_DRAFT * draft):
        shown, is_at = (_height(z) for z in (by_file, aboard))
        is_by = f"the reference point of {database.source} is {shown}"
        right = f"'at' counts from the keel, so that its z is {draft + by_file:.2f} m"
        yield f"{is_by}, 'at' {is_at} at the draft of the lift file; {right}"


def _height(z: float) -> str:
    if abs(z) < 0.005:
        return "at the water"
    return f"{abs(z):.2f} m {'above' if z > 0.0 else 'below'} the water"


def _elsewhere(
    places: dict[tuple[str | None, str | None], tuple[str, ByFile]], key: str, given: ByFile
) -> Iterator[str]:
    """That a file has its reference point or its axes elsewhere under another key of the vessel.

    Args:
        places: Keys and what stands there, found before, by file and body; this one is added.
        key: The key.
        given: What stands there.
    """
    other, before = places.setdefault((given.database, given.body), (key, given))
    if float(np.abs(np.subtract(given.at, before.at)).max()) > _SAME:
        here, first = (f"({', '.join(f'{x + 0.0:g}' for x in one.at)}) m" for one in (given, before))
        yield f"'at' is {here} and that of '{other}' {first}; a file has one reference point"
    apart = math.remainder(given.heading_in_file - before.heading_in_file, math.tau)
    if abs(apart) > _SAME:
        here, first = (f"{math.degrees(one.heading_in_file):g} deg" for one in (given, before))
        yield f"'heading_in_file' is {here} and that of '{other}' {first}; a file has one of each body"


def _of_long_waves(
    database: HydrodynamicDatabase, at: Array, hull: Hydrostatics, size: Array, gravity: float
) -> Iterator[str]:
    """The same by the longest waves of a database, where it has any that are long enough."""
    if database.excitation is None:
        return
    omega = database.frequencies[:1]
    depth = database.water_depth
    number = float(wave_number(omega, gravity, None if depth is None or math.isinf(depth) else depth)[0])
    denser = 1.0 if database.density is None else hull.density / database.density
    stiffness = hull.density * gravity * hull.waterplane_area
    moved = hull.density * hull.volume + denser * float(database.added_mass[0, 2, 2])
    expected = stiffness - float(omega[0]) ** 2 * moved
    if number * size[0] > _LONG or expected < _STIFF * stiffness:
        return
    forces = database.excitation[0]
    held = sum((other.added_mass[0, :, 2] for other in database.others.values()), start=np.zeros(6))
    phase = forces[:, 2] / np.maximum(np.abs(forces[:, 2]), 1e-300)
    forces = denser * (forces + float(omega[0]) ** 2 * np.multiply.outer(phase, held))
    heave = float(np.abs(forces[:, 2]).max())
    waves = f"waves of {2 * math.pi / float(omega[0]):.4g} s"
    if abs(heave / expected - 1.0) > _OTHER_HULL:
        shown = f"{heave / 1e6:.3g} MN per metre, the vessel's hull at its draft {expected / 1e6:.3g} MN"
        yield f"{database.source} is of another hull, draft or scale: {waves} lift it with {shown}"
        return  # where a hull has its middle that is not this one is nothing to go by
    forces = forces[np.abs(forces[:, 2]) > _STIFF * heave]
    levers = np.stack([-forces[:, 4], forces[:, 3]]) / forces[:, 2]
    least = np.abs(levers.imag).argmin(axis=1)  # the direction in which the slope of the waves counts least
    middle, wanted = levers.real[[0, 1], least] + at[:2], hull.centre_of_flotation[:2]
    if (np.abs(middle - wanted) > _OTHER_PLACE * size).any():
        by_file, by_hull = (f"({x + 0.0:.1f}, {y + 0.0:.1f}) m" for x, y in np.round([middle, wanted], 1))
        yield (
            f"with its reference point 'at' {database.source} has the middle of the waterplane at {by_file} "
            f"of the vessel, its hull at {by_hull}"
        )
