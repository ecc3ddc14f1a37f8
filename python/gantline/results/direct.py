"""Variables of a recording that are columns of the core as they are, with their dimensions and units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gantline.results.file.layout import COUNTED, DIMS, FIXED
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = ["DIRECT", "commands", "direct", "only", "round_path"]

#: A drawn path is kept to 60 nm; a power of two, so that the last bits of its numbers are zeros, which pack.
_POINTS_PER_METRE = 2.0**24
#: Samples that are rounded at once: few enough to stay in the cache.
_AT_ONCE = 32

#: Unit and description of each, by the name that column and variable have; `layout` has the dimensions.
DIRECT: dict[str, tuple[str, str]] = {
    "rope_tension": ("N", "tension of a rope: mean over its segments, or the largest of its nodes' segments"),
    "rope_lengthening": ("m", "what adjusting has added to the unstretched length of a rope"),
    "segment_tension": ("N", "tension of a segment of rope"),
    "segment_length": ("m", "length of a segment of rope, stretched"),
    "rope_point": ("m", "points on the drawn path of a rope"),
    "wrap_angle": ("rad", "angle over which a rope lies on a sheave; 0 where it runs straight past"),
    "fleet_angle": ("rad", "angle of a rope to the plane of a sheave, positive to where its axis points"),
    "body_position": ("m", "centre of gravity of a body"),
    "body_orientation": ("1", "unit quaternion world from body"),
    "body_velocity": ("m/s", "velocity of the centre of gravity, world axes"),
    "body_angular_velocity": ("rad/s", "angular velocity of a body, world axes"),
    "momentum": ("kg m/s", "momentum of all bodies together"),
    "angular_momentum": ("kg m^2/s", "angular momentum of all bodies together about the world's origin"),
    "joint_position": ("m or rad", "position of a slider or hinge; rope that passed a sheave or left a drum"),
    "pin_force": (
        "N",
        "force that a locking pin takes, positive where its sheave is pulled down; 0 while it is out",
    ),
    "contact_force": ("N", "normal force of a contact point"),
    "clearance": ("m", "smallest distance of a watched pair, 0 or less where they touch"),
    "displaced_volume": ("m^3", "volume of a hull, or of what a load displaces, below the water"),
    "clearance_point": (
        "m",
        "where a watched pair is nearest: a point of each side, of a rope on its centre line",
    ),
    "energy": ("J", "energy by kind; gravity from the start, losses add up"),
    "heave_compensation": (
        "m",
        "by how much heave compensation has raised a hook; 0 once it has ended, the hook staying where it is",
    ),
    "residual_constraint": ("m", "largest excess length of an inextensible rope"),
    "residual_complementarity": ("N", "largest distance of a force from its law"),
    "rope_peak_tension": ("N", "largest tension of a rope over all steps"),
    "rope_peak_time": ("s", "time of the largest tension of a rope"),
    "contact_peak_force": ("N", "largest normal force of a contact point over all steps"),
    "contact_peak_time": ("s", "time of the largest normal force of a contact point"),
    "event_time": ("s", "time of an event"),
}
#: Dimensions whose entries have names.
_NAMED = {dim for name in DIRECT for dim in DIMS[name]} - COUNTED
# name in the recording, name among the names, dimension, description
_TEXTS = (
    ("rope_of_point", "rope_point", "rope_point", "rope to which a drawn point belongs"),
    ("event_kind", "event_kind", "event", "kind of an event"),
    ("event_name", "event_name", "event", "what the event happened to"),
)


def direct(columns: Columns, names: Names, of_nodes: Mapping[str, Variable]) -> Derived:
    """Variables that are columns of the core as they are, and the names along dimensions."""
    variables = {"time": Variable(("time",), columns["time"], "s", "time since the start of the lift")}
    for name, (unit, description) in DIRECT.items():
        dims, values = DIMS[name], columns[name]
        # Before there are samples, what a lift has is there without values.
        is_there = dims[0] == "time" and 0 not in values.shape[1:]
        if is_there or values.size or "event" in dims:
            # Nobody else has them: no copy is needed to keep them as they are.
            values.flags.writeable = False
            variables[name] = Variable(dims, values, unit, description)
    for name, source, dim, description in _TEXTS:
        variables[name] = Variable((dim,), np.array(names[source], dtype=np.str_), "1", description)
    coordinates: dict[str, Sequence[str]] = {dim: names[dim] for dim in names if dim in _NAMED and names[dim]}
    coordinates |= {dim: FIXED[dim] for dim in ("xyz", "wxyz", "sheave_side", "pair_side")}
    if of_nodes:
        variables |= of_nodes
        coordinates["rope_end"] = FIXED["rope_end"]
    return variables, coordinates


def only(columns: Columns, names: Names, wanted: str) -> tuple[Variable, dict[str, Sequence[str]]] | None:
    """One such variable and the names along its dimensions; None where no column is that, or it is empty."""
    if wanted not in DIRECT or not columns[wanted].size:
        return None
    dims = DIMS[wanted]
    labels = {dim: names[dim] for dim in dims if dim in names and dim in _NAMED}
    return Variable(dims, columns[wanted], *DIRECT[wanted]), labels


# name in columns and recording -> unit, description
_OF_COMMANDS = {
    "command_time": ("s", "when a program commanded a drive"),
    "command_speed": ("m/s or rad/s", "speed that it commanded, signed"),
    "command_acceleration": ("m/s^2 or rad/s^2", "acceleration that it allowed"),
    "command_name": ("1", "what it commanded, as the plan names it"),
    "command_motion": ("1", "verb of the plan for that motion"),
}


def commands(columns: Columns, names: Names) -> dict[str, Variable]:
    """What programs have commanded; nothing of a lift at rest, or that its plan alone moves."""
    if not len(columns.get("command_time", ())):
        return {}
    found = {}
    for name, (unit, description) in _OF_COMMANDS.items():
        values = columns[name] if name in columns else np.array(names[name], dtype=np.str_)
        found[name] = Variable(("command",), values, unit, description)
    return found


def round_path(points: FloatArray, ropes: Sequence[str]) -> None:
    """Round drawn points in place, but for the ends of ropes, whose directions count.

    Forces have been found by them before: their last digits fill half of a file. A path is most of what a
    recording holds, and a copy of it would double that.

    Args:
        points: Points of all ropes, (time, rope_point, xyz) [m].
        ropes: The rope to which each of them belongs.
    """
    owner = np.asarray(ropes)
    is_end = np.ones((2, len(owner)), dtype=np.bool_)
    is_end[0, 1:] = is_end[1, :-1] = owner[1:] != owner[:-1]
    ends = np.flatnonzero(is_end.any(axis=0))
    for first in range(0, len(points), _AT_ONCE):
        some = points[first : first + _AT_ONCE]
        kept = some[:, ends]
        some *= _POINTS_PER_METRE
        np.rint(some, out=some)
        some /= _POINTS_PER_METRE
        some[:, ends] = kept
