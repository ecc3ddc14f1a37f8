"""Plain bodies, joints, sheaves and ropes, for what yard words cannot say."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.afloat.water import Afloat
from gantline.scenario.base import Element, Named, with_a_type
from gantline.scenario.cranes.drum import Drum
from gantline.scenario.plan.motion import SpeedRamp, TurnRamp
from gantline.scenario.plan.parting import BREAKS_SHOWN, CUT_SHOWN, BreaksAt
from gantline.scenario.quantities import (
    Angle,
    AngularSpeed,
    AngularVelocity,
    Damping,
    Direction,
    Flag,
    Inertia,
    Length,
    ListOf,
    Mass,
    Name,
    NameText,
    NotNegativeForce,
    Position,
    PositiveLength,
    PositiveRotationalStiffness,
    PositiveStiffness,
    Quantity,
    Ratio,
    RotationalDamping,
    Sizes,
    Speed,
    Text,
    Time,
    Torque,
    Velocity,
    WordOr,
    refuse,
)
from gantline.scenario.rope_weight import NODES_SHOWN, WEIGHT_SHOWN, RopeNodes, RopeWeightWord
from gantline.scenario.sheave import SheaveWords

__all__ = [
    "Ball",
    "Body",
    "BodyContact",
    "BodyInertia",
    "BodyShape",
    "Contact",
    "Eye",
    "Fixed",
    "Free",
    "Guide",
    "HalfTurn",
    "HingeJoint",
    "HingeStops",
    "Joint",
    "Mechanics",
    "MechanicsRope",
    "Plane",
    "Point",
    "RopeEnd",
    "Rotation",
    "Sheave",
    "Slider",
    "SliderStops",
]

ORIGIN = (0.0, 0.0, 0.0)
AXIS_SHOWN = "Axis, three plain numbers; in the parent's axes, turned by the body's 'orientation'."
PLACE_SHOWN = "Position at the start, from 'at'; in the parent's axes, turned by the body's 'orientation'."
SPEED_SHOWN = "Velocity at the start, in the axes of 'position'."


class Rotation(Element):
    """An orientation: turned by an angle about an axis."""

    what: ClassVar[str] = "an orientation"

    about: Direction = Field(description="Axis of the turn, three plain numbers.")
    angle: Angle = Field(description="Angle of the turn, right-handed.")


class BodyInertia(Element):
    """Inertia of a body about its centre of gravity, body axes; products as off-diagonal terms."""

    what: ClassVar[str] = "the inertia of a body"

    xx: Inertia = Field(description="About x.")
    yy: Inertia = Field(description="About y.")
    zz: Inertia = Field(description="About z.")
    xy: Inertia = Field(0.0, description="Off-diagonal term xy, minus the integral of x y over the mass.")
    xz: Inertia = Field(0.0, description="Off-diagonal term xz, minus the integral of x z over the mass.")
    yz: Inertia = Field(0.0, description="Off-diagonal term yz, minus the integral of y z over the mass.")


class SliderStops(Element):
    """Where a slider ends."""

    what: ClassVar[str] = "the stops of a slider"

    lower: Length | None = Field(None, description="Least travel; none if not given.")
    upper: Length | None = Field(None, description="Largest travel; none if not given.")
    stiffness: PositiveStiffness = Field(description="Stiffness of each stop.")
    damping: Damping = Field(0.0, description="Damping of each stop.")
    loaded: Flag = Field(
        False,
        description="true: the joint may start beyond a stop, which pushes from then on; with both at one "
        "place they are a spring.",
    )


class HingeStops(Element):
    """Where a hinge ends."""

    what: ClassVar[str] = "the stops of a hinge"

    lower: Angle | None = Field(None, description="Least angle; none if not given.")
    upper: Angle | None = Field(None, description="Largest angle; none if not given.")
    stiffness: PositiveRotationalStiffness = Field(description="Stiffness of each stop.")
    damping: RotationalDamping = Field(0.0, description="Damping of each stop.")
    loaded: Flag = Field(
        False,
        description="true: the joint may start beyond a stop, which pushes from then on; with both at one "
        "place they are a spring.",
    )


class Fixed(Element):
    """No motion against the parent."""

    what: ClassVar[str] = "a fixed joint"

    type: Literal["fixed"] = Field(description="Kind of joint.")


class HingeJoint(Element):
    """Turning about one axis."""

    what: ClassVar[str] = "a hinge"

    type: Literal["hinge"] = Field(description="Kind of joint.")
    axis: Direction = Field(description=AXIS_SHOWN)
    position: Angle = Field(0.0, description="Angle at the start.")
    velocity: AngularSpeed = Field(0.0, description="Angular speed at the start.")
    damping: RotationalDamping = Field(0.0, description="Damping of the turning.")
    friction: Torque = Field(0.0, description="Dry friction that holds it; not with a motion.")
    stops: HingeStops | None = Field(None, description="Where it ends; nowhere if not given.")
    motion: list[TurnRamp] | None = Field(None, description="Motion given in advance, at rest at first.")


class Slider(Element):
    """Sliding along one axis."""

    what: ClassVar[str] = "a slider"

    type: Literal["slider"] = Field(description="Kind of joint.")
    axis: Direction = Field(description=AXIS_SHOWN)
    position: Length = Field(0.0, description="Travel at the start.")
    velocity: Speed = Field(0.0, description="Speed at the start.")
    damping: Damping = Field(0.0, description="Damping of the sliding.")
    friction: NotNegativeForce = Field(0.0, description="Dry friction that holds it; not with a motion.")
    stops: SliderStops | None = Field(None, description="Where it ends; nowhere if not given.")
    motion: list[SpeedRamp] | None = Field(None, description="Motion given in advance, at rest at first.")


class Ball(Element):
    """Turning about a point."""

    what: ClassVar[str] = "a ball joint"

    type: Literal["ball"] = Field(description="Kind of joint.")
    orientation: Rotation | None = Field(None, description="Orientation at the start.")
    angular_velocity: AngularVelocity = Field(ORIGIN, description="Angular velocity at the start, body axes.")


class Point(Element):
    """Three translations, no turning."""

    what: ClassVar[str] = "a point joint"

    type: Literal["point"] = Field(description="Kind of joint.")
    position: Position = Field(ORIGIN, description=PLACE_SHOWN)
    velocity: Velocity = Field(ORIGIN, description=SPEED_SHOWN)


class Free(Element):
    """All six motions."""

    what: ClassVar[str] = "a free joint"

    type: Literal["free"] = Field(description="Kind of joint.")
    position: Position = Field(ORIGIN, description=PLACE_SHOWN)
    orientation: Rotation | None = Field(None, description="Orientation at the start.")
    velocity: Velocity = Field(ORIGIN, description=SPEED_SHOWN)
    angular_velocity: AngularVelocity = Field(ORIGIN, description="Angular velocity at the start, body axes.")


Joint = Annotated[
    Fixed | HingeJoint | Slider | Ball | Point | Free,
    Field(discriminator="type"),
    with_a_type("fixed", "hinge", "slider", "ball", "point", "free"),
]


class BodyShape(Element):
    """A box that stands for a body in pictures."""

    what: ClassVar[str] = "the shape of a body"

    box: Sizes = Field(description="Sizes along x, y, z of the body.")
    centre: Position = Field(ORIGIN, description="Its middle in the body's axes.")


class Body(Afloat):
    """A rigid body on a joint."""

    what: ClassVar[str] = "a body"

    parent: Name | None = Field(None, description="Body it hangs on; the world if not given.")
    at: Position = Field(ORIGIN, description="Place of the joint in the parent's axes.")
    orientation: Rotation | None = Field(None, description="Orientation of the joint in the parent's axes.")
    joint: Joint = Field(description="The joint to the parent.")
    mass: Mass = Field(0.0, description="Mass.")
    centre_of_gravity: Position = Field(ORIGIN, description="Centre of gravity in the body's axes.")
    inertia: BodyInertia | None = Field(
        None, description="Inertia about the centre of gravity; 0 if not given."
    )
    shape: BodyShape | None = Field(None, description="A box to draw, and with which it touches others.")
    remark: Text | None = Field(None, description="A remark for people.")

    @property
    def floats_freely(self) -> bool:
        """Whether it has a hull, and nothing but forces hold it."""
        return self.hull is not None and self.parent is None and self.joint.type == "free"


class RopeEnd(Element):
    """An end of a rope: a dead end, or where a drum pays it out."""

    what: ClassVar[str] = "an end of a rope"

    type: Literal["end"] = Field(description="Kind of guide.")
    body: Name = Field(description="Body that it, or its drum, is fixed to; or 'world'.")
    at: Position = Field(
        ORIGIN, description="Place in the body's axes, on the load from its centre of gravity."
    )
    lug: Name | None = Field(None, description="Lug of the load that it is made fast to, in place of 'at'.")
    drum: Name | None = Field(
        None, description="Drum that pays rope out here, a name of 'drums'; a dead end if not given."
    )
    drum_diameter: PositiveLength | None = Field(
        None, description="Pitch diameter on which this rope lies; that of the drum if not given."
    )
    wound: Literal["with", "against"] | None = Field(
        None,
        description="'against': wound the other way round, so that it is hauled in where the drum pays out; "
        "'with' if not given.",
    )

    @model_validator(mode="after")
    def _in_one_place(self) -> RopeEnd:
        if self.lug is not None and "at" in self.model_fields_set:
            raise refuse("an end is made fast to a 'lug', or is 'at' a place; leave one of both out", "at")
        return self

    @model_validator(mode="after")
    def _of_a_drum(self) -> RopeEnd:
        for key in ("drum_diameter", "wound"):
            if self.drum is None and getattr(self, key) is not None:
                raise refuse(f"'{key}' stands without 'drum'; name the drum or leave it out", key)
        return self


class HalfTurn(SheaveWords):
    """Half a turn over a sheave, at fixed places of a body, as in the paper."""

    what: ClassVar[str] = "a half turn over a sheave"

    type: Literal["half_turn"] = Field(description="Kind of guide.")
    body: Name = Field(description="Body that carries the sheave, or 'world'.")
    enter: Position = Field(description="Where the rope comes on, in the body's axes.")
    leave: Position = Field(description="Where the rope goes off, in the body's axes.")
    bulge: Direction = Field(description="Side on which the rope lies on the sheave, three plain numbers.")

    @property
    def radius(self) -> float:
        """Pitch radius [m]."""
        return math.dist(self.enter, self.leave) / 2


class Sheave(SheaveWords):
    """A sheave as it is: the rope touches it along true tangents and wraps it as far as it must."""

    what: ClassVar[str] = "a sheave"

    type: Literal["sheave"] = Field(description="Kind of guide.")
    body: Name = Field(description="Body that carries the sheave, or 'world'.")
    at: Position = Field(ORIGIN, description="Its centre in the body's axes.")
    axis: Direction = Field(description="Its axis in the body's axes; the rope runs about it, right-handed.")
    diameter: PositiveLength = Field(description="Pitch diameter, to the centre line of the rope.")
    may_lift_off: Flag = Field(
        False, description="Whether the rope may leave it and run straight past; else that is a warning."
    )

    @property
    def radius(self) -> float:
        """Pitch radius [m]."""
        return self.diameter / 2


class Eye(Element):
    """An eye or a shackle that the rope slides through without friction: a point."""

    what: ClassVar[str] = "an eye"

    type: Literal["eye"] = Field(description="Kind of guide.")
    body: Name = Field(description="Body that it belongs to, or 'world'.")
    at: Position = Field(ORIGIN, description="Place in the body's axes.")


Guide = Annotated[
    RopeEnd | HalfTurn | Sheave | Eye,
    Field(discriminator="type"),
    with_a_type("end", "half_turn", "sheave", "eye"),
]


class MechanicsRope(Element):
    """A rope along a route."""

    what: ClassVar[str] = "a rope of mechanics"

    rope: Name = Field(description="Kind of rope, a name of 'ropes'.")
    length: Annotated[
        float | Literal["as_routed"], WordOr(("as_routed",), Quantity("length", "positive"))
    ] = Field(description="Unstretched length; 'as_routed': just taut at the start.")
    stretched: Flag = Field(
        False, description="It may be longer at the start than 'length' by more than 2 %, as a spring may."
    )
    rope_weight: RopeWeightWord | None = Field(None, description=WEIGHT_SHOWN)
    rope_nodes: RopeNodes | None = Field(None, description=NODES_SHOWN)
    breaks_at: BreaksAt | None = Field(None, description=f"{BREAKS_SHOWN} As its rope if not given.")
    comes_free: Flag = Field(
        False,
        description="It stands for mud or suction that holds the load to its bed: where it breaks as the "
        "load is hoisted that came free, and no rope parted.",
    )
    cut_at: Time | None = Field(None, description=CUT_SHOWN)
    route: list[Guide] = Field(min_length=2, description="Ends, and sheaves and eyes between them, in order.")

    @model_validator(mode="after")
    def _at_a_force(self) -> MechanicsRope:
        if self.comes_free and self.breaks_at in (None, "never"):
            sentence = "what 'comes_free' does so at a force; give it in 'breaks_at', such as '600 kN'"
            raise refuse(sentence, "comes_free")
        return self


class Plane(Element):
    """A plane that a contact point meets."""

    what: ClassVar[str] = "a plane"

    point: Position = Field(ORIGIN, description="A point of the plane.")
    normal: Direction = Field((0.0, 0.0, 1.0), description="Direction to the free side, three plain numbers.")


class Contact(Element):
    """A point of a body that may meet a plane."""

    what: ClassVar[str] = "a contact"

    body: Name = Field(description="Body that the point belongs to.")
    at: Position = Field(ORIGIN, description="The point in the body's axes.")
    plane: Plane = Field(description="The plane, fixed in the world.")
    stiffness: PositiveStiffness = Field(description="Stiffness.")
    damping: Damping = Field(0.0, description="Damping.")
    friction: Ratio = Field(0.0, description="Coefficient of friction.")
    group: Name | None = Field(
        None, description="Contacts of one group lift off together; the body if not given."
    )


class BodyContact(Element):
    """Two bodies with shapes that may touch each other."""

    what: ClassVar[str] = "a contact of bodies"

    between: Annotated[tuple[str, str], ListOf(NameText(), 2)] = Field(
        description="Two names as in 'watch', no ropes."
    )
    stiffness: PositiveStiffness = Field(description="Stiffness at each place that touches.")
    damping: Damping = Field(0.0, description="Damping at each place that touches.")
    friction: Ratio = Field(0.0, description="Coefficient of friction.")
    group: Name | None = Field(
        None,
        description="Contacts of one group lift off together; if not given the load, "
        "but what stands on it from the start, or the first that moves.",
    )


class Mechanics(Element):
    """Plain bodies, drums, ropes and contacts."""

    what: ClassVar[str] = "mechanics"

    bodies: Named[Body] = Field(default_factory=dict, description="Bodies by name.")
    drums: Named[Drum] | None = Field(None, description="Drums by name.")
    ropes: Named[MechanicsRope] | None = Field(None, description="Ropes by name.")
    contacts: Named[Contact] | None = Field(None, description="Contacts by name.")
    body_contacts: Named[BodyContact] | None = Field(
        None, description="Bodies that may touch each other, by name."
    )
