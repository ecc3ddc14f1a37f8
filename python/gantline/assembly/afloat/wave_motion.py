"""What moves vessels with `wave_motion`: waves by their RAOs, or a record; what is doubtful of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.carriers import carrier, wave_drive
from gantline.assembly.afloat.recorded_motion import move_by_record
from gantline.assembly.afloat.trains import Train
from gantline.assembly.afloat.vessels import vessel_hull
from gantline.assembly.parts import Parts
from gantline.assembly.stamp import stamp
from gantline.hydro.database import AXES, DatabaseError
from gantline.hydro.raos import DisplacementRaos, Phases, read_raos
from gantline.hydro.waves import wave_number
from gantline.scenario import Scenario
from gantline.scenario.afloat.vessel import Vessel, WaveMotion
from gantline.scenario.afloat.water import Water
from gantline.scenario.errors import PathPart

__all__ = ["move_by_waves"]

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]

#: Share of the energy of a sea in waves shorter or longer than a table has, from which on it is told, and of
#: shorter ones refused.
_SILENT, _MOST_UNKNOWN = 0.05, 0.2
#: Waves are long beside a vessel of the length L up to this κL: she goes up and down with them.
_LONG = 0.6
#: Heave in long waves over that of the water; pitch over the slope of the water.
_HEAVES, _PITCHES = (0.7, 1.3), (0.3, 2.0)
#: Heave of no vessel [m/m], and turns of none [rad/m].
_MOST_HEAVE, _MOST_TURN = 5.0, 1.0
#: Waves run along a vessel with at least this share of their way.
_ALONG = 0.7


def move_by_waves(parts: Parts, scenario: Scenario, trains: dict[str, Train]) -> None:
    """Let waves of the lift, or records, move the drives of vessels; tell what is doubtful of them.

    Args:
        parts: the lift so far, with its sea.
        scenario: the lift.
        trains: its waves by name.

    Raises:
        ScenarioError: if a table cannot be used, has none of the waves, or ends too early.
    """
    for name, vessel in (scenario.vessels or {}).items():
        if vessel.wave_motion is None:
            continue
        if vessel.wave_motion.record is not None:
            move_by_record(parts, scenario, name, vessel.wave_motion)
            continue
        path = ("vessels", name, "wave_motion")
        table = _table(scenario, path, vessel.wave_motion)
        for sentence in list(_of_table(scenario, name, vessel, table)) or _large(table):
            parts.doubt(path, f"wave motion of {name}: {sentence}")
        for train_name, train in trains.items():
            answer = _answer(scenario, path, vessel, table, train)
            for sentence in _unknown(scenario, path, train_name, train, table):
                parts.doubt(path, f"wave motion of {name}: {sentence}")
            _add_motion(parts, name, vessel, train, answer)


def _table(scenario: Scenario, path: tuple[PathPart, ...], given: WaveMotion) -> DisplacementRaos:
    assert given.raos is not None and given.phases is not None  # validated
    place = Path(scenario.source).parent / given.raos
    try:
        return _read(place, stamp(place), given.phases)
    except DatabaseError as problem:
        raise scenario.error((*path, "raos"), str(problem).replace(str(place), given.raos)) from None


@lru_cache(maxsize=8)
def _read(path: Path, _stamp: tuple[int, int], phases: Phases) -> DisplacementRaos:
    """A table, read once for all cases of a lift."""
    return read_raos(path, phases)


def _answer(
    scenario: Scenario,
    path: tuple[PathPart, ...],
    vessel: Vessel,
    table: DisplacementRaos,
    train: Train,
) -> Complex:
    """X of each wave in the direction that it has from the vessel (n, 6) [m/m, rad/m]."""
    try:
        return table.at(train.waves.frequency, train.waves.direction - vessel.heading)
    except DatabaseError as problem:
        raise scenario.error((*path, "raos"), str(problem)) from None


def _add_motion(parts: Parts, name: str, vessel: Vessel, train: Train, answer: Complex) -> None:
    """What waves add to the drives of a vessel: a X exp i(k·s + ε − ωt), s its point at the start."""
    assert parts.sea is not None and vessel.wave_motion is not None
    place = parts.pose(carrier(name, "surge"))[0][:2]
    waves = train.waves
    # a |X| cos(arg X + k·s + ε − ωt)
    phases = train.numbers @ place + waves.phase
    for number, axis in enumerate(AXES):
        motion = answer[:, number] * waves.amplitude
        drive = parts.drives[wave_drive(name, axis)]
        grown = drive.setdefault("waves", {"components": [], "rise_time": parts.sea["rise_time"]})
        grown["components"] += [
            {"frequency": omega, "wave_number": [0.0, 0.0], "amplitude": size, "phase": phase}
            for omega, size, phase in zip(
                waves.frequency.tolist(),
                np.abs(motion).tolist(),
                (phases + np.angle(motion)).tolist(),
                strict=True,
            )
        ]


def _unknown(
    scenario: Scenario,
    path: tuple[PathPart, ...],
    name: str,
    train: Train,
    table: DisplacementRaos,
) -> Iterator[str]:
    """Sentences on waves shorter or longer than a table has."""
    energy = train.waves.amplitude**2 / (train.waves.amplitude**2).sum()
    omega, (low, high) = train.waves.frequency, table.frequencies[[0, -1]]
    short = float(energy[omega > high * (1 + 1e-6)].sum())
    long = float(energy[omega < low * (1 - 1e-6)].sum())
    if short > _SILENT:
        sentence = f"{100 * short:.0f} % of the energy of {name} is in waves shorter than any there"
        if short > _MOST_UNKNOWN:
            shortest = f"the shortest are of {2 * math.pi / high:.4g} s"
            raise scenario.error((*path, "raos"), f"{table.source}: {sentence}; {shortest}")
        yield f"{sentence}; they move nothing"
    if long > _SILENT:
        sentence = f"{100 * long:.0f} % of the energy of {name} is in waves longer than any there"
        yield f"{sentence}; they move it as those of {2 * math.pi / low:.4g} s, the longest"


def _of_table(scenario: Scenario, name: str, vessel: Vessel, table: DisplacementRaos) -> Iterator[str]:
    """Sentences on a table that long waves contradict: units, signs and phases slip easily.

    In waves that are long beside her a vessel goes with the water: X₃ = 1, and X₅ = -iκ cos β.
    """
    omega = table.frequencies[:1]
    number = float(wave_number(omega, scenario.simulation.gravity, (scenario.water or Water()).depth)[0])
    length = float(np.ptp(vessel_hull(scenario, name, vessel).box[:, 0]))
    if number * length > _LONG:
        return
    motion, along = table.motion[0], np.cos(table.directions)
    waves = f"in its waves of {2 * math.pi / float(omega[0]):.4g} s, long beside the vessel,"
    heave = float(np.mean(motion[:, 2].real))
    if not _HEAVES[0] <= heave <= _HEAVES[1]:
        yield (
            f"{table.source}: {waves} it heaves by {heave:.2g} of the water and not with it: see units and "
            "phases, which count from the crest"
        )
        return
    ahead = np.abs(along) >= _ALONG
    if not ahead.any():
        return
    # Of what the slope of the water has the pitch follows so much, by the middle of these directions.
    follows = float(np.median((motion[ahead, 4] / (-1j * number * along[ahead])).real))
    if follows < 0.0:
        yield (
            f"{table.source}: {waves} it pitches against their slope: pitch is positive by the bow down, "
            "waves run to 'direction', head seas 180 deg, and phases are lags or leads"
        )
    elif not _PITCHES[0] <= follows <= _PITCHES[1]:
        yield f"{table.source}: {waves} it pitches by {follows:.2g} of their slope: see the unit of pitch"


def _large(table: DisplacementRaos) -> Iterator[str]:
    """A sentence on each motion that is so large that its unit is doubtful, however long the waves."""
    for place, most in ((2, _MOST_HEAVE), (3, _MOST_TURN), (4, _MOST_TURN), (5, _MOST_TURN)):
        size = np.abs(table.motion[:, :, place]).max(axis=1)
        if size.max() > most:
            period = 2 * math.pi / float(table.frequencies[size.argmax()])
            largest = float(size.max())
            shown = f"{largest:.3g} m/m" if place < 3 else f"{math.degrees(largest):.3g} deg/m"
            yield f"{table.source}: in its waves of {period:.4g} s {AXES[place]} is {shown}: see its unit"
