"""Supports under the load, in the form of the document."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.parts import Json
from gantline.assembly.spatial import about_axis, rotation_matrix
from gantline.scenario import Scenario
from gantline.scenario.consistency.supports import foot_of
from gantline.scenario.loads.load import Load
from gantline.scenario.loads.supports import Support, Supports, supports_of

__all__ = ["every_support", "pad_shape", "removals", "support_contact", "support_pad"]


def support_contact(support: Support) -> str:
    """Name of the contact between a support and its load."""
    return f"support.{support.name}"


def every_support(scenario: Scenario) -> Iterator[tuple[Supports, Support]]:
    """All supports of a lift, each with its group."""
    for name, group in (scenario.supports or {}).items():
        for support in supports_of(name, group):
            yield group, support


def support_pad(
    scenario: Scenario, load: Load, group: Supports, support: Support, sides: Sequence[Json]
) -> Json:
    """A support as a flat top in the world, on which any of the load's sides may lie.

    Args:
        scenario: the lift.
        load: what stands on it.
        group: the group that it is of.
        support: the support.
        sides: corners (n, 3) of each side of the load from its centre of gravity [m], lists of lists.
    """
    heading = group.heading if group.measured_from == "world" else load.heading
    return {
        "name": support_contact(support),
        "group": load.name,
        "body": load.name,
        "at": support_place(scenario, load, group, support),
        "half": [side / 2 for side in support.top],
        "along": [math.cos(heading), math.sin(heading), 0.0],
        "sides": sides,
        "stiffness": support.stiffness,
        "damping_time": support.damping / support.stiffness,
        "friction": support.friction,
        "removed_at": support.removed_at,
    }


def support_place(scenario: Scenario, load: Load, group: Supports, support: Support) -> list[float]:
    """Middle of the top of a support in the world [m]."""
    level = foot_of(scenario, group) + support.height
    if group.measured_from == "world":
        turned = rotation_matrix(about_axis((0.0, 0.0, 1.0), group.heading)) @ np.array((*support.at, 0.0))
        return [float(turned[0]), float(turned[1]), level]
    turned = rotation_matrix(about_axis((0.0, 0.0, 1.0), load.heading)) @ np.array((*support.at, 0.0))
    return [load.position[0] + float(turned[0]), load.position[1] + float(turned[1]), level]


def removals(scenario: Scenario) -> list[list[str]]:
    """By step of the plan the contacts of the supports that are taken away as it begins."""
    every = [support for _, support in every_support(scenario)]

    def named(name: str) -> list[str]:
        return [support_contact(one) for one in every if name in (one.name, one.group)]

    return [[contact for name in step.remove_supports for contact in named(name)] for step in scenario.plan]


def pad_shape(support: Json, height: float) -> Json:
    """A support as a box in the world, from its foot to its top."""
    x, y, top = support["at"]
    angle = math.atan2(support["along"][1], support["along"][0])
    return {
        "type": "box",
        "size": [2 * support["half"][0], 2 * support["half"][1], height],
        "centre": [x, y, top - height / 2],
        "orientation": about_axis((0.0, 0.0, 1.0), angle),
    }
