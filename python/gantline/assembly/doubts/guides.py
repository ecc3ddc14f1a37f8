"""Landing guides that miss each other where the load comes down, or are too flat to guide it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.assembly.afloat.vessels import vessel_hull
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array, about_axis, rotation_matrix
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.guide import (
    SIDES,
    Bumper,
    GuideFrame,
    GuidePost,
    GuideWall,
    LandingGuide,
    guide_body,
)
from gantline.scenario.loads.structures import ground_at
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.steps import MovingStep
from gantline.units import format_quantity

__all__ = ["GuideFit", "Turned", "doubtful_guides", "guide_fits", "is_taken_along", "misses"]

#: Verbs of steps that take a load along: where it comes down only the run knows.
_TAKE_ALONG = ("traverse", "travel", "slew", "luff", "haul", "veer")
#: A load to be upended lies otherwise at the start than as it lands: cosine of its own z to plumb.
_UPRIGHT = 0.98
#: A load that is held against a guide at rest is in it by no more: 0.2 MN of 20 MN/m [m].
_DEEP = 0.01
#: What a face misses by less is caught: rounding [m].
_JUST = 1e-6
#: Posts and bumpers are 0.1 to 1.5 m thick; none is thicker than this [m].
_THICKEST = 5.0
#: How far below the ground a foot is told: blinding and bases of posts are thinner [m].
_BURIED = 0.1


@dataclass(frozen=True)
class GuideFit:
    """How a guide fits from above as the load is at the start.

    Attributes:
        offset: from the middle of the frame to the axis of the post along x and y of the load, or from the
            face of a wall to the bumper and from its middle along it [m].
        catches: how far it may be off towards each of its faces to catch the load [m].
        off: how far it is off towards each of them [m].
        rim: what a face stands on that it just misses is so thick [m].
        aside: how far the post or the bumper is from the middle of the face along it, of that which it passes
            by least [m].
        breadth: how broad that face is [m].
        radius: of the post or the bumper [m].
        depth: by how much the post or the bumper is inside a face at the start [m]; 0 if it is not.
    """

    offset: tuple[float, float]
    catches: Mapping[str, float]
    off: Mapping[str, float]
    rim: float
    aside: float
    breadth: float
    radius: float
    depth: float

    @property
    def passes(self) -> bool:
        """Whether the post or the bumper comes down beside the ends of all faces, and touches none."""
        return self.aside > self.breadth / 2 + self.radius + _JUST

    @property
    def worst(self) -> tuple[str, float]:
        """The face that it is nearest to missing, and by how much it misses it [m]; negative if not."""
        missed = {side: off - self.catches[side] for side, off in self.off.items()}
        side = max(missed, key=missed.__getitem__)
        return side, missed[side]


def is_taken_along(scenario: Scenario) -> bool:
    """Whether a step of the plan takes loads to another place."""
    return any(
        isinstance(step, LeadStep) or (isinstance(step, MovingStep) and step.verb in _TAKE_ALONG)
        for step in scenario.plan
    )


@dataclass(frozen=True)
class Turned:
    """A load that has turned about plumb since the start.

    Attributes:
        about: a point of the axis (3,), world axes [m].
        by: how far, anticlockwise from above [rad].
        comes_down_on_it: it is taken to where, before it turns, it is right over each guide.
    """

    about: Array
    by: float
    comes_down_on_it: bool = False


def misses(fit: GuideFit) -> bool:
    """Whether the load comes down beside a guide, or on its rim."""
    return fit.worst[1] > _JUST or fit.passes


def guide_fits(parts: Parts, scenario: Scenario, turned: Turned | None = None) -> dict[str, GuideFit]:
    """How each guide fits, by its name; none if the load lies there.

    Args:
        parts: the system, with all its bodies.
        scenario: the lift.
        turned: how the load has turned; None where it is as at the start.
    """
    fits: dict[str, GuideFit] = {}
    for name, guide in (scenario.guides or {}).items():
        place, turn = parts.pose(guide_body(name))
        at, faces = guide.foot
        foot, lies = parts.place(guide.holder, at), parts.pose(guide.holder)[1]
        if turn[2, 2] < _UPRIGHT or lies[2, 2] < _UPRIGHT:
            continue
        out = (lies @ np.array([math.cos(faces), math.sin(faces), 0.0]))[:2]
        out = out / np.linalg.norm(out)
        if turned is not None:
            away = 0.0 if guide.frame is not None else guide.bumper_there.diameter / 2
            over = foot + np.array([*(away * out), 0.0]) - place
            shift = np.array([over[0], over[1], 0.0]) if turned.comes_down_on_it else np.zeros(3)
            rotation = rotation_matrix(about_axis((0.0, 0.0, 1.0), turned.by))
            place = turned.about + shift + rotation @ (place - turned.about)
            turn = rotation @ turn
        if guide.frame is not None:
            fits[name] = _of_frame(guide.frame, guide.post_there, turn.T @ (foot - place))
        else:
            fits[name] = _of_wall(guide.bumper_there, guide.wall_there, place - foot, out)
    return fits


def _of_frame(frame: GuideFrame, post: GuidePost, apart: Array) -> GuideFit:
    """Of a frame; from its middle the foot of the post is apart, in the load's own axes (3,) [m]."""
    x, y, foot = (float(part) for part in apart)
    run = 0.0 if frame.flare is None else frame.flare.run
    reach = post.diameter / 2 + frame.clearance + run - post.tip_radius
    off = {side: x * SIDES[side][0] + y * SIDES[side][1] for side in frame.sides}
    aside = min(abs(x * SIDES[side][1] - y * SIDES[side][0]) for side in frame.sides)
    radius = post.diameter / 2
    breadth = 2 * (radius + frame.clearance + run)
    heights = [foot, foot + post.height, foot + post.top]
    radii = [radius, radius, post.tip_radius]
    drop = 0.0 if frame.flare is None else frame.flare.length * math.cos(frame.flare.angle)
    knees = [-drop, 0.0, frame.height]
    away = [radius + frame.clearance + one for one in (run, 0.0, 0.0)]
    # Beside the ends of a side the post is not in it.
    beside = {side: abs(x * SIDES[side][1] - y * SIDES[side][0]) for side in frame.sides}
    depths = [_deepest(heights, radii, knees, away) + off[side] for side in off if beside[side] < breadth / 2]
    depth = max([0.0, *(one for one in depths if one < 2 * radius)])
    return GuideFit(
        (x, y), dict.fromkeys(off, reach), off, 2 * post.tip_radius, aside, breadth, radius, depth
    )


