"""Distances that are watched, and supports: warnings, and when a distance is too small."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rig import Rig, Watch
from gantline.results.variable import BoolArray, Columns, FloatArray, Names
from gantline.units import length_digits, telling_digits

__all__ = ["clearance_events", "contact_warnings", "watched_during", "watched_span"]

#: A sample at the time of an event shows a support before it was taken away; rounding of that time [s].
_AT_ONCE = 1e-9
#: A support that bears less is taken away from under nothing, as planned [N].
_NOTHING = 500.0


def clearance_events(
    rig: Rig, columns: dict[str, FloatArray], names: dict[str, list[str]]
) -> tuple[dict[str, FloatArray], dict[str, list[str]]]:
    """Columns and names with an event whenever a watched distance becomes too small and large enough again.

    Their kinds are `too_close` and `clear_again`. Between samples the distance is taken as straight; a pair
    that is too close from the first sample on is so at its time.
    """
    found = [event for watch in rig.watches for event in _crossings(watch, columns, names)]
    if not found:
        return columns, names
    own = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    every = sorted([*((float(time), kind, name) for time, kind, name in own), *found], key=lambda one: one[0])
    times = np.array([time for time, _, _ in every])
    kinds, subjects = [kind for _, kind, _ in every], [name for _, _, name in every]
    return {**columns, "event_time": times}, {**names, "event_kind": kinds, "event_name": subjects}


def watched_span(watch: Watch, events: Iterable[tuple[float, str, str]]) -> tuple[float, float]:
    """From when to when a pair is held against its distance [s]; infinite where nothing says so.

    Args:
        watch: The pair.
        events: Time [s], kind and name of each. A step that has not begun does so at infinity.
    """
    begin, end = (math.inf if watch.from_step else -math.inf), math.inf
    for time, kind, name in events:
        if kind == "step_begin" and name == watch.from_step:
            begin = time
        if kind == "step_end" and name == watch.to_step:
            end = time
    return begin, end


def watched_during(recording: Recording, watch: Watch) -> BoolArray:
    """Samples at which a pair is held against its distance, shape (time,)."""
    begin, end = watched_span(watch, recording.events())
    if recording.is_equilibrium:
        # It has its own moment alone, and steps that are over then are not looked at.
        during: BoolArray = (recording.time >= begin) & (recording.time <= end)
        return during
    return _samples_of(recording.time, begin, end)


def _samples_of(time: FloatArray, begin: float, end: float) -> BoolArray:
    """Samples within a span, shape (time,); of one that lies between two samples the one nearest to it."""
    inside: BoolArray = (time >= begin) & (time <= end)
    if len(time) and not inside.any() and time[0] < begin <= end < time[-1]:
        inside[int(np.argmin(np.abs(time - 0.5 * (begin + end))))] = True
    return inside


def _span(watch: Watch, columns: Columns, names: Names) -> tuple[float, float]:
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    return watched_span(watch, events)


def _margin(watch: Watch, columns: Columns, names: Names) -> FloatArray:
    """How much farther apart a pair is than it has to be (time,) [m]; rounding of a touch is none."""
    margin: FloatArray = columns["clearance"][:, list(names["pair"]).index(watch.name)] - watch.smallest
    return margin


def _crossings(watch: Watch, columns: Columns, names: Names) -> Iterator[tuple[float, str, str]]:
    begin, end = _span(watch, columns, names)
    during = _samples_of(columns["time"], begin, end)
    time, margin = columns["time"][during], _margin(watch, columns, names)[during]
    close = _is_close(watch, margin)
    if len(time) and close[0]:
        yield float(min(max(time[0], begin), end)), "too_close", watch.name
    for at in np.flatnonzero(close[1:] != close[:-1]):
        before, after = margin[at], margin[at + 1]
        # Where ropes have parted there is no distance any more.
        share = before / (before - after) if np.isfinite(after) and before != after else 1.0
        moment = time[at] + min(max(share, 0.0), 1.0) * (time[at + 1] - time[at])
        yield float(moment), "too_close" if close[at + 1] else "clear_again", watch.name


def _is_close(watch: Watch, margin: FloatArray) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Samples at which a pair is too close: below its limit, or touching where that is 0."""
    return margin < 0.0 if watch.smallest > 0.0 else margin <= 0.0


def contact_warnings(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """Pairs that came too close, supports that were taken away or that the load left beyond their edges."""
    warnings = []
    time = columns["time"]
    for watch in rig.watches if len(time) else ():
        begin, end = _span(watch, columns, names)
        during = _samples_of(time, begin, end)
        margin = np.where(during, _margin(watch, columns, names), np.inf)
        close = _is_close(watch, margin)
        if not close.any():
            continue
        first, worst = int(np.argmax(close)), int(np.argmin(margin))
        least = margin[worst] + watch.smallest
        one, other = watch.between
        if least <= 0.0:
            warnings.append(f"{one} and {other} touch, for the first time at {time[first]:.2f} s")
        else:
            digits = telling_digits(least, watch.smallest, "m", length_digits(least))
            sentence = f"{one} comes within {least:.{digits}f} m of {other} at {time[worst]:.2f} s"
            warnings.append(f"{sentence}, below {watch.smallest:g} m from {time[first]:.2f} s on")
    for moment, kind, name in zip(
        columns["event_time"], names["event_kind"], names["event_name"], strict=True
    ):
        if kind == "support_removed":
            force = _force_before(columns, names, name, float(moment))
            if moment <= time[0] + _AT_ONCE:  # no sample shows what it bore
                warnings.append(f"{name} is taken away as the run begins, whatever stands on it")
            elif force > _NOTHING:
                warnings.append(f"{name} is taken away at {moment:.2f} s under {force / 1e3:.0f} kN")
        elif kind == "off_support":
            warnings.append(f"the load leaves {name} beyond its edge at {moment:.2f} s")
    return warnings


def _force_before(columns: Columns, names: Names, contact: str, moment: float) -> float:
    """Force of a contact at the last sample up to a moment [N]."""
    before = int(np.searchsorted(columns["time"], moment + _AT_ONCE, side="right")) - 1
    return float(columns["contact_force"][max(before, 0), list(names["contact"]).index(contact)])
