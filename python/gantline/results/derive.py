"""From the core's columns to the variables of a recording, as functions of arrays and rig."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gantline.results.afloat.moorings import mooring_state
from gantline.results.afloat.tanks import tank_contents, weight_of
from gantline.results.afloat.vessels import vessel_state
from gantline.results.afloat.wind import wind_at_loads
from gantline.results.cranes.boom import boom_state
from gantline.results.cranes.chain_hoists import chain_hoist_state
from gantline.results.cranes.crane import corner_loads, crane_events, hook_state
from gantline.results.cranes.crawler import crawler_events, crawler_state
from gantline.results.cranes.rating import (
    counted_load,
    counted_places,
    overloads,
    place_of,
    rated_at_places,
    rated_groups,
)
from gantline.results.direct import commands, direct, only, round_path
from gantline.results.loads.guides import guide_state
from gantline.results.loads.hinges import held_up, hinge_columns, hinge_moments_kept, hinge_state
from gantline.results.loads.hook_load import hook_loads, hook_peaks
from gantline.results.recording import Recording
from gantline.results.rig import Load, Rig
from gantline.results.ropes.flows import rope_flows
from gantline.results.ropes.nodes import joined
from gantline.results.rotation import tilt
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable


def recording_of(
    columns: Columns, names: Names, rig: Mapping[str, Any], pulled: Columns | None = None, **attributes: Any
) -> Recording:
    """Make a recording of what the core recorded.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions, and `event_kind`, `event_name`.
        rig: What results need to know of the lift, see `gantline.results.rig`.
        pulled: Columns of the moments at which ropes of hooks pulled most, see `hook_peaks`, and at which
            hinges bore most, see `hinge_moments_kept`.
        attributes: Further attributes of the recording: `title`, `scene`, `settings`, ...

    Returns:
        The recording, with the variables that riggers ask for added to those of the core.
    """
    lift = Rig.from_json(rig)
    peaks = {} if pulled is None else _peaks(*joined(pulled, names, lift)[:2], lift)
    columns, names, of_nodes = joined(columns, names, lift)
    columns, names = hinge_columns(columns, names, lift)
    columns, names, contents, tanks = tank_contents(columns, names, lift)
    round_path(columns["rope_point"], names["rope_point"])
    variables, coordinates = direct(columns, names, of_nodes)
    variables |= commands(columns, names) | peaks
    for derived, labels in ((contents, tanks), *_of_each_sample(columns, names, lift)):
        variables |= derived
        coordinates |= labels
    of_cranes, labels = _cranes(columns, names, lift, variables)
    variables |= of_cranes
    coordinates |= labels
    return Recording(variables, _used(coordinates, variables), {**attributes, "rig": dict(rig)})


def _peaks(pulled: Columns, names: Names, lift: Rig) -> dict[str, Variable]:
    """What hooks and hinges bore at most over all steps."""
    return hook_peaks(pulled, names, lift) | hinge_moments_kept(pulled, names, lift)


def _of_each_sample(columns: Columns, names: Names, lift: Rig) -> Iterator[Derived]:
    """What follows from the columns of a sample by themselves, the cheapest first."""
    yield hook_loads(columns, names, lift)
    yield _load_state(columns, names, lift)
    yield hinge_state(columns, names, lift)
    yield _sheave_travel(columns, names, lift)
    yield _rods_out(columns, names, lift)
    yield rope_flows(columns, names, lift)
    yield chain_hoist_state(columns, names, lift)
    yield wind_at_loads(columns, names, {load.name: load.body for load in lift.loads}, lift.wind)
    yield mooring_state(columns, names, lift.mooring_lines, lift.fenders)
    yield guide_state(columns, names, lift.guides)
    yield vessel_state(columns, names, lift.vessels, lift.sea)


def present_of(columns: Columns, names: Names, lift: Rig, wanted: str) -> Recording:
    """A variable of one moment: one that is a column of the core, or follows from one sample.

    Args:
        columns: Columns of the core by name, of one sample.
        names: Names along their dimensions.
        lift: What results need to know of the lift.
        wanted: Name of the variable.

    Returns:
        A recording of one sample that has this variable; where it is not one of these, all that are.
    """
    columns, names, of_nodes = joined(columns, {**names, "event_kind": (), "event_name": ()}, lift)
    columns, names = hinge_columns(columns, names, lift)
    columns, names, contents, tanks = tank_contents(columns, names, lift)
    found = only(columns, names, wanted)
    if found is not None:
        return Recording({wanted: found[0]}, found[1], {})
    variables, coordinates = direct(columns, names, of_nodes)
    variables = {name: one for name, one in variables.items() if one.dims[0] == "time" and one.dims[1:]}
    for derived, labels in ((contents, tanks), *_of_each_sample(columns, names, lift)):
        if wanted in derived:
            one = {wanted: derived[wanted]}
            return Recording(one, _used(labels, one), {})
        variables |= derived
        coordinates |= labels
    return Recording(variables, _used(coordinates, variables), {})


def _used(
    coordinates: Mapping[str, Sequence[str]], variables: Mapping[str, Variable]
) -> dict[str, Sequence[str]]:
    """Coordinates of dimensions that some variable has."""
    used = {dim for variable in variables.values() for dim in variable.dims}
    return {dim: labels for dim, labels in coordinates.items() if dim in used}


def _sheave_travel(columns: Columns, names: Names, rig: Rig) -> Derived:
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


def _rods_out(columns: Columns, names: Names, rig: Rig) -> Derived:
    if not rig.compensators:
        return {}, {}
    joints = list(names["joint"])
    own = [columns["joint_position"][:, joints.index(one.rod)] for one in rig.compensators]
    text = "how far the rod of a compensator is out, 0 at its inner stop"
    out = Variable(("time", "compensator"), np.stack(own, axis=1), "m", text)
    return {"rod_out": out}, {"compensator": [one.name for one in rig.compensators]}


def _cranes(columns: Columns, names: Names, rig: Rig, known: dict[str, Variable]) -> Derived:
    """What is particular to cranes; moments at which limits of hooks and cranes are passed are events."""
    if not rig.hooks:
        return {}, {}
    hooks = rig.carried_hooks
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
    heights = {hook.name: found["hook_height"].values[:, place] for place, hook in enumerate(hooks)}
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
        for group in rated_groups(chart):
            load = counted_load(rig, chart, group.hooks, loads)
            where = {}
            for hook in group.hooks:
                variable, column = place_of(chart, hook)
                of = labels["boom" if variable == "boom_angle" else "boom_hook"]
                where[hook] = found[variable].values[:, of.index(column)]
            places = counted_places(rig, chart, where, loads)
            rated = rated_at_places(rig, chart, group, places, loads)
            name = group.element if group.element in group.hooks else chart.crane
            events += [(at, "overload", name) for at in overloads(time, load, rated)]
    return events


def _load_state(columns: Columns, names: Names, rig: Rig) -> Derived:
    if not rig.loads:
        return {}, {}
    borne = np.stack([_borne(columns, names, load) for load in rig.loads], axis=1)
    hang = [
        1.0
        - (borne[:, place] + held_up(columns, names, rig, load.name)) / weight_of(columns, names, rig, load)
        for place, load in enumerate(rig.loads)
    ]
    # A hinge that holds its load down against its hooks bears nothing of it, nor does a wall by its friction.
    transferred = np.minimum(np.stack(hang, axis=1), 1.0)
    bodies = [list(names["body"]).index(load.body) for load in rig.loads]
    dims = ("time", "load")
    return {
        "load_borne": Variable(
            dims,
            borne,
            "N",
            "what supports, ground and other bodies bear of a load: their force upwards, with friction",
        ),
        "load_transferred": Variable(
            dims,
            transferred,
            "1",
            "1 - what supports and hinge bear/weight of a load with its tanks, 1 at most",
        ),
        "load_tilt": Variable(
            dims,
            tilt(columns["body_orientation"][:, bodies]),
            "rad",
            "angle of a load's own z axis from plumb",
        ),
    }, {"load": [load.name for load in rig.loads]}


def _borne(columns: Columns, names: Names, load: Load) -> FloatArray:
    """What all that a load touches bears of it, forces upwards [N], shape (time,)."""
    at = [list(names["contact"]).index(contact) for contact in load.contacts]
    borne: FloatArray = columns["contact_lift"][:, at].sum(axis=1)
    return borne
