"""Compensators: what hangs below them, and what is left of their stroke."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from gantline.checks.design_weight import largest_ratios
from gantline.checks.equalizers import hanging_of_capacity
from gantline.checks.force import over
from gantline.checks.forces import sum_force, with_upper_ends
from gantline.checks.measure import Caution, Finding, Missing, extreme
from gantline.results.cranes.compensators import borne, counted, met_while, slings_below
from gantline.results.gear import Compensator
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static vertical force of all slings that hang from a compensator over its rated capacity."""
    for one in recording.rig.compensators:
        yield from hanging_of_capacity(recording, during, one, slings_below(recording, one))


def peak_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Dynamic vertical force of these slings, by the rule's factor or the simulated peak, over the same."""
    for one in recording.rig.compensators:
        slings = slings_below(recording, one)
        if not one.rated_capacity:
            yield Missing(one.name, "rated capacity not known", is_strength=True)
        elif slings:
            force = sum_force(recording, borne(recording, one), slings[0].to_load, during)
            force = with_upper_ends(recording, slings, force)
            yield from over(force, one.rated_capacity, one.name)


def stroke_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Way of a rod from either stop over its stroke, while the load is clear and no pin holds the rod."""
    for one in recording.rig.compensators:
        counts = during & counted(recording, one)
        if not counts.any():
            yield Missing(one.name, "its rod is locked, or the load never clear")
            continue
        yield from _least(recording, one, counts)
        if during.all():
            for met in met_while(recording, one):
                yield Caution(
                    f"{met.joint} met its stop at {met.time:.2f} s, with the load hanging{met.again}"
                )


def _least(recording: Recording, one: Compensator, counts: BoolArray) -> Iterator[Finding]:
    """The least way of its rod from each of its stops, within a mask of samples.

    With the design weight it is farther out, by what the gas gives to that.
    """
    out = recording.column("rod_out", one.name)
    further = _with_design_weight(recording, one, out)

    def text(left: FloatArray, at: int) -> str:
        return f"{format_quantity(float(left[at]), 'm', 3)} / {format_quantity(one.stroke, 'm', 3)}"

    for word, left in (("in", out), ("out", one.stroke - out)):
        element = f"{one.name} {word}"
        shown = partial(text, left)
        for found in extreme(recording, left / one.stroke, counts, element, shown, smallest=True):
            least = 1.0 if word == "in" else float((one.stroke - further)[counts].min() / one.stroke)
            yield replace(found, at_design=max(least, 0.0) if least < found.value else None)
            if least <= 0.0 < found.value:
                yield Caution(f"with the design weight the rod of {one.name} comes to its outer stop")


def _with_design_weight(recording: Recording, one: Compensator, out: FloatArray) -> FloatArray:
    """How far its rod is out with the design weight of what hangs below it, shape (time,) [m].

    By the law of its gas from the pull that is recorded, seals as they hold: what is static of it, and what
    swings about that, go with the weight.
    """
    slings = slings_below(recording, one)
    if not one.pulls or not slings:
        return out
    ways, pulls = np.transpose(one.pulls)
    ratios = largest_ratios(recording, {sling.to_load for sling in slings})
    pull = recording.column("rope_tension", one.gas)
    more = pull + (ratios - 1.0) * np.maximum(borne(recording, one), 0.0)
    there, then = (np.interp(force, pulls, ways) for force in (pull, more))
    # Recorded are chords of the law: past its end there is the stop.
    further: FloatArray = np.where((more > pull) & (more >= pulls[-1]), one.stroke, out + then - there)
    return further
