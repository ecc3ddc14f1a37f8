"""Loads that are hoisted against something above them, or tied to what is below: it holds them down."""

from __future__ import annotations

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.measure import named
from gantline.results import progress, series
from gantline.results.loads.hinges import Hinge, distance_from_axis, pulled_up
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
        with_ = _with(share[worst], weight[worst])
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
        with_ = _with(share[worst], series.load_weight(recording, load)[worst])
        remark = (
            f"tied to {to} by {named(ropes)}: that holds it down {with_}, while it hangs, and its hooks "
            "pull so much more than it weighs; 'cut' of a step lets go of a lashing, and a rope that is "
            "meant to hold a load down ends on a drum"
        )
        checks.append(_not_let_go(recording, load, worst, remark))
    return checks


def shut_in(recording: Recording) -> list[Check]:
    """A failure for each load that is hoisted against a hinge that is shut.

    Lifted at lugs that are nearer to the hinge than its centre of gravity a load needs to be held down there;
    at lugs farther off none does, and what holds it down is what hooks pull too much. A jolt is over before
    a load would hang still.
    """
    checks = []
    for hinge in recording.rig.hinges:
        load = recording.rig.load(hinge.load)
        if load is None or not len(recording.time):
            continue
        weight = series.load_weight(recording, load)
        share = np.where(_is_lifted_beyond(recording, hinge, load), pulled_up(recording, hinge) / weight, 0.0)
        if recording.is_equilibrium:
            share[:-1] = 0.0
        else:
            least = series.time_to_hang_still(recording.rig)
            lasting = [
                stretch
                for stretch in series.stretches(share > _HELD)
                if np.ptp(recording.time[stretch]) >= least
            ]
            share = np.where(np.any(lasting, axis=0), share, 0.0) if lasting else np.zeros_like(share)
        worst = int(np.argmax(share))
        if share[worst] <= _HELD:
            continue
        remark = (
            f"{hinge.name} is shut and holds it down {_with(share[worst], weight[worst])}, and its hooks "
            "pull so much more than it takes: 'open_hinges' of a step lets it go, once the hinge bears next "
            "to nothing"
        )
        checks.append(_not_let_go(recording, load, worst, remark))
    return checks


def _with(share: float, weight: float) -> str:
    """With what a load is held down, this share [1] of its weight [N]."""
    return f"with {format_quantity(share * weight, 'kN', 1)}, {format_quantity(share, '%', 0)} of its weight"


def _not_let_go(recording: Recording, load: Load, worst: int, remark: str) -> Check:
    """The failure of a load that is tied down most at this sample."""
    time = None if recording.is_equilibrium else float(recording.time[worst])
    meaning = "nothing ties down a load that is hoisted"
    return Check("let_go_below", Verdict.FAILED, meaning, element=load.name, time=time, remark=remark)


def _is_lifted_beyond(recording: Recording, hinge: Hinge, load: Load) -> BoolArray:
    """Where slings carry a load at lugs that are all farther from a hinge than its centre of gravity."""
    lifted: BoolArray = np.zeros(len(recording.time), dtype=bool)
    nearer: BoolArray = np.zeros(len(recording.time), dtype=bool)
    own = distance_from_axis(recording, hinge, (0.0, 0.0, 0.0))
    for sling in recording.rig.slings:
        carries = series.is_carrying(series.sling_tension(recording, sling))
        for _, of, lug in sling.at_lugs():
            if of == load.name:
                lifted |= carries
                nearer |= carries & (distance_from_axis(recording, hinge, load.lugs[lug].at) < own)
    return lifted & ~nearer


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
