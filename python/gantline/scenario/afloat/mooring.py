"""Mooring lines and fenders: what keeps vessels where they are."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.afloat.water import SEA_WATER
from gantline.scenario.base import Element
from gantline.scenario.errors import nearest
from gantline.scenario.plan.parting import BREAKS_SHOWN, CUT_SHOWN, BreaksAt
from gantline.scenario.quantities import (
    Angle,
    Damping,
    Flag,
    Length,
    ListOf,
    Name,
    NotNegativeLength,
    Position,
    PositiveAcceleration,
    PositiveForce,
    PositiveLength,
    PositiveSpeed,
    PositiveStiffness,
    Quantity,
    Ratio,
    Time,
    refuse,
)
from gantline.scenario.rope_weight import RopeNodes, RopeWeight, RopeWeightWord, rope_weight
from gantline.units import format_by_size

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings, Path
    from gantline.scenario.gear import RopeMaterial
    from gantline.scenario.model import Scenario

__all__ = [
    "Fender",
    "MooringLine",
    "Winch",
    "body_of",
    "check_moorings",
    "fender_contact",
    "is_moored",
    "line_rope",
    "line_weight",
    "lines_at",
    "moored_bodies",
    "weight_on_nodes",
]

#: Density of the steel of ropes [kg/m^3], EN 1991-1-1, table A.4: what they displace follows from their mass.
STEEL = 7850.0
#: How far the lower end of a line may be from the bed that it lies on [m].
_ON_BED = 1e-3


def body_of(name: str | None) -> str | None:
    """The body that holds the far end of a line or a fender's wall; None is the world."""
    return None if name == "world" else name


class Winch(Element):
    """A winch on which a mooring line or a tag line ends."""

    what: ClassVar[str] = "a winch"

    speed: PositiveSpeed = Field(description="Highest speed of the rope.")
    acceleration: PositiveAcceleration = Field(
        description="Highest acceleration of the rope; also used where a step names none."
    )
    capacity: PositiveForce | None = Field(
        None,
        description="Largest pull, at which it slips: of tag lines, and of mooring lines of type 'spring'. "
        "Whatever it takes if not given.",
    )

    def refuse_weak(self, pretension: float | None) -> None:
        """Refuse a pretension [N] at which it would slip from the start."""
        if self.capacity is not None and pretension is not None and pretension > self.capacity:
            most = format_by_size(self.capacity, "force")
            sentence = (
                f"the winch slips at {most}, and the line shall pull {format_by_size(pretension, 'force')}"
            )
            raise refuse(f"{sentence} from the start; a stronger winch or less pretension is right", "winch")


