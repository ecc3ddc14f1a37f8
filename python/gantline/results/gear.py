"""Hooks, equalizers, slings, ropes, sheaves and drums as results know them; all numbers are SI."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Annotated, Any, Self

from pydantic import Field

from gantline.results.file.form import Vector
from gantline.results.strength import FromJson, HasLugs, Lug, Shackle


@dataclass(frozen=True)
class RopeOver(FromJson):
    """A rope that runs over a hook.

    Attributes:
        rope: Its name.
        place: Which of its guides is on the hook, from 0 for its first end on.
        arcs: Whether each of its guides is a sheave, on which points of its drawn path lie, or a point.
    """

    rope: str
    place: int = 1
    arcs: Sequence[bool] = ()


@dataclass(frozen=True)
class Hook(FromJson):
    """A crane's hook.

    Attributes:
        name: Its name.
        crane: The crane to which it belongs.
        bearing_joints: Bodies that hang in the hook by a joint; the forces of these joints are hook load.
        direct_slings: Slings that hang in the hook without an equalizer.
        rated_capacity: Of crane or hook [N]; None if not said.
        rating_includes_hook_block: Whether the rated capacity is for the hoist load.
        hoist_weight_extra: Hook block and hanging falls [N] that are no part of the mechanics.
        falls: Segments of rope in which a hook with reeving hangs; empty for a hook without.
        falls_weight_above: What the upper sheaves bear of the weight of the falls [N].
        direct_ropes: Other ropes that end at the hook, each with its end there, `first` or `last`; of a hook
            with reeving.
        ropes_over: Ropes that run over the hook; of a hook with reeving.
        bears_mechanics: Whether ropes or bodies of `mechanics` hang in it, whatever hangs on them.
        direct_weight: Weight of what slings and ropes have lumped on the hook [N]; of a hook with reeving.
        sheave_diameter: Pitch diameter of the sheaves of its hook block [m]; 0 for a hook without reeving.
        falls_spread: Mean square of the distances of its falls from the axis about which the hook block turns
            in them [m^2]; 0 where that is not known.
        rope_torque: Torque of a hoist rope over its tension [m].
        is_rope_torque_known: Whether it is that of the rope, and not what such ropes usually have.
        drum: Name of its drum; empty for a hook without reeving.
        holds: Hoist load that motor and brake of its drum both hold on the first layer [N]; None without end.
        has_weaker_brake: Whether that is what its brake holds, and its motor more.
        wind_limit: Largest gust in which the crane of a fixed hook may lift [m/s]; None if not said, and of
            hooks of other cranes, which have their own.
        wind: Wind or gust of the lift that is held against it [m/s]; None if not said.
    """

    name: str
    crane: str = ""
    bearing_joints: Sequence[str] = ()
    direct_slings: Sequence[str] = ()
    rated_capacity: float | None = None
    rating_includes_hook_block: bool = False
    hoist_weight_extra: float = 0.0
    falls: Sequence[str] = ()
    falls_weight_above: float = 0.0
    direct_ropes: Sequence[Sequence[str]] = ()
    ropes_over: Sequence[RopeOver] = ()
    bears_mechanics: bool = False
    direct_weight: float = 0.0
    sheave_diameter: float = 0.0
    falls_spread: float = 0.0
    rope_torque: float = 0.0
    is_rope_torque_known: bool = False
    drum: str = ""
    holds: float | None = None
    has_weaker_brake: bool = False
    wind_limit: float | None = None
    wind: float | None = None

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        over = tuple(RopeOver.from_json(one) for one in document.get("ropes_over", ()))
        return super().from_json({**document, "ropes_over": over})


@dataclass(frozen=True)
class Equalizer(FromJson):
    """Frame, equalizing rope and moving sheaves under one hook.

    Attributes:
        name: Its name.
        body: Name of the frame's body.
        hook: The hook from which it hangs.
        equalizing_rope: Name of the rope.
        slings: Ropes that hang from its moving sheaves, in the order of the sheaves.
        moving_sheaves: Bodies (and joints) of the moving sheaves.
        travel_up: Stroke above the place in the lift file [m]; None if not limited.
        travel_down: Stroke below the place in the lift file [m]; None if not limited.
        stops: Whether stops at both ends of the stroke are simulated.
        rated_capacity: Below the moving sheaves [N]; None if not said.
        heading_joint: Joint about which the frame turns under its hook.
        tilts: Whether the frame tilts under its hook too; else the hook holds it upright.
        bearing: Where it hangs in its hook, from its centre of gravity, axes of the frame [m]; None if not
            said.
        mechanism: `sheaves`, or `approximated`: no sheave moves, the lengths of its slings are adjusted.
        adjusting_factor: Of an approximated one, else None.
        guided: `vertical`, or `none`: its moving sheaves hang free in its rope, and have no locking pins.
        locked: Moving sheaves that pins hold at the start.
        pin_capacity: Of each locking pin [N]; None if not said.
    """

    name: str
    body: str
    hook: str = ""
    equalizing_rope: str = ""
    slings: Sequence[str] = ()
    moving_sheaves: Sequence[str] = ()
    travel_up: float | None = None
    travel_down: float | None = None
    stops: bool = False
    rated_capacity: float | None = None
    heading_joint: str | None = None
    tilts: bool = False
    bearing: Sequence[float] | None = None
    mechanism: str = "sheaves"
    adjusting_factor: float | None = None
    guided: str = "vertical"
    locked: Sequence[str] = ()
    pin_capacity: float | None = None


@dataclass(frozen=True)
class Sling(FromJson):
    """A rope from a hook, moving sheave or other gear to a lug, or by extension sheaves to more of them.

    Attributes:
        name: Its name in the lift file.
        rope: Its name among the ropes, `sling.<name>`.
        from_body: Where its upper end is made fast, or the extension sheave that it runs over.
        from_lug: The lug at its upper end, of a spreader; None if there is none.
        to_load: The load at its lower end; None if other gear hangs there.
        to_lug: The lug of the load at its lower end, if that is the only one.
        over: The extension sheave that it runs over, from end to end; None if it runs over none.
        lugs: The lug at each lower end, one or two; None where an extension sheave or compensator hangs.
        lugs_of: The load or spreader that has it, of each lower end; the compensator that hangs there.
        length: Effective sling length [m].
        minimum_breaking_force: Of its rope [N]; None if not said.
        shackles: Shackles at `top` and `bottom`.
        bends_about: Diameters of what its eyes lie on where there is no shackle, at `top` and `bottom` [m].
        upper_weight: What its upper end hangs on what holds it beside its tension [N]: of a lumped rope half,
            its upper shackle, a chain hoist.
    """

    name: str
    rope: str
    from_body: Annotated[str, Field(alias="from")] = ""
    from_lug: str | None = None
    to_load: str | None = None
    to_lug: str | None = None
    over: str | None = None
    lugs: Sequence[str | None] = ()
    lugs_of: Sequence[str | None] = ()
    length: float | None = None
    minimum_breaking_force: float | None = None
    shackles: Mapping[str, Shackle] = field(default_factory=dict)
    bends_about: Mapping[str, float] = field(default_factory=dict)
    upper_weight: float = 0.0

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        lug = document.get("to_lug")
        lugs = document.get("lugs", () if lug is None else (lug,))
        parts = {
            "from_body": document.get("from", ""),
            "lugs": lugs,
            "lugs_of": [None if one is None else document.get("to_load") for one in lugs],
            **document,
            "shackles": {
                end: Shackle.from_json(one) for end, one in (document.get("shackles") or {}).items()
            },
        }
        return super().from_json(parts)

    def at_lugs(self) -> Iterator[tuple[int, str, str]]:
        """Its lugs: number of the lower end (0 at the upper one), what has the lug, its name there."""
        if self.from_lug is not None:
            yield 0, self.from_body, self.from_lug
        for end, (of, lug) in enumerate(zip(self.lugs_of, self.lugs, strict=True)):
            if of is not None and lug is not None:
                yield end, of, lug


@dataclass(frozen=True)
class Spreader(HasLugs):
    """A bar, beam or frame between slings.

    Attributes:
        name: Its name.
        body: Name of its body.
        weight: As simulated [N], with what slings and shackles lump onto it.
        size: Of its box along its axes [m].
        rated_capacity: Of all that hangs below it [N]; None if not said.
        lugs: Lugs by name, where from its centre of gravity, its axes [m].
    """

    name: str
    body: str
    weight: float = 0.0
    size: Vector = (0.0, 0.0, 0.0)
    rated_capacity: float | None = None
    lugs: Mapping[str, Lug] = field(default_factory=dict)


@dataclass(frozen=True)
class Compensator(FromJson):
    """A gas spring between slings.

    Attributes:
        name: Its name.
        body: Name of the body of its cylinder.
        rod: Name of the body of its rod, and of the joint on which that slides.
        gas: Name of the rope that stands for its gas.
        weight: Of both as simulated [N], with what slings and shackles lump onto them.
        stroke: How far the rod comes out [m].
        pull_in: Pull of the gas with the rod in [N].
        pull_out: Pull of the gas with the rod out [N].
        pulls: Ways of the rod out [m] with the pull of the gas there [N], from stop to stop; none in an old
            recording.
        seal_friction: Of its seals [N].
        locked: Whether a pin holds the rod at the start.
        rated_capacity: Of all that hangs below it [N]; None if not said.
    """

    name: str
    body: str
    rod: str = ""
    gas: str = ""
    weight: float = 0.0
    stroke: float = 0.0
    pull_in: float = 0.0
    pull_out: float = 0.0
    pulls: Sequence[Sequence[float]] = ()
    seal_friction: float = 0.0
    locked: bool = False
    rated_capacity: float | None = None


@dataclass(frozen=True)
class Rope(FromJson):
    """What is known of a rope beside its mechanics.

    Attributes:
        name: Its name among the ropes of the recording.
        construction: Its construction, such as `6x36 IWRC`; None if not said.
        diameter: Nominal diameter [m]; None if not said.
        axial_stiffness: EA [N], of a curve that of the same energy; None if it does not stretch, or in an old
            recording.
        curve: Strain and tension [N] of each point of its curve, rising; none of a rope of one stiffness.
        length: Unstretched length of one that runs straight from end to end, is no sling and has no drum [m];
            None of others, or in an old recording.
        mass_per_length: Mass per length that counts in the lift [kg/m]; 0 if it has none.
        minimum_breaking_force: From a certificate or from construction and grade [N]; None if not known.
        breaks_at: Tension at which it breaks in the simulation [N]; None if it never does.
        weight: How its weight acts: `none`, `lumped` or `distributed`.
        mass: Mass that counts in the lift [kg].
        mass_on_world: What of it the world bears, so that it is on no body [kg].
        nodes: Number of nodes if it is distributed, else 0.
        end_mass: What each end carries of the mass [kg], if there are nodes.
        over_eyes: Whether it bends about eyes, or sheaves of luffing tackles, whose diameter nobody says.
        comes_free: Whether it stands for mud or suction, that comes free of the load where it breaks.
    """

    name: str
    construction: str | None = None
    diameter: float | None = None
    axial_stiffness: float | None = None
    curve: Sequence[Sequence[float]] = ()
    length: float | None = None
    mass_per_length: float = 0.0
    minimum_breaking_force: float | None = None
    breaks_at: float | None = None
    weight: str = "none"
    mass: float = 0.0
    mass_on_world: float = 0.0
    nodes: int = 0
    end_mass: float | None = None
    over_eyes: bool = False
    comes_free: bool = False

    def strain(self, tension: float) -> tuple[float, float] | None:
        """Strain under a tension [N] at rest and what it grows by with that [1/N]; None if it is not known.

        Its first line goes on below nothing, its last one beyond its last point.
        """
        if self.curve:
            lines = pairwise([(0.0, 0.0), *self.curve])
            for (begin, low), (end, high) in lines:
                soft = (end - begin) / (high - low)
                if tension <= high:
                    break
            return begin + soft * (tension - low), soft
        if not self.axial_stiffness:
            return None
        return tension / self.axial_stiffness, 1.0 / self.axial_stiffness


@dataclass(frozen=True)
class Sheave(FromJson):
    """A sheave with losses or inertia.

    Attributes:
        name: Of the flow of rope over it: `<equalizer>/moving_<n>`, `<equalizer>/fixed_<n>`, or
            `<rope>/sheave_<n>` of a rope of `mechanics`, counted from 1 along the rope.
        rope: The rope over it.
        segments: Segments of the rope before and after it.
        ratio: Largest ratio of the tensions on both sides that its bearing holds, 1 without losses, None
            where it does not turn.
        groove_friction: Coefficient of friction of a groove in which the rope may slip, None where it grips.
        spins: Whether its spin is a coordinate of its own beside the rope over it.
        inertia: Mass that moves with the rope, moment of inertia over radius squared [kg].
        inertia_from: What that mass is, in words.
    """

    name: str
    rope: str
    segments: Sequence[str]
    ratio: float | None = 1.0
    groove_friction: float | None = None
    spins: bool = False
    inertia: float = 0.0
    inertia_from: str = ""

    @property
    def has_losses(self) -> bool:
        """Whether it takes tension from the rope that passes."""
        return self.ratio != 1.0 or self.groove_friction is not None


@dataclass(frozen=True)
class WrappedSheave(FromJson):
    """A sheave that its rope touches along true tangents.

    Attributes:
        name: `<rope>/sheave_<n>`, counted from 1 along the rope.
        rope: Its rope.
        may_lift_off: Whether the rope may leave it.
    """

    name: str
    rope: str
    may_lift_off: bool = False


@dataclass(frozen=True)
class Drum(FromJson):
    """A drum, of `mechanics` or of a hook with reeving.

    Attributes:
        name: Its name.
        flow: Name of its flow; its own if not given, as of rope that is wound against the rest.
        diameter: Pitch diameter on which its rope is counted [m]; of the first layer.
        paid_out: Rope paid out in the first layer per unit of its flow; of a hook's drum, which counts what
            the hook rises, less than 0.
        wraps_at_start: Turns on it at the start; None where that is not known.
        wraps_per_layer: Turns in a full layer; None of one layer without end.
        layers: Layers that fit on it.
        layer_step: Radius that each further layer adds [m].
        first_sheave: Distance of the sheave before the middle of a full layer of its rope [m]; None if not
            said.
        rope_diameter: Of the rope on it [m]; None where that is not known.
        spare_turns: Turns that have to stay on it; None where nothing is said.
        asks_for_turns: Whether the lift file says so, and no rule in its place.
        ropes: Names of the ropes on it; empty of a hook's drum, which has them as falls.
        ends: Which end of each lies there, `first` or `last` of its route.
        rated_capacity: Working load limit of each of them there [N]; None if not said.
    """

    name: str
    diameter: float = 0.0
    paid_out: float = 1.0
    wraps_at_start: float | None = None
    wraps_per_layer: float | None = None
    layers: int = 1
    layer_step: float = 0.0
    first_sheave: float | None = None
    rope_diameter: float | None = None
    spare_turns: float | None = None
    asks_for_turns: bool = False
    flow: str = ""
    ropes: Sequence[str] = ()
    ends: Sequence[str] = ()
    rated_capacity: float | None = None

    @property
    def joint(self) -> str:
        """The joint of a recording that says how far it has turned."""
        return self.flow or self.name
