"""Series over time that metrics, checks and plots share, so that each word has one definition.

- *supported force*: sum of the contact forces under a load.
- *clear*: samples at which no load has a supported force.
- *carrying*: samples at which a sling has more than 1 % of its largest tension; only then has it an angle.
- *yaw* of a load: change of its heading from the start, about plumb, counter-clockwise from above positive;
  of one whose x axis comes near plumb, as of a column that is upended, its turn about plumb.
- *quiet window*: the end of the recording over which static values are means. It begins when the last
  drive has come to rest (if that leaves at least 5 s, else when the loads came clear, or since when no sling
  has been put on and no load turned by more than 10 degrees from where it is at the end) and lasts to the
  end. Where the loads do not end clear it is the last earlier time that they hung still: clear, all drives
  but tuggers and winches that slip at rest, for 5 s or more. In waves it takes three of their longest
  periods in place of 5 s, if that is more, in gusts 20 s. The mean is weighted by sin^2, zero at both
  ends, so that a load that rings to and fro does not lift or lower it. Where the loads hung still in water
  alone, which bears a part of them, the longest time that they hung in the air counts too, moving or not,
  with as much in their tanks all along.
  The window of an equilibrium is its last sample, whether the loads are clear or not.
- *quiet windows*: that, and all earlier times that the loads hung still.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gantline.results.alike import earliest_peak, first_peak, nothing
from gantline.results.gear import Equalizer, Sheave, Sling, WrappedSheave
from gantline.results.loads.hinges import HINGE_OPENED
from gantline.results.loads.standing import all_stands
from gantline.results.recording import Recording
from gantline.results.rig import Load, Rig
from gantline.results.ropes.parting import ATTACHED, DETACHED, PARTING, while_there
from gantline.results.ropes.pinned import PIN_PULLED
from gantline.results.rotation import axes, heading, tilt, turn_about_plumb
from gantline.results.variable import BoolArray, FloatArray

_SHORTEST_QUIET = 5.0  # s
_CARRIED = 1e-3  # of the weight of a load, above rounding
_CARRIED_MORE = 1.001  # from which share of the last static value an earlier one counts in its place
_CARRYING_FROM = 0.01  # of the largest tension
_LOADED = 0.05  # of the most that the slings of an equalizer carry together
_STEEPEST = math.radians(80.0)  # x axis of a load over level; beyond it no heading means anything
_TURNED = math.radians(10.0)  # from where a load hung still, from which on hooks carry other shares


def support_force(recording: Recording, load: Load) -> FloatArray:
    """Force of all supports on a load [N], shape (time,)."""
    return recording.kept(("support_force", *load.contacts), lambda: _sum_of_contacts(recording, load))


def borne(recording: Recording, load: Load) -> FloatArray:
    """What supports bear of a load: their force upwards, with friction [N], shape (time,).

    Recordings of older versions have but the sizes of their forces.
    """
    known = "load_borne" in recording
    return recording.column("load_borne", load.name) if known else support_force(recording, load)


def _sum_of_contacts(recording: Recording, load: Load) -> FloatArray:
    total = np.zeros(len(recording.time))
    for contact in load.contacts:
        total += recording.column("contact_force", contact)
    return total


def load_weight(recording: Recording, load: Load) -> FloatArray:
    """What a load weighs with what is in its tanks [N], shape (time,)."""
    weight = np.full(len(recording.time), load.weight)
    for tank in load.tanks:
        weight += recording.rig.gravity * recording.column("tank_content", tank)
    return weight


def load_is_clear(recording: Recording, load: Load) -> BoolArray:
    """Samples at which nothing supports a load, shape (time,)."""
    clear: BoolArray = support_force(recording, load) <= 0.0
    return clear


def ends_partly_lifted(recording: Recording, load: Load) -> bool:
    """Whether at the last sample supports bear a load, and hooks some of it."""
    carried = float(recording.column("load_transferred", load.name)[-1])
    return carried > _CARRIED and not load_is_clear(recording, load)[-1]


def is_clear(recording: Recording) -> BoolArray:
    """Samples at which nothing supports any load, shape (time,); never for a lift without a load."""
    loads = recording.rig.loads
    clear = np.full(len(recording.time), bool(loads))
    for load in loads:
        clear &= load_is_clear(recording, load)
    return clear


def load_yaw(recording: Recording, load: Load) -> FloatArray | None:
    """Yaw of a load [rad], shape (time,); None if it is turned upside down or its attitude is unknown."""
    if "body_orientation" not in recording or load.body not in recording.coordinates.get("body", ()):
        return None
    turned = body_heading(recording, load.body)
    if np.isnan(turned).any():
        turned = turn_about_plumb(recording.column("body_orientation", load.body))
    if not len(turned) or np.isnan(turned).any():
        return None
    yaw: FloatArray = turned - turned[0]
    return yaw


def body_heading(recording: Recording, body: str) -> FloatArray:
    """Heading of a body without jumps [rad], shape (time,); NaN where its x axis comes near plumb."""
    orientation = recording.column("body_orientation", body)
    level = np.abs(axes(orientation)[:, 2, 0]) <= math.sin(_STEEPEST)
    found = np.full(len(orientation), np.nan)
    found[level] = np.unwrap(heading(orientation[level]))
    return found


def trailing(mask: BoolArray) -> BoolArray:
    """The run of true values at the end of a mask, shape (time,)."""
    false = np.flatnonzero(~mask)
    last = np.zeros_like(mask)
    last[false[-1] + 1 if false.size else 0 :] = True
    return last


def last_sample(recording: Recording) -> BoolArray:
    """The mask of the last sample alone, shape (time,)."""
    mask = _no_sample(recording)
    mask[-1:] = True
    return mask


def everywhere(recording: Recording) -> BoolArray:
    """The mask of all samples that count, shape (time,): of an equilibrium the last one."""
    return (
        last_sample(recording) if recording.is_equilibrium else np.ones(len(recording.time), dtype=np.bool_)
    )


def _no_sample(recording: Recording) -> BoolArray:
    return np.zeros(len(recording.time), dtype=np.bool_)


def quiet_window(recording: Recording) -> BoolArray:
    """Samples over which static values are means, shape (time,); all false if the loads never hung still."""
    return (quiet_windows(recording) or [_no_sample(recording)])[-1]


def quiet_windows(recording: Recording) -> list[BoolArray]:
    """Times that the loads hung still, in order, each of shape (time,); the last is the quiet window.

    None goes on where a rope parts, a locking pin is pulled or a hinge opens: what slings carry before and
    after has no mean.
    """
    return list(recording.kept("quiet_windows", lambda: np.array(_found_quiet(recording), dtype=np.bool_)))


def _found_quiet(recording: Recording) -> list[BoolArray]:
    if recording.is_equilibrium:
        return [last_sample(recording)]
    clear = is_clear(recording)
    for time, kind, _ in recording.events():
        if kind in (*PARTING, PIN_PULLED, HINGE_OPENED):
            clear[np.searchsorted(recording.time, time) :][:1] = False
    found, wet = _hung_still(recording, clear), is_wet(recording)
    if any(not (one & wet).any() for one in found) or not wet.any():
        return found
    in_air = [one for one in stretches(clear & ~wet & _contents_stand(recording)) if _lasts(recording, one)]
    return [max(in_air, key=np.count_nonzero), *found] if in_air else found


def moves_all_along(recording: Recording) -> bool:
    """True of a run whose loads never hung still for long enough: its static values are means over motion.

    What drives did must be known; else nothing tells.
    """
    if recording.is_equilibrium or "drive_work" not in recording.coordinates.get("energy_kind", ()):
        return False
    still = np.append(all_stands(recording), True)
    return bool(quiet_windows(recording)) and not any(still[one].all() for one in quiet_windows(recording))


def time_to_hang_still(rig: Rig) -> float:
    """How long loads hang still at least where static values are means over that [s]."""
    return max(_SHORTEST_QUIET, rig.time_to_average)


def is_wet(recording: Recording) -> BoolArray:
    """Samples at which water bears a part of any load, shape (time,)."""
    wet = _no_sample(recording)
    for load in recording.rig.loads:
        if load.in_water is not None:
            wet |= recording.column("displaced_volume", load.in_water) > 0.0
    return wet


def _contents_stand(recording: Recording) -> BoolArray:
    """Samples since the one before which nothing has been pumped into or out of a load, shape (time,)."""
    stand = np.ones(len(recording.time), dtype=np.bool_)
    for load in recording.rig.loads:
        if load.tanks:
            stand[1:] &= np.diff(load_weight(recording, load)) == 0.0
    return stand


def _hung_still(recording: Recording, clear: BoolArray) -> list[BoolArray]:
    """Times that the loads hung still, given the samples at which they are clear."""
    last = trailing(clear)
    earlier = []
    if "energy" in recording and "drive_work" in recording.coordinates["energy_kind"]:
        still = clear & np.append(all_stands(recording), True)
        earlier = [one for one in stretches(still) if _lasts(recording, one)]
        if earlier and earlier[-1][-1]:
            return earlier
    if not last.any():
        return earlier
    so = trailing(clear & _hangs_as_at_the_end(recording))
    if _lasts(recording, so):
        return [*earlier, so]
    # A mean over a turn, or over slings that were not on yet, tells less than an earlier time at rest.
    return earlier if earlier and (so < last).any() else [*earlier, last]


def turned_as_at(recording: Recording, sample: int) -> BoolArray:
    """Samples at which no load is turned by more than 10 degrees from where it is at one, shape (time,).

    What counts is where plumb is in the load: turned about plumb it hangs as it did.
    """
    alike = np.ones(len(recording.time), dtype=np.bool_)
    for load in recording.rig.loads:
        plumb = axes(recording.column("body_orientation", load.body))[:, 2, :]
        alike &= plumb @ plumb[sample] >= math.cos(_TURNED)
    return alike


def _hangs_as_at_the_end(recording: Recording) -> BoolArray:
    """Samples with loads turned as they are at the end, and no sling put on since, shape (time,)."""
    put_on = [time for time, kind, _ in recording.events() if kind == ATTACHED]
    since: BoolArray = recording.time > max(put_on, default=-np.inf)
    return since & turned_as_at(recording, -1)


def stretches(mask: BoolArray) -> list[BoolArray]:
    """Every run of true values of a mask, each of its shape."""
    begins = np.flatnonzero(mask & ~np.append(False, mask[:-1]))
    ends = np.flatnonzero(mask & ~np.append(mask[1:], False))
    found = []
    for begin, end in zip(begins, ends, strict=True):
        stretch = np.zeros_like(mask)
        stretch[begin : end + 1] = True
        found.append(stretch)
    return found


def _lasts(recording: Recording, stretch: BoolArray) -> bool:
    times = recording.time[stretch]
    return bool(times[-1] - times[0] >= time_to_hang_still(recording.rig))


def greatest_static(recording: Recording, values: FloatArray) -> tuple[float | None, BoolArray]:
    """Static value at that time that the loads hung still at which it was largest, and that time.

    A load that is turned, or goes from crane to crane, hangs still at its hold points with other forces than
    at the end. The last time counts unless an earlier value is more (`is_more`).

    Args:
        recording: The recording.
        values: A series, shape (time,).

    Returns:
        The mean, in the unit of `values`, None if the loads never hung still; and its quiet window.
    """
    *before_that, window = quiet_windows(recording) or [_no_sample(recording)]
    static = static_value(recording, values, window)
    for earlier in before_that:
        before = static_value(recording, values, earlier)
        if static is not None and before is not None and is_more(before, static):
            static, window = before, earlier
    return static, window


def is_more(earlier: float, later: float) -> bool:
    """Whether a force at an earlier time that the loads hung still counts more than at a later one.

    It is more by over a thousandth, which no swinging leaves in a mean.
    """
    return earlier > later * _CARRIED_MORE


def static_value(recording: Recording, values: FloatArray, window: BoolArray | None = None) -> float | None:
    """Mean over the quiet window.

    Args:
        recording: The recording.
        values: A series, shape (time,).
        window: The quiet window, if the caller has it already.

    Returns:
        The mean, in the unit of `values`; None if the lift has no quiet window.
    """
    inside = quiet_window(recording) if window is None else window
    times = recording.time[inside]
    if not times.size:
        return None
    if times.size < 3:
        return float(values[inside][-1])
    weights = recording.kept(("static_weights", inside.tobytes()), lambda: _static_weights(times))
    return float(np.average(values[inside], weights=weights))


def _static_weights(times: FloatArray) -> FloatArray:
    """What samples of a quiet window count in its mean, most in its middle, shape (time,)."""
    middle: FloatArray = np.sin(np.pi * (times - times[0]) / (times[-1] - times[0])) ** 2
    return middle * np.gradient(times)


def mean_over(times: FloatArray, values: FloatArray) -> float:
    """Mean of a series over its time, by straight lines between samples, which need not be equally far apart.

    Args:
        times: Shape (time,), one at least [s].
        values: Shape (time,).

    Returns:
        The mean, in the unit of `values`; of a single sample its value.
    """
    span = float(times[-1] - times[0])
    return float(np.trapezoid(values, times)) / span if span > 0.0 else float(values.mean())


def sling_tension(recording: Recording, sling: Sling) -> FloatArray:
    """Tension of a sling [N], shape (time,)."""
    return recording.column("rope_tension", sling.rope)


def tightest_tension(recording: Recording, rope: str) -> FloatArray:
    """Tension of a rope [N], shape (time,); over sheaves with losses that of its tightest segment."""
    sheaves = [sheave for sheave in recording.rig.sheaves if sheave.rope == rope]
    segments = sorted({segment for sheave in sheaves for segment in sheave.segments})
    if not segments:
        return recording.column("rope_tension", rope)
    tightest: FloatArray = np.max([recording.column("segment_tension", one) for one in segments], axis=0)
    return tightest


def is_carrying(tension: FloatArray) -> BoolArray:
    """Samples at which a rope carries enough for its direction to mean something, shape (time,)."""
    carrying: BoolArray = tension > _CARRYING_FROM * np.max(tension, initial=0.0)
    return carrying


def rope_ends(recording: Recording, rope: str) -> tuple[FloatArray, FloatArray]:
    """First and last drawn point of a rope [m], world axes, each of shape (time, 3)."""
    at = recording.points_of_ropes[rope]
    points = recording["rope_point"].values
    return points[:, at[0]], points[:, at[-1]]


def sling_direction(recording: Recording, sling: Sling, end: int = 0) -> FloatArray:
    """Unit vectors along a sling from a lower end upwards, world axes, shape (time, 3).

    Zero once it has parted. `end` counts the lower ends of one that runs over an extension sheave, 0 and 1.
    """
    return recording.kept(
        ("sling_direction", sling.rope, sling.over, end), lambda: _along_sling(recording, sling, end)
    )


def _along_sling(recording: Recording, sling: Sling, end: int) -> FloatArray:
    first, last = rope_ends(recording, sling.rope)
    upper, lower = first, last
    if sling.over is not None:
        upper, lower = recording.column("body_position", sling.over), (first, last)[end]
    along = upper - lower
    length = np.linalg.norm(along, axis=1, keepdims=True)
    unit: FloatArray = np.divide(along, length, out=np.zeros_like(along), where=length > 0.0)
    return unit


def sling_upright(recording: Recording, sling: Sling) -> FloatArray:
    """Vertical part of the tension of a sling [N], shape (time,)."""
    upright: FloatArray = sling_tension(recording, sling) * sling_direction(recording, sling)[:, 2]
    return upright


def sling_angle(recording: Recording, sling: Sling) -> FloatArray:
    """Angle of a sling from the vertical [rad], shape (time,); the larger one of two legs."""
    angles = []
    for end in range(1 if sling.over is None else 2):
        unit = sling_direction(recording, sling, end)
        angles.append(np.arctan2(np.hypot(unit[:, 0], unit[:, 1]), unit[:, 2]))
    largest: FloatArray = np.max(angles, axis=0)
    return largest


def out_of_plane_angles(recording: Recording, sling: Sling) -> dict[tuple[str, str], FloatArray]:
    """Angles between a sling and the main plates of its lugs [rad], shape (time,).

    By load or spreader and lug; of those of which the main plate is known.
    """
    return recording.kept(("out_of_plane_angles", sling.name), lambda: _to_main_plates(recording, sling))


def _to_main_plates(recording: Recording, sling: Sling) -> dict[tuple[str, str], FloatArray]:
    found: dict[tuple[str, str], FloatArray] = {}
    for end, of, lug in sling.at_lugs():
        angle = to_main_plate(recording, of, lug, sling_direction(recording, sling, end))
        if angle is not None:
            found[of, lug] = angle
    return found


def to_main_plate(recording: Recording, of: str, lug: str, direction: FloatArray) -> FloatArray | None:
    """Angles between directions and the main plate of a lug [rad], shape (time,); None if it is not known.

    Args:
        recording: The recording.
        of: The load or spreader that has the lug.
        lug: Its name there.
        direction: Unit vectors, shape (time, 3), world axes.
    """
    holder = recording.rig.with_lugs(of)
    plate = None if holder is None else holder.lugs.get(lug)
    if holder is None or plate is None or plate.main_plate_normal is None:
        return None
    body = axes(recording.column("body_orientation", holder.body))
    normal = body @ np.asarray(plate.main_plate_normal, dtype=np.float64)
    across = np.einsum("ij,ij->i", normal, direction)
    angle: FloatArray = np.abs(np.arcsin(np.clip(across, -1.0, 1.0)))
    return angle


def tension_spread(recording: Recording, equalizer: Equalizer) -> FloatArray:
    """(max - min)/mean over the slings of one equalizer [1], shape (time,); 0 where all are slack.

    What has parted is not counted from then on.
    """
    tensions = np.array([recording.column("rope_tension", rope) for rope in equalizer.slings])
    counts = are_whole(recording, equalizer.slings)
    mean = np.divide(np.sum(tensions, axis=0, where=counts), np.maximum(counts.sum(axis=0), 1))
    highest = np.max(tensions, axis=0, where=counts, initial=0.0)
    spread = highest - np.minimum(np.min(tensions, axis=0, where=counts, initial=np.inf), highest)
    ratio: FloatArray = np.divide(spread, mean, out=np.zeros_like(mean), where=mean > 0.0)
    return ratio


def are_taut(recording: Recording, equalizer: Equalizer) -> BoolArray:
    """Where all slings of one equalizer that are whole carry something, shape (time,)."""
    tensions = np.array([recording.column("rope_tension", rope) for rope in equalizer.slings])
    taut: BoolArray = np.all((tensions > 0.0) | ~are_whole(recording, equalizer.slings), axis=0)
    return taut


def is_loaded(recording: Recording, equalizer: Equalizer) -> BoolArray:
    """Where the slings of one equalizer carry a twentieth of their most together, shape (time,).

    Of one that is let down on purpose, or not loaded yet, what little is left has no spread that matters.
    """
    total = np.sum([recording.column("rope_tension", rope) for rope in equalizer.slings], axis=0)
    loaded: BoolArray = (total > 0.0) & (total >= _LOADED * np.max(total, initial=0.0))
    return loaded


def spread_when_clear(recording: Recording, equalizer: Equalizer) -> float | None:
    """Largest tension spread while the loads are clear and an equalizer is loaded [1]; None if never."""
    counts = everywhere(recording) & is_clear(recording) & is_loaded(recording, equalizer)
    return float(tension_spread(recording, equalizer)[counts].max()) if counts.any() else None


def are_whole(recording: Recording, ropes: Sequence[str]) -> BoolArray:
    """Where ropes are on and have not parted, shape (ropes, time); at the moment of its parting one is."""
    return while_there(recording, ropes)


def is_on(recording: Recording, rope: str) -> BoolArray:
    """Where a rope is put on and not taken off, parted or not, shape (time,)."""
    on: BoolArray = while_there(recording, [rope], [DETACHED])[0]
    return on


def slings_on(recording: Recording) -> list[Sling]:
    """Slings that are on at the end and have not parted; of an equilibrium those that it has."""
    slings = recording.rig.slings
    there = are_whole(recording, [sling.rope for sling in slings])[:, -1:]
    return [sling for sling, is_there in zip(slings, there, strict=True) if is_there.any()]


def slings_parted(recording: Recording) -> list[Sling]:
    """Slings that have parted by the end, and that nobody took off."""
    left = slings_on(recording)
    rest = [sling for sling in recording.rig.slings if sling not in left]
    return [sling for sling in rest if is_on(recording, sling.rope)[-1:].any()]


def of_the_mean(recording: Recording) -> dict[str, float | None]:
    """Tension of every sling of `slings_on` at the end over the mean of all below as much gear [1].

    None where all of these are slack, or just reach. Slings above a spreader or compensator carry it too, and
    lean otherwise: beside those below they tell nothing.
    """
    slings = slings_on(recording)
    tensions = [float(recording.column("rope_tension", sling.rope)[-1]) for sling in slings]
    depths = [_gear_above(recording.rig, sling) for sling in slings]
    alike: dict[int, list[float]] = {}
    for depth, tension in zip(depths, tensions, strict=True):
        alike.setdefault(depth, []).append(tension)
    means = {depth: sum(ones) / len(ones) for depth, ones in alike.items()}
    return {
        sling.name: tension / means[depth] if means[depth] > nothing("kN") else None
        for sling, tension, depth in zip(slings, tensions, depths, strict=True)
    }


def _gear_above(rig: Rig, sling: Sling) -> int:
    """How many spreaders and compensators hang one below the other above a sling."""
    above = rig.gear_above(sling)
    if above is None:
        return 0
    return 1 + max((_gear_above(rig, one) for one in rig.slings if above.name in one.lugs_of), default=0)


def frame_tilt(recording: Recording, equalizer: Equalizer) -> FloatArray:
    """Angle of an equalizer's frame from plumb [rad], shape (time,)."""
    return tilt(recording.column("body_orientation", equalizer.body))


