"""Vessels that move as a record of their motion has it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

import numpy as np

from gantline.assembly.afloat.carriers import wave_drive
from gantline.assembly.parts import Parts
from gantline.assembly.stamp import stamp
from gantline.hydro.database import AXES, DatabaseError
from gantline.hydro.motion_record import Harmonics, MotionRecord, read_motion_record
from gantline.scenario import Scenario
from gantline.scenario.afloat.vessel import WaveMotion
from gantline.units import format_quantity

__all__ = ["ends_too_early", "move_by_record"]

#: The motion grows over so many of its mean periods.
_PERIODS_TO_GROW = 3.0
#: Of times, of which sums of many intervals are off by so much.
_ROUNDING = 1e-9


def move_by_record(parts: Parts, scenario: Scenario, name: str, given: WaveMotion) -> None:
    """Let the waves that add up to a record move the drives of a vessel.

    Args:
        parts: the lift so far.
        scenario: the lift.
        name: of the vessel.
        given: how it moves, by a record.

    Raises:
        ScenarioError: if the record cannot be used, or is shorter than the lift.
    """
    assert given.record is not None
    path = ("vessels", name, "wave_motion", "record")
    place = _place(scenario, given.record)
    try:
        record, waves = _read(place, stamp(place))
    except DatabaseError as problem:
        raise scenario.error(path, str(problem).replace(str(place), given.record)) from None
    if too_early := _too_early(given.record, record, "the lift", scenario.duration):
        raise scenario.error(path, too_early)
    for sentence in _doubtful(record, waves):
        parts.doubt(path, f"wave motion of {name}: {sentence}")
    if scenario.waves:
        parts.doubt(
            path,
            f"wave motion of {name}: a record knows nothing of 'waves' of the lift; loads in water and "
            "freeboard meet these, and other vessels move with them",
        )
    # To a tenth of a second, as people are told of it.
    rise_time = math.ceil(10.0 * _PERIODS_TO_GROW * waves.period) / 10.0
    for axis, column in zip(AXES, waves.motion.T, strict=True):
        parts.drives[wave_drive(name, axis)]["waves"] = {
            "components": [
                {"frequency": omega, "wave_number": [0.0, 0.0], "amplitude": size, "phase": phase}
                for omega, size, phase in zip(
                    waves.frequency.tolist(), np.abs(column).tolist(), np.angle(column).tolist(), strict=True
                )
                if column.any()
            ],
            "rise_time": rise_time,
        }


def ends_too_early(scenario: Scenario, duration: float) -> str | None:
    """That a record ends before a run, if one does: after its end comes its way back, which no vessel took.

    Args:
        scenario: a lift that has been assembled.
        duration: of the run, which may be another than that of the lift [s].
    """
    motions = [one.wave_motion for one in (scenario.vessels or {}).values() if one.wave_motion is not None]
    for name in (one.record for one in motions if one.record is not None):
        place = _place(scenario, name)
        if too_early := _too_early(name, _read(place, stamp(place))[0], "the run", duration):
            return too_early
    return None


def _place(scenario: Scenario, name: str) -> Path:
    return Path(scenario.source).parent / name


def _too_early(name: str, record: MotionRecord, what: str, duration: float) -> str | None:
    if duration <= record.duration * (1.0 + _ROUNDING):
        return None
    lasts = f"{name}: lasts {format_quantity(record.duration, 's', 1)}"
    return f"{lasts} and {what} {format_quantity(duration, 's', 1)}; a record at least as long is right"


def _doubtful(record: MotionRecord, waves: Harmonics) -> Iterator[str]:
    """Sentences on a record whose accelerations are of something else, or that tells too little."""
    if waves.too_fast is not None:
        axis, share = waves.too_fast
        fast = f"waves shorter than 2 s make {100.0 * share:.0f} % of the acceleration of its {axis}, rms"
        yield f"{record.source}: {fast}; no vessel moves so, it is noise of what measured it: filter it"
    if record.coarse is not None:
        axis, share = record.coarse
        open_ = f"its last decimal leaves {100.0 * share:.0f} % of its {axis} open, rms"
        yield f"{record.source}: {open_}; more decimals are right"


@lru_cache(maxsize=4)
def _read(path: Path, _stamp: tuple[int, int]) -> tuple[MotionRecord, Harmonics]:
    """A record and its waves, read once for all cases of a lift."""
    record = read_motion_record(path)
    return record, record.harmonics()
