"""How a vessel moved, as a table over time, and the waves that add up to it.

A motion that comes by as a sum of waves has all derivatives that drives need, at any time. So a record is
taken as one period of something that goes on for ever: after its end it goes back to where it began, as
smoothly as it was told, and the sum of its harmonics goes through every sample but for what of them is left
out, those that are too fast to be any motion of a vessel or too small to count.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.hydro.database import AXES, DatabaseError
from gantline.hydro.table_file import Titles, read_table

__all__ = ["Harmonics", "MotionRecord", "read_motion_record", "write_motion_record"]

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]

_TURN = {"deg": math.radians(1.0), "rad": 1.0}
_UNITS: Mapping[str, Mapping[str, float]] = {
    "time": {"s": 1.0},
    **{axis: {"m": 1.0} if place < 3 else _TURN for place, axis in enumerate(AXES)},
}
_TITLES = Titles(
    _UNITS,
    ("time",),
    "a record of motion",
    "'time [s]', 'heave [m]', 'roll [deg]'",
    "a motion that there is none of is 0, or has no column",
    {},
)
#: Samples of a record that is read, and the fewest that tell a motion.
_MOST_SAMPLES, _FEWEST = 200_000, 16
#: What no vessel does, and of which numbers have slipped: from its mean [m or rad].
_FARTHEST = (1000.0, 1.6)
#: Times are evenly spaced to this share of the interval.
_UNEVEN = 1e-3
#: What harmonics that are left out may move, root mean square, of what the record does.
_LEFT_OUT = 1e-3
#: The most waves that a record is made of. More are no motion of a vessel but noise of what measured it.
_MOST_WAVES = 2000
#: The way back to the beginning takes so many mean periods.
_PERIODS_BACK = 3.0


@dataclass(frozen=True, eq=False)
class Harmonics:
    """Waves that add up to a motion: Re Σ X exp(-iωt), from its mean.

    Attributes:
        frequency: ω, rising (n,) [rad/s].
        motion: X (n, 6) [m, rad].
        period: mean period of the motion that has the slowest [s].
    """

    frequency: Array
    motion: Complex
    period: float

    def at(self, time: Array) -> Array:
        """The motion at these times (k,) [s], shape (k, 6) [m, rad]."""
        found: Array = (np.exp(-1j * np.outer(time, self.frequency)) @ self.motion).real
        return found


@dataclass(frozen=True, eq=False)
class MotionRecord:
    """How a point of a vessel moved, from its mean.

    Attributes:
        source: name of its file.
        interval: between samples [s].
        motion: surge, sway, heave along level axes of the vessel's heading, turns by roll, pitch and yaw
            (n, 6) [m, rad].
        mean: what was taken off (6,) [m, rad].
    """

    source: str
    interval: float
    motion: Array
    mean: Array

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return (len(self.motion) - 1) * self.interval

    def harmonics(self) -> Harmonics:
        """The waves that it is made of.

        Raises:
            DatabaseError: if they are more than any motion of a vessel needs.
        """
        moving = self.motion.std(axis=0)
        period = max((_mean_period(way, self.interval) for way in self.motion.T[moving > 0.0]), default=0.0)
        if period == 0.0:
            raise DatabaseError(f"{self.source}: nothing moves in it")
        whole = _closed(self.motion, self.interval, period)
        spectrum = 2.0 * np.fft.rfft(whole, axis=0) / len(whole)
        # A record goes as exp(iωt) there; half of its harmonics say all.
        powers = 0.5 * np.abs(spectrum) ** 2
        beyond = np.cumsum(powers[::-1], axis=0)[::-1]
        needed = (beyond > (_LEFT_OUT * moving) ** 2) & (moving > 0.0)
        last = int(np.flatnonzero(needed.any(axis=1))[-1])
        if last > _MOST_WAVES:
            shortest = len(whole) * self.interval / last
            raise DatabaseError(
                f"{self.source}: it takes {last} waves, down to {shortest:.2g} s, to come as near as "
                f"{100 * _LEFT_OUT:g} % to it, and {_MOST_WAVES} are allowed: filter its noise, or take a "
                "shorter part"
            )
        kept = spectrum[1 : last + 1]
        omega: Array = 2.0 * math.pi * np.arange(1.0, last + 1.0) / (len(whole) * self.interval)
        return Harmonics(omega, np.conj(kept), period)


def read_motion_record(path: str | Path) -> MotionRecord:
    """A record of motion.

    Its first line names the columns with their units, `time [s]` and any of `surge [m]`, `sway [m]`,
    `heave [m]`, `roll [deg]`, `pitch [deg]`, `yaw [deg]`; every other line is one sample, at even times.
    What has no column does not move.

    Args:
        path: of the file.

    Raises:
        DatabaseError: if it cannot be read, with the line, in one plain sentence.
    """
    place = Path(path)
    columns, lines = read_table(place, _TITLES)
    if len(columns) < 2:
        raise DatabaseError(f"{place}:1: there is no motion beside the time; {_TITLES.right} are right")
    times: list[float] = []
    samples: list[list[float]] = []
    for number, said in lines:
        times.append(said["time"])
        if wrong := _uneven(times):
            raise DatabaseError(f"{place}:{number}: {wrong}")
        samples.append([said.get(axis, 0.0) for axis in AXES])
        if len(times) > _MOST_SAMPLES:
            raise DatabaseError(f"{place}:{number}: more than {_MOST_SAMPLES} samples; leave every other out")
    if len(times) < _FEWEST:
        raise DatabaseError(f"{place}: has {len(times)} samples; no fewer than {_FEWEST} tell a motion")
    motion = np.array(samples)
    mean = motion.mean(axis=0)
    motion = motion - mean
    for place_of, axis in enumerate(AXES):
        most, unit = (_FARTHEST[0], "m") if place_of < 3 else (_FARTHEST[1], "rad")
        farthest = float(np.abs(motion[:, place_of]).max())
        if farthest > most:
            raise DatabaseError(f"{place}: {axis} goes {farthest:.3g} {unit} from its mean; see its unit")
    interval = (times[-1] - times[0]) / (len(times) - 1)
    return MotionRecord(place.name, interval, motion, mean)


def write_motion_record(record: MotionRecord, path: str | Path) -> None:
    """Write a record that `read_motion_record` reads, turns in degrees.

    Args:
        record: any.
        path: of the file, `.csv`.
    """
    units = np.repeat([1.0, _TURN["deg"]], 3)
    with Path(path).open("w", encoding="utf-8", newline="") as file:
        file.write(",".join(f"{name} [{next(iter(unit))}]" for name, unit in _UNITS.items()) + "\n")
        for number, sample in enumerate((record.motion + record.mean) / units):
            values = [number * record.interval, *sample]
            file.write(",".join(f"{value:.12g}" for value in values) + "\n")


def _uneven(times: list[float]) -> str:
    """What is wrong with the last of the times of samples so far [s], if anything is."""
    if len(times) < 2:
        return ""
    first, last = times[1] - times[0], times[-1] - times[-2]
    if not first > 0.0:
        return f"{times[-1]:g} s is not after the line before"
    if abs(last - first) > _UNEVEN * first:
        between = f"{last:.6g} s after the line before, and {first:.6g} s lie between the first two"
        return f"{between}; times at even intervals are right"
    return ""


def _mean_period(way: Array, interval: float) -> float:
    """Mean time between passages of the mean on the way up [s]."""
    ups = int(np.count_nonzero((way[:-1] < 0.0) & (way[1:] >= 0.0)))
    return (len(way) - 1) * interval / max(ups, 1)


def _closed(motion: Array, interval: float, period: float) -> Array:
    """A motion and its way back from the last sample to the first, with three derivatives of both ends.

    On the whole its mean is none, as that of the motion.
    """
    from scipy.interpolate import BPoly, make_interp_spline  # takes a while to load

    count = len(motion)
    ends = make_interp_spline(interval * np.arange(count), motion, k=7)
    last = (count - 1) * interval
    steps = max(8, math.ceil(_PERIODS_BACK * period / interval))
    long = steps * interval
    tips = [[ends(time, nu=order) for order in range(4)] for time in (last, 0.0)]
    back = BPoly.from_derivatives([0.0, long], tips)
    share = np.arange(1, steps)[:, None] / steps
    way, bump = back(long * share[:, 0]), (share * (1.0 - share)) ** 4
    return np.concatenate([motion, way - bump * (way.sum(axis=0) / bump.sum())])
