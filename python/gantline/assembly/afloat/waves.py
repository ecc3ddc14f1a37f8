"""Waves of a lift file into the sea of a document and what it does to vessels."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.databases import from_database
from gantline.assembly.afloat.mean_drift import mean_drift
from gantline.assembly.afloat.side_by_side import SideBySide, vessels_side_by_side
from gantline.assembly.afloat.steepness import doubts_of_steepness, refuse_breaking
from gantline.assembly.afloat.trains import Train
from gantline.assembly.afloat.vessels import vessel_hull
from gantline.assembly.afloat.wave_motion import move_by_waves
from gantline.assembly.parts import Json, Parts
from gantline.hydro.database import AXES, DatabaseError, ForcesAround, HydrodynamicDatabase
from gantline.hydro.mean_drift import Drifting
from gantline.hydro.waves import Components, regular, sea, wave_number
from gantline.scenario import Scenario
from gantline.scenario.afloat.mooring import is_moored
from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.afloat.water import Water
from gantline.scenario.afloat.waves import WaveTrain
from gantline.scenario.errors import Doubt

__all__ = ["add_waves"]

Complex = npt.NDArray[np.complex128]
Array = npt.NDArray[np.float64]

#: Waves grow over so many of their longest period.
_PERIODS_TO_GROW = 3.0
#: Share of the energy of a sea that may be of waves shorter than a database knows.
_MOST_UNKNOWN = 0.2
#: The same that goes without saying.
_SILENT = 0.05
#: Added mass and damping of another period than the waves' by more than this share are doubtful.
_OTHER_PERIOD = 0.25
#: Share of motions that may be by waves that a file has none close to, without saying.
_MOST_SPARSE = 0.35
#: Waves that are longer or shorter by another depth by more than this share are doubtful.
_OTHER_LENGTH = 0.05


def add_waves(parts: Parts, scenario: Scenario) -> None:
    """Add the sea, and to each vessel what its waves do to it; warn of waves that do nothing.

    All bodies are there, with their masses, and what damps vessels.

    Raises:
        ScenarioError: if waves break, or a database or a table of RAOs cannot be used.
    """
    if not scenario.waves:
        # In still water too a vessel with 'wave_motion' does not feel what hangs from it.
        move_by_waves(parts, scenario, {})
        return
    refuse_breaking(scenario)
    trains = {name: _train(scenario, name, waves) for name, waves in scenario.waves.items()}
    listed = [wave for train in trains.values() for wave in train.document]
    rise_time = _PERIODS_TO_GROW * max(train.main_period for train in scenario.waves.values())
    parts.sea = {"components": listed, "rise_time": rise_time, "depth": (scenario.water or Water()).depth}
    pushed = {name: vessel for name, vessel in (scenario.vessels or {}).items() if vessel.wave_forces}
    neighbours = vessels_side_by_side(parts, scenario)
    for name, vessel in pushed.items():
        force, *mean = _forces(parts, scenario, name, trains, neighbours.get(name))
        parts.forces += [force, *mean]
        parts.doubts += _other_period(scenario, name, vessel)
        parts.doubts += _drifting(scenario, name, vessel, drifts=bool(force["drifts"]))
    move_by_waves(parts, scenario, trains)
    parts.doubts += _idle(scenario) + doubts_of_steepness(scenario)


def _train(scenario: Scenario, name: str, given: WaveTrain) -> Train:
    waves = _components(name, given)
    depth = (scenario.water or Water()).depth
    return Train.of(waves, wave_number(waves.frequency, scenario.simulation.gravity, depth))


def _components(name: str, train: WaveTrain) -> Components:
    if train.height is not None and train.period is not None:
        return regular(train.height, train.period, train.direction, train.phase or 0.0)
    assert train.significant_height is not None and train.peak_period is not None  # validated
    return sea(
        train.significant_height,
        train.peak_period,
        train.direction,
        enhancement=train.peak_enhancement,
        count=train.components,
        seed=f"{train.seed}/{name}",
    )


def _forces(
    parts: Parts, scenario: Scenario, name: str, trains: dict[str, Train], beside: SideBySide | None
) -> list[Json]:
    """What all waves do to a vessel, vessel axes, phases from the middle of its length in the centre plane.

    The first is their force as they come by, the second, if they have any, that on the whole.

    There they change least between the frequencies and directions of a file, whose own origin may be far off.
    """
    vessel = (scenario.vessels or {})[name]
    given = vessel.wave_forces
    assert given is not None
    path = ("vessels", name, "wave_forces")
    box = vessel_hull(scenario, name, vessel).box[:, :2]
    found = []
    for train_name, train in trains.items():
        pushed = _of_database(scenario, name, train.waves, box, beside)
        parts.doubts += [Doubt(path, f"wave forces of {name}: {doubt}") for doubt in pushed.doubts]
        unknown = _unknown(train.waves, pushed.at_start)
        if unknown > _SILENT:
            shown = f"{100 * unknown:.0f} % of the energy of {train_name}"
            sentence = f"{shown} is in waves shorter than any there"
            if unknown > _MOST_UNKNOWN:
                raise scenario.error((*path, "database"), f"{given.database}: {sentence}")
            parts.doubt(path, f"wave forces of {name}: {sentence}; they do nothing")
        found.append(pushed)
    forces = np.concatenate([pushed.around.cubics for pushed in found])
    pushes = [pushed.on_the_whole for pushed in found if pushed.on_the_whole is not None]
    drifts = [one.drift.cubics.real for one in pushes]
    # One file has the same directions for all waves.
    force: Json = {
        "type": "wave",
        "name": f"{name}.wave_forces",
        "body": name,
        "at": list(given.at),
        "origin": [float(box[:, 0].mean()), 0.0, given.at[2]],
        "directions": found[0].around.directions.tolist(),
        "phasors": np.stack([forces.real, forces.imag], axis=-1).tolist(),
        "drifts": np.concatenate(drifts).tolist() if drifts else [],
    }
    return [force, mean_drift(scenario, name, given, pushes, box)] if pushes else [force]


class _Pushed(NamedTuple):
    """Forces of waves on a vessel in its axes, over amplitudes or their squares, and what is doubtful.

    Attributes:
        at_start: as it lies at the start (n, 6).
        around: by the direction of the waves.
        on_the_whole: drift forces, if any.
        doubts: sentences.
    """

    at_start: Complex
    around: ForcesAround
    on_the_whole: Drifting | None
    doubts: list[str]


def _of_database(
    scenario: Scenario, name: str, train: Components, box: Array, beside: SideBySide | None
) -> _Pushed:
    """What waves do to a vessel; phases count from the middle of its length in its centre plane.

    Args:
        scenario: the lift.
        name: of the vessel.
        train: the waves.
        box: its least and largest x, y [m].
        beside: what it lies among, if its file has others beside it.
    """
    vessel = (scenario.vessels or {})[name]
    given = vessel.wave_forces
    assert given is not None
    density = (scenario.water or Water()).density
    lowest, middle, size = float(train.frequency[0]), float(box[:, 0].mean()), np.ptp(box, axis=0)

    def forces(database: HydrodynamicDatabase) -> _Pushed:
        shortest = 2 * math.pi / float(database.frequencies[-1])
        if len(train.frequency) == 1 and lowest > float(database.frequencies[-1]) * (1 + 1e-6):
            wanted = f"has no waves of {2 * math.pi / lowest:.4g} s"
            raise DatabaseError(f"{database.source}: {wanted}; the shortest are of {shortest:.4g} s")
        reference = np.zeros(3) if database.reference is None else database.reference
        phased_at = (reference + np.array([middle, 0.0, 0.0]) - given.at)[:2]
        towards = train.direction - vessel.heading
        found, doubts = database.excitation_at(train.frequency, towards, density, phased_at)
        doubts += _of_other_waves(scenario, database, train)
        if beside is None:
            around, extent = database.excitation_around(train.frequency, density, phased_at), size
        else:
            around, extent = beside.forces(name, train.frequency), size + 2 * beside.extent
        drift = database.drift_around(train.frequency, density) if given.drift is not False else None
        if given.drift and drift is None:
            raise DatabaseError(f"{database.source}: has no drift forces")
        met = database.drift_around(train.frequency, density, derivative=1)
        mean = None if drift is None or met is None else Drifting(train, drift, met)
        return _Pushed(found, around, mean, doubts + _sparse(database, around, towards, train, extent))

    return from_database(
        scenario,
        ("vessels", name, "wave_forces"),
        (given.database, given.body, given.heading_in_file),
        forces,
    )


def _of_other_waves(scenario: Scenario, database: HydrodynamicDatabase, train: Components) -> list[str]:
    """Sentences on waves that are longer than a database knows, or longer or shorter by its depth."""
    energy = train.amplitude**2 / (train.amplitude**2).sum()
    doubts = []
    long = float(energy[train.frequency < database.frequencies[0] * (1 - 1e-6)].sum())
    if long > _SILENT:
        sentence = f"{100 * long:.3g} % of the energy is in waves longer than any there"
        doubts.append(
            f"{database.source}: {sentence}; they push as those of {database.periods[0]:.4g} s, the longest"
        )
    depth, gravity = (scenario.water or Water()).depth, scenario.simulation.gravity
    if database.water_depth is not None:
        theirs = None if math.isinf(database.water_depth) else database.water_depth
        ratio = wave_number(train.frequency, gravity, theirs) / wave_number(train.frequency, gravity, depth)
        if float(energy @ np.abs(ratio - 1.0)) > _OTHER_LENGTH:
            said = ["deep water" if one is None else f"water {one:g} m deep" for one in (theirs, depth)]
            sentence = f"{database.source} is for {said[0]}, the lift is in {said[1]}"
            doubts.append(f"{sentence}: waves have other lengths there, and other forces")
    return doubts


def _sparse(
    database: HydrodynamicDatabase, around: ForcesAround, towards: float, train: Components, size: Array
) -> list[str]:
    """A sentence where frequencies or directions of a file are too far apart for what lies between them."""
    is_far = ~database.has_close(train.frequency, towards, *size)
    forces = around.at(towards)
    assert forces is not None  # asked before
    # Motions go with X/ω²; beside those of waves from the worst side what is small does not count.
    soft = (train.amplitude / train.frequency**2)[:, np.newaxis]
    motions = soft * np.abs(forces)
    whole = ((soft * np.abs(around.cubics[:, :, 0]).max(axis=1)) ** 2).sum(axis=0)
    shares = np.sqrt((motions[is_far] ** 2).sum(axis=0) / np.where(whole > 0, whole, 1.0))
    if shares.max() <= _MOST_SPARSE:
        return []
    longest = 2 * math.pi / float(train.frequency[is_far].min())
    shown = f"which are {100 * shares.max():.0f} % of what moves it in {AXES[int(shares.argmax())]}"
    sentence = f"frequencies or directions of {database.source} are far apart for waves of {longest:.3g} s"
    return [f"{sentence} and shorter, {shown}; forces between them may be a tenth and more off"]


def _unknown(train: Components, forces: Complex) -> float:
    """Share of the energy of a sea in waves that push nothing, being shorter than the database knows."""
    energy = train.amplitude**2
    return float(energy[~forces.any(axis=1)].sum() / energy.sum())


def _other_period(scenario: Scenario, name: str, vessel: Vessel) -> list[Doubt]:
    """Water that is taken at a period which the waves have not, or not at all."""
    if vessel.radiation is not None:
        return []
    found = list[Doubt]()
    periods = [train.main_period for train in (scenario.waves or {}).values()]
    for key in ("added_mass", "water_damping"):
        given = getattr(vessel, key)
        if given is None:
            sentence = f"{name} has 'wave_forces' and no '{key}': its motions in waves are not its own"
            if key == "added_mass":
                sentence += "; barges heave with 1 to 7 times their mass of water"
            found.append(Doubt(("vessels", name), sentence))
        read = getattr(given, "period", None)
        if read == "infinite_frequency":
            sentence = f"{key} of {name} is that of infinite frequency; the waves are slower"
            found.append(Doubt(("vessels", name, key), sentence))
        if not isinstance(read, float):
            continue
        if all(abs(read / period - 1.0) > _OTHER_PERIOD for period in periods):
            shown = ", ".join(f"{period:g} s" for period in periods)
            sentence = f"{key} of {name} is that of motions of {read:g} s; the waves have {shown}"
            found.append(Doubt(("vessels", name, key), f"{sentence}; 'radiation' takes all periods"))
    return found


def _drifting(scenario: Scenario, name: str, vessel: Vessel, *, drifts: bool) -> list[Doubt]:
    """A vessel that drift forces take away or make swing for long, or moorings without them unsaid."""
    given = vessel.wave_forces
    assert given is not None
    path = ("vessels", name, "wave_forces")
    is_held = is_moored(scenario, name)
    if drifts and not is_held:
        sentence = (
            f"no mooring line holds {name} against the drift forces of its waves, which take it along ever "
            "faster; 'drift: false' leaves them out"
        )
        return [Doubt(path, sentence)]
    if is_held and given.drift is None and not drifts:
        sentence = (
            f"{given.database} has no drift forces: the pull of the mooring lines of {name} is without them, "
            "and so is where it lies; 'drift: false' says that this is known"
        )
        return [Doubt(path, sentence)]
    if drifts and vessel.water_damping is None and not vessel.current_areas:
        sentence = (
            f"nothing but waves takes of the slow motions of {name} on its mooring lines, which drift forces "
            "stir: lines and hull take more; 'water_damping: {critical: …}' or 'current_areas' say what"
        )
        return [Doubt(path, sentence)]
    return []


def _idle(scenario: Scenario) -> list[Doubt]:
    names = ", ".join(scenario.waves or {})
    vessels = scenario.vessels or {}
    if not vessels and scenario.load is not None and scenario.load.in_water is not None:
        return []
    if not vessels:
        return [Doubt(("waves",), f"the waves {names} do nothing: there are no vessels")]
    still = [name for name, one in vessels.items() if one.wave_forces is None and not one.is_carried]
    if not still:
        return []
    sentence = f"the waves {names} pass under {', '.join(still)} without a trace: no 'wave_forces'"
    return [Doubt(("vessels", still[0]), sentence)]
