"""How a vessel moved, as a table over time, and the waves that add up to it.

A motion that comes by as a sum of waves has all derivatives that drives need, at any time. So a record is
taken as one period of something that goes on for ever: after its end it goes back to where it began, as
smoothly as it was told, and the sum of its harmonics goes through every sample but for what of them is left
out, those that are too fast to be any motion of a vessel or too small to count.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import numpy.typing as npt
from numpy.polynomial import Legendre

from gantline.arguments import path_of
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
#: Times are even to this share of the interval, or of their last decimal, as of 0.33, 0.67, 1.00. The decimal
#: is to be no wider than so much of the interval: a line that is missing leaves a time half of one away.
_UNEVEN, _OF_DECIMAL, _WIDEST_DECIMAL = 1e-3, 0.75, 0.65
#: The most decimals of numbers that are looked for.
_DECIMALS = 9
#: What harmonics that are left out may move, root mean square, of what the record does.
_LEFT_OUT = 1e-3
#: Numbers that are told to a decimal d are off by d/√12, root mean square; that is not followed.
_OF_ROUNDING = math.sqrt(12.0)
#: What the last decimal may leave open of a motion untold, root mean square.
_COARSE = 0.05
#: The most waves that a record is made of. More are no motion of a vessel but noise of what measured it.
_MOST_WAVES = 2000
#: The way back to the beginning takes so many mean periods, of which the longest swell has the longest [s]: a
#: drift that passes its mean once has one as long as the record.
_PERIODS_BACK, _LONGEST_PERIOD = 3.0, 20.0
#: Derivatives at an end are those of a polynomial of this degree through this share of a mean period there:
#: noise of single samples is not taken for them. It has to come as near as one through half of that does.
_DEGREE, _SHARE_OF_PERIOD, _AS_NEAR = 7, 0.5, 2.0
#: The fewest samples of such a polynomial, and how near is near enough of what the record does.
_FEWEST_AT_END, _NEAR_ENOUGH = 10, 2e-4
#: Waves that are shorter are none of a vessel [s], and what of an acceleration they may have untold.
_NO_VESSEL, _UNTOLD = 2.0, 0.2


@dataclass(frozen=True, eq=False)
class Harmonics:
    """Waves that add up to a motion: Re Σ X exp(-iωt), from its mean.

    Attributes:
        frequency: ω, rising (n,) [rad/s].
        motion: X (n, 6) [m, rad].
        period: mean period of the motion that has the slowest, 20 s at most [s].
    """

    frequency: Array
    motion: Complex
    period: float

    def at(self, time: Array) -> Array:
        """The motion at these times (k,) [s], shape (k, 6) [m, rad]."""
        found: Array = (np.exp(-1j * np.outer(time, self.frequency)) @ self.motion).real
        return found

    @property
    def too_fast(self) -> tuple[str, float] | None:
        """The motion of whose acceleration waves shorter than 2 s have the largest share, rms, and that.

        None where it is less than a fifth in all: a bound chosen here.
        """
        powers = np.abs(self.frequency[:, None] ** 2 * self.motion) ** 2
        fast, whole = powers[self.frequency > 2.0 * math.pi / _NO_VESSEL].sum(axis=0), powers.sum(axis=0)
        shares = np.sqrt(fast / np.where(whole > 0.0, whole, 1.0))
        most = int(np.argmax(shares))
        return (AXES[most], float(shares[most])) if shares[most] > _UNTOLD else None


@dataclass(frozen=True, eq=False)
class MotionRecord:
    """How a point of a vessel moved, from its mean.

    Attributes:
        source: name of its file.
        interval: between samples [s].
        motion: surge, sway, heave along level axes of the vessel's heading, turns by roll, pitch and yaw
            (n, 6) [m, rad].
        mean: what was taken off (6,) [m, rad].
        decimal: the last to which its table tells each motion (6,) [m, rad]; 0 where it is known to any.
    """

    source: str
    interval: float
    motion: Array
    mean: Array
    decimal: Array = field(default_factory=lambda: np.zeros(6))

    @property
    def coarse(self) -> tuple[str, float] | None:
        """The motion of which the last decimal leaves most open, root mean square, and what share of it.

        None where it is less than a twentieth in all: a bound chosen here.
        """
        moving = self.motion.std(axis=0)
        shares = self.decimal / _OF_ROUNDING / np.where(moving > 0.0, moving, np.inf)
        most = int(np.argmax(shares))
        return (AXES[most], float(shares[most])) if shares[most] > _COARSE else None

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
        if not moving.any():
            raise DatabaseError(f"{self.source}: nothing moves in it")
        period = max(_mean_period(way, self.interval) for way in self.motion.T[moving > 0.0])
        whole = _closed(self.motion, self.interval, period)
        spectrum = 2.0 * np.fft.rfft(whole, axis=0) / len(whole)
        # A record goes as exp(iωt) there; half of its harmonics say all.
        powers = 0.5 * np.abs(spectrum) ** 2
        beyond = np.cumsum(powers[::-1], axis=0)[::-1]
        open_ = (_LEFT_OUT * moving) ** 2 + (self.decimal / _OF_ROUNDING) ** 2
        needed = ((beyond > open_) & (moving > 0.0)).any(axis=1)
        if not needed.any():
            raise DatabaseError(f"{self.source}: nothing moves in it by more than its last decimal")
        last = int(np.flatnonzero(needed)[-1])
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
    place = path_of(path, "the file of a motion record")
    columns, lines = read_table(place, _TITLES)
    if len(columns) < 2:
        raise DatabaseError(f"{place}:1: there is no motion beside the time; {_TITLES.right} are right")
    times: list[float] = []
    samples: list[list[float]] = []
    numbers: list[int] = []
    for number, said in lines:
        if times and not said["time"] > times[-1]:
            raise DatabaseError(f"{place}:{number}: {said['time']:g} s is not after the line before")
        times.append(said["time"])
        numbers.append(number)
        samples.append([said.get(axis, 0.0) for axis in AXES])
        if len(times) > _MOST_SAMPLES:
            raise DatabaseError(f"{place}:{number}: more than {_MOST_SAMPLES} samples; leave every other out")
    if len(times) < _FEWEST:
        raise DatabaseError(f"{place}: has {len(times)} samples; no fewer than {_FEWEST} tell a motion")
    even, interval = _even(np.array(times))
    if even is not None:
        apart = f"{times[even] - times[even - 1]:.6g} s after the line before"
        most = f"most lines are {interval:.6g} s apart"
        raise DatabaseError(
            f"{place}:{numbers[even]}: {apart}; {most}, and times at even intervals are right"
        )
    motion = np.array(samples)
    decimals = np.array([_decimal(way) for way in motion.T])
    # Turns may have been told in degrees.
    decimals[3:] = [
        max(one, _TURN["deg"] * _decimal(way / _TURN["deg"]))
        for one, way in zip(decimals[3:], motion.T[3:], strict=True)
    ]
    mean = motion.mean(axis=0)
    motion = motion - mean
    for place_of, axis in enumerate(AXES):
        bound, unit = (_FARTHEST[0], "m") if place_of < 3 else (_FARTHEST[1], "rad")
        farthest = float(np.abs(motion[:, place_of]).max())
        if farthest > bound:
            raise DatabaseError(f"{place}: {axis} goes {farthest:.3g} {unit} from its mean; see its unit")
    return MotionRecord(place.name, interval, motion, mean, decimals)


def write_motion_record(record: MotionRecord, path: str | Path) -> None:
    """Write a record that `read_motion_record` reads, turns in degrees.

    Args:
        record: any.
        path: of the file, `.csv`.
    """
    units = np.repeat([1.0, _TURN["deg"]], 3)
    with path_of(path, "a file to write").open("w", encoding="utf-8", newline="") as file:
        file.write(",".join(f"{name} [{next(iter(unit))}]" for name, unit in _UNITS.items()) + "\n")
        for number, sample in enumerate((record.motion + record.mean) / units):
            values = [number * record.interval, *sample]
            file.write(",".join(f"{value:.12g}" for value in values) + "\n")


def _even(time: Array) -> tuple[int | None, float]:
    """Which of the times (n,) [s] is not at even intervals, None if all are, and the interval [s].

    They are held against the straight line through all: of times that are told to a few decimals, 0.33 s,
    0.67 s, 1 s, single intervals differ by much more than any time is away from its place.
    """
    apart = np.diff(time)
    interval = float(np.median(apart))
    counts = np.arange(len(time)) - 0.5 * (len(time) - 1)
    slope = float(counts @ time / (counts @ counts))
    away = np.abs(time - time.mean() - slope * counts)
    decimal = _decimal(time)
    rounded = _OF_DECIMAL * decimal if decimal <= _WIDEST_DECIMAL * slope else 0.0
    if float(away.max()) <= max(_UNEVEN * slope, rounded):
        return None, slope
    return 1 + int(np.argmax(np.abs(apart - interval))), interval


def _decimal(numbers: Array) -> float:
    """The last decimal to which numbers are told: 0.01 of 0.33, 0.67, 1."""
    for decimals in range(_DECIMALS):
        scaled = numbers * 10.0**decimals
        if np.abs(scaled - np.round(scaled)).max() < 1e-6:
            return 10.0**-decimals
    return 0.0


def _mean_period(way: Array, interval: float) -> float:
    """Mean time between passages of the mean on the way up, 20 s at most [s]."""
    ups = int(np.count_nonzero((way[:-1] < 0.0) & (way[1:] >= 0.0)))
    return min((len(way) - 1) * interval / max(ups, 1), _LONGEST_PERIOD)


def _closed(motion: Array, interval: float, period: float) -> Array:
    """A motion and its way back from the last sample to the first, with three derivatives of both ends.

    On the whole its mean is none, as that of the motion.
    """
    from scipy.interpolate import BPoly  # takes a while to load

    steps = max(8, math.ceil(_PERIODS_BACK * period / interval))
    long = steps * interval
    ends = [[_end(way, interval) for way in part.T] for part in (motion[::-1], motion)]
    # (order, motion) of either end; the last samples were seen backwards, so that odd derivatives turn.
    last, first = (np.array(end).T for end in ends)
    back = BPoly.from_derivatives([0.0, long], [last * np.array([[1.0], [-1.0], [1.0], [-1.0]]), first])
    share = np.arange(1, steps)[:, None] / steps
    way, bump = back(long * share[:, 0]), (share * (1.0 - share)) ** 4
    return np.concatenate([motion, way - bump * (way.sum(axis=0) / bump.sum())])


def _end(way: Array, interval: float) -> Array:
    """One motion (n,) at its first sample, and its first three derivatives there (4,) [m or rad, s]."""
    enough = _NEAR_ENOUGH * float(way.std())
    count = min(
        len(way), max(_FEWEST_AT_END, round(_SHARE_OF_PERIOD * _mean_period(way, interval) / interval))
    )
    found, missed = _fitted(way[:count])
    while count > _FEWEST_AT_END:
        half = max(_FEWEST_AT_END, count // 2)
        nearer, less = _fitted(way[:half])
        if missed <= _AS_NEAR * less + enough:
            break
        found, missed, count = nearer, less, half
    reach = 0.5 * (count - 1) * interval
    slopes = [float(found.deriv(order)(-1.0)) / reach**order for order in (1, 2, 3)]
    return np.array([float(way[0]), *slopes])


def _fitted(way: Array) -> tuple[Legendre, float]:
    """The polynomial through samples over -1 to 1, and what it misses, rms over what it leaves free."""
    place = np.linspace(-1.0, 1.0, len(way))
    found = Legendre.fit(place, way, _DEGREE, domain=[-1.0, 1.0])
    return found, float(np.sqrt(((found(place) - way) ** 2).sum() / (len(way) - _DEGREE - 1)))
