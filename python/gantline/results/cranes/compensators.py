"""Compensators: where their rods are between their stops, what hangs below them, when pins hold them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.gear import Compensator, Sling
from gantline.results.recording import Recording
from gantline.results.ropes.parting import Met, stops_met
from gantline.results.ropes.pinned import is_pinned
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

__all__ = ["Range", "borne", "counted", "in_words", "met_while", "range_of", "slings_below"]


@dataclass(frozen=True)
class Range:
    """Where a rod was within some samples.

    Attributes:
        least: Least way out [m].
        most: Largest way out [m].
        last: Way out at the last of them [m].
    """

    least: float
    most: float
    last: float


def slings_below(recording: Recording, compensator: Compensator) -> list[Sling]:
    """Slings that hang from its rod."""
    return [sling for sling in recording.rig.slings if sling.from_body == compensator.rod]


def borne(recording: Recording, compensator: Compensator) -> FloatArray:
    """Vertical force of all slings that hang from its rod [N], shape (time,)."""
    forces = [series.sling_upright(recording, sling) for sling in slings_below(recording, compensator)]
    total: FloatArray = np.sum(forces, axis=0)
    return total


def counted(recording: Recording, compensator: Compensator) -> BoolArray:
    """Samples at which its way counts: the loads are clear, and no pin holds its rod, shape (time,).

    While a load stands its rod is in, as it is meant to be.
    """
    return series.is_clear(recording) & ~is_pinned(recording, compensator.rod, at_start=compensator.locked)


def range_of(recording: Recording, compensator: Compensator) -> Range | None:
    """Where its rod was in the samples that count; None if there are none."""
    out = recording.column("rod_out", compensator.name)[counted(recording, compensator)]
    return Range(float(out.min()), float(out.max()), float(out[-1])) if out.size else None


def met_while(recording: Recording, compensator: Compensator) -> Iterator[Met]:
    """That its rod met a stop while its way counts: between samples it may have been there and back."""
    counts = counted(recording, compensator)

    def is_meant(time: float) -> bool:
        after = int(np.searchsorted(recording.time, time))
        return not counts[max(after - 1, 0) : after + 1].all()

    own = [one for one in recording.events("stop_hit") if one[2] == compensator.rod]
    yield from stops_met(one for one in own if not is_meant(one[0]))


def in_words(recording: Recording, compensator: Compensator) -> list[tuple[str, str]]:
    """What tables say of a compensator, names and texts: rod, gas, what hangs below it, pin and stops."""
    rows = []
    found, stroke = range_of(recording, compensator), compensator.stroke
    if found is None:
        at_end = float(recording.column("rod_out", compensator.name)[-1])
        rows.append(("rod out", f"{_metres(at_end)} at the end, locked or the load never clear"))
    else:
        between = (
            f"{_metres(found.least)} to {_metres(found.most)} when clear, {_metres(found.last)} at the end"
        )
        rows.append(("rod out", between))
        used = format_quantity((found.most - found.least) / stroke, "%", 1)
        margins = f"{_metres(found.least)} to the inner stop, {_metres(stroke - found.most)} to the outer one"
        rows.append(("stroke used", f"{used} of {_metres(stroke)}, margins {margins}"))
    pulls = f"{_force(compensator.pull_in)} with the rod in, {_force(compensator.pull_out)} with it out"
    gas = recording.column("rope_tension", compensator.gas)
    rows.append(("pull of the gas", f"{_force(float(gas.max()))} at most; {pulls}"))
    hangs = borne(recording, compensator)
    if (most := series.peak(recording, hangs)) is not None:
        static, _ = series.greatest_static(recording, hangs)
        still = "" if static is None else f"{_force(static)} static, "
        rows.append(("hangs from it", f"{still}{_force(most[0])} at most, at {most[1]:.2f} s"))
    rows += _pin(recording, compensator)
    met = stops_met(one for one in recording.events() if one[2] == compensator.rod)
    return rows + [("stop met", f"at {one.time:.2f} s{one.again}") for one in met]


def _pin(recording: Recording, compensator: Compensator) -> list[tuple[str, str]]:
    """What its pin held, and when it was pulled and put in; nothing of one without."""
    if compensator.rod not in recording.coordinates.get("pin", ()):
        return []
    force = np.abs(recording.column("pin_force", compensator.rod))
    text = f"{_force(float(force.max()))} at most"
    for kind, words in (("pin_pulled", "pulled"), ("pin_put_in", "put in")):
        times = [time for time, _, name in recording.events(kind) if name == compensator.rod]
        if times:
            text += f", {words} at {' and '.join(f'{time:.2f} s' for time in times)}"
    return [("locking pin", text)]


def _metres(value: float) -> str:
    return format_quantity(value, "m", 3)


def _force(value: float) -> str:
    return format_quantity(value, "kN", 1)