def _deepest(
    heights: Sequence[float], radii: Sequence[float], knees: Sequence[float], away: Sequence[float]
) -> float:
    """Radius of a round less the way to a face where that is most [m]; both are given by corners.

    Minus infinity where no height has both of them.
    """
    low, high = max(heights[0], knees[0]), min(heights[-1], knees[-1])
    if low >= high:
        return -math.inf
    corners = [low, high, *(one for one in (*heights, *knees) if low < one < high)]
    return float(np.max(np.interp(corners, heights, radii) - np.interp(corners, knees, away)))


def _of_wall(bumper: Bumper, wall: GuideWall, apart: Array, out: Array) -> GuideFit:
    """Of a wall that faces `out` from above (2,); from its foot the bumper is apart, world axes (3,) [m]."""
    radius = bumper.diameter / 2
    gap, aside = float(apart[:2] @ out) - radius, float(apart[:2] @ np.array([-out[1], out[0]]))
    run = 0.0 if wall.slope is None else wall.slope.run
    caught, off = {"wall": run}, {"wall": -gap}
    over, rise = float(apart[2]), 0.0
    if wall.slope is not None:
        rise = wall.slope.length * math.cos(wall.slope.angle)
    knees = [0.0, wall.height, wall.height + rise]
    depth = _deepest([over, over + bumper.length], [0.0, 0.0], knees, [0.0, 0.0, run]) - gap
    is_in = abs(aside) < wall.breadth / 2 and 0.0 < depth < 2 * radius
    return GuideFit(
        (gap, aside), caught, off, 2 * radius, abs(aside), wall.breadth, radius, depth if is_in else 0.0
    )


def doubtful_guides(parts: Parts, scenario: Scenario, fits: Mapping[str, GuideFit]) -> Iterator[Doubt]:
    """Each guide that the load comes down beside, that stands amid a vessel, or that friction holds it on."""
    for name, guide in (scenario.guides or {}).items():
        thick = list(_too_thick(name, guide))
        yield from thick or _too_flat(name, guide)
        if guide.holder is None:
            yield from _below_ground(scenario, name, guide)
            yield from _in_vessels(parts, scenario, name, guide)
    for name, fit in fits.items():
        if fit.depth > _DEEP:
            post, face = ("post", "frame") if (scenario.guides or {})[name].frame else ("bumper", "wall")
            deep = f"the {post} of guide {name} is {format_quantity(fit.depth, 'm', 3)} inside its {face}"
            thrown = "which throws the load aside"
            yield Doubt(
                ("guides", name), f"{deep} as the lift begins, {thrown}; let it begin higher or beside"
            )
    if is_taken_along(scenario):
        return
    for name, fit in fits.items():
        if missed := _missed(fit, (scenario.guides or {})[name].frame is not None):
            where, ends = missed
            moved = "as the load hangs at the start, from where no step takes it along"
            yield Doubt(("guides", name), f"the load misses guide {name}: {where}, {moved}; it {ends}")


