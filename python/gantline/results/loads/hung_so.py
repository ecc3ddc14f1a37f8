"""Whether loads ever hung still as they hang at some other time, so that forces of both may be compared."""

from __future__ import annotations

import numpy as np

from gantline.results import series
from gantline.results.loads.hinges import shut_as_at
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.ropes.parting import DETACHED, PARTING, while_there
from gantline.results.ropes.pinned import pinned_as_at
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

__all__ = [
    "has_hung_as_heavy",
    "has_hung_so",
    "how_on_the_way",
    "hung_otherwise",
    "left_by_water",
    "most_on_the_way",
    "never_hung_so",
    "on_the_way",
    "tells_dynamics",
    "window_of_most",
]

#: By what share of a load more is left to bear than while it hung still, which is no dynamics then [1].
_HEAVIER = 0.02


#: Share of the peak of a sling below which its static force is that of a slack one [1]; chosen here.
_SLACK = 0.05


def tells_dynamics(static: float, peak: float) -> bool:
    """Whether the peak of a sling over its static force [N] is a dynamic factor.

    Of one that hangs all but slack at rest, beside others that were meant to share, it is any number.
    """
    return static >= _SLACK * peak


def has_hung_so(recording: Recording, time: float, *, of_slings: bool = False) -> bool:
    """Whether the loads ever hung still on the slings that are on at a time [s], turned as they are then.

    Where they did not, a force of that time has no static value to be compared with: what slings that came or
    went left to the others, or a hinge that opened, or what one hook hands to another as a load is turned,
    is no dynamics. Nor is what a load weighs more that comes out of the water, or has been filled, than
    whenever it hung still. Nor is how slings share under locking pins, or with those whole that were cut or
    broke: of forces `of_slings` the same sheaves have to be pinned and the same slings whole.
    """
    return hung_otherwise(recording, time, of_slings=of_slings) == []


def hung_otherwise(recording: Recording, time: float, *, of_slings: bool = False) -> list[str] | None:
    """In what the loads, whenever they hung still, hung otherwise than at a time [s], as halves of sentences.

    Of several times that which is most like it counts. Empty where they hung so, see `has_hung_so`; None
    where they hung still at no time.
    """
    windows = series.quiet_windows(recording)
    if not windows:
        return None
    gone_by = PARTING if of_slings else [DETACHED]
    on = while_there(recording, [sling.rope for sling in recording.rig.slings], gone_by)
    # Between two samples either may be right: what comes or goes is slack.
    last = len(recording.time) - 1
    after = min(int(np.searchsorted(recording.time, time, side="right")), last)
    around = [on[:, place, np.newaxis] for place in (max(after - 1, 0), after)]
    slings = "other slings were on or whole" if of_slings else "other slings were on"
    alike = {
        "water bore more of it or less was in its tanks": _still_as_heavy(recording, time),
        "hinges held it otherwise": shut_as_at(recording, time),
        "it was turned by more than 10 deg otherwise": series.turned_as_at(recording, after),
        slings: np.any([(on == then).all(axis=0) for then in around], axis=0),
    }
    if of_slings:
        alike["other sheaves were pinned"] = pinned_as_at(recording, time)
    samples = np.array(list(alike.values()))[:, np.any(windows, axis=0)]
    most = samples[:, int(np.argmax(samples.sum(axis=0)))]
    return [words for words, is_so in zip(alike, most, strict=True) if not is_so]


def never_hung_so(recording: Recording) -> BoolArray:
    """Samples as which the loads never hung still, in these slings, turned and filled so, shape (time,).

    None of loads that hung still at no time, of which nothing static is known, and of loads in water, which
    hang with other weights there.
    """
    return recording.kept("never_hung_so", lambda: _found_never(recording))


def _found_never(recording: Recording) -> BoolArray:
    windows = series.quiet_windows(recording)
    if not windows or any(load.in_water is not None for load in recording.rig.loads):
        return np.zeros(len(recording.time), dtype=np.bool_)
    on = while_there(recording, [sling.rope for sling in recording.rig.slings], [DETACHED])
    alike = np.zeros(len(recording.time), dtype=np.bool_)
    for window in windows:
        at = int(np.flatnonzero(window)[-1])
        with_these = (on == on[:, at, np.newaxis]).all(axis=0)
        so = shut_as_at(recording, float(recording.time[at])) & series.turned_as_at(recording, at)
        alike |= window | (with_these & so & _filled_as_at(recording, at))
    return ~alike


def _filled_as_at(recording: Recording, sample: int) -> BoolArray:
    """Samples at which tanks of loads hold what they hold at one, shape (time,).

    What runs from one end of a load to the other changes what slings bear as much as what runs out.
    """
    alike = np.ones(len(recording.time), dtype=np.bool_)
    for load in recording.rig.loads:
        enough = _HEAVIER * float(series.load_weight(recording, load).max())
        for tank in load.tanks:
            held = recording.rig.gravity * recording.column("tank_content", tank)
            alike &= np.abs(held - held[sample]) <= enough
    return alike


