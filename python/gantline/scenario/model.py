"""The whole lift file as one model."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, PrivateAttr

from gantline.hydro.wind import WindProfile
from gantline.scenario.afloat.mooring import Fender, MooringLine, is_moored, lines_at
from gantline.scenario.afloat.stream import Current, Wind, WindOfLift
from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.afloat.water import Water
from gantline.scenario.afloat.waves import WaveTrain
from gantline.scenario.base import Element, Named, Types
from gantline.scenario.cranes.boom import PlacedBoom
from gantline.scenario.cranes.compensator import Compensator
from gantline.scenario.cranes.crane import Equalizer, EqualizerType
from gantline.scenario.cranes.crane_types import Crane
from gantline.scenario.cranes.hook_group import HookGroup
from gantline.scenario.cranes.hook_parts import HookType
from gantline.scenario.cranes.hooks import Hook, booms_of, hooks_of
from gantline.scenario.errors import PathPart, Problem, ScenarioError, StartError
from gantline.scenario.extension import ExtensionSheave
from gantline.scenario.file.case import Case
from gantline.scenario.file.tree import MapNode, problem_at
from gantline.scenario.gear import RopeMaterial, Shackle, Sling, SlingDefaults
from gantline.scenario.ground import Axes, Ground, LiftHead, SimulationSettings
from gantline.scenario.limits import Limits, Rules
from gantline.scenario.loads.guide import LandingGuide
from gantline.scenario.loads.hinge import LoadHinge
from gantline.scenario.loads.load import Load
from gantline.scenario.loads.lug import LugType
from gantline.scenario.loads.spreader import Spreader
from gantline.scenario.loads.structures import Structure
from gantline.scenario.loads.supports import Supports
from gantline.scenario.mechanics import Mechanics
from gantline.scenario.plan.plan import EmergencyStop, Step
from gantline.scenario.plan.times import usual_sample_interval
from gantline.scenario.quantities import FilesReader, PositiveTime, Reader, found, refuse
from gantline.scenario.tag_line import TagLine
from gantline.scenario.watch import Watch

__all__ = ["Scenario"]


class _FormatReader(Reader):
    """Reads ``format: 1``."""

    def read(self, value: object) -> int:
        """The format, which is 1."""
        if value != "1":
            raise refuse(f"found format {found(value)}; this version reads 'format: 1'")
        return 1

    def shown(self) -> dict[str, Any]:
        """The number, or the same as text."""
        return {"enum": [1, "1"]}


class Scenario(Element):
    """A lift file: every quantity a float in SI units, names as written. Made by `load_scenario`."""

    what: ClassVar[str] = "a lift file"

    format: Annotated[int, _FormatReader()] = Field(description="Format of the file: 1.")
    library: Annotated[tuple[str, ...], FilesReader()] = Field(
        (), description="Files beside the lift file with types, ropes and shackles; one, or a list."
    )
    lift: LiftHead = Field(description="What the lift is called.")
    duration: PositiveTime = Field(description="Time to simulate.")
    start: Literal["rest", "settled", "as_given"] | None = Field(
        None,
        description="'rest': everything in equilibrium, found from the positions given, friction held; "
        "'settled': the load has settled on the ground, all else is as given; 'as_given': from the "
        "positions given. If not given: 'rest' for a lift with a 'load' or 'vessels', else 'as_given'.",
    )
    axes: Axes | None = Field(None, description="Where the axes point, for people.")
    wind: WindOfLift | None = Field(
        None,
        description="Wind at the height of girder and areas, held against the wind limit of cranes: a speed, "
        "which pushes nothing, or speed and direction, which push on 'wind_areas'.",
    )
    current: Current | None = Field(
        None, description="Current; it pushes on 'current_areas'. None if not given."
    )
    waves: Named[WaveTrain] | None = Field(
        None, description="Waves that run over the water, by name; they act on vessels with 'wave_forces'."
    )
    ground: Ground | None = Field(None, description="Level ground; none if not given.")
    water: Water | None = Field(None, description="Water around hulls; sea water up to 0 if not given.")
    vessel_types: Types | None = Field(
        None, description="What several vessels have in common, in their keys, by name of the type."
    )
    vessels: Named[Vessel] | None = Field(None, description="Vessels by name.")
    ropes: Named[RopeMaterial] | None = Field(None, description="Kinds of rope by name.")
    shackles: Named[Shackle] | None = Field(None, description="Kinds of shackle by name.")
    lug_types: Named[LugType] | None = Field(None, description="Types of lug by name.")
    load: Load | None = Field(None, description="The load.")
    hook_types: Named[HookType] | None = Field(
        None, description="Types of hook of trolleys and booms, by name."
    )
    crane_types: Types | None = Field(
        None, description="What several cranes have in common, in their keys, by name of the type."
    )
    cranes: Named[Crane] | None = Field(None, description="Cranes by name.")
    supports: Named[Supports] | None = Field(None, description="Groups of supports under the load by name.")
    structures: Named[Structure] | None = Field(None, description="What stands in the yard, by name.")
    hook_groups: Named[HookGroup] | None = Field(
        None, description="Hooks that share a trolley or a crane, by name."
    )
    equalizer_types: Named[EqualizerType] | None = Field(None, description="Types of equalizer by name.")
    equalizers: Named[Equalizer] | None = Field(None, description="Equalizers by name.")
    sling_defaults: SlingDefaults | None = Field(
        None, description="What slings have unless they say otherwise."
    )
    slings: Named[Sling] | None = Field(None, description="Slings by name.")
    extension_sheaves: Named[ExtensionSheave] | None = Field(
        None, description="Sheaves that hang on slings and serve two lugs each, by name."
    )
    spreader_types: Types | None = Field(
        None, description="What several spreaders have in common, in their keys, by name of the type."
    )
    spreaders: Named[Spreader] | None = Field(
        None, description="Bars, beams and frames between slings, by name."
    )
    compensator_types: Types | None = Field(
        None, description="What several compensators have in common, in their keys, by name of the type."
    )
    compensators: Named[Compensator] | None = Field(None, description="Gas springs between slings, by name.")
    tag_lines: Named[TagLine] | None = Field(
        None, description="Thin ropes that keep the heading of the load, by name."
    )
    guide_types: Types | None = Field(
        None, description="What several guides have in common, in their keys, by name of the type."
    )
    guides: Named[LandingGuide] | None = Field(
        None, description="Posts and walls that bring the load to its place as it lands, by name."
    )
    hinges: Named[LoadHinge] | None = Field(
        None, description="Hinge frames, foot pins and grippers in which the load turns, by name."
    )
    mooring_line_types: Types | None = Field(
        None, description="What several mooring lines have in common, in their keys, by name of the type."
    )
    mooring_lines: Named[MooringLine] | None = Field(None, description="Lines that hold vessels, by name.")
    fender_types: Types | None = Field(
        None, description="What several fenders have in common, in their keys, by name of the type."
    )
    fenders: Named[Fender] | None = Field(
        None, description="Fenders between vessels and quays or other vessels, by name."
    )
    plan: list[Step] = Field(default_factory=list, description="Steps of the lift, one after the other.")
    emergency_stop: EmergencyStop | None = Field(
        None, description="Stops all that the plan moves, and the plan."
    )
    watch: list[Watch] = Field(
        default_factory=list, description="Pairs whose smallest distance is recorded and watched."
    )
    cases: Named[Case] | None = Field(None, description="What may be otherwise than planned, by name.")
    limits: Limits | None = Field(None, description="Limits that the lift is checked against.")
    rules: Rules | None = Field(None, description="Factors on loads and strengths for the checks.")
    simulation: SimulationSettings = Field(SimulationSettings(), description="How the lift is simulated.")
    mechanics: Mechanics | None = Field(None, description="Plain bodies, joints, sheaves and ropes.")

    _text: str = PrivateAttr("")
    _source: str = PrivateAttr("")
    _tree: MapNode = PrivateAttr(default_factory=MapNode)
    _tree_as_written: MapNode = PrivateAttr(default_factory=MapNode)
    _centre_moved: tuple[float, float, float] = PrivateAttr((0.0, 0.0, 0.0))
    _is_let_go: bool = PrivateAttr(False)

    def telling(self, more: str) -> Scenario:
        """The same scenario, with lines that say more below its text."""
        self._text = f"{self._text.rstrip()}\n{more}"
        return self

    @property
    def text(self) -> str:
        """The lift file as it was read; below it, as comments, the libraries that it names."""
        beside = self._tree_as_written.beside
        return f"{self._text.rstrip()}\n{beside}" if beside else self._text

    @property
    def file_text(self) -> str:
        """The lift file as it was read, by itself."""
        return self._text

    @property
    def source(self) -> str:
        """The lift file as the user named it."""
        return self._source

    @property
    def tree(self) -> MapNode:
        """The lift file as a tree of texts with lines; what types give is in the things that have them."""
        return self._tree

    @property
    def tree_as_written(self) -> MapNode:
        """The same, in which it is in the types alone."""
        return self._tree_as_written

    @property
    def centre_moved(self) -> tuple[float, float, float]:
        """How far the load's centre of gravity is from that of the file, in a case or other change (3,) [m].

        Points of `mechanics` on the load count from the centre of gravity, and stay on the load where they
        are; so they count from where the file has it.
        """
        return self._centre_moved

    def counted_from(self, before: Scenario) -> Scenario:
        """The same scenario, knowing the one that was changed into it."""
        old, new = (None if one.load is None else one.load.centre_of_gravity.at for one in (before, self))
        moved = before.centre_moved
        if isinstance(old, tuple) and isinstance(new, tuple):
            ways = zip(moved, new, old, strict=True)
            along, across, up = (way + after - at for way, after, at in ways)
            moved = along, across, up
        self._centre_moved = moved
        self._is_let_go = before._is_let_go
        return self

    def let_go_of(self, before: Scenario) -> Scenario:
        """The same scenario, which starts as given for no more than that its ropes may pull.

        Made of one that starts at rest it is pushed at rest by what that one is pushed by.
        """
        self._is_let_go = before._is_let_go or before.starts_at_rest
        return self

    def read_from(self, source: str, text: str, tree: MapNode, tree_as_written: MapNode) -> Scenario:
        """The same scenario, knowing the file it came from; messages about it then have lines."""
        self._source, self._text, self._tree, self._tree_as_written = source, text, tree, tree_as_written
        return self

    def changed(self, values: Mapping[str, Any]) -> Scenario:
        """The same lift with other values, without its cases.

        Args:
            values: Each at its dotted path, written as in a lift file: `{"load.weight.calculated": "320 t"}`.
                A number stands where a lift file has one without a unit; lists and mappings are of such.
                Places in lists count from 1, as in messages: `plan[2].speed`, or `load.lugs.L1.at.z`.
                What holds a value and is not in the file is given whole: `{"wind": {"speed": "8 m/s", ...}}`.

        Raises:
            ScenarioError: If a path leads nowhere, or a value cannot be there.
            TypeError: If the values are no mapping.
        """
        from gantline.scenario.file.variants import changed

        return changed(self, values)

    def problem(self, path: tuple[PathPart, ...], sentence: str) -> Problem:
        """A problem at a path of this file, with its line."""
        return problem_at(self._tree, path, sentence)

    def error(self, path: tuple[PathPart, ...], sentence: str) -> ScenarioError:
        """An error with one problem at a path of this file."""
        return ScenarioError(self._source, [self.problem(path, sentence)])

    def start_error(self, path: tuple[PathPart, ...], sentence: str) -> StartError:
        """The same of a start that cannot be put together, by a file that is right as such."""
        return StartError(self._source, [self.problem(path, sentence)])

    def __repr__(self) -> str:
        """Title and file; its parts have all that they are made of."""
        return f"<Scenario {self.lift.title!r}: {self.source}, {self.duration:g} s>"

    __str__ = __repr__

    def _repr_html_(self) -> str:
        """For notebooks: what the lift file describes."""
        from gantline.html import facts_table
        from gantline.units import format_quantity

        head = self.lift
        rows = [("lift file", str(self.source)), ("duration", format_quantity(self.duration, "s", 0))]
        if head.number:
            rows.insert(0, ("number", f"{head.number} rev {head.revision}" if head.revision else head.number))
        if self.load is not None:
            rows.append((f"load {self.load.name}", format_quantity(self.load.weight.simulated, "t", 1)))
        groups = {
            "cranes": self.cranes,
            "hooks": self.hooks,
            "equalizers": self.equalizers,
            "slings": self.slings,
            "spreaders": self.spreaders,
            "compensators": self.compensators,
            "cases": self.cases,
        }
        rows += [(what, f"{len(names)}: {', '.join(names)}") for what, names in groups.items() if names]
        rows += [(f"step {number}", step.step) for number, step in enumerate(self.plan, 1)]
        return facts_table(head.title, rows)

    @cached_property
    def hooks(self) -> dict[str, Hook]:
        """Hooks of all cranes by their full names."""
        return hooks_of(self.cranes or {}, self.hook_types or {})

    @property
    def wind_profile(self) -> WindProfile | None:
        """How the wind grows above the lower of ground and water; None where it does not."""
        if not isinstance(self.wind, Wind) or self.wind.profile is None:
            return None
        levels = [one.level for one in (self.ground, self.water) if one is not None]
        return self.wind.profile.above(min(levels, default=0.0))

    def wind_share(self, z: float) -> float:
        """Mean wind at a height z of the world [m] over its speed in the lift file."""
        return 1.0 if self.wind_profile is None else float(self.wind_profile.share(z))

    @property
    def left_out_at_rest(self) -> list[str]:
        """Sentences on what an equilibrium leaves out: waves, gusts and holes; none where it has none."""
        from gantline.scenario.afloat.tanks import holed_tanks

        gusts = isinstance(self.wind, Wind) and self.wind.gusts is not None
        waves = f"the waves {', '.join(self.waves or {})}"
        pushed = any(self.has_mean_drift(name) for name in self.vessels or {})
        without = f"{waves}, but with their mean drift forces if there are any" if pushed else waves
        holed = list(holed_tanks(self))
        return [
            *([f"Still water: without {without}"] if self.waves else []),
            *(["Steady wind: without its gusts"] if gusts else []),
            *([f"{', '.join(holed)} as at the start: nothing runs through holes"] if holed else []),
        ]

    def has_mean_drift(self, vessel: str) -> bool:
        """Whether mean drift forces of waves, if there are any, push a vessel from the start, and at rest.

        They do where mooring lines hold it, and it starts in equilibrium, or is a case of a lift that does.
        On a single one it would swing round to leeward first.
        """
        forces = (self.vessels or {})[vessel].wave_forces
        is_held = len(lines_at(self, vessel)) > 1 and is_moored(self, vessel)
        is_still = self.starts_at_rest or self._is_let_go
        return is_held and is_still and forces is not None and forces.drift is not False

    @cached_property
    def booms(self) -> dict[str, PlacedBoom]:
        """Booms of all cranes that have one, by the name of the crane."""
        return booms_of(self.cranes or {}, self.vessels or {})

    @property
    def starts(self) -> str:
        """The word of `start` that holds, also where none is written."""
        has_rest = self.load is not None or self.vessels is not None
        return self.start or ("rest" if has_rest else "as_given")

    @property
    def starts_at_rest(self) -> bool:
        """Whether everything is in equilibrium before the lift begins."""
        return self.starts == "rest"

    @property
    def sample_interval(self) -> float:
        """Time between recorded samples [s]."""
        return self.simulation.sample_interval or usual_sample_interval(self.duration)

    def moves_sheaves(self, equalizer: str) -> bool:
        """Whether sheaves of an equalizer move; of an approximated one slings hang from its frame."""
        given = (self.equalizers or {})[equalizer]
        kind = (self.equalizer_types or {}).get(given.type or "")
        return (given.mechanism or (kind and kind.mechanism)) != "approximated"

    @property
    def load_has_settled(self) -> bool:
        """Whether the load has settled on the ground before the lift begins."""
        stands = self.load is not None and self.load.stands_on is not None
        return stands and self.start != "as_given"