def _too_thick(name: str, guide: LandingGuide) -> Iterator[Doubt]:
    """A post or bumper as thick as none is; its cone is then no flat one."""
    what, of = ("post", guide.post) if guide.post is not None else ("bumper", guide.bumper_there)
    if of.diameter > _THICKEST:
        thick = f"the {what} of guide {name} has a diameter of {format_quantity(of.diameter, 'm', 2)}"
        yield Doubt(("guides", name, what, "diameter"), f"{thick}; a unit has slipped, m for mm")


def _below_ground(scenario: Scenario, name: str, guide: LandingGuide) -> Iterator[Doubt]:
    """A post or wall of the world whose foot is below the ground, or below the floor of a dock there."""
    x, y, foot = guide.foot[0]
    ground = ground_at(scenario, x, y)
    if ground is not None and foot < ground - _BURIED:
        what = "post" if guide.post is not None else "wall"
        below = f"the foot of the {what} of guide {name} is {format_quantity(ground - foot, 'm', 2)}"
        ends = f"its height counts from there; from the ground on it is right with z at {ground:g} m"
        yield Doubt(("guides", name, what, "at"), f"{below} below the ground, and {ends}")


def _in_vessels(parts: Parts, scenario: Scenario, name: str, guide: LandingGuide) -> Iterator[Doubt]:
    """A guide of the world that stands within the hull of a vessel from above: on her deck, most likely."""
    for vessel, given in (scenario.vessels or {}).items():
        position, lies = parts.pose(vessel)
        box = vessel_hull(scenario, vessel, given).box[:, :2]
        there = (lies.T @ (np.array(guide.foot[0]) - position))[:2]
        if (box[0] < there).all() and (there < box[1]).all():
            stands = f"guide {name} stands in the world, amid {vessel} from above, who moves without it"
            right = f"'held_by: {vessel}' has it stand on her, at a place in her own axes"
            yield Doubt(("guides", name), f"{stands}; {right}")


def _missed(fit: GuideFit, on_load: bool) -> tuple[str, str] | None:
    """Where what of a guide misses the other, and where that ends; nothing where it catches the load."""
    side, missed = fit.worst
    beside = "would come down beside it"
    if missed > _JUST:
        off, catches = (format_quantity(one, "m", 2) for one in (fit.off[side], fit.catches[side]))
        rim = "the tip of the post" if on_load else "the top of the wall"
        where = (
            f"its post is {off} to {side} of the middle of its frame"
            if on_load
            else f"its bumper comes down {off} behind the face of its wall"
        )
        ends = f"would stand on the rim, {rim}" if missed < fit.rim else beside
        return f"{where}, which catches it up to {catches}", ends
    if fit.passes:
        aside, breadth = (format_quantity(one, "m", 2) for one in (fit.aside, fit.breadth))
        where = (
            f"its post is {aside} aside of the middle of its frame, whose sides are {breadth} broad"
            if on_load
            else f"its bumper comes down {aside} aside of the middle of its wall, which is {breadth} broad"
        )
        return where, beside
    return None


def _too_flat(name: str, guide: LandingGuide) -> Iterator[Doubt]:
    """Slopes on which friction holds a load that comes down on them."""
    slopes = []
    if guide.frame is not None:
        post = guide.post_there
        if guide.frame.flare is not None:
            slopes.append((("frame", "flare"), guide.frame.flare.angle))
        if post.cone is not None:
            narrows = (post.diameter - post.cone.tip_diameter) / 2
            slopes.append((("post", "cone"), math.atan2(narrows, post.cone.length)))
    elif guide.wall_there.slope is not None:
        slopes.append((("wall", "slope"), guide.wall_there.slope.angle))
    for keys, angle in slopes:
        if guide.friction * math.tan(angle) >= 1.0:
            leans, friction = f"{math.degrees(angle):.0f} deg", f"friction {guide.friction:g}"
            sentence = f"guide {name} leans by {leans} from upright: with {friction} a load stays on it"
            yield Doubt(("guides", name, *keys), f"{sentence}; a steeper face, or less friction, guides it")