def on_the_way(recording: Recording) -> BoolArray:
    """The same, with those at which loads partly stand, shape (time,).

    One that is let down on one corner may leave the sling across twice of what it bore as the load hung.
    """
    never = never_hung_so(recording)
    if not series.quiet_windows(recording) or any(one.in_water is not None for one in recording.rig.loads):
        return never
    return never | ~series.is_clear(recording)


def window_of_most(recording: Recording, values: FloatArray) -> BoolArray:
    """The time of which a force has its static value, shape (time,).

    That is where the loads hung still, or on the way from or to such a time, if it is more there and no force
    of what is all but slack.

    Args:
        recording: The recording.
        values: The force, shape (time,).
    """
    static, window = series.greatest_static(recording, values)
    way = most_on_the_way(recording, values, on_the_way(recording))
    if static is None or way is None:
        return window
    more = series.static_value(recording, values, way) or 0.0
    counts = series.is_more(more, static) and tells_dynamics(more, float(values.max()))
    return way if counts else window


def most_on_the_way(recording: Recording, values: FloatArray, among: BoolArray) -> BoolArray | None:
    """The time at which a series is largest as a mean over as long as loads hang still at least.

    Args:
        recording: The recording.
        values: The series, shape (time,).
        among: Samples that count, shape (time,).

    Returns:
        Its samples, shape (time,); None where none of these go on for so long, and of an equilibrium.
    """
    if recording.is_equilibrium:
        return None
    lasts = series.time_to_hang_still(recording.rig)
    changes = np.flatnonzero(np.diff(np.concatenate(([False], among, [False])).astype(np.int8)))
    most, found = -np.inf, (0.0, -1.0)
    # A load that bounces has hundreds of stretches, most of them too short.
    for first, after in changes.reshape(-1, 2):
        times, of_stretch = recording.time[first:after], values[first:after]
        begins = times[times + lasts <= times[-1]]
        if not begins.size:
            continue
        steps = np.diff(times) * (of_stretch[1:] + of_stretch[:-1]) / 2.0
        sums = np.append(0.0, np.cumsum(steps))
        means = (np.interp(begins + lasts, times, sums) - sums[: begins.size]) / lasts
        at = int(np.argmax(means))
        if means[at] > most:
            most, found = float(means[at]), (float(begins[at]), float(begins[at]) + lasts)
    window: BoolArray = (recording.time >= found[0]) & (recording.time <= found[1])
    return window if window.any() else None


def how_on_the_way(recording: Recording, window: BoolArray | None) -> str:
    """In words, when a time on the way was, shape (time,); empty of one at which the loads hung still."""
    if window is None or not window.any() or np.any(series.quiet_windows(recording), axis=0)[window].any():
        return ""
    how = "between holds" if series.is_clear(recording)[window].all() else "partly standing"
    return f"{how}, about {format_quantity(float(recording.time[window].mean()), 's', 0)}"


def has_hung_as_heavy(recording: Recording, time: float, window: BoolArray | None = None) -> bool:
    """Whether of every load as much was left to bear in some time that it hung still as is at a time [s].

    Args:
        recording: The recording.
        time: The time [s].
        window: Another time of which forces have their static value, between two of these, shape (time,).
    """
    still = bool(_still_as_heavy(recording, time).any())
    return still or (window is not None and _are_as_heavy(recording, time, window))


def left_by_water(recording: Recording, load: Load) -> FloatArray:
    """What a load weighs with what is in its tanks, less what water carries of it [N], shape (time,)."""
    weight = series.load_weight(recording, load)
    if load.in_water is None:
        return weight
    displaced = recording.column("displaced_volume", load.in_water)
    left: FloatArray = weight - load.water_density * recording.rig.gravity * displaced
    return left


def _still_as_heavy(recording: Recording, time: float) -> BoolArray:
    """Samples of all times that the loads hung still with no less left to bear than at a time [s].

    Of loads in waves the mean about it counts, over as long as static values are means over: what the waves
    leave of them from crest to trough is dynamics.
    """
    still = np.zeros(len(recording.time), dtype=np.bool_)
    for window in series.quiet_windows(recording):
        if _are_as_heavy(recording, time, window):
            still |= window
    return still


def _are_as_heavy(recording: Recording, time: float, window: BoolArray) -> bool:
    changing = [one for one in recording.rig.loads if one.in_water is not None or one.tanks]
    return all(_is_as_heavy(recording, load, time, window) for load in changing)


def _is_as_heavy(recording: Recording, load: Load, time: float, window: BoolArray) -> bool:
    left = left_by_water(recording, load)
    half = recording.rig.time_to_average / 2.0
    about = np.abs(recording.time - time) <= half
    then = float(left[about].mean()) if about.any() else float(np.interp(time, recording.time, left))
    hung = series.static_value(recording, left, window)
    return hung is None or then <= hung + _HEAVIER * float(series.load_weight(recording, load).max())