class MooringLine(Element):
    """A line that holds a vessel to the world, or to another vessel."""

    what: ClassVar[str] = "a mooring line"

    vessel: Name = Field(description="The vessel that it holds, or a body of 'mechanics'.")
    fairlead: Position = Field(description="Where it leaves the vessel, in the vessel's axes.")
    to: Position = Field(
        description="Where it is made fast: in the world, a bollard or an anchor, or in the axes of what "
        "'held_by' names."
    )
    held_by: Name | None = Field(
        None,
        description="What it leads to: another vessel, or a body of 'mechanics'; the world if not given. Not "
        "of catenaries.",
    )
    rope: Name = Field(description="Kind of rope, a name of 'ropes'.")
    length: PositiveLength | None = Field(None, description="Unstretched length.")
    pretension: PositiveForce | None = Field(
        None,
        description="Tension at the fairlead, the vessel where it is at the start; in place of 'length'.",
    )
    type: Literal["catenary", "spring", "distributed"] = Field(
        "catenary",
        description="'catenary': hangs by its own weight from a place that stands still; 'spring': straight "
        "between its ends, without weight; 'distributed': its weight and its inertia on nodes along it.",
    )
    rope_nodes: RopeNodes | None = Field(None, description="Nodes of a distributed line; 50 if not given.")
    sea_bed: Length | None = Field(
        None,
        description="Height of the level bed that a catenary may lie on, without friction; that of 'to', "
        "where it is made fast. No bed if not given.",
    )
    under_water: Flag | None = Field(
        None,
        description="Whether a catenary weighs what it weighs under water, all of it; where there is a "
        "'sea_bed' if not given.",
    )
    winch: Winch | None = Field(None, description="Winch on the vessel; it is made fast if not given.")
    breaks_at: BreaksAt | None = Field(None, description=f"{BREAKS_SHOWN} As its rope if not given.")
    cut_at: Time | None = Field(None, description=CUT_SHOWN)

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> MooringLine:
        if (self.length is None) == (self.pretension is None):
            found = "none of them" if self.length is None else "both"
            raise refuse(f"a mooring line has one of 'length' and 'pretension'; found {found}")
        self._refuse_what_its_type_has_not()
        if self.winch is not None:
            self.winch.refuse_weak(self.pretension)
        if self.held_by == self.vessel:
            raise refuse(f"'{self.held_by}' is the vessel that it holds; a line has two ends", "held_by")
        if self.sea_bed is not None and abs(self.to[2] - self.sea_bed) > _ON_BED:
            side = "above" if self.sea_bed > self.to[2] else "below"
            apart = abs(self.sea_bed - self.to[2])
            sentence = f"the sea bed at {self.sea_bed:g} m is {apart:g} m {side} the end at {self.to[2]:g} m"
            raise refuse(f"{sentence}; a line rests on the bed on which it is made fast", "sea_bed")
        return self

    def _refuse_what_its_type_has_not(self) -> None:
        # No catenary leads to another vessel: none is the advice then.
        if self.type != "catenary":
            other = "" if self.holder is not None else ", or write 'type: catenary'"
            for key in ("sea_bed", "under_water"):
                if getattr(self, key) is not None:
                    raise refuse(f"'{key}' is for catenaries; leave it out{other}", key)
        elif self.holder is not None:
            sentence = "the lower end of a catenary stands still"
            right = "'type: spring' for a short line between vessels, 'distributed' for one that sags"
            raise refuse(f"{sentence}; write {right}", "held_by")
        if self.type != "distributed" and self.rope_nodes is not None:
            raise refuse("only a distributed line has nodes; write 'type: distributed' too", "rope_nodes")
        if self.winch is None:
            return
        if self.type == "distributed":
            sentence = "a line with nodes has no winch"
            other = "" if self.holder is not None else " or 'catenary'"
            raise refuse(f"{sentence}; leave it out, or write 'type: spring'{other}", "winch")
        if self.type == "catenary" and self.winch.capacity is not None:
            sentence = "the winch of a catenary does not slip"
            raise refuse(f"{sentence}; leave 'capacity' out, or write 'type: spring'", "winch")

    @property
    def holder(self) -> str | None:
        """The body that it leads to; None is the world."""
        return body_of(self.held_by)

    @property
    def is_under_water(self) -> bool:
        """Whether it weighs what it weighs under water."""
        return self.sea_bed is not None if self.under_water is None else self.under_water


class Fender(Element):
    """A fender between a vessel and a quay or another vessel: a point of it that meets an upright plane."""

    what: ClassVar[str] = "a fender"

    type: Name | None = Field(None, description="A name of 'fender_types' that gives what is not said here.")
    vessel: Name = Field(description="The vessel, or a body of 'mechanics'.")
    at: Position = Field(description="Where the vessel presses on it, in the vessel's axes.")
    wall: Annotated[tuple[float, float], ListOf(Quantity("length"), 2)] = Field(
        description="A place of the wall of the quay, x and y of the world, or of what 'wall_of' names."
    )
    wall_of: Name | None = Field(
        None,
        description="The vessel whose side is the wall, or a body of 'mechanics'; a quay if not given.",
    )
    facing: Angle = Field(
        description="Where the wall faces, to the vessel: from x towards y of the world, or of the body that "
        "'wall_of' names."
    )
    thickness: NotNegativeLength = Field(0.0, description="Of the fender, where nothing presses on it.")
    stiffness: PositiveStiffness = Field(description="Force over compression.")
    damping: Damping = Field(0.0, description="Force over the speed of compression.")
    friction: Ratio = Field(0.0, description="Coefficient of friction along the wall.")
    capacity: PositiveForce | None = Field(None, description="Largest force that it may take.")

    @model_validator(mode="after")
    def _two_bodies(self) -> Fender:
        if self.wall_of == self.vessel:
            raise refuse(f"'{self.wall_of}' is the vessel itself; a fender is between two", "wall_of")
        return self

    @property
    def wall_body(self) -> str | None:
        """The body whose side is the wall; None is the world."""
        return body_of(self.wall_of)

    @property
    def normal(self) -> tuple[float, float, float]:
        """Direction in which the wall faces, in the axes of its body."""
        return math.cos(self.facing), math.sin(self.facing), 0.0


def line_rope(name: str) -> str:
    """Name of a mooring line among the ropes of a recording."""
    return f"mooring.{name}"


def fender_contact(name: str) -> str:
    """Name of a fender among the contacts of a recording."""
    return f"fender.{name}"


def line_weight(scenario: Scenario, line: MooringLine) -> float:
    """Weight per length of a catenary [N/m]."""
    mass = (scenario.ropes or {})[line.rope].mass_per_length
    density = scenario.water.density if scenario.water is not None else SEA_WATER
    share = 1.0 - density / STEEL if line.is_under_water else 1.0
    return mass * share * scenario.simulation.gravity


