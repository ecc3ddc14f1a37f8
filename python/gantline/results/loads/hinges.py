"""Hinges and grippers of loads in a recording: what they bear, and when they hold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from gantline.results.file.form import Vector
from gantline.results.rotation import axes
from gantline.results.strength import FromJson
from gantline.results.variable import BoolArray, Columns, Derived, FloatArray, Names, Variable

if TYPE_CHECKING:
    from gantline.results.recording import Recording
    from gantline.results.rig import Rig

__all__ = [
    "HINGE_OPENED",
    "HINGE_WAYS",
    "Hinge",
    "axial_force",
    "borne_by_pins",
    "distance_from_axis",
    "held_up",
    "hinge_columns",
    "hinge_force",
    "hinge_moment",
    "hinge_moments_kept",
    "hinge_state",
    "is_shut",
    "pulled_up",
    "radial_force",
    "shut_as_at",
]

#: Kind of event: a hinge lets its load go.
HINGE_OPENED = "hinge_opened"
#: Axes of a hinge: the middle one is its own, the last as upright as that allows.
HINGE_WAYS = ("across", "along", "upright")


@dataclass(frozen=True)
class Hinge(FromJson):
    """A hinge in which a load turns.

    Attributes:
        name: Its name, that of the joint in which the load turns.
        load: The load that it holds.
        at: Its middle on the load, from the origin of the load's body, its axes [m].
        held_by: What it stands on; None is the world.
        pushes: Joints whose pins hold the load along the axes of the hinge, in the order of `HINGE_WAYS`.
        turns: Joints whose pins keep it from turning about the two that are not the hinge's own.
        rated_capacity: Largest force that it may bear [N]; None if not said.
        pins_apart: Distance along its axis of the two pins that it is of [m]; None if not said.
        opened_in: Steps of the plan that open it.
    """

    name: str
    load: str
    at: Vector = (0.0, 0.0, 0.0)
    held_by: str | None = None
    pushes: Sequence[str] = ()
    turns: Sequence[str] = ()
    rated_capacity: float | None = None
    pins_apart: float | None = None
    opened_in: Sequence[str] = ()


def hinge_columns(columns: Columns, names: Names, rig: Rig) -> tuple[Columns, Names]:
    """Columns of hinges in place of those of the pins, joints and events that they are for the core.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        rig: The lift.

    Returns:
        The same with the columns `hinge_push` (time, hinge, 3) [N] and `hinge_moment` (time, hinge) [N m],
        where the lift has hinges.
    """
    if not rig.hinges:
        return columns, names
    pins = list(names["pin"])
    inner = {joint for hinge in rig.hinges for joint in (*hinge.pushes, *hinge.turns)}

    def of(joints: Sequence[str]) -> FloatArray:
        # What the load does to the hinge: a pin's force is what it keeps its joint from going forwards with.
        found: FloatArray = columns["pin_force"][:, [pins.index(joint) for joint in joints]]
        return found

    kept = {dim: [k for k, name in enumerate(names[dim]) if name not in inner] for dim in ("pin", "joint")}
    moments = [np.linalg.norm(of(hinge.turns), axis=1) for hinge in rig.hinges]
    columns = {
        **columns,
        "hinge_push": np.stack([of(hinge.pushes) for hinge in rig.hinges], axis=1),
        "hinge_moment": np.stack(moments, axis=1),
        "pin_force": columns["pin_force"][:, kept["pin"]],
        "joint_position": columns["joint_position"][:, kept["joint"]],
    }
    names = {**names, **{dim: [names[dim][k] for k in places] for dim, places in kept.items()}}
    return _with_openings(columns, names, rig, inner)


def _with_openings(columns: Columns, names: Names, rig: Rig, inner: set[str]) -> tuple[Columns, Names]:
    """One event for each hinge that opens, in place of those of its pins."""
    first = {hinge.pushes[0]: hinge.name for hinge in rig.hinges}
    kinds, own = list(names["event_kind"]), list(names["event_name"])
    kept = [place for place, name in enumerate(own) if name in first or name not in inner]
    opened = [own[place] in first for place in kept]
    names = {
        **names,
        "event_kind": [HINGE_OPENED if new else kinds[at] for at, new in zip(kept, opened, strict=True)],
        "event_name": [first.get(own[at], own[at]) for at in kept],
    }
    if "event_time" not in columns:  # of one moment
        return columns, names
    return {**columns, "event_time": columns["event_time"][kept]}, names


def hinge_state(columns: Columns, names: Names, rig: Rig) -> Derived:
    """What hinges bear, as variables, and their names; nothing in a lift without."""
    if not rig.hinges:
        return {}, {}
    push = columns["hinge_push"]
    force = "force between a load and its hinge, whichever way; 0 once that has opened"
    of_it = "force of a load on its hinge, along the axes of the hinge"
    moment = "moment by which a hinge keeps its load from turning askew, about its middle"
    return {
        "hinge_force": Variable(("time", "hinge"), np.linalg.norm(push, axis=2), "N", force),
        "hinge_push": Variable(("time", "hinge", "hinge_way"), push, "N", of_it),
        "hinge_moment": Variable(("time", "hinge"), columns["hinge_moment"], "N m", moment),
    }, {"hinge": [hinge.name for hinge in rig.hinges], "hinge_way": HINGE_WAYS}


def hinge_moments_kept(pulled: Columns, names: Names, rig: Rig) -> dict[str, Variable]:
    """What hinges bear at the moments at which they bore most, between samples too.

    Args:
        pulled: Columns of the core of one moment for each group of bearers. The last of them are of two for
            each hinge: when its force was most, and when its moment was; none before the first step.
        names: Names along their dimensions.
        rig: The lift.

    Returns:
        Variables by their names; nothing without hinges or before the first step.
    """
    count = 2 * len(rig.hinges)
    if not count or len(pulled["time"]) < count:
        return {}
    # Names have events that are found in samples too, such as `too_close`: moments have none of their own.
    moments = {name: column for name, column in pulled.items() if name != "event_time"}
    columns, names = hinge_columns(moments, names, rig)
    borne = {name: columns[name][-count:] for name in ("hinge_push", "hinge_moment")}
    state, _ = hinge_state(borne, names, rig)
    time = Variable(("hinge_peak",), pulled["time"][-count:], "s", "when hinges bore most, over all steps")
    kept = {"hinge_peak_time": time}
    for name in ("hinge_push", "hinge_moment"):
        one = state[name]
        text = f"{one.description}, at hinge_peak_time"
        dims = ("hinge_peak", *one.dims[1:])
        kept[name.replace("hinge", "hinge_peak")] = Variable(dims, one.values, one.unit, text)
    return kept


def held_up(columns: Columns, names: Names, rig: Rig, load: str) -> FloatArray:
    """What hinges bear of the weight of a load, negative where they hold it down [N], shape (time,)."""
    held: FloatArray = np.zeros(len(columns["time"]))
    for place, hinge in enumerate(rig.hinges):
        if hinge.load == load:
            body = list(names["body"]).index(hinge.pushes[-1])
            held = held - _upwards(columns["body_orientation"][:, body], columns["hinge_push"][:, place])
    return held


def _upwards(orientation: FloatArray, push: FloatArray) -> FloatArray:
    """The part of a force that points up [N], shape (time,).

    Args:
        orientation: Of the axes of a hinge, quaternions (time, 4).
        push: The force along these axes (time, 3) [N].
    """
    up: FloatArray = (axes(orientation)[:, 2] * push).sum(axis=1)
    return up


def hinge_force(recording: Recording, hinge: Hinge) -> FloatArray:
    """Force between load and hinge, whichever way [N], shape (time,)."""
    return recording.column("hinge_force", hinge.name)


def borne_by_pins(recording: Recording, hinge: Hinge) -> FloatArray:
    """Twice what the pin of a hinge bears that bears most, shape (time,) [N]: F + 2 M/b, at most.

    Each of two pins b apart bears half of the force F, and M/b by the moment askew M, which is level with F
    and against it at one of them at most. Of one of which no distance of pins is said it is F.
    """
    force = hinge_force(recording, hinge)
    return (
        force if hinge.pins_apart is None else force + 2.0 * hinge_moment(recording, hinge) / hinge.pins_apart
    )


def pulled_up(recording: Recording, hinge: Hinge) -> FloatArray:
    """With what a hinge holds its load down [N], shape (time,); negative where it bears it."""
    return _upwards(_frame(recording, hinge), recording.column("hinge_push", hinge.name))


def distance_from_axis(recording: Recording, hinge: Hinge, at: Vector) -> FloatArray:
    """How far a place on the load of a hinge is from its axis [m], shape (time,).

    Args:
        recording: The recording.
        hinge: The hinge.
        at: The place, from the origin of the load's body, its axes [m].
    """
    load = axes(recording.column("body_orientation", hinge.load))
    along = axes(_frame(recording, hinge))[:, :, 1]
    way = load @ (np.asarray(at, dtype=np.float64) - np.asarray(hinge.at, dtype=np.float64))
    distance: FloatArray = np.linalg.norm(np.cross(way, along), axis=1)
    return distance


def _frame(recording: Recording, hinge: Hinge) -> FloatArray:
    """Orientation of the axes of a hinge, quaternions (time, 4)."""
    return recording.column("body_orientation", hinge.pushes[-1])


def axial_force(recording: Recording, hinge: Hinge) -> FloatArray:
    """Force of the load on the hinge along its axis, positive that way [N], shape (time,)."""
    force: FloatArray = recording.column("hinge_push", hinge.name)[:, 1]
    return force


def radial_force(recording: Recording, hinge: Hinge) -> FloatArray:
    """Force at right angles to the axis of the hinge [N], shape (time,)."""
    forces = recording.column("hinge_push", hinge.name)
    radial: FloatArray = np.hypot(forces[:, 0], forces[:, 2])
    return radial


def hinge_moment(recording: Recording, hinge: Hinge) -> FloatArray:
    """Moment by which the hinge keeps the load from turning askew, about its middle [N m], shape (time,)."""
    return recording.column("hinge_moment", hinge.name)


def is_shut(recording: Recording, hinge: Hinge) -> BoolArray:
    """Samples at which a hinge holds its load, shape (time,); at that of its opening it does.

    It does at none where it opens as the recording begins: the first sample is of what comes after that.
    """
    shut = np.ones(len(recording.time), dtype=np.bool_)
    for time, _, name in recording.events(HINGE_OPENED):
        if name == hinge.name:
            # An equilibrium has but its end, at which what has opened is open.
            begins = time <= recording.time[0]
            shut &= recording.time < time if recording.is_equilibrium or begins else recording.time <= time
    return shut


def shut_as_at(recording: Recording, time: float) -> BoolArray:
    """Samples at which hinges hold their loads as at a time [s], shape (time,)."""
    same = np.ones(len(recording.time), dtype=np.bool_)
    for hinge in recording.rig.hinges:
        opened = [at for at, _, name in recording.events(HINGE_OPENED) if name == hinge.name]
        is_open = any(at < time or at <= recording.time[0] for at in opened)
        same &= is_shut(recording, hinge) != is_open
    return same
