"""When drives stand, and what is in tanks of loads: a load hangs still while they do."""

from __future__ import annotations

import math

import numpy as np

from gantline.results.recording import Recording
from gantline.results.ropes.parting import while_there
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["all_stands"]

_ROUNDED = 1e-14  # of the work of drives over a run
_SLIPPING = 1e-10  # rounding of the work of a tugger that slips, from sample to sample


def all_stands(recording: Recording) -> BoolArray:
    """Whether from sample to sample no drive does work and no load changes its weight, shape (time - 1,).

    What runs through holes of a vessel's tanks is no drive's work, and leaves what hangs as it is. What runs
    out of a load, or of a body that may hang with it, does not.
    """
    stands = _drives_stand(recording)
    if "tank_content" in recording:
        afloat = tuple(f"{vessel.name}." for vessel in recording.rig.vessels)
        of_loads = {tank for load in recording.rig.loads for tank in load.tanks}
        for tank in recording.rig.tanks:
            if tank.name in of_loads or not tank.name.startswith(afloat):
                stands = stands & (np.diff(recording.column("tank_content", tank.name)) == 0.0)
    return stands


def _drives_stand(recording: Recording) -> BoolArray:
    """Whether no drive does work from sample to sample, shape (time - 1,).

    Winches that only pull may, and hoists that compensate heave. Tuggers ask for hauling in all the
    time, and slip: their drives do the work of pull times speed. One whose line is slack hauls at that
    speed and does none.
    """
    work = np.diff(recording.column("energy", "drive_work"))
    tuggers = [line for line in recording.rig.tag_lines if line.pull is not None and line.speed is not None]
    rounding = _ROUNDED * float(np.max(np.abs(recording.column("energy", "drive_work")), initial=0.0))
    if tuggers:
        taut = np.array([recording.column("rope_tension", line.rope) for line in tuggers]) > 0.0
        pulling = while_there(recording, [line.rope for line in tuggers])[:, 1:] & (
            taut[:, 1:] | taut[:, :-1]
        )
        powers = np.array([(line.pull or 0.0) * (line.speed or 0.0) for line in tuggers])
        slipped = (powers @ pulling) * np.diff(recording.time)
        standing: BoolArray = np.isclose(work, slipped, rtol=_SLIPPING, atol=rounding)
        work = work - slipped
    else:
        standing = work == 0.0
    return standing | _winches_slip(recording, work, rounding) | _compensates_alone(recording)


def _compensates_alone(recording: Recording) -> BoolArray:
    """Whether hoists keep hooks still against heave and steps move nothing, shape (time - 1,).

    What hangs then hangs as still as waves leave it, stiller than from a hoist that stands.
    """
    alone = np.zeros(len(recording.time[1:]), dtype=np.bool_)  # none of a run that has not begun
    moved = alone.copy()
    for step in recording.rig.plan:
        if step.compensate_heave or step.drives:
            under_way = _under_way(recording, step.step)
            alone |= under_way & bool(step.compensate_heave)
            moved |= under_way & bool(step.drives)
    return alone & ~moved


def _winches_slip(recording: Recording, work: FloatArray, rounding: float) -> BoolArray:
    """Whether from sample to sample no step moves anything but winches that slip, shape (time - 1,).

    A winch of constant tension, one of `mechanics` with a capacity, is a tugger by another name. Its motor
    pulls what it can, at a speed that its step asks for, so that its work grows evenly; that of anything that
    brakes after its step does not.

    Args:
        recording: The recording.
        work: Of all drives but tuggers from sample to sample [J], shape (time - 1,).
        rounding: Of that [J].
    """
    before, after = recording.time[:-1], recording.time[1:]
    none = np.zeros(len(before), dtype=np.bool_)
    slips: dict[str, BoolArray] = {}
    for drum in recording.rig.drums:
        times = _from_to(recording, drum.name, "drum_slips", "drum_holds")
        within = [(before >= begin) & (after <= end) for begin, end in times]
        slips[f"{drum.name}.drive"] = np.any([none, *within], axis=0)
    alone: BoolArray = np.any([none, *slips.values()], axis=0)
    if not alone.any():
        return alone
    for step in recording.rig.plan:
        under_way = _under_way(recording, step.step) if step.drives else none
        for drive in step.drives:
            alone &= ~under_way | slips.get(drive, none)
    power = work / (after - before)
    even = np.abs(np.diff(power)) <= _SLIPPING * np.abs(power[1:]) + rounding / np.min(after - before)
    alone &= np.append(False, even) | np.append(even, False)
    return alone


def _under_way(recording: Recording, step: str) -> BoolArray:
    """Whether a step goes on from sample to sample, or in a part of that, shape (time - 1,)."""
    before, after = recording.time[:-1], recording.time[1:]
    under_way = np.zeros(len(before), dtype=np.bool_)
    for begin, end in _from_to(recording, step, "step_begin", "step_end"):
        under_way |= (after > begin) & (before < end)
    return under_way


def _from_to(recording: Recording, name: str, begins: str, ends: str) -> list[tuple[float, float]]:
    """From when to when something of a name goes on [s], by events of two kinds; infinite without an end."""
    found: list[tuple[float, float]] = []
    begun: float | None = None
    for time, kind, of in recording.events():
        if of == name and kind == begins and begun is None:
            begun = time
        elif of == name and kind == ends and begun is not None:
            found.append((begun, time))
            begun = None
    return found if begun is None else [*found, (begun, math.inf)]
