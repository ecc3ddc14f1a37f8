"""Landing guides that miss each other where the load comes down, or are too flat to guide it."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.guide import (
    SIDES,
    GuideFrame,
    GuidePost,
    GuideWall,
    LandingGuide,
    guide_body,
)
from gantline.scenario.steps import MovingStep
from gantline.units import format_quantity

__all__ = ["GuideFit", "doubtful_guides", "guide_fits", "is_taken_along"]

#: Verbs of steps that take a load along: where it comes down only the run knows.
_TAKE_ALONG = ("traverse", "travel", "slew", "luff", "haul", "veer")
#: Steps of less than this above what a face catches are no doubt [m].
_JUST = 1e-6


class GuideFit:
    """How a guide fits from above as the load stands at the start.

    Attributes:
        offset: From the middle of the frame to the axis of the post along x and y of the load, of a wall from its face
            to the bumper and from its middle along it [m].
        catches: How far the guide may be off towards each face, by its side, so that it catches the load [m].
        off: How far it is off towards each of them [m].
        tip: Thickness of what a face comes down on where it does not [m].
    """

    def __init__(self, offset: Array, catches: dict[str, float], off: dict[str, float], tip: float) -> None:
        self.offset, self.catches, self.off, self.tip = offset, catches, off, tip

    @property
    def worst(self) -> tuple[str, float]:
        """The side of the face that it is nearest to missing, and by how much it misses it [m]; negative if not."""
        return max(((side, self.off[side] - self.catches[side]) for side in self.off), key=lambda one: one[1])


def is_taken_along(scenario: Scenario) -> bool:
    """Whether a step of the plan takes loads to another place."""
    return any(isinstance(step, MovingStep) and step.verb in _TAKE_ALONG for step in scenario.plan)


def guide_fits(parts: Parts, scenario: Scenario) -> dict[str, GuideFit]:
    """How each guide fits, by its name, the load being where it is at the start."""
    fits = {}
    for name, guide in (scenario.guides or {}).items():
        place, turn = parts.pose(guide_body(name))
        if guide.frame is not None:
            fits[name] = _of_frame(guide.frame, guide.post_there, place, turn)
        else:
            fits[name] = _of_wall(guide, guide.wall_there, place)
    return fits


def _of_frame(frame: GuideFrame, post: GuidePost, place: Array, turn: Array) -> GuideFit:
    offset = (turn.T @ (np.array(post.at) - place))[:2]
    run = 0.0 if frame.flare is None else frame.flare.run
    reach = post.diameter / 2 + frame.clearance + run - post.tip_radius
    off = {side: float(offset @ np.array(SIDES[side])) for side in frame.sides}
    return GuideFit(offset, dict.fromkeys(off, reach), off, 2 * post.tip_radius)


def _of_wall(guide: LandingGuide, wall: GuideWall, place: Array) -> GuideFit:
    out = np.array([math.cos(wall.faces), math.sin(wall.faces)])
    apart = place[:2] - np.array(wall.at[:2])
    radius = guide.bumper_there.diameter / 2
    gap, aside = float(apart @ out) - radius, float(apart @ np.array([-out[1], out[0]]))
    run = 0.0 if wall.slope is None else wall.slope.run
    return GuideFit(np.array([gap, aside]), {"wall": run}, {"wall": -gap}, 2 * radius)


def doubtful_guides(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each guide that the load comes down beside, and each whose faces hold it by friction."""
    for name, guide in (scenario.guides or {}).items():
        yield from _too_flat(name, guide)
    if is_taken_along(scenario):
        return
    for name, fit in guide_fits(parts, scenario).items():
        side, missed = fit.worst
        if missed <= _JUST:
            continue
        on_load = (scenario.guides or {})[name].frame is not None
        off, catches = (format_quantity(one, "m", 2) for one in (fit.off[side], fit.catches[side]))
        if on_load:
            where = f"its post is {off} to {side} of the middle of its frame, which catches it up to {catches}"
        else:
            where = f"its bumper comes down {off} behind the face of its wall, which catches it up to {catches}"
        rim = "the tip of the post" if on_load else "the top of the wall"
        ends = f"would stand on the rim, {rim}" if missed < fit.tip else "would come down beside it"
        moved = "as the load hangs at the start, from where no step takes it along"
        yield Doubt(("guides", name), f"the load misses guide {name}: {where}, {moved}; it {ends}")


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
