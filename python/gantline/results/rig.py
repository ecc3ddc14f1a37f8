"""What results need to know of the lift: which rope is a sling, what hangs from which hook, what is allowed.

A recording carries it as its attribute `rig`, so that tables, checks and plots never ask the lift file again.
All numbers are SI.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cache
from typing import Any, Self, get_args, get_origin, get_type_hints

from gantline.results.afloat.moorings import Fender, MooringLine
from gantline.results.afloat.sea import Sea
from gantline.results.afloat.vessels import Vessel
from gantline.results.afloat.wind import Current, Wind
from gantline.results.cranes.boom import Boom
from gantline.results.cranes.chain_hoists import ChainHoist
from gantline.results.cranes.crane import Crane, CraneHook
from gantline.results.cranes.crawler import Crawler
from gantline.results.cranes.ranges import DriveRange
from gantline.results.cranes.rating_chart import RatingChart
from gantline.results.file.form import Vector
from gantline.results.gear import (
    Compensator,
    Drum,
    Equalizer,
    Hook,
    Rope,
    Sheave,
    Sling,
    Spreader,
    WrappedSheave,
)
from gantline.results.loads.guides import Guide
from gantline.results.loads.hinges import Hinge
from gantline.results.ropes.tag_lines import TagLine
from gantline.results.strength import Bend, Factor, FromJson, HasLugs, Lug, Rating, SideLoad

#: Tension spread below which an equalizer counts as equalised where the lift file names none [1].
EQUALISED_BELOW = 0.05


@dataclass(frozen=True)
class Resting(FromJson):
    """How an equilibrium has a load where a run hangs it still.

    Attributes:
        time: That moment [s].
        leads_away: What moves on from there by itself, in words; empty where it is stable.
        aside: Angle between its own z axis in the run and in the equilibrium [rad].
    """

    time: float
    leads_away: str = ""
    aside: float = 0.0


@dataclass(frozen=True)
class Load(HasLugs):
    """What is lifted.

    Attributes:
        name: Its name.
        body: Name of its body.
        weight: As simulated [N], with what slings and shackles lump onto it; without what is in its tanks.
        simulated_mass: Mass of the load alone as simulated [kg].
        contacts: Names of the contact points on which it stands.
        meets: What moves and is met at a contact, by the name of the contact; nothing of ground and supports.
        contact_group: Name that events of these contacts carry.
        calculated_mass: Before contingency [kg].
        contingency: Factor on the calculated mass.
        design_mass: With contingency [kg].
        lugs: Lugs by name.
        other_ropes: Ropes that are no slings and end at it or run over it.
        ends_of_ropes: Which end of those that end at it does so, `first` or `last`.
        ropes_at_lugs: By lug, which end of which rope is made fast there: pairs of rope and end.
        tied_to: What holds the other end of those that no drum hauls, where that is the world, a vessel, or
            fixed to one of these.
        let_go_in: Steps of the plan that let go of those, by rope.
        centre_envelope: How far its centre of gravity may be elsewhere, plus and minus along its axes [m].
        in_water: Name of what it displaces among the hulls; None where no water acts on it.
        water_density: Of the water that it displaces [kg/m^3].
        tanks: Names of its tanks.
        resting: How equilibria have it where it hung still in ropes that are no slings, or with liquid in its
            tanks, as far as there are any.
    """

    name: str
    body: str
    weight: float
    contacts: Sequence[str] = ()
    meets: Mapping[str, str] = field(default_factory=dict)
    contact_group: str | None = None
    simulated_mass: float | None = None
    calculated_mass: float | None = None
    contingency: float | None = None
    design_mass: float | None = None
    lugs: Mapping[str, Lug] = field(default_factory=dict)
    other_ropes: Sequence[str] = ()
    ends_of_ropes: Mapping[str, str] = field(default_factory=dict)
    ropes_at_lugs: Mapping[str, Sequence[Sequence[str]]] = field(default_factory=dict)
    tied_to: Mapping[str, str] = field(default_factory=dict)
    let_go_in: Mapping[str, Sequence[str]] = field(default_factory=dict)
    centre_envelope: Vector = (0.0, 0.0, 0.0)
    in_water: str | None = None
    water_density: float = 1025.0
    tanks: Sequence[str] = ()
    resting: Sequence[Resting] = ()

    @property
    def more_mass(self) -> float:
        """By how much its design weight is more than what is simulated [kg]; 0 where that is not known."""
        if self.design_mass is None or self.simulated_mass is None:
            return 0.0
        return max(0.0, self.design_mass - self.simulated_mass)

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        resting = tuple(Resting.from_json(one) for one in document.get("resting", ()))
        return super().from_json({**document, "resting": resting})


def with_resting(rig: Mapping[str, Any], resting: Mapping[str, Sequence[Resting]]) -> dict[str, Any]:
    """The JSON of a rig whose loads tell how equilibria have them.

    Args:
        rig: Its JSON.
        resting: What is known of loads by their names.
    """
    told = {name: [asdict(one) for one in found] for name, found in resting.items()}
    loads = [{**one, "resting": told[one["name"]]} if one["name"] in told else one for one in rig["loads"]]
    return {**rig, "loads": loads}


@dataclass(frozen=True)
class Support(FromJson):
    """A support under a load.

    Attributes:
        name: Its name among the contacts of the recording, `support.<group>.<name>`.
        group: Name of its group.
        load: The load that stands on it.
        capacity: What it may carry [N]; None if not said.
        removed_at: When it is taken away [s]; None if not at a time of its own.
    """

    name: str
    group: str = ""
    load: str = ""
    capacity: float | None = None
    removed_at: float | None = None


@dataclass(frozen=True)
class Watch(FromJson):
    """A pair whose distance is watched.

    Attributes:
        name: Its name among the pairs of the recording.
        between: The two.
        smallest: Distance that they have to keep [m].
        from_step: Step of the plan as which begins it counts; empty for the start.
        to_step: Step of the plan with whose end it ceases to count; empty for the end.
    """

    name: str
    between: Sequence[str] = ("", "")
    smallest: float = 0.0
    from_step: str = ""
    to_step: str = ""

    @property
    def is_whole_lift(self) -> bool:
        """Whether it counts from the start to the end."""
        return not (self.from_step or self.to_step)


@dataclass(frozen=True)
class Tank(FromJson):
    """A tank of something that floats, or of a load.

    Attributes:
        name: Its full name, `<vessel>.<tank>` or `<load>.<tank>`.
        content: Mass of the liquid in it at the start [kg].
        capacity: Mass that goes into it [kg].
        holes: Names of its holes.
    """

    name: str
    content: float = 0.0
    capacity: float = 0.0
    holes: Sequence[str] = ()


@dataclass(frozen=True)
class Step(FromJson):
    """One step of the plan.

    Attributes:
        step: Its name.
        kind: What it does: `hoist`, `hold`, ...
        hold_until: What a hold without a length lasts until: `end` of the run, or a condition is `met`.
        lasts: How long a hold goes on [s]; None where that is not said, and of any other step.
        report: Quantities to be read off at its end.
        require: Limits at its end: `{quantity: {"below": value}}` or `{"above": value}`, SI.
        drives: What it moves.
        tanks: Tanks that it pumps.
        pumps: From where to where it pumps: tanks, or `sea`; nothing of another step.
        rate: How much it pumps in a time [kg/s]; None of another step.
        pumped: How much in all [kg]; None where it ends otherwise.
        cut: Ropes that are cut as it begins.
        detach: Slings and ropes that are taken off then.
        attach: Slings that are put on then.
        remove_supports: Supports, or groups of them, that are taken away then.
        open_hinges: Hinges that open then.
        open_holes: Holes of tanks that open then, as the lift file names them.
        close_holes: The same of those that are closed.
        turns: Whether it waits for, or asks for, a tilt of the load above some angle.
        speed: Of what it moves [m/s], of a boom or crane that it turns [rad/s]; None of a step that moves
            nothing.
        pull_pins: Equalizers or moving sheaves whose locking pins are pulled as it begins.
        put_in_pins: The same of those that are put in.
        keep_plumb: Hooks whose falls it keeps plumb.
        ends_by: Key of the lift file that says when something that moves stops, such as `until` or
            `brake_from`; empty of a hold.
        until: What it waits for, in words, such as `supports clear`; empty of one that waits for nothing.
        seen_by: Variable, its element, and a unit, by which that is seen; nothing where no single one has it.
            `tension_spread` is no variable, and follows from slings; its equalizers have spaces between.
        moves: What it moves, as the lift file names it: hooks, trolleys, cranes, drums, lines.
        by: Way after which that is at rest [m or rad], negative back; None where it ends otherwise.
        to: Position in which it is at rest [m or rad], of hooks a height; None where it ends otherwise.
        way: How far it leads the load along x, y and z of the world [m]; None of another step.
        turn: By how much it turns the load meanwhile [rad].
        travelling: Cranes that travel for that in place of luffing.
        towards: `minus` of what goes to smaller positions until something else ends it.
        compensate_heave: Hooks that it keeps still against heave, as the lift file names them.
        relative_to: Vessel over whose deck it keeps them still; empty over the ground.
    """

    step: str
    kind: str = ""
    hold_until: str = ""
    lasts: float | None = None
    speed: float | None = None
    pull_pins: Sequence[str] = ()
    put_in_pins: Sequence[str] = ()
    report: Sequence[str] = ()
    require: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    drives: Sequence[str] = ()
    tanks: Sequence[str] = ()
    pumps: Sequence[str] = ()
    rate: float | None = None
    pumped: float | None = None
    cut: Sequence[str] = ()
    detach: Sequence[str] = ()
    attach: Sequence[str] = ()
    remove_supports: Sequence[str] = ()
    open_hinges: Sequence[str] = ()
    open_holes: Sequence[str] = ()
    close_holes: Sequence[str] = ()
    turns: bool = False
    keep_plumb: Sequence[str] = ()
    ends_by: str = ""
    until: str = ""
    seen_by: Sequence[str] = ()
    moves: Sequence[str] = ()
    by: float | None = None
    to: float | None = None
    way: Vector | None = None
    turn: float = 0.0
    travelling: Sequence[str] = ()
    towards: str = ""
    compensate_heave: Sequence[str] = ()
    relative_to: str = ""

    @property
    def acts_as(self) -> str:
        """What it does to a load: leading it downwards lowers it, leading it straight up hoists it."""
        if self.way is None or self.way[2] == 0.0:
            return self.kind
        if self.way[2] < 0.0:
            return "lower"
        return self.kind if any(self.way[:2]) or self.turn else "hoist"


@dataclass(frozen=True)
class Rig(FromJson):
    """The lift as results see it.

    Attributes:
        title: Title of the lift.
        number: Number of the lift; None if not said, as the next two.
        revision: Revision of the lift file.
        remark: Remark of its author.
        gravity: Acceleration of gravity [m/s^2].
        loads: What is lifted.
        supports: What the loads stand on, where that is more than the ground.
        watches: Pairs whose distance is watched.
        touching: Pairs that touch each other in the simulation as the lift file says.
        fixtures: Bodies of `mechanics` with a shape that are fixed to the world, a vessel or another hull.
        hooks: Hooks of all cranes.
        sea: Waves on the water; None where it is still.
        wind: Wind with a direction; None where there is none.
        current: Current; None where there is none.
        vessels: Vessels.
        mooring_lines: Mooring lines.
        fenders: Fenders.
        tag_lines: Tag lines of the loads.
        guides: Landing guides of the loads.
        hinges: Hinges and grippers in which loads turn.
        cranes: Goliath cranes, with what is particular to their hooks.
        booms: Booms, with what is particular to their hooks.
        crawlers: Crawler cranes, with what they stand on.
        ranges: How far trolleys, cranes, upper structures and chain hoists may go.
        equalizers: Equalizers of all hooks.
        spreaders: Bars, beams and frames between slings.
        compensators: Gas springs between slings.
        slings: Slings of all hooks.
        chain_hoists: Chain hoists of slings.
        ropes: All ropes: equalizing ropes, slings, mooring lines, tag lines, ropes of `mechanics`.
        sheaves: Sheaves with losses or inertia.
        drums: Drums.
        turning: Joints that turn, whose positions are angles; all others slide. None where nobody says.
        tanks: Tanks of vessels and loads.
        wrapped_sheaves: Sheaves with true tangents.
        limits: Limits of the lift by name, SI; `rule` says from where they come.
        assumed_limits: Those of them that the lift file does not name: going past one is a warning.
        limit_sources: Where each limit comes from.
        level_hooks: Hooks whose levels are compared; all that bear the load if none is named.
        factors: Factors on loads and strengths by name, see `gantline.rule_data.FACTORS`.
        shackle_side_load: Chart of side loads on shackles.
        ratings: Rated capacities of hooks, trolleys and cranes.
        lifting_by_mechanics: Cranes to which ropes and bodies of `mechanics` lead from the load.
        rating_charts: Rating charts of cranes.
        bends: The smallest sheave or drum of each rope.
        equalised_below: Tension spread below which an equalizer has equalised [1].
        plan: Steps of the plan.
        starts_off: Ropes that are not on at the start, since a step puts them on.
    """

    title: str = ""
    number: str | None = ""
    revision: str | None = ""
    remark: str | None = ""
    gravity: float = 9.81
    loads: Sequence[Load] = ()
    supports: Sequence[Support] = ()
    watches: Sequence[Watch] = ()
    touching: Sequence[tuple[str, str]] = ()
    fixtures: Sequence[str] = ()
    hooks: Sequence[Hook] = ()
    sea: Sea | None = None
    wind: Wind | None = None
    current: Current | None = None
    vessels: Sequence[Vessel] = ()
    mooring_lines: Sequence[MooringLine] = ()
    fenders: Sequence[Fender] = ()
    tag_lines: Sequence[TagLine] = ()
    guides: Sequence[Guide] = ()
    hinges: Sequence[Hinge] = ()
    cranes: Sequence[Crane] = ()
    booms: Sequence[Boom] = ()
    crawlers: Sequence[Crawler] = ()
    ranges: Sequence[DriveRange] = ()
    equalizers: Sequence[Equalizer] = ()
    spreaders: Sequence[Spreader] = ()
    compensators: Sequence[Compensator] = ()
    slings: Sequence[Sling] = ()
    chain_hoists: Sequence[ChainHoist] = ()
    ropes: Sequence[Rope] = ()
    sheaves: Sequence[Sheave] = ()
    drums: Sequence[Drum] = ()
    turning: Sequence[str] | None = None
    tanks: Sequence[Tank] = ()
    wrapped_sheaves: Sequence[WrappedSheave] = ()
    limits: Mapping[str, Any] = field(default_factory=dict)
    assumed_limits: Sequence[str] = ()
    limit_sources: Mapping[str, str] = field(default_factory=dict)
    level_hooks: Sequence[str] = ()
    factors: Mapping[str, Factor] = field(default_factory=dict)
    shackle_side_load: SideLoad = field(default_factory=SideLoad)
    ratings: Sequence[Rating] = ()
    lifting_by_mechanics: Sequence[str] = ()
    rating_charts: Sequence[RatingChart] = ()
    bends: Sequence[Bend] = ()
    equalised_below: float = EQUALISED_BELOW
    plan: Sequence[Step] = ()
    starts_off: Sequence[str] = ()

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        parts = {key: _made(form, document[key]) for key, form in _forms().items() if key in document}
        parts["limits"] = document.get("limits") or {}
        parts["shackle_side_load"] = SideLoad.from_json(document.get("shackle_side_load") or {})
        parts["ratings"] = _ratings(document)
        return super().from_json({**document, **parts})

    @property
    def is_lift(self) -> bool:
        """Whether something is lifted or floats: plain mechanics have no weights and no reasons to stop."""
        return bool(self.loads or self.hooks or self.slings or self.vessels)

    @property
    def growing(self) -> dict[str, float]:
        """Waves, gusts and motions of vessels by records, by these words, and how long they grow [s].

        They make one moment unlike the next.
        """
        trains = {"waves": self.sea, "gusts": None if self.wind is None else self.wind.gusts}
        found = {name: one.rise_time for name, one in trains.items() if one is not None}
        of_records = max((vessel.grows_over for vessel in self.vessels), default=0.0)
        return {**found, **({"recorded motions": of_records} if of_records > 0.0 else {})}

    @property
    def is_in_waves(self) -> bool:
        """Whether waves move something: those of the lift file, or those that a record of a vessel holds."""
        return self.sea is not None or any(vessel.grows_over > 0.0 for vessel in self.vessels)

    @property
    def moved_in_still_water(self) -> list[str]:
        """Vessels that move by a record over water that stays still, as no lift file has its waves."""
        return [] if self.sea is not None else [one.name for one in self.vessels if one.grows_over > 0.0]

    @property
    def time_to_average(self) -> float:
        """Time over which what waves, gusts and records do averages [s]; 0 where there are none."""
        return max(self.growing.values(), default=0.0)

    @property
    def carried_hooks(self) -> list[CraneHook]:
        """Hooks that a trolley or a boom takes along."""
        of_trolleys = [hook for crane in self.cranes for _, hook in crane.hooks]
        return of_trolleys + [hook for boom in self.booms for hook in boom.hooks]

    @property
    def seen_by_their_parts(self) -> frozenset[str]:
        """Bodies of cranes with a boom: where such a crane slews, its frame is at the stern of its vessel.

        All that there is to see of it is of other bodies then, and a mark for it would be of nothing.
        """
        return frozenset(boom.name for boom in self.booms)

    @property
    def fixed_hooks(self) -> list[Hook]:
        """Hooks without a crane behind them."""
        others = {crane.name for crane in self.cranes} | {boom.name for boom in self.booms}
        return [hook for hook in self.hooks if hook.crane not in others]

    def rope(self, name: str) -> Rope | None:
        """The rope of that name, if something is known of it."""
        return next((one for one in self.ropes if one.name == name), None)

    def hook_of(self, sling: Sling) -> str:
        """Name of the hook from which a sling hangs, by an equalizer or by itself; of other gear its own."""
        equalizer = self.equalizer_of(sling)
        return equalizer.hook if equalizer is not None else sling.from_body

    def load(self, name: str | None) -> Load | None:
        """The load of that name, if there is one."""
        return next((load for load in self.loads if load.name == name), None)

    def with_lugs(self, name: str | None) -> Load | Spreader | None:
        """The load or spreader of that name, if there is one."""
        return self.load(name) or next((one for one in self.spreaders if one.name == name), None)

    def minimum_breaking_force(self, rope: str) -> float | None:
        """Minimum breaking force of the rope of that name [N]; None if it is not known."""
        one = self.rope(rope)
        return one.minimum_breaking_force if one is not None else None

    @property
    def outer_ropes(self) -> tuple[str, ...]:
        """Ropes that go far beyond what is lifted: mooring and tag lines."""
        return (*(line.rope for line in self.mooring_lines), *(line.rope for line in self.tag_lines))

    def gear_above(self, sling: Sling) -> Spreader | Compensator | None:
        """The spreader or compensator from which a sling hangs, if any."""
        bodies: list[tuple[str, Spreader | Compensator]] = [(one.body, one) for one in self.spreaders]
        bodies += [(one.rod, one) for one in self.compensators]
        return next((one for body, one in bodies if body == sling.from_body), None)

    def equalizer_of(self, sling: Sling) -> Equalizer | None:
        """The equalizer from which a sling hangs, if any."""
        return next((e for e in self.equalizers if sling.rope in e.slings), None)


def at_rest(rig: Mapping[str, Any]) -> dict[str, Any]:
    """The JSON of the same lift in still water and steady wind, which is what statics knows of it."""
    found = {key: value for key, value in rig.items() if key != "sea"}
    if wind := rig.get("wind"):
        steady = ("speed", "direction", "profile")
        found["wind"] = {key: value for key, value in wind.items() if key in steady}
    return found


@cache
def _forms() -> dict[str, Any]:
    """Types of the fields of a rig, by name."""
    return get_type_hints(Rig)


def _made(form: Any, given: Any) -> Any:
    """What a field of that type holds, from its JSON: a class, or None, or a list or mapping of a class."""
    kind = next((one for one in get_args(form) if hasattr(one, "from_json")), None)
    if kind is None:
        return given
    if get_origin(form) is Sequence:
        return tuple(kind.from_json(one) for one in given or ())
    if get_origin(form) is Mapping:
        return {name: kind.from_json(one) for name, one in (given or {}).items()}
    return kind.from_json(given) if given else None


def _ratings(document: Mapping[str, Any]) -> tuple[Rating, ...]:
    """Rated capacities; in recordings that have none of their own those of the hooks."""
    if "ratings" in document:
        return tuple(Rating.from_json(d) for d in document["ratings"])
    return tuple(
        Rating(hook.name, "hook", (hook.name,), hook.rated_capacity, hook.rating_includes_hook_block)
        for hook in (Hook.from_json(d) for d in document.get("hooks") or ())
    )
