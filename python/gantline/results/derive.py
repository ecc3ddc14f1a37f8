"""From the core's columns to the variables of a recording, as functions of arrays and rig."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gantline.results.boom import boom_state
from gantline.results.crane import corner_loads, crane_events, hook_state
from gantline.results.crawler import crawler_events, crawler_state
from gantline.results.flows import rope_flows
from gantline.results.gear import Hook
from gantline.results.moorings import mooring_state
from gantline.results.nodes import joined
from gantline.results.rating import rated_groups
from gantline.results.recording import Recording
from gantline.results.rig import Load, Rig
from gantline.results.rotation import tilt
from gantline.results.tanks import tank_contents
from gantline.results.variable import FloatArray, Variable
from gantline.results.vessels import vessel_state
from gantline.results.wind import wind_at_loads

Columns = Mapping[str, FloatArray]
Names = Mapping[str, Sequence[str]]

#: A drawn path is kept to 60 nm; a power of two, so that the last bits of its numbers are zeros, which pack.
_POINTS_PER_METRE = 2.0**24

# name in the columns -> name in the recording, dimensions, unit, description
_DIRECT: dict[str, tuple[str, tuple[str, ...], str, str]] = {
    "rope_tension": (
        "rope_tension",
        ("time", "rope"),
        "N",
        "tension of a rope: mean over its segments, or the largest of its nodes' segments",
    ),
    "rope_lengthening": (
        "rope_lengthening",
        ("time", "rope"),
        "m",
        "what adjusting has added to the natural length of a rope",
    ),
    "segment_tension": ("segment_tension", ("time", "segment"), "N", "tension of a segment of rope"),
    "segment_length": ("segment_length", ("time", "segment"), "m", "length of a segment of rope, stretched"),
    "rope_point": ("rope_point", ("time", "rope_point", "xyz"), "m", "points on the drawn path of a rope"),
    "wrap_angle": (
        "wrap_angle",
        ("time", "wrapped_sheave"),
        "rad",
        "angle over which a rope lies on a sheave; 0 where it runs straight past",
    ),
    "fleet_angle": (
        "fleet_angle",
        ("time", "wrapped_sheave", "sheave_side"),
        "rad",
        "angle of a rope to the plane of a sheave, positive to where its axis points",
    ),
    "body_position": ("body_position", ("time", "body", "xyz"), "m", "centre of gravity of a body"),
    "body_orientation": (
        "body_orientation",
        ("time", "body", "wxyz"),
        "1",
        "unit quaternion world from body",
    ),
    "body_velocity": (
        "body_velocity",
        ("time", "body", "xyz"),
        "m/s",
        "velocity of the centre of gravity, world axes",
    ),
    "body_angular_velocity": (
        "body_angular_velocity",
        ("time", "body", "xyz"),
        "rad/s",
        "angular velocity of a body, world axes",
    ),
    "joint_position": (
        "joint_position",
        ("time", "joint"),
        "m or rad",
        "position of a slider or hinge; rope that passed a sheave or left a drum",
    ),
    "pin_force": (
        "pin_force",
        ("time", "pin"),
        "N",
        "force that a locking pin takes, positive where its sheave is pulled down; 0 while it is out",
    ),
    "contact_force": ("contact_force", ("time", "contact"), "N", "normal force of a contact point"),
    "clearance": (
        "clearance",
        ("time", "pair"),
        "m",
        "smallest distance of a watched pair, 0 or less where they touch",
    ),
    "displaced_volume": (
        "displaced_volume",
        ("time", "hull"),
        "m^3",
        "volume of a hull below the water",
    ),
    "clearance_point": (
        "clearance_point",
        ("time", "pair", "pair_side", "xyz"),
        "m",
        "where a watched pair is nearest: a point of each side, of a rope on its centre line",
    ),
    "energy": (
        "energy",
        ("time", "energy_kind"),
        "J",
        "energy by kind; gravity from the start, losses add up",
    ),
    "constraint_residual": (
        "residual_constraint",
        ("time",),
        "m",
        "largest excess length of an inextensible rope",
    ),
    "complementarity_residual": (
        "residual_complementarity",
        ("time",),
        "N",
        "largest distance of a force from its law",
    ),
    "rope_peak_tension": ("rope_peak_tension", ("rope",), "N", "largest tension of a rope over all steps"),
    "rope_peak_time": ("rope_peak_time", ("rope",), "s", "time of the largest tension of a rope"),
    "event_time": ("event_time", ("event",), "s", "time of an event"),
}
_NAMED = (
    "rope",
    "segment",
    "wrapped_sheave",
    "body",
    "joint",
    "contact",
    "pin",
    "pair",
    "hull",
    "energy_kind",
)
# name in the recording, name among the names, dimension, description
_TEXTS = (
    ("rope_of_point", "rope_point", "rope_point", "rope to which a drawn point belongs"),
    ("event_kind", "event_kind", "event", "kind of an event"),
    ("event_name", "event_name", "event", "what the event happened to"),
)


def recording_of(columns: Columns, names: Names, rig: Mapping[str, Any], **attributes: Any) -> Recording:
    """Make a recording of what the core recorded.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions, and `event_kind`, `event_name`.
        rig: What results need to know of the lift, see `gantline.results.rig`.
        attributes: Further attributes of the recording: `title`, `scene`, `settings`, ...

    Returns:
        The recording, with the variables that riggers ask for added to those of the core.
    """
    lift = Rig.from_json(rig)
    columns, names, of_nodes = joined(columns, names, lift)
    columns, names, contents, tanks = tank_contents(columns, names, lift)
    variables, coordinates = _direct(columns, names, of_nodes)
    variables |= _commands(columns, names)
    for derived, labels in (
        (contents, tanks),
        _sheave_travel(columns, names, lift),
        _hook_loads(columns, names, lift),
        _load_state(columns, names, lift),
        rope_flows(columns, names, lift),
        wind_at_loads(columns, names, {load.name: load.body for load in lift.loads}, lift.wind),
        vessel_state(columns, names, lift.vessels, lift.sea),
        mooring_state(columns, names, lift.mooring_lines, lift.fenders),
    ):
        variables |= derived
        coordinates |= labels
    of_cranes, labels = _cranes(columns, names, lift, variables)
    variables |= of_cranes
    coordinates |= labels
    if "rope_point" in variables:
        variables["rope_point"] = _rounded(variables["rope_point"], names["rope_point"])
    return Recording(variables, _used(coordinates, variables), {**attributes, "rig": dict(rig)})


def present_of(columns: Columns, names: Names, lift: Rig, wanted: str) -> Recording:
    """A variable of one moment: one that is a column of the core, or the loads of hooks.

    Args:
        columns: Columns of the core by name, of one sample.
        names: Names along their dimensions.
        lift: What results need to know of the lift.
        wanted: Name of the variable.

    Returns:
        A recording of one sample that has this variable; where it is not one of these, all of the core's.
    """
    columns, names, of_nodes = joined(columns, {**names, "event_kind": (), "event_name": ()}, lift)
    if wanted in ("hook_load", "hoist_load"):
        loads, hooks = _hook_loads(columns, names, lift)
        return Recording(loads, hooks, {})
    for column, (name, dims, unit, description) in _DIRECT.items():
        if name == wanted and columns[column].size:
            labels = {dim: names[dim] for dim in dims if dim in _NAMED}
            return Recording({name: Variable(dims, columns[column], unit, description)}, labels, {})
    variables, coordinates = _direct(columns, names, of_nodes)
    return Recording(variables, _used(coordinates, variables), {})


def _direct(
    columns: Columns, names: Names, of_nodes: Mapping[str, Variable]
) -> tuple[dict[str, Variable], dict[str, Sequence[str]]]:
    """Variables that are columns of the core as they are, and the names along dimensions."""
    variables = {"time": Variable(("time",), columns["time"], "s", "time since the start of the lift")}
    for column, (name, dims, unit, description) in _DIRECT.items():
        if columns[column].size or "event" in dims:
            # Nobody else has them: no copy is needed to keep them as they are.
            columns[column].flags.writeable = False
            variables[name] = Variable(dims, columns[column], unit, description)
    for name, source, dim, description in _TEXTS:
        variables[name] = Variable((dim,), np.array(names[source], dtype=np.str_), "1", description)
    coordinates: dict[str, Sequence[str]] = {kind: names[kind] for kind in _NAMED if len(names[kind])}
    coordinates |= {"xyz": ("x", "y", "z"), "wxyz": ("w", "x", "y", "z")}
    coordinates["sheave_side"] = ("arriving", "leaving")
    coordinates["pair_side"] = ("first", "second")
    if of_nodes:
        variables |= of_nodes
        coordinates["rope_end"] = ("first", "last")
    return variables, coordinates


def _used(
    coordinates: Mapping[str, Sequence[str]], variables: Mapping[str, Variable]
) -> dict[str, Sequence[str]]:
    """Coordinates of dimensions that some variable has."""
    used = {dim for variable in variables.values() for dim in variable.dims}
    return {dim: labels for dim, labels in coordinates.items() if dim in used}


# name in columns and recording -> unit, description
_OF_COMMANDS = {
    "command_time": ("s", "when a program commanded a drive"),
    "command_speed": ("m/s or rad/s", "speed that it commanded, signed"),
    "command_acceleration": ("m/s^2 or rad/s^2", "acceleration that it allowed"),
    "command_name": ("1", "what it commanded, as the plan names it"),
    "command_motion": ("1", "verb of the plan for that motion"),
}


def _commands(columns: Columns, names: Names) -> dict[str, Variable]:
    """What programs have commanded; nothing of a lift at rest, or that its plan alone moves."""
    if not len(columns.get("command_time", ())):
        return {}
    found = {}
    for name, (unit, description) in _OF_COMMANDS.items():
        values = columns[name] if name in columns else np.array(names[name], dtype=np.str_)
        found[name] = Variable(("command",), values, unit, description)
    return found


def _rounded(path: Variable, ropes: Sequence[str]) -> Variable:
    """Drawn points, rounded but for the ends of ropes, whose directions count.

    Forces have been found by them before: their last digits fill half of a file.
    """
    points = path.values * _POINTS_PER_METRE
    np.rint(points, out=points)
    points /= _POINTS_PER_METRE
    owner = np.asarray(ropes)
    is_new = owner[1:] != owner[:-1]
    ends = np.flatnonzero(np.append(True, is_new) | np.append(is_new, True))
    points[:, ends] = path.values[:, ends]
    points.flags.writeable = False
    return replace(path, values=points)


_Derived = tuple[dict[str, Variable], dict[str, Sequence[str]]]


def _sheave_travel(columns: Columns, names: Names, rig: Rig) -> _Derived:
    sheaves = [sheave for equalizer in rig.equalizers for sheave in equalizer.moving_sheaves]
    if not sheaves:
        return {}, {}
    joints = list(names["joint"])
    # Sheaves of an approximated equalizer are no bodies, and stand still.
    still = np.zeros(len(columns["time"]))
    own = [columns["joint_position"][:, joints.index(s)] if s in joints else still for s in sheaves]
    # Joints count from where the lift file has them, as stops do: a start at rest may be elsewhere.
    travel = Variable(
        ("time", "moving_sheave"),
        np.stack(own, axis=1),
        "m",
        "travel of a moving sheave in its frame, down positive",
    )
    return {"sheave_travel": travel}, {"moving_sheave": sheaves}


def _hook_loads(columns: Columns, names: Names, rig: Rig) -> _Derived:
    if not rig.hooks:
        return {}, {}
    hook_load = np.stack([_hook_load(columns, names, hook) for hook in rig.hooks], axis=1)
    hoist_load = np.stack(
        [_hoist_load(columns, names, hook, load) for hook, load in zip(rig.hooks, hook_load.T, strict=True)],
        axis=1,
    )
    dims = ("time", "hook")
    return {
        "hook_load": Variable(dims, hook_load, "N", "vertical force on the bearing of a hook"),
        "hoist_load": Variable(dims, hoist_load, "N", "hook load with hook block and hanging falls"),
    }, {"hook": [hook.name for hook in rig.hooks]}


def _hoist_load(columns: Columns, names: Names, hook: Hook, hook_load: FloatArray) -> FloatArray:
    """What the upper sheaves see of a hook that hangs in ropes; else hook load, hook block and falls."""
    if not hook.falls:
        return hook_load + hook.hoist_weight_extra
    segments = list(names["segment"])
    at = [segments.index(fall) for fall in hook.falls]
    carried: FloatArray = columns["segment_tension"][:, at].sum(axis=1) + hook.falls_weight_above
    return carried


def _hook_load(columns: Columns, names: Names, hook: Hook) -> FloatArray:
    bodies, ropes = list(names["body"]), list(names["rope"])
    total = np.full(len(columns["time"]), hook.direct_weight)
    for body in hook.bearing_joints:
        total += columns["joint_force"][:, bodies.index(body), 2]
    slings = [sling if sling in ropes else f"sling.{sling}" for sling in hook.direct_slings]
    # The upper end of a sling comes first.
    for rope, end in [*((sling, "first") for sling in slings), *hook.direct_ropes]:
        total += _pulled_down(columns, names, rope, *((0, 0, 1) if end == "first" else (-1, -1, -2)))
    for over in hook.ropes_over:
        points = sum(of == over.rope for of in names["rope_point"])
        arcs = sum(over.arcs)
        # All arcs are drawn with as many points, everything else with one.
        each = (points - len(over.arcs) + arcs) // arcs if arcs else 1
        first, last = (
            sum(each if arc else 1 for arc in over.arcs[:end]) for end in (over.place, over.place + 1)
        )
        total += _pulled_down(columns, names, over.rope, over.place - 1, first, first - 1)
        total += _pulled_down(columns, names, over.rope, over.place, last - 1, last)
    return total


def _pulled_down(
    columns: Columns, names: Names, rope: str, segment: int, own: int, following: int
) -> FloatArray:
    """What a segment of a rope pulls down with at a drawn point, towards another [N], shape (time,)."""
    at = [place for place, of in enumerate(names["rope_point"]) if of == rope]
    own_segments = [place for place, of in enumerate(names["segment"]) if of.rpartition("/")[0] == rope]
    pull = columns["rope_point"][:, at[following]] - columns["rope_point"][:, at[own]]
    # A rope that has parted is drawn as one point at its upper end, and pulls no way.
    down = -pull[:, 2] / np.maximum(np.linalg.norm(pull, axis=1), np.finfo(np.float64).tiny)
    force: FloatArray = columns["segment_tension"][:, own_segments[segment]] * down
    return force


def _cranes(columns: Columns, names: Names, rig: Rig, known: dict[str, Variable]) -> _Derived:
    """What is particular to cranes; moments at which their limits are passed join the events."""
    hooks = rig.carried_hooks
    if not hooks:
        return {}, {}
    loads = {
        name: {hook.name: known[name].values[:, place] for place, hook in enumerate(rig.hooks)}
        for name in ("hook_load", "hoist_load")
    }
    found: dict[str, Variable] = {}
    labels: dict[str, Sequence[str]] = {}
    for of, named in (
        hook_state(columns, names, hooks, [load.name for load in rig.loads]),
        corner_loads(columns, names, rig.cranes, loads["hoist_load"]),
        boom_state(columns, names, rig.booms),
        crawler_state(columns, names, rig.crawlers),
    ):
        found |= of
        labels |= named
    height = found["hook_height"].values
    heights = {name: height[:, place] for place, name in enumerate(labels["crane_hook"])}
    passed = list(crane_events(columns["time"], rig.ratings, loads, hooks, heights))
    passed += _overloads(columns["time"], rig, loads, found, labels)
    if rig.crawlers:
        tipping = dict(zip(labels["crawler"], found["tipping_utilisation"].values.T, strict=True))
        passed += crawler_events(columns["time"], rig.crawlers, tipping)
    events = [known[f"event_{key}"].values.tolist() for key in ("time", "kind", "name")]
    before = list(zip(*events, strict=True))
    # Corners of tracks have no friction, what it would hold joints do: that they slip is no event.
    corners = {corner for crane in rig.crawlers for corner in crane.corners}
    kept = [one for one in before if not (one[1] in ("slip", "stick") and one[2] in corners)]
    together = sorted([*kept, *passed], key=lambda event: event[0])
    if together != before:
        for place, key in enumerate(("time", "kind", "name")):
            kind = np.float64 if key == "time" else np.str_
            values = np.array([event[place] for event in together], dtype=kind)
            found[f"event_{key}"] = replace(known[f"event_{key}"], values=values)
    return found, labels


def _overloads(
    time: FloatArray,
    rig: Rig,
    loads: Mapping[str, Mapping[str, FloatArray]],
    found: Mapping[str, Variable],
    labels: Mapping[str, Sequence[str]],
) -> list[tuple[float, str, str]]:
    """Moments at which more hangs from a crane, or one of its hooks, than its chart allows where it is."""
    events = []
    for chart in rig.rating_charts:
        of = loads["hoist_load" if chart.includes_hook_block else "hook_load"]
        borne = np.sum([loads["hook_load"][hook] for hook in chart.hooks], axis=0)
        for group in rated_groups(chart):
            load = np.where(borne > 0, np.sum([of[hook] for hook in group.hooks], axis=0), 0.0)
            if chart.over == "angle":
                places = found["boom_angle"].values[:, [labels["boom"].index(chart.crane)]]
            else:
                columns = [labels["boom_hook"].index(hook) for hook in group.hooks]
                places = found["crane_radius"].values[:, columns]
            name = group.element if group.element in group.hooks else chart.crane
            events += [(at, "overload", name) for at in chart.overloads(time, load, places, group.share)]
    return events


def _load_state(columns: Columns, names: Names, rig: Rig) -> _Derived:
    if not rig.loads:
        return {}, {}
    transferred = np.stack([_transferred(columns, names, load) for load in rig.loads], axis=1)
    bodies = [list(names["body"]).index(load.body) for load in rig.loads]
    dims = ("time", "load")
    return {
        "load_transferred": Variable(dims, transferred, "1", "1 - support forces/weight of a load"),
        "load_tilt": Variable(
            dims,
            tilt(columns["body_orientation"][:, bodies]),
            "rad",
            "angle of a load's own z axis from plumb",
        ),
    }, {"load": [load.name for load in rig.loads]}


def _transferred(columns: Columns, names: Names, load: Load) -> FloatArray:
    at = [list(names["contact"]).index(contact) for contact in load.contacts]
    carried: FloatArray = 1.0 - columns["contact_force"][:, at].sum(axis=1) / load.weight
    return carried
