"""Crawler cranes: pressure on the ground and stability against tipping."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gantline.checks.measure import Finding, Missing, Refused, extreme
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray
from gantline.units import format_quantity


def ground_pressure(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Pressure on the ground over what it bears, at the ends of all tracks."""
    for crane in recording.rig.crawlers:
        if not crane.allowed_pressure:
            yield Missing(crane.name, "what the ground bears is not known")
            continue
        for corner in crane.corners:
            used = recording.column("ground_pressure", corner) / crane.allowed_pressure
            allowed = format_quantity(crane.allowed_pressure, "kPa", 1)
            for found in extreme(recording, used, during, corner):
                pressure = format_quantity(found.value * crane.allowed_pressure, "kPa", 1)
                yield replace(found, formula=f"{pressure} / {allowed}")


def tipping(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Moment of what hangs over that of the crane's own weight, about its worst tipping line."""
    for crane in recording.rig.crawlers:
        used = recording.column("tipping_utilisation", crane.name)
        tipped = [time for time, _, name in recording.events("tipping") if name == crane.name]
        within = during & (used >= 1 - 1e-9)
        if within.any():
            at = tipped[0] if tipped else float(recording.time[int(np.flatnonzero(within)[0])])
            yield Refused(crane.name, f"it tips at {at:.2f} s: nothing is left under one side")
            continue
        yield from extreme(recording, used, during, crane.name)
