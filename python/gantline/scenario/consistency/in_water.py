"""Whether water can do to a load what the lift file says."""

from __future__ import annotations

from typing import NamedTuple

from gantline.scenario.afloat.water import Water
from gantline.scenario.findings import Findings
from gantline.scenario.loads.in_water import InWater

__all__ = ["Room", "check_in_water", "check_room_in_water"]


def check_in_water(findings: Findings) -> None:
    """Note what a load cannot be in water, as far as the lift file tells without its CAD file."""
    load = findings.scenario.load
    if load is None or load.in_water is None:
        return
    given, path = load.in_water, ("load", "in_water")
    if findings.scenario.water is None:
        findings.add(path, "where is the water? Write 'water: {level: 0 m}' with the height of its surface")
    least = load.room_volume
    if given.displaced_volume is not None and given.displaced_volume <= least:
        sentence = f"{given.displaced_volume:g} m^3 are no more than the inside of its tanks, {least:.4g} m^3"
        right = "it displaces that and its members, and what is in the tanks weighs as given"
        findings.add((*path, "displaced_volume"), f"{sentence}; {right}")
    if load.current_areas:
        sentence = "'drag_coefficients' of 'in_water' say already how water resists the load"
        findings.add(("load", "current_areas"), f"{sentence}; leave one out")
    if given.slamming_coefficient is not None and given.added_mass[2] == 0.0:
        sentence = "what slams is the added mass along z as it comes, and that is 0"
        findings.add(
            (*path, "slamming_coefficient"),
            f"{sentence}; give the third number of 'added_mass', or leave 'slamming_coefficient' out",
        )
    room = None
    if load.shape.cylinder is not None:
        cylinder = load.shape.cylinder
        room = Room("the load", cylinder.enclosed, cylinder.seen[2], cylinder.sizes[2])
    elif load.shape.box is not None:
        room = Room.of_box(load.shape.box)
    if room is not None:
        check_room_in_water(findings, room, given, (findings.scenario.water or Water()).density)


class Room(NamedTuple):
    """What a load has room for in water.

    Attributes:
        what: what it is, in words.
        volume: within it [m^3].
        underside: what it shows from below [m^2].
        height: its height [m].
    """

    what: str
    volume: float
    underside: float
    height: float

    @classmethod
    def of_box(cls, box: tuple[float, float, float]) -> Room:
        """That of the box about a load [m]."""
        length, breadth, height = box
        return cls("the load's box", length * breadth * height, length * breadth, height)


def check_room_in_water(findings: Findings, room: Room, given: InWater, density: float) -> None:
    """Note what a load has no room for, in water of that density [kg/m^3]."""
    path = ("load", "in_water")
    if given.displaced_volume is not None and given.displaced_volume > room.volume:
        sentence = f"{given.displaced_volume:g} m^3 are more than {room.what} has, {room.volume:.4g} m^3"
        findings.add((*path, "displaced_volume"), sentence)
    depth = given.slamming_depth(room.underside, density)
    if depth is not None and depth > room.height:
        least = given.slamming_depth(room.underside, density * room.height) or 0.0
        even = (given.slamming_coefficient or 0.0) * least
        sentence = (
            f"{given.slamming_coefficient:g} is less than {even:.3g}, which added mass along z makes that "
            "comes evenly over the load's height"
        )
        findings.add((*path, "slamming_coefficient"), f"{sentence}; leave it out")
