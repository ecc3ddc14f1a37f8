"""Supports against their capacity, and pairs that are watched against the distance that they have to keep."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gantline.checks.design_weight import largest_ratios
from gantline.checks.forces import raised_of_capacity
from gantline.checks.measure import Finding, Missing, extreme
from gantline.results.loads.clearances import watched_during
from gantline.results.loads.contact_peaks import contact_peak
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray

_UNWATCHED = "no pair under 'watch', not even slings and load"


def of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force of a support, raised to the design weight of what stands on it, over its capacity."""
    for support in recording.rig.supports:
        if support.capacity is None:
            yield Missing(support.name, "no capacity")
            continue
        stand = [load.name for load in recording.rig.loads if support.name in load.contacts]
        ratios = largest_ratios(recording, stand)
        force = recording.column("contact_force", support.name)
        of_steps = contact_peak(recording, support.name)
        yield from raised_of_capacity(
            recording, during, support.name, force, ratios, support.capacity, of_steps
        )


def clearance_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Smallest distance of a watched pair less what it has to keep."""
    if not recording.rig.watches and not recording.is_equilibrium:
        yield from (Missing(load.name, _UNWATCHED) for load in recording.rig.loads)
    for watch in recording.rig.watches:
        inside = during & watched_during(recording, watch)
        if during.any() and not inside.any():
            yield Missing(watch.name, "none of its steps is looked at")
        distance = recording.column("clearance", watch.name)
        there = inside & ~np.isposinf(distance)
        if inside.any() and not there.any():
            yield Missing(watch.name, "its ropes are off or have parted")
        for found in extreme(recording, distance - watch.smallest, there, watch.name, smallest=True):
            apart = found.value + watch.smallest
            yield replace(found, formula=f"{apart:.3f} m - {watch.smallest:g} m")
