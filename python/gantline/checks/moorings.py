"""Mooring lines against their minimum breaking force, and fenders against their capacity."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.force import OWN_WEIGHT, kilonewton
from gantline.checks.forces import raised_of_capacity
from gantline.checks.measure import Finding, Found, Missing
from gantline.results.loads.contact_peaks import contact_peak
from gantline.results.recording import Recording
from gantline.results.ropes.upper_end import peak_at_upper_end
from gantline.results.variable import BoolArray


def moors_by_its_limit(recording: Recording, rope: str) -> bool:
    """Whether a rope is a mooring line that a limit of its own is for, and no factor of slings."""
    limited = "mooring_tension_of_breaking_force" in recording.rig.limits
    return limited and any(line.rope == rope for line in recording.rig.mooring_lines)


def tension_of_breaking_force(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Peak tension of a mooring line, at its upper end, over the minimum breaking force of its rope."""
    for line in recording.rig.mooring_lines:
        strength = line.minimum_breaking_force
        if strength is None:
            yield Missing(line.name, "minimum breaking force not known")
            continue
        highest = peak_at_upper_end(recording, line.rope, during)
        if highest is not None:
            tension = kilonewton(highest.tension - highest.own_weight)
            if highest.own_weight > 0.0:
                tension = f"({tension} + {OWN_WEIGHT} {kilonewton(highest.own_weight)})"
            text = f"{tension} / {kilonewton(strength)}"
            yield Found(highest.tension / strength, line.name, highest.time, text)


def fender_of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force of a fender over its capacity."""
    for fender in recording.rig.fenders:
        capacity = fender.capacity
        if capacity is None:
            yield Missing(fender.name, "no capacity")
            continue
        force = recording.column("fender_force", fender.name)
        of_steps = contact_peak(recording, fender.contact)
        yield from raised_of_capacity(
            recording, during, fender.name, force, np.ones_like(force), capacity, of_steps
        )