def weight_on_nodes(line: MooringLine, kind: RopeMaterial) -> RopeWeight:
    """How the weight of a line of this kind of rope acts, as far as it is that of nodes or bodies."""
    # A catenary's weight is its own; it is no body's mass.
    way: RopeWeightWord = "distributed" if line.type == "distributed" else "none"
    return rope_weight(kind, way, line.rope_nodes)


def lines_at(scenario: Scenario, body: str) -> list[str]:
    """Mooring lines that end on a body, or on what stands on it."""
    lines = (scenario.mooring_lines or {}).items()
    return [name for name, line in lines if body in _ends(scenario, line)]


def is_moored(scenario: Scenario, body: str) -> bool:
    """Whether lines lead from a body to the world, by way of others or not."""
    ends = [_ends(scenario, line) for line in (scenario.mooring_lines or {}).values()]
    held: set[str | None] = {body}
    while None not in held:
        ahead = {end for both in ends if not held.isdisjoint(both) for end in both} - held
        if not ahead:
            return False
        held |= ahead
    return True


def _ends(scenario: Scenario, line: MooringLine) -> list[str | None]:
    """What bears both ends of a line: a vessel, or a body of 'mechanics' that moves; None is the world."""
    return [_bearer(scenario, body) for body in (line.vessel, line.holder)]


def _bearer(scenario: Scenario, body: str | None) -> str | None:
    """What a body stands on, as bollards do on a vessel and piles in the ground; itself where it moves."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    while body in plain and (plain[body].parent is not None or plain[body].joint.type == "fixed"):
        body = plain[body].parent
    return body


def moored_bodies(scenario: Scenario) -> list[str]:
    """What mooring lines can hold and fenders keep off."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    return [*(scenario.vessels or {}), *plain]


def check_moorings(findings: Findings) -> None:
    """Note everything that is wrong with mooring lines and fenders."""
    scenario = findings.scenario
    known = moored_bodies(scenario)
    kinds, lines, fenders = scenario.ropes or {}, scenario.mooring_lines or {}, scenario.fenders or {}
    ends = [
        *((("mooring_lines", name), line.vessel, "held_by", line.holder) for name, line in lines.items()),
        *((("fenders", name), one.vessel, "wall_of", one.wall_body) for name, one in fenders.items()),
    ]
    for element, vessel, key, other in ends:
        for said, body in (("vessel", vessel), (key, other)):
            if body is not None and body not in known:
                sentence = f"'{body}' is not a vessel, nor a body of 'mechanics'"
                findings.add((*element, said), f"{sentence}; {nearest(body, known)}")
    plain = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    for name, line in lines.items():
        path: Path = ("mooring_lines", name)
        if line_rope(name) in plain:
            sentence = f"'{line_rope(name)}' is already the name of a rope of 'mechanics'"
            findings.add(path, f"{sentence}; use another name")
        if line.rope not in kinds:
            findings.add(
                (*path, "rope"), f"'{line.rope}' is not a name of 'ropes'; {nearest(line.rope, kinds)}"
            )
            continue
        _check_rope(findings, path, line, kinds[line.rope])
    if any(line.type == "catenary" for line in lines.values()):
        findings.refuse_explicit("catenaries", instead="'type: spring'")


def _check_rope(findings: Findings, path: Path, line: MooringLine, kind: RopeMaterial) -> None:
    if kind.inextensible:
        sentence = f"rope '{line.rope}' does not stretch, which a mooring line has to"
        findings.add((*path, "rope"), f"{sentence}; give it an 'axial_stiffness' or a 'construction'")
    straight = {"catenary": "a catenary", "distributed": "a line with nodes", "spring": None}[line.type]
    if straight is not None and (bent := kind.bent(line.rope, straight)) is not None:
        findings.add((*path, "rope"), f"{bent}, or write 'type: spring', straight from end to end")
    on_a_winch = kind.bent(line.rope, "a line on a winch")
    if straight is None and line.winch is not None and on_a_winch is not None:
        findings.add((*path, "rope"), f"{on_a_winch}, or leave 'winch' out")
    if line.type == "spring":
        return
    if kind.mass_per_length == 0:
        hangs = "a catenary" if line.type == "catenary" else "a distributed line"
        sentence = f"the mass of rope '{line.rope}' is not known, and {hangs} hangs by its weight"
        right = "give it a 'construction' or its mass, such as 'mass: 8 kg/m', or write 'type: spring'"
        findings.add((*path, "rope"), f"{sentence}; {right}")
    if findings.scenario.simulation.gravity == 0:
        findings.add((*path, "type"), "without gravity nothing hangs; 'type: spring' is right here")