def fleet_angle(recording: Recording, sheave: WrappedSheave) -> FloatArray:
    """Larger of the angles [rad] of a rope to the plane of a sheave on its two sides, shape (time,)."""
    larger: FloatArray = np.abs(recording.column("fleet_angle", sheave.name)).max(axis=1)
    return larger


def tension_ratio(recording: Recording, sheave: Sheave) -> FloatArray:
    """Larger over smaller tension on both sides of a sheave [1], shape (time,).

    1 where the loads are not clear, in a lift in which they ever are, and where one side carries no more than
    1 % of the largest tension: of a rope that is hardly taut the inertia of the sheave makes ratios that mean
    nothing.
    """
    before, after = recording.column("sheave_tension", sheave.name).T
    low, high = np.minimum(before, after), np.maximum(before, after)
    counts = low > _CARRYING_FROM * np.max(high, initial=0.0)
    clear = is_clear(recording)
    if clear.any():
        counts &= clear
    ratio: FloatArray = np.divide(high, low, out=np.ones_like(high), where=counts)
    return ratio


def slip_ratio(recording: Recording, sheave: Sheave) -> FloatArray:
    """Ratio of tensions from which rope passes a sheave, by bearing or groove [1], shape (time,)."""
    bearing = math.inf if sheave.ratio is None else sheave.ratio
    if sheave.groove_friction is None:
        return np.full(recording.time.shape, bearing)
    is_wrapped = any(other.name == sheave.name for other in recording.rig.wrapped_sheaves)
    wrap = (
        recording.column("wrap_angle", sheave.name) if is_wrapped else np.full(recording.time.shape, math.pi)
    )
    ratio: FloatArray = np.minimum(bearing, np.exp(sheave.groove_friction * wrap))
    return ratio


def rope_peak(recording: Recording, rope: str) -> tuple[float, float]:
    """Largest tension of a rope over all steps, not only over the samples.

    Of a mooring line steps know their ends alone, and a sample within one may have more. Samples that are no
    number say nothing against what the steps had. Of a rope at rest the first time counts at which it has it;
    of an equilibrium its last sample alone, that of the tightest segment.

    Returns:
        Tension [N] and its time [s].
    """
    if recording.is_equilibrium:
        return float(tightest_tension(recording, rope)[-1]), float(recording.time[-1])
    of_steps = (
        float(recording.column("rope_peak_tension", rope)),
        float(recording.column("rope_peak_time", rope)),
    )
    of_samples = peak(recording, recording.column("rope_tension", rope))
    return earliest_peak(of_steps, *([] if of_samples is None else [of_samples]))


def peak(
    recording: Recording, values: FloatArray, during: BoolArray | None = None
) -> tuple[float, float] | None:
    """Largest sample, and the time [s] at which it first is so; None if `during` holds no sample."""
    inside = np.ones(len(values), dtype=np.bool_) if during is None else during
    if not inside.any():
        return None
    within = np.where(inside, values, -np.inf)
    return float(within.max()), float(recording.time[first_peak(within)])
