"""Landing guides: posts and walls that bring the load the last half metre to its place."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.afloat.mooring import body_of
from gantline.scenario.base import Element
from gantline.scenario.quantities import (
    Angle,
    Damping,
    ListOf,
    Name,
    NotNegativeLength,
    Position,
    PositiveAngle,
    PositiveForce,
    PositiveLength,
    PositiveStiffness,
    Ratio,
    Word,
    refuse,
)

__all__ = [
    "SIDES",
    "Bumper",
    "Cone",
    "GuideFrame",
    "GuidePost",
    "GuideWall",
    "LandingGuide",
    "Slope",
    "guide_body",
    "guide_contact",
    "guide_stand",
]

#: Stiffness and damping of a guide, if the lift file does not say them [N/m, N s/m].
USUAL_STIFFNESS, USUAL_DAMPING = 20e6, 200e3
#: Sides of a frame, each with the direction in the load's own axes in which it lies from the middle.
SIDES = {"fore": (1.0, 0.0), "aft": (-1.0, 0.0), "port": (0.0, 1.0), "starboard": (0.0, -1.0)}
#: Length of a bumper, if the lift file does not say it [m].
_USUAL_BUMPER = 0.5


class Cone(Element):
    """The cone on a post."""

    what: ClassVar[str] = "a cone"

    length: PositiveLength = Field(description="Its length along the post.")
    tip_diameter: NotNegativeLength = Field(description="Diameter of its flat tip.")


class GuidePost(Element):
    """A round post that stands where the load is to come down."""

    what: ClassVar[str] = "a guide post"

    at: Position = Field(
        description="Where the middle of its foot stands: in the world, or in the axes of what 'held_by' "
        "names."
    )
    diameter: PositiveLength = Field(description="Its diameter.")
    height: PositiveLength = Field(description="From its foot to where its cone begins.")
    cone: Cone | None = Field(None, description="The cone on top of it; none if not given.")

    @model_validator(mode="after")
    def _narrows(self) -> GuidePost:
        if self.cone is not None and self.cone.tip_diameter >= self.diameter:
            tip = f"{self.cone.tip_diameter:g} m"
            raise refuse(f"the tip, {tip}, is not thinner than the post, {self.diameter:g} m", "cone")
        return self

    @property
    def top(self) -> float:
        """From its foot to its tip [m]."""
        return self.height + (0.0 if self.cone is None else self.cone.length)

    @property
    def tip_radius(self) -> float:
        """Of its flat tip [m]."""
        return (self.diameter if self.cone is None else self.cone.tip_diameter) / 2


class Slope(Element):
    """A face that leans away: the flare below a frame, the slope on top of a wall."""

    what: ClassVar[str] = "a slope"

    length: PositiveLength = Field(description="Its length along the face.")
    angle: PositiveAngle = Field(description="Its angle to the upright face; 20 to 45 deg is usual.")

    @model_validator(mode="after")
    def _steep(self) -> Slope:
        if self.angle >= math.radians(80):
            found = f"{math.degrees(self.angle):g} deg from upright"
            raise refuse(f"a slope of {found} guides nothing; less than 80 deg is right", "angle")
        return self

    @property
    def run(self) -> float:
        """How far it reaches out [m]."""
        return self.length * math.sin(self.angle)


class GuideFrame(Element):
    """What of the load runs along a post: a bucket of four sides, a fork of three, a bumper of one."""

    what: ClassVar[str] = "a frame on the load"

    at: Position = Field(
        description="Its middle on the load, in the load's own axes, as lugs are: where the middle of the "
        "post is as the load stands in its place, at the lower end of the upright sides."
    )
    sides: Annotated[tuple[str, ...], ListOf(Word(tuple(SIDES)), scalar=True)] = Field(
        tuple(SIDES),
        description="On which sides of the post it is, by the load's own axes: 'fore' is towards x, 'port' "
        "towards y; all four if not given.",
    )
    clearance: NotNegativeLength = Field(description="From the post to each side, in the middle.")
    height: PositiveLength = Field(description="Of the upright sides, above 'at'.")
    flare: Slope | None = Field(None, description="How the sides open below 'at'; not if not given.")

    @model_validator(mode="after")
    def _has_sides(self) -> GuideFrame:
        if not self.sides or len(set(self.sides)) < len(self.sides):
            raise refuse(f"a frame has one to four sides, each once: {', '.join(SIDES)}", "sides")
        return self


class GuideWall(Element):
    """An upright wall that stands where the load is to come down, with a slope on top."""

    what: ClassVar[str] = "a guide wall"

    at: Position = Field(
        description="Middle of the foot of its face: in the world, or in the axes of what 'held_by' names."
    )
    faces: Angle = Field(description="Direction in which its face looks, from x towards y of these axes.")
    breadth: PositiveLength = Field(description="Its breadth.")
    height: PositiveLength = Field(description="From its foot to where it leans away.")
    slope: Slope | None = Field(None, description="How it leans away on top; not if not given.")


class Bumper(Element):
    """A round bumper on the load, upright, that runs down along a wall."""

    what: ClassVar[str] = "a bumper"

    at: Position = Field(
        description="Middle of its lower end on the load, in the load's own axes, as lugs are."
    )
    diameter: PositiveLength = Field(description="Its diameter.")
    length: PositiveLength = Field(_USUAL_BUMPER, description="Its length upwards; 0.5 m if not given.")


class LandingGuide(Element):
    """A post and a frame on the load that comes down over it, or a wall and a bumper on the load."""

    what: ClassVar[str] = "a landing guide"

    type: Name | None = Field(None, description="A name of 'guide_types' that gives what is not said here.")
    post: GuidePost | None = Field(None, description="The post that stands there, with 'frame'.")
    frame: GuideFrame | None = Field(None, description="What of the load runs along the post.")
    wall: GuideWall | None = Field(None, description="The wall that stands there, with 'bumper'.")
    bumper: Bumper | None = Field(None, description="What of the load runs along the wall.")
    held_by: Name | None = Field(
        None,
        description="What post or wall stand on: a vessel, a part of a crane, a body of 'mechanics'; the "
        "world if not given.",
    )
    friction: Ratio = Field(description="Coefficient of friction; 0.1 greased, 0.2 to 0.4 steel on steel.")
    stiffness: PositiveStiffness = Field(
        USUAL_STIFFNESS,
        description="Stiffness of each place that touches, of what stands there and of the load; 20 MN/m if "
        "not given.",
    )
    damping: Damping = Field(
        USUAL_DAMPING, description="Damping of each place that touches; 0.2 MN s/m if not given."
    )
    capacity: PositiveForce | None = Field(
        None, description="Largest force that it may take across its faces; not checked if not given."
    )

    @model_validator(mode="after")
    def _one_pair(self) -> LandingGuide:
        given = [key for key in ("post", "frame", "wall", "bumper") if getattr(self, key) is not None]
        if given not in (["post", "frame"], ["wall", "bumper"]):
            found = " and ".join(f"'{key}'" for key in given) or "neither"
            right = "a guide has 'post' and 'frame', or 'wall' and 'bumper'"
            raise refuse(f"{right}; found {found}")
        return self

    @property
    def holder(self) -> str | None:
        """The body that post or wall stand on; None is the world."""
        return body_of(self.held_by)

    @property
    def foot(self) -> tuple[tuple[float, float, float], float]:
        """Where post or wall stand [m], and the direction in which a face looks [rad], axes of the holder."""
        return (self.post.at, 0.0) if self.post is not None else (self.wall_there.at, self.wall_there.faces)

    @property
    def sides(self) -> tuple[str, ...]:
        """Its faces: sides of the frame, or the one of the wall."""
        return ("wall",) if self.frame is None else self.frame.sides

    @property
    def post_there(self) -> GuidePost:
        """The post of a guide with a frame."""
        assert self.post is not None
        return self.post

    @property
    def wall_there(self) -> GuideWall:
        """The wall of a guide with a bumper."""
        assert self.wall is not None
        return self.wall

    @property
    def bumper_there(self) -> Bumper:
        """The bumper of a guide with a wall."""
        assert self.bumper is not None
        return self.bumper


def guide_body(name: str) -> str:
    """Name of what of a guide is on the load among the bodies, and of its contacts together."""
    return f"guide.{name}"


def guide_stand(name: str) -> str:
    """Name of the body for pictures that is what of a guide stands on a body, and not in the world."""
    return f"{guide_body(name)}.stand"


def guide_contact(name: str, side: str) -> str:
    """Name of the contact of a face of a guide; its places are `<contact>/1` and `<contact>/2`."""
    return f"guide.{name}.{side}"
