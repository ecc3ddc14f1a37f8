"""Loads that are hoisted against something above them, or tied to what is below: it holds them down."""

from __future__ import annotations

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.measure import named
from gantline.results import progress, series
from gantline.results.loads.pulls import upright_pull
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

#: Share of its weight with which something may hold a load down before it is told [1]: as it is hoisted
#: along a wall or a landing guide friction does so with less.
_HELD = 0.1
_WORLD = "world"


def held_down(recording: Recording) -> list[Check]:
    """A failure for each load that what it touches holds down against its hooks.

    An edge or a deck above it does, or a gap in which it is stuck. Hooks then pull with more than it weighs,
    as far as they are hoisted; their rated capacity need not tell that.

    Args:
        recording: Of a run, or of an equilibrium, of which the last sample counts.
    """
    checks = []
    for load in recording.rig.loads:
        if load.name not in recording.coordinates.get("load", ()) or not len(recording.time):
            continue
        weight = series.load_weight(recording, load)
        share = -series.borne(recording, load) / weight
        share[_bears_what_is_loose(recording, load)] = 0.0
        if recording.is_equilibrium:
            share[:-1] = 0.0
        worst = int(np.argmax(share))
        if share[worst] <= _HELD:
            continue
        force = format_quantity(float(share[worst] * weight[worst]), "kN", 1)
        with_ = f"with {force}, {format_quantity(float(share[worst]), '%', 0)} of its weight"
        time, where = None, ""
        if not recording.is_equilibrium:
            time = float(recording.time[np.argmax(share > _HELD)])
            spans = progress.spans(recording).items()
            steps = [step for step, (begin, end) in spans if begin < time <= end]
            where = f" in '{progress.BESIDE.join(steps)}'" if steps else ""
            with_ = f"{with_} at {recording.time[worst]:.2f} s"
        remark = (
            f"it hooks under something, or is stuck in it{where}: that holds it down {with_}, and its hooks "
            "pull so much more than it weighs"
        )
        meaning = "nothing holds down a load that is hoisted"
        checks.append(
            Check("stays_clear", Verdict.FAILED, meaning, element=load.name, time=time, remark=remark)
        )
    return checks


def tied_down(recording: Recording) -> list[Check]:
    """A failure for each load that hangs while ropes to the world or a vessel hold it down.

    Lashings that nobody has let go of: hooks and slings pull with more than it weighs, as far as they are
    hoisted. What breaks on the way, as a rope does that stands for mud, holds nothing down that hangs still;
    a rope on a drum is hauled by somebody who means it.

    Args:
        recording: Of a run, or of an equilibrium, of which the last sample counts.
    """
    checks = []
    for load in recording.rig.loads:
        pulls = {rope: -upright_pull(recording, load, rope) for rope in load.tied_to}
        counts = _rests_clear(recording, load)
        if not pulls or not counts.any():
            continue
        share = np.where(counts, sum(pulls.values()) / series.load_weight(recording, load), 0.0)
        worst = int(np.argmax(share))
        if share[worst] <= _HELD:
            continue
        ropes = [rope for rope, pull in pulls.items() if pull[worst] > 0.0]
        to = named(load.tied_to[rope].replace(_WORLD, f"the {_WORLD}") for rope in ropes)
        force = float(share[worst] * series.load_weight(recording, load)[worst])
        remark = (
            f"tied to {to} by {named(ropes)}: that holds it down with {format_quantity(force, 'kN', 1)}, "
            f"{format_quantity(float(share[worst]), '%', 0)} of its weight, while it hangs, and its hooks "
            "pull so much more than it weighs; 'cut' of a step lets go of a lashing, and a rope that is "
            "meant to hold a load down ends on a drum"
        )
        checks.append(
            Check(
                "let_go_below",
                Verdict.FAILED,
                "nothing ties down a load that is hoisted",
                element=load.name,
                time=None if recording.is_equilibrium else float(recording.time[worst]),
                remark=remark,
            )
        )
    return checks


def _rests_clear(recording: Recording, load: Load) -> BoolArray:
    """Samples at which a load hangs still, and the last one if it hangs then."""
    counts = series.last_sample(recording)
    if not recording.is_equilibrium:
        for window in series.quiet_windows(recording):
            counts = counts | window
    clear: BoolArray = counts & series.load_is_clear(recording, load)
    return clear


def _bears_what_is_loose(recording: Recording, load: Load) -> BoolArray:
    """At which samples a load touches what may stand on it, and is held down by that thing's weight."""
    vessels = {vessel.body for vessel in recording.rig.vessels}
    loose = [contact for contact, body in load.meets.items() if body not in vessels]
    touches: BoolArray = np.zeros(len(recording.time), dtype=bool)
    for contact in loose:
        touches |= recording.column("contact_force", contact) > 0.0
    return touches
