"""What comes by as a sum of regular waves that travel: the surface of the water, gusts of the wind."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.results.strength import FromJson
from gantline.results.variable import FloatArray

__all__ = ["Trains"]

#: Steps from point to point that differ by less are equal [m].
_EVEN = 1e-11
#: Decimals to which that is so [m].
_DIGITS = 12
#: Samples that are looked at together at points of a body: few enough to stay in the cache.
_AT_ONCE = 4096


@dataclass(frozen=True)
class Trains(FromJson):
    """η = g(t) Σ a cos(k·x − ωt + ε), g growing from 0 to 1 with two derivatives.

    Attributes:
        components: regular waves: `frequency` ω [rad/s], `wave_number` k, world x and y [rad/m],
            `amplitude` a [m, of gusts m/s], `phase` ε [rad].
        rise_time: in which they grow [s].
    """

    components: Sequence[Mapping[str, Any]] = ()
    rise_time: float = 1.0

    def at(self, time: FloatArray, place: FloatArray) -> FloatArray:
        """η [m, of gusts m/s].

        Args:
            time: (samples,) [s].
            place: world x and y (samples, ..., 2) [m].

        Returns:
            (samples, ...).
        """
        beside = (slice(None), *[None] * (place.ndim - 2))
        found = np.zeros(place.shape[:-1])
        for wave in self.components:
            x, y = wave["wave_number"]
            along = x * place[..., 0] + y * place[..., 1]
            found += wave["amplitude"] * np.cos(along - wave["frequency"] * time[beside] + wave["phase"])
        return found * self._growth(time)[beside]

    def at_body(
        self, time: FloatArray, origin: FloatArray, turn: FloatArray, points: FloatArray
    ) -> FloatArray:
        """η [m, of gusts m/s] at points of a body.

        Along a row of points a wave's phase grows by the same angle from each to the next: cos and sin of
        that do for all of the row.

        Args:
            time: (samples,) [s].
            origin: Of the body, (samples, 3) [m].
            turn: World from body, (samples, 3, 3).
            points: In its axes, (points, 3) [m].

        Returns:
            (samples, points).
        """
        found = np.empty((len(time), len(points)))
        for first in range(0, len(time), _AT_ONCE):
            some = slice(first, first + _AT_ONCE)
            found[some] = self._along(_rows(points), time[some], origin[some], turn[some], points)
        return found

    def _along(
        self,
        rows: Sequence[range],
        time: FloatArray,
        origin: FloatArray,
        turn: FloatArray,
        points: FloatArray,
    ) -> FloatArray:
        """As `at_body`, of points in rows."""
        firsts = np.array([origin[:, :2] + turn[:, :2] @ points[row.start] for row in rows])
        steps: dict[tuple[float, ...], FloatArray] = {}
        for row in rows:
            steps.setdefault(_step(points, row), turn[:, :2] @ np.array(_step(points, row)))
        found = np.zeros((len(points), len(time)))
        for wave in self.components:
            number = np.array(wave["wave_number"])
            phases = firsts @ number + (wave["phase"] - wave["frequency"] * time)
            turned = {step: _on_circle(way @ number) for step, way in steps.items()}
            for row, phase in zip(rows, phases, strict=True):
                height, turns = wave["amplitude"] * _on_circle(phase), turned[_step(points, row)]
                for place in range(row.start, row.stop):
                    found[place] += height.real
                    height *= turns
        return found.T * self._growth(time)[:, None]

    def _growth(self, time: FloatArray) -> FloatArray:
        """g(t), shape (samples,)."""
        share = np.clip(time / self.rise_time, 0.0, 1.0)
        growth: FloatArray = share**3 * (10.0 - share * (15.0 - 6.0 * share))
        return growth


def _on_circle(angle: FloatArray) -> npt.NDArray[np.complex128]:
    """Points of the unit circle, cos + i sin, at angles [rad], in their shape."""
    found = np.empty(angle.shape, dtype=np.complex128)
    np.cos(angle, out=found.real)
    np.sin(angle, out=found.imag)
    return found


def _step(points: FloatArray, row: range) -> tuple[float, ...]:
    """From one point of a row to the next, (3,) [m]; zero of a single one."""
    way = (points[row[-1]] - points[row[0]]) / max(len(row) - 1, 1)
    return tuple(np.round(way, _DIGITS).tolist())


def _rows(points: FloatArray) -> list[range]:
    """Points that follow each other by equal steps, as places in an array (points, 3) [m]."""
    if not len(points):
        return []
    steps = np.diff(points, axis=0)
    rows, start = [], 0
    while start < len(points):
        end = start + 1
        while end < len(points) and np.abs(steps[end - 1] - steps[start]).max() <= _EVEN:
            end += 1
        rows.append(range(start, end))
        start = end
    return rows
