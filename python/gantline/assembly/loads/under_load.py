"""Supports under the load where it starts: what of it each is under, and how far below."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gantline.assembly.loads.load_body import LoadBody
from gantline.assembly.loads.supports import every_support, support_pad
from gantline.assembly.loads.tops import Sides
from gantline.assembly.parts import Json
from gantline.assembly.spatial import Array, about_axis, rotation_matrix
from gantline.cad.underside import lowest_over
from gantline.scenario import Scenario
from gantline.scenario.consistency.supports import foot_of
from gantline.scenario.loads.load import Load
from gantline.scenario.loads.supports import OneSupport, Support, Supports

__all__ = ["UnderLoad", "cut_to_load", "nothing_over", "sides_in_world", "under_load"]


@dataclass(frozen=True)
class UnderLoad:
    """A support, and where the load would bear on it as it is given at the start.

    Attributes:
        group: what says more of it.
        support: the support.
        pad: its top, as the core reads it.
        place: where the load is nearest to it (3,), world axes [m]; None where nothing of the load that is
            flatter than 60° is over its top.
        rise: how steeply the load's side rises there, as a tangent; 0 without a place.
        own: lowest of all triangles of the load's CAD file over the top [m]; None where none is, or of a box.
    """

    group: Supports
    support: Support
    pad: Json
    place: Array | None
    rise: float
    own: float | None

    @property
    def gap(self) -> float | None:
        """How far the top is below the load [m], negative inside it; None without a place."""
        return None if self.place is None else float(self.place[2]) - float(self.pad["at"][2])


def cut_to_load(scenario: Scenario, load: Load, body: LoadBody) -> Scenario:
    """A lift with a height for each support whose top is up to the load: that of its underside at the start.

    Args:
        scenario: the lift.
        load: the load.
        body: its sides, measured from its datum.

    Raises:
        ScenarioError: if nothing of the load is over such a support, or it is not above its foot.
    """
    groups = dict(scenario.supports or {})
    in_world = sides_in_world(load, body.sides)
    cut = [(group, support) for group, support in every_support(scenario) if support.is_cut]
    for group, support in cut:
        path = ("supports", support.group)
        pad = support_pad(scenario, load, group, support, [])
        bearing = in_world.over(pad)
        if bearing is None:
            sentence = f"the height of '{support.name}' is up to the load, and {nothing_over(pad)}"
            raise scenario.start_error(path, f"{sentence}; say its height, or move it under the load")
        height = float(bearing.place[2]) - foot_of(scenario, group)
        if height <= 0.0:
            sentence = f"the load is {-height:.4g} m below the foot of '{support.name}'"
            right = "move the load up, or say the 'foot'"
            raise scenario.start_error(path, f"{sentence}, whose height is up to it; {right}")
        groups[support.group] = _with_height(groups[support.group], support, height)
    return scenario.model_copy(update={"supports": groups}) if cut else scenario


def _with_height(group: Supports, support: Support, height: float) -> Supports:
    """A group of which one support has this height [m]."""
    own = support.name[len(support.group) + 1 :]
    if own in (group.places or {}):
        places = dict(group.places or {})
        places[own] = places[own].model_copy(update={"height": height})
        return group.model_copy(update={"places": places})
    each = dict(group.each or {})
    each[own] = each.get(own, OneSupport()).model_copy(update={"height": height})
    return group.model_copy(update={"each": each})


def nothing_over(pad: Json) -> str:
    """What is wrong with a support without a place of the load, in words."""
    x, y, _ = pad["at"]
    length, breadth = (2.0 * half for half in pad["half"])
    top = f"its top of {length:g} m by {breadth:g} m at ({x:.2f}, {y:.2f}) m"
    return f"nothing of the load that is flatter than 60° is over {top}"


def under_load(scenario: Scenario, load: Load, body: LoadBody, centre: Array) -> list[UnderLoad]:
    """Every support of a lift under the load.

    Args:
        scenario: the lift.
        load: the load.
        body: its sides and triangles, measured from its datum.
        centre: its centre of gravity with what is lumped on it, from its datum (3,) [m].
    """
    sides = [(side - centre).tolist() for side in body.sides]
    in_world = sides_in_world(load, body.sides)
    turned = rotation_matrix(about_axis((0.0, 0.0, 1.0), load.heading))
    corners = None if body.surface is None else body.surface.corners @ turned.T + np.array(load.position)
    found = []
    for group, support in every_support(scenario):
        pad = support_pad(scenario, load, group, support, sides)
        own = None if corners is None else _lowest(corners, pad)
        place, rise = in_world.over(pad) or (None, 0.0)
        found.append(UnderLoad(group, support, pad, place, rise, own))
    return found


def sides_in_world(load: Load, sides: Sequence[Array]) -> Sides:
    """Sides of a load, from its datum, where it is at the start."""
    turned = rotation_matrix(about_axis((0.0, 0.0, 1.0), load.heading))
    return Sides(tuple(side @ turned.T + np.array(load.position) for side in sides))


def _lowest(corners: Array, pad: Json) -> float | None:
    """Lowest of triangles (m, 3, 3), world axes [m], over the top of a support."""
    x, y, _ = pad["along"]
    along = np.array([[x, -y, 0.0], [y, x, 0.0], [0.0, 0.0, 1.0]])
    over = (corners - np.array([*pad["at"][:2], 0.0])) @ along
    return lowest_over(over, (pad["half"][0], pad["half"][1]))
