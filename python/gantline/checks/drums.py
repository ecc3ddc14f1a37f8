"""Drums: what they carry of what they may carry, and whether rope enough stays on them, but not too much.

A simulation pays out more rope than there is, and winds it on in layers that the drum does not have.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.force import over
from gantline.checks.forces import at_upper_end, rope_force
from gantline.checks.lugs import BEARS
from gantline.checks.measure import Finding, Missing, extreme
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.gear import Drum
from gantline.results.recording import Recording
from gantline.results.ropes.flows import drum_fleet_angle
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["fleet_angle", "lifts_loads", "load_of_rated_capacity", "turns_left", "upright_share"]


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force of each rope on a winch or strand jack, static and dynamic, over what that is rated for.

    At its upper end, where the bundle of a jack hangs in it; a winch down on a deck has less. One of which
    nothing says what it is rated for counts beside others that are, and where it lifts as hooks do.
    """
    rig = recording.rig
    # Whichever way round and on whichever diameter of its shaft, and a rope with both ends there once.
    ropes: dict[str, set[str]] = {}
    for drum in rig.drums:
        if drum.ropes:
            ropes.setdefault(drum.joint, set()).update(drum.ropes)
    rated = {drum.joint: drum.rated_capacity for drum in rig.drums if drum.rated_capacity}
    for name, on_it in ropes.items():
        if name in rated:
            for rope in sorted(on_it):
                force = at_upper_end(recording, rope, rope_force(recording, rope, during), during)
                yield from over(force, rated[name], name if len(on_it) == 1 else f"{name}/{rope}")
        elif rated or any(lifts_loads(recording, rope) for rope in on_it):
            yield Missing(name, "rated capacity not known", is_strength=True)


def lifts_loads(recording: Recording, rope: str) -> bool:
    """Whether a rope on a drum lifts: any where no hook does, else one that pulls more than a tag line may.

    A tugger beside hooks steadies a load, as a tag line does, and pulls with little of its weight. All parts
    of a tackle count together.

    Args:
        recording: Of any lift.
        rope: Name of a rope on a drum of `mechanics`.
    """
    rig = recording.rig
    if not rig.loads or not rig.hooks:
        return bool(rig.loads)
    pull, time = series.rope_peak(recording, rope)
    return _upright_parts(recording, rope, time) * pull > BEARS * min(load.weight for load in rig.loads)


def upright_share(recording: Recording, rope: str) -> float:
    """How much of its way a rope goes up or down as it pulls most; 1 of one that is not drawn."""
    steps = _drawn(recording, rope, series.rope_peak(recording, rope)[1])
    along = np.linalg.norm(steps, axis=1).sum()
    return float(np.abs(steps[:, 2]).sum() / along) if along > 0.0 else 1.0


def _upright_parts(recording: Recording, rope: str, time: float) -> float:
    """How often a rope goes all the way up or down at a time [s]; 1 of one that is level or is not drawn."""
    steps = _drawn(recording, rope, time)
    heights = np.append(0.0, np.cumsum(steps[:, 2]))
    up, along = np.abs(steps[:, 2]).sum(), np.linalg.norm(steps, axis=1).sum()
    whole = np.ptp(heights) * along
    return max(1.0, float(up * up / whole)) if whole > 0.0 else 1.0


def _drawn(recording: Recording, rope: str, time: float) -> FloatArray:
    """From point to point of a rope at a time [s], shape (parts, 3) [m]; no part of one that is not drawn."""
    drawn = recording.points_of_ropes.get(rope, ())
    if len(drawn) < 2 or not len(recording.time):
        return np.zeros((0, 3))
    sample = min(int(np.searchsorted(recording.time, time)), len(recording.time) - 1)
    steps: FloatArray = np.diff(recording["rope_point"].values[sample, drawn], axis=0)
    return steps


def fleet_angle(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a rope to the plane of the groove of a drum, of those that say where the first sheave is."""
    for drum in recording.rig.drums:
        if drum.first_sheave is None:
            continue
        angle = drum_fleet_angle(drum, recording.column("drum_wraps", drum.name))
        if angle is None:
            yield Missing(drum.name, "diameter of its rope not known")
        else:
            yield from extreme(recording, angle, during, drum.name)


def turns_left(recording: Recording) -> list[Check]:
    """A check for each drum on which too few turns stay, or more come than it has room for.

    One whose rope runs off fails: what hangs on it falls. So does one with fewer turns than its lift file
    asks for; fewer than two where nothing is asked for are a warning, and so is a drum for which the lift
    file asks, and of which nothing says how many turns it has at the start. One with more turns than its
    layers take fails: rope climbs over its flange.
    """
    return [check for drum in recording.rig.drums for check in _of_drum(recording, drum)]


def _of_drum(recording: Recording, drum: Drum) -> Iterator[Check]:
    asked = drum.spare_turns
    check = Check("turns_on_drum", Verdict.NOT_CHECKED, "rope stays on drums", element=drum.name)
    if drum.wraps_at_start is None:
        if drum.asks_for_turns:
            remark = f"turns at the start not known ('wraps_at_start'), of which {asked:g} have to stay"
            yield replace(check, verdict=Verdict.WARNING, remark=remark)
        return
    during = series.everywhere(recording)
    if not during.any():
        return
    wraps = recording.column("drum_wraps", drum.name)
    if drum.wraps_per_layer is not None:
        room = drum.layers * drum.wraps_per_layer
        most = first_peak(np.where(during, wraps, -np.inf))
        if wraps[most] > room:
            over = f"{wraps[most]:.1f} turns come on it, and its layers take {room:g}"
            time = float(recording.time[most])
            remark = f"{over}: rope climbs over its flange"
            yield replace(check, verdict=Verdict.FAILED, time=time, remark=remark)
    if asked is None:
        return
    wraps = np.where(during, wraps, np.inf)
    at = first_peak(-wraps)
    left = float(wraps[at])
    if left >= asked and left >= 0.0:
        return
    failed = left < 0.0 or drum.asks_for_turns
    remark = f"{left:.1f} turns are left, and {asked:g} have to stay"
    if left < 0.0:
        more = f"it pays out {-left:.1f} turns more than lie on it"
        remark = f"its rope runs off, and what hangs on it falls: {more}"
    verdict = Verdict.FAILED if failed else Verdict.WARNING
    yield replace(check, verdict=verdict, time=float(recording.time[at]), remark=remark)
