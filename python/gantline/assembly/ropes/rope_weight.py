"""The weight of ropes: lumped to the bodies that they touch, or as nodes with mass between their ends.

Lumped: half of each straight segment goes to the guide at either end of it, an arc to the sheave on which it
lies, all by unstretched length; an end takes its share where the rope is fixed, a sheave at its centre. What
falls to the world is borne by the world. The mass stays where it was put: it does not travel along with the
rope.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.assembly.parts import Json, Parts, material
from gantline.assembly.ropes.catenary import NoRest, end_mass, hang, node_masses
from gantline.assembly.ropes.route import route_lengths
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.errors import PathPart
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.rope_weight import RopeWeight

__all__ = ["add_free_rope", "length_that_pulls", "lump_rope", "mass_at_end"]

#: A rope pulls least at its upper end where it is a quarter longer than its ends are apart, or less.
_LEAST_WITHIN = 2.0
#: Of a length that is searched for, of how far its ends are apart.
_ROUNDING = 1e-14


def mass_at_end(weight: RopeWeight, length: float) -> float:
    """Mass at each end of a rope that is free from end to end [kg]; `length` is unstretched [m]."""
    mass = weight.mass_per_length * length
    return end_mass(mass, weight.nodes) if weight.nodes else mass / 2


def lump_rope(
    parts: Parts, name: str, weight: RopeWeight, length: float | None, route: Sequence[Json]
) -> None:
    """Put the mass of a rope onto the bodies of its route.

    Of a rope with nodes, only what its ends carry.

    Args:
        parts: the system so far, with all bodies of the route.
        name: name of the rope.
        weight: how its weight acts.
        length: unstretched length [m]; None is just taut at the start.
        route: guides in order.
    """
    if weight.mass_per_length == 0:
        return
    straight, arcs = route_lengths(parts, route)
    routed = float(np.sum(straight) + np.sum(arcs))
    length = routed if length is None else length
    if weight.nodes:
        shares = np.full(2, mass_at_end(weight, length))
    else:
        halves = np.concatenate(([0.0], straight / 2, [0.0]))
        shares = (halves[:-1] + halves[1:] + arcs) * (weight.mass_per_length * length / routed)
    for guide, share in zip(route, shares, strict=True):
        at = guide["at"] if "at" in guide else (np.array(guide["enter"]) + np.array(guide["leave"])) / 2
        parts.lump(guide["body"], at, float(share))
        if guide["body"] is not None:
            lumps = parts.rope_lumps.setdefault(name, {})
            lumps[guide["body"]] = lumps.get(guide["body"], 0.0) + float(share)
    on_world = [share for guide, share in zip(route, shares, strict=True) if guide["body"] is None]
    parts.rope_mass[name] = weight.mass_per_length * length, float(np.sum(on_world))


def length_that_pulls(
    first: Array, last: Array, pull: float, kind: RopeMaterial, weight: RopeWeight, gravity: float
) -> tuple[float | None, float]:
    """The unstretched length at which a rope with nodes pulls so at its first end, hanging at rest.

    The shortest: a longer rope pulls less, and from some length on more by its own weight.

    Args:
        first: first end (3,) [m].
        last: last end (3,) [m].
        pull: wanted tension at the first end [N].
        kind: kind of rope, which stretches.
        weight: how its weight acts, on nodes.
        gravity: acceleration of gravity [m/s^2].

    Returns:
        The length [m], None where none pulls so little, and the least that any length pulls with [N].
    """
    from scipy.optimize import brentq, minimize_scalar  # takes half a second to load

    stiffness = kind.stiffness
    assert stiffness is not None  # a rope with nodes has been checked to stretch

    def pulls(length: float) -> float:
        masses = node_masses(weight.mass_per_length * length, weight.nodes)
        force = hang(first, last, length, stiffness, masses * gravity).forces[0]
        return float(np.linalg.norm(force - np.array([0.0, 0.0, mass_at_end(weight, length) * gravity])))

    chord = float(np.linalg.norm(last - first))
    short = chord / (1.0 + 2.0 * pull / stiffness)
    while pulls(short) <= pull:
        short *= 0.5
    lightest = minimize_scalar(pulls, bounds=(short, _LEAST_WITHIN * chord), method="bounded")
    if lightest.fun > pull:
        return None, float(lightest.fun)
    found = brentq(lambda length: pulls(length) - pull, short, lightest.x, xtol=_ROUNDING * chord)
    return float(found), float(lightest.fun)


def add_free_rope(
    parts: Parts,
    scenario: Scenario,
    path: tuple[PathPart, ...],
    name: str,
    kind: RopeMaterial,
    weight: RopeWeight,
    length: float,
    ends: Sequence[Json],
) -> None:
    """Add a rope that is free from end to end, with nodes that hang at rest if its weight is distributed.

    Args:
        parts: the system so far, with the bodies of both ends.
        scenario: the lift.
        path: where the lift file has the rope.
        name: name of the rope.
        kind: kind of rope.
        weight: how its weight acts.
        length: unstretched length [m].
        ends: its two ends.

    Raises:
        ScenarioError: if no place at rest was found for the nodes.
    """
    made_of = material(kind)
    if not weight.nodes:
        parts.add_rope(name, length, made_of, ends)
        return
    assert kind.stiffness is not None  # a rope with nodes has been checked to stretch
    masses = node_masses(weight.mass_per_length * length, weight.nodes)
    first, last = (parts.place(guide["body"], guide["at"]) for guide in ends)
    try:
        hanging = hang(first, last, length, kind.stiffness, masses * scenario.simulation.gravity)
    except NoRest:
        sentence = "no place was found where this rope hangs at rest"
        raise scenario.start_error(
            path, f"{sentence}; fewer nodes or 'rope_weight: lumped' may be right"
        ) from None
    parts.add_rope_with_nodes(name, length, made_of, ends, hanging.points[1:-1].tolist(), masses.tolist())
