"""The load as a rigid body with what is lumped on its lugs, and how it rests on the ground."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gantline.assembly.afloat.water import frozen
from gantline.assembly.doubts.supports import bears_nothing, too_low
from gantline.assembly.loads.hinges import hinged_load
from gantline.assembly.loads.load_body import LoadBody, load_body
from gantline.assembly.loads.resting import TipsOver, rest_on_ground, rest_on_rim
from gantline.assembly.loads.round_body import rims
from gantline.assembly.loads.under_load import UnderLoad
from gantline.assembly.loads.underground import under_ground
from gantline.assembly.parts import Json, Parts
from gantline.assembly.plain import ropes_at_lugs
from gantline.assembly.spatial import (
    Array,
    about_axis,
    inertia_list,
    quaternion_product,
    rotation_matrix,
    rotation_vector,
)
from gantline.assembly.yard import lower_lump
from gantline.cad.mass_properties import point_inertia
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.water import BallastTank
from gantline.scenario.consistency.supports import foot_of
from gantline.scenario.errors import StartError
from gantline.scenario.ground import Ground
from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.loads.load import Load
from gantline.scenario.loads.structures import dock_of

__all__ = ["LiftedLoad", "add_load", "lifted_load", "shift_by_liquid"]

#: Lugs that a warning names.
_MOST_NAMED = 5
#: A load may sink into ground and supports by this share of its height.
_DEEPEST = 0.05
#: How deep a load that stands on nothing may begin in the ground without a word [m].
_IN_GROUND = 0.1
#: Supports that are less beside a line than this stand in it [m].
_IN_A_LINE = 0.05


@dataclass(frozen=True)
class LiftedLoad:
    """The load with everything that is lumped on it.

    Attributes:
        mass: mass [kg].
        centre: centre of gravity from the datum, axes of the load (3,) [m].
        inertia: about the centre of gravity, axes of the load (3, 3) [kg m^2].
        corners: corners of its box from the centre of gravity (8, 3) [m], the lower four first; of a round
            load those of its hull (n, 3).
        lugs: position of each lug from the centre of gravity [m].
        body: the load by itself, measured from its datum.
        contents: mass of the liquid in its tanks at the start [kg]: no part of the mass above.
        shift: from the centre of gravity to that with this liquid, upright (3,) [m].
    """

    mass: float
    centre: Array
    inertia: Array
    corners: Array
    lugs: dict[str, list[float]]
    body: LoadBody
    contents: float = 0.0
    shift: Array = field(default_factory=lambda: np.zeros(3))

    @property
    def mass_at_start(self) -> float:
        """With what is in its tanks [kg]."""
        return self.mass + self.contents

    @property
    def centre_at_start(self) -> Array:
        """Centre of gravity with that, upright, from the datum (3,) [m]."""
        return self.centre + self.shift


def lifted_load(scenario: Scenario, load: Load, rigging: Rigging) -> LiftedLoad:
    """Mass, centre of gravity and inertia of the load with lower shackles and lower halves of slings.

    Raises:
        ScenarioError: if its CAD file cannot be used.
    """
    body = load_body(scenario, load)
    own, middle = body.mass, body.centre
    lumps = [
        (lower_lump(sling), np.array(load.lugs[lug].at))
        for sling in rigging.slings.values()
        for lug in sling.lugs
    ]
    lumps = [(mass, at) for mass, at in lumps if mass > 0]
    mass = own + sum(lump for lump, _ in lumps)
    centre = middle
    if lumps:
        centre = (own * middle + np.sum([lump * at for lump, at in lumps], axis=0)) / mass
    inertia = body.inertia + point_inertia(own, middle - centre)
    for lump, at in lumps:
        inertia = inertia + point_inertia(lump, at - centre)
    (left, back, low), (right, front, high) = body.box
    around = [(left, back), (right, back), (right, front), (left, front)]
    corners = np.array([(*plan, height) for height in (low, high) for plan in around])
    corners = (corners if load.shape.cylinder is None else body.hull) - centre
    lugs = {name: [float(part) for part in np.array(lug.at) - centre] for name, lug in load.lugs.items()}
    shift = shift_by_liquid((load.tanks or {}).values(), mass, centre)
    return LiftedLoad(mass, centre, inertia, corners, lugs, body, load.contents, shift)


def shift_by_liquid(tanks: Iterable[BallastTank], mass: float, centre: Array) -> Array:
    """How far what is in tanks moves a centre of gravity, upright (3,) [m].

    Args:
        tanks: With their contents.
        mass: Of the load without them [kg].
        centre: Its centre of gravity, from its datum (3,) [m].
    """
    filled = list(tanks)
    total = mass + math.fsum(tank.content for tank in filled)
    shift = np.zeros(3)
    for tank in filled:
        shift += tank.content / total * (np.array(frozen(tank)[0]) - centre)
    return shift


def add_load(
    parts: Parts,
    scenario: Scenario,
    load: Load,
    rigging: Rigging,
    lifted: LiftedLoad,
    under: Sequence[UnderLoad],
) -> None:
    """The load as a body at its centre of gravity, free or in its hinge; its corners as contacts with ground.

    Args:
        parts: what the body is added to.
        scenario: the lift.
        load: the load.
        rigging: who carries whom.
        lifted: the load with what is lumped on it.
        under: all supports, and where the load is over them.

    Raises:
        ScenarioError: if the load shall be at rest and would tip over or sink in.
    """
    orientation = about_axis((0.0, 0.0, 1.0), load.heading)
    position = np.array(load.position) + rotation_matrix(orientation) @ lifted.centre
    if scenario.load_has_settled and not scenario.hinges:  # in a hinge statics finds where it comes to rest
        height, turn = _at_rest(parts, scenario, load, lifted, orientation, under)
        orientation = quaternion_product(turn, orientation)
        position[2] = height - (rotation_matrix(orientation) @ lifted.shift)[2]
    own: dict[str, Any] = {"mass": lifted.mass, "inertia": inertia_list(lifted.inertia)}
    start = [float(part) for part in position], orientation
    if scenario.hinges:
        hinged_load(parts, scenario, load.name, start, lifted.centre, own)
    else:
        joint = {"type": "free", "position": start[0], "orientation": start[1]}
        still = {"velocity": [0.0, 0.0, 0.0], "angular_velocity": [0.0, 0.0, 0.0]}
        parts.add_body(load.name, joint | still, **own)
    if not scenario.load_has_settled:
        corners = position + lifted.corners @ rotation_matrix(orientation).T
        _doubt_depth(parts, scenario, load, corners[int(np.argmin(corners[:, 2]))])
    _doubt_free_lugs(parts, load, rigging, ropes_at_lugs(scenario))
    ground = scenario.ground
    if ground is None or dock_of(scenario) is not None:
        return  # around a dock the ground is a body like others
    if load.shape.cylinder is not None:
        parts.rims += _on_rims(load, load.shape.cylinder, lifted, ground)
    else:
        parts.contacts += _on_corners(load, lifted, ground)


def _doubt_free_lugs(parts: Parts, load: Load, rigging: Rigging, with_ropes: Collection[str]) -> None:
    """Lugs to which no sling leads, where slings or ropes of `mechanics` lead to others."""
    used = {lug for sling in rigging.slings.values() for lug in sling.lugs} | set(with_ropes)
    free = [name for name in load.lugs if name not in used]
    if used and free:
        more = f" and {len(free) - _MOST_NAMED} more" if len(free) > _MOST_NAMED else ""
        sentence = f"no sling leads to lug {', '.join(free[:_MOST_NAMED])}{more}"
        parts.doubt(("load", "lugs", free[0]), sentence)


def _on_corners(load: Load, lifted: LiftedLoad, ground: Ground) -> Iterator[Json]:
    """Contacts of the corners of a load with the ground."""
    for place, corner in enumerate(lifted.corners, start=1):
        yield {
            "name": f"{load.name}.corner_{place}",
            "group": load.name,
            "body": load.name,
            "at": [float(part) for part in corner],
            "plane_point": [0.0, 0.0, ground.level],
            "plane_normal": [0.0, 0.0, 1.0],
            "stiffness": ground.stiffness,
            "damping_time": ground.damping / ground.stiffness,
            "friction": ground.friction,
        }


def _on_rims(load: Load, given: Cylinder, lifted: LiftedLoad, ground: Ground) -> Iterator[Json]:
    """Both rims of a round load over the ground, each as stiff as the corners of a box in its place."""
    for place, (middle, axis, radius) in enumerate(rims(given), start=1):
        yield {
            "name": f"{load.name}.rim_{place}",
            "group": load.name,
            "body": load.name,
            "at": (middle - lifted.centre).tolist(),
            "axis": axis.tolist(),
            "radius": radius,
            "plane_point": [0.0, 0.0, ground.level],
            "plane_normal": [0.0, 0.0, 1.0],
            "stiffness": _corners_of(given) * ground.stiffness,
            "damping_time": ground.damping / ground.stiffness,
            "friction": ground.friction,
        }


def _corners_of(given: Cylinder) -> int:
    """How many corners of a box a rim is as stiff as: those of an end that it lies on, or stands on."""
    return 2 if given.along == "x" else 4


def _doubt_depth(parts: Parts, scenario: Scenario, load: Load, lowest: Array) -> None:
    """Warn of a load that hangs or floats at the start and has its lowest corner (3,) [m] in the ground."""
    x, y, z = (float(part) for part in lowest)
    depth = under_ground(scenario, (x, y, z))
    if depth is not None and under_ground(scenario, (x, y, z + _IN_GROUND)) is not None:
        sentence = (
            f"{load.name} starts {depth}, which pushes it up: see its position and the level of the ground"
        )
        below = "; a sea bed has a negative one where the water is at 0" if scenario.water else ""
        parts.doubt(("load", "position"), sentence + below)


def _at_rest(
    parts: Parts,
    scenario: Scenario,
    load: Load,
    lifted: LiftedLoad,
    orientation: list[float],
    under: Sequence[UnderLoad],
) -> tuple[float, list[float]]:
    """Height of the centre of gravity, with contents, and the turn from the given attitude once settled."""
    if load.stands_on != "ground":
        own = [one for one in under if one.support.group == load.stands_on]
        return _on_supports(parts, scenario, load, lifted, orientation, own)
    ground = scenario.ground
    assert ground is not None  # a load that stands on the ground has been checked to have one
    corners = (lifted.corners - lifted.shift) @ rotation_matrix(orientation).T
    weight = lifted.mass_at_start * scenario.simulation.gravity
    depth = weight / (4 * ground.stiffness)
    if depth > _DEEPEST * float(np.ptp(corners[:, 2])):
        sentence = f"the load of {lifted.mass_at_start / 1e3:.7g} t would sink {depth:.3g} m into this ground"
        right = "a greater stiffness is right, such as 200 MN/m, or a smaller weight"
        raise scenario.start_error(("ground", "stiffness"), f"{sentence}; {right}")
    cylinder = load.shape.cylinder
    try:
        if cylinder is None:
            resting = rest_on_ground(corners, weight, ground.stiffness)
        else:
            over = rotation_matrix(orientation) @ lifted.centre_at_start
            stiffness = _corners_of(cylinder) * ground.stiffness
            resting = rest_on_rim(over, cylinder.radii[0], weight, stiffness)
    except TipsOver:
        what = "corners" if cylinder is None else "rim"
        raise _tips_over(scenario, lifted, what) from None
    return ground.level + resting.height, rotation_vector(resting.turn)


def _on_supports(
    parts: Parts,
    scenario: Scenario,
    load: Load,
    lifted: LiftedLoad,
    orientation: list[float],
    under: Sequence[UnderLoad],
) -> tuple[float, list[float]]:
    """The same on supports, all as stiff as on the average; from there statics finds where it rests."""
    assert load.stands_on is not None
    turned = rotation_matrix(orientation)
    if lifted.body.surface is not None:
        under = [one for one in under if one.place is not None]
    supports = [one.support for one in under]
    highest = max(one.height for one in supports)
    foot = foot_of(scenario, under[0].group)
    bottom = _bottom(load, lifted, turned, under)
    stiffness = float(np.mean([one.stiffness for one in supports]))
    weight = lifted.mass_at_start * scenario.simulation.gravity
    depth = weight / (len(supports) * stiffness)
    if depth > min(highest, _DEEPEST * float(np.ptp((lifted.corners @ turned.T)[:, 2]))):
        weighs = f"the load of {lifted.mass_at_start / 1e3:.7g} t"
        sentence = f"{weighs} would sink {depth:.3g} m into '{load.stands_on}'"
        right = "a greater stiffness is right, such as 100 MN/m, or a smaller weight"
        raise scenario.start_error(("supports", load.stands_on, "stiffness"), f"{sentence}; {right}")
    try:
        resting = rest_on_ground(bottom, weight, stiffness)
    except TipsOver:
        if _stand_in_a_line(bottom):
            raise _balances(scenario, load.stands_on) from None
        raise _tips_over(scenario, lifted, "supports", too_low(under)) from None
    parts.doubts += bears_nothing(load.stands_on, under, (resting.forces > 0.0).tolist())
    return foot + highest + resting.height, rotation_vector(resting.turn)


def _bottom(load: Load, lifted: LiftedLoad, turned: Array, under: Sequence[UnderLoad]) -> Array:
    """What of the load is over each support, from its centre of gravity with contents (supports, 3) [m].

    A support that is lower than the highest is one under a point that is higher.
    """
    highest = max(one.support.height for one in under)
    lower = np.array([highest - one.support.height for one in under])
    if lifted.body.surface is not None:
        centre = np.array(load.position) + turned @ lifted.centre_at_start
        found = np.array([one.place for one in under]) - centre
        found[:, 2] += lower
        return found
    group = under[0].group
    places = np.array([(*one.support.at, 0.0) for one in under])
    if group.measured_from == "load":
        places = places @ turned.T
    else:
        upright = rotation_matrix(about_axis((0.0, 0.0, 1.0), group.heading))
        places = places @ upright.T - np.array(load.position)
    bottom: Array = places - turned @ lifted.centre_at_start
    bottom[:, 2] = float(lifted.corners[:, 2].min()) - lifted.shift[2] + lower
    return bottom


def _stand_in_a_line(places: Array) -> bool:
    """Whether places, shape (places, 3), lie in one line as seen from above, or are but one."""
    level = places[:, :2] - places[:, :2].mean(axis=0)
    return bool(np.linalg.matrix_rank(level, tol=_IN_A_LINE) < 2)


def _balances(scenario: Scenario, supports: str) -> StartError:
    sentence = "the load would tip over: its supports stand in one line, and each carries at one point"
    right = "place some to either side of that line, as under both edges of the load"
    return scenario.start_error(("supports", supports), f"{sentence}; {right}")


def _tips_over(scenario: Scenario, lifted: LiftedLoad, what: str, low: str = "") -> StartError:
    # Adding 0 takes the sign off a zero.
    x, y, _ = np.round(lifted.centre_at_start, 3) + 0.0
    beside = "rigging and what is in its tanks" if lifted.contents else "rigging"
    sentence = f"the load would tip over: its centre of gravity, with {beside}, is at ({x:g}, {y:g}) m"
    advice = f"which is not well within the {what} it stands on; move it towards the middle"
    return scenario.start_error(("load", "centre_of_gravity"), f"{sentence}, {advice}{low and f'; {low}'}")
