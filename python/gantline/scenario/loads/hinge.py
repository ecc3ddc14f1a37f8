"""Hinges and grippers: what holds a load at one place, so that it turns there about one axis."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.quantities import Direction, Name, Position, PositiveLength, PositiveMass, Torque

if TYPE_CHECKING:
    from gantline.scenario.model import Scenario

__all__ = ["PUSHES", "TURNS", "LoadHinge", "failed_at", "hinge_joints", "hinge_pins", "opened_in"]

#: What the load cannot do in a hinge, by the ends of the names of joints that pins hold: ways along the axes
#: of the hinge, and turns about the two that are not its own. Each is a joint on the one before.
PUSHES = ("across", "along", "upright")
TURNS = ("about_upright", "about_across")


class LoadHinge(Element):
    """A hinge frame, foot pins or a gripper in which the load turns about one axis."""

    what: ClassVar[str] = "a hinge"

    at: Position = Field(description="Its middle on the load, in the load's own axes, as lugs are.")
    axis: Direction = Field(description="Its axis in the load's own axes, three plain numbers.")
    held_by: Name | None = Field(
        None, description="What it stands on: a vessel, or a part of a crane; the world if not given."
    )
    to: Position | None = Field(
        None,
        description="Where it stands, in the world or in the axes of what 'held_by' names; where the load "
        "has it at the start if not given. The load has to fit it.",
    )
    rated_capacity: PositiveMass | None = Field(
        None, description="Largest force between load and hinge, whichever way; not checked if not given."
    )
    pins_apart: PositiveLength | None = Field(
        None,
        description="Distance along the axis of the two pins that it is of; they bear its moment askew too, "
        "which 'rated_capacity', of both together, is then held against.",
    )
    friction: Torque = Field(
        0.0, description="Dry friction that holds the turning, a moment; none if not given, or if it opens."
    )


def hinge_joints(hinge: str) -> dict[str, str]:
    """Names of the joints of a hinge that pins hold, by what they are, each on the one before."""
    return {end: f"{hinge}/{end}" for end in (*PUSHES, *TURNS)}


def hinge_pins(scenario: Scenario) -> list[list[str]]:
    """Joints of hinges whose pins each step of the plan pulls as it begins."""
    return [
        [joint for name in step.open_hinges for joint in hinge_joints(name).values()]
        for step in scenario.plan
    ]


def opened_in(scenario: Scenario, hinge: str) -> list[str]:
    """Names of the steps of the plan that open a hinge."""
    return [step.step for step in scenario.plan if hinge in step.open_hinges]


def failed_at(scenario: Scenario, element: str, cause: str) -> tuple[str, str]:
    """Where a simulation failed, and why, of a joint within a hinge told as that of the hinge.

    Args:
        scenario: The lift.
        element: Name of what it failed at; one that is in no hinge stays as it is, with its cause.
        cause: What failed.
    """
    for name in scenario.hinges or {}:
        if element not in (name, *hinge_joints(name).values()):
            continue
        if not opened_in(scenario, name):
            return name, cause
        # The joints of an open hinge know one attitude in which two of them turn about the same axis.
        there = "an open hinge goes not along with its load to where an 'axis' that was level is upright"
        right = "choose the 'axis' across the load, about which it is raised, or open it once that is done"
        return name, f"{cause}; {there}, or one that was upright level: {right}"
    return element, cause
