"""Spreaders: what hangs below them, what pushes them together, and how far askew they hang."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.equalizers import hanging_of_capacity
from gantline.checks.force import as_it_is
from gantline.checks.forces import sum_force
from gantline.checks.measure import Finding, extreme
from gantline.results import series
from gantline.results.loads.spreaders import thrust
from gantline.results.recording import Recording
from gantline.results.rotation import tilt
from gantline.results.variable import BoolArray

#: Share of its largest tension from which a sling below a spreader counts [1]: as slings come taut one after
#: another it turns to and fro.
_BEARS = 0.25


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static vertical force of all slings that hang from a spreader over its rated capacity."""
    for spreader in recording.rig.spreaders:
        slings = [sling for sling in recording.rig.slings if sling.from_body == spreader.name]
        yield from hanging_of_capacity(recording, during, spreader, slings)


def largest_thrust(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Dynamic thrust along a spreader: static by the rule's factor, or the simulated peak."""
    for spreader in recording.rig.spreaders:
        force = sum_force(recording, thrust(recording, spreader), None, during)
        yield from as_it_is(force, spreader.name)


def tilt_under_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a spreader's own z axis from plumb, while any sling below it bears what counts."""
    for spreader in recording.rig.spreaders:
        below = [sling for sling in recording.rig.slings if sling.from_body == spreader.name]
        tensions = [series.sling_tension(recording, sling) for sling in below]
        loaded = during & np.any([one > _BEARS * np.max(one, initial=0.0) for one in tensions], axis=0)
        angle = tilt(recording.column("body_orientation", spreader.body))
        yield from extreme(recording, angle, loaded, spreader.name)
