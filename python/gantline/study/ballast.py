"""Contents of tanks with which a vessel floats as wanted at a moment of the plan, with least water moved.

The equilibrium with everything that hangs on the vessel is found anew in each round. The sensitivities of its
factorised tangent say how heel, trim and draft answer to a kilogram in each tank, and a linear programme
finds the contents that do it with the least sum of changes (`docs/concepts/ballast.md`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.arguments import number, told
from gantline.assembly.afloat.hulls import afloat_path
from gantline.hydro.tank import Tank, free_surface_correction
from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.scenario.afloat.tanks import bodies_afloat, pumped_at_most
from gantline.scenario.afloat.water import BallastTank
from gantline.scenario.errors import PathPart
from gantline.scenario.file.edit import text_with
from gantline.scenario.file.library import with_libraries
from gantline.scenario.file.tree import MapNode, parse_text, problem_at, written_at
from gantline.scenario.file.types import filled_in
from gantline.scenario.file.variants import with_values, without_cases
from gantline.scenario.plan.steps import PumpStep
from gantline.statics import Equilibrium, Losses, NoEquilibriumError, Statics
from gantline.study.afloat import Afloat, VesselAttitude
from gantline.study.ballast_question import (
    QuestionError,
    moment_of,
    refuse_draft,
    tanks_that_may_change,
    vessel_of,
)
from gantline.study.newton import CannotBeError
from gantline.units import format_quantity, si_text

__all__ = ["BallastAnswer", "solve_ballast"]

Floats = npt.NDArray[np.float64]

#: What may be left of heel and trim [rad] and of draft [m].
_LEFT = 1e-7
_DRAFT_LEFT = 1e-6
#: The same where the moment moves with the contents: equilibria find the end of a step that waits for
#: something at looks some hundredths of a second apart, from one to the next of which a hoist goes on.
_LEFT_BY_LOOKS = 1e-5
_DRAFT_LEFT_BY_LOOKS = 1e-4
#: Rounds, at most.
_ROUNDS = 30
#: A step is halved this often before it is given up.
_HALVINGS = 8
#: Rounds in which any tank may take the place of another. Where several ways move nearly as little water,
#: what answers do not say to first order makes now one and now another of them the least, without an end.
_FREE_ROUNDS = 6
#: A tank is changed from so much on, of its capacity.
_CHANGED = 1e-9
#: A metre of draft counts like so many radians where not all of what is wanted can be had [1/m].
_DRAFT_COUNTS = 0.1
#: Parts of an attitude with the units in which people read them.
_SHOWN = {"heel": "deg", "trim": "deg", "draft": "m"}
#: A tank may be over its ends by rounding, a share of its capacity.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class BallastAnswer:
    """Contents of tanks with which a vessel floats as wanted.

    Attributes:
        vessel: Its name.
        time: The moment [s]; of a step its end with the contents found.
        time_given: The same with the contents that the lift file gives.
        given: Content of each tank at the start in the lift file [kg].
        contents: The same as found [kg].
        contents_then: What is in the tanks at the moment, with what the plan has pumped until then [kg].
        moved: Sum of the changes' sizes [kg].
        attitude_given: At the moment with the contents that the lift file gives.
        attitude: At the moment with those found.
        attitude_before: At the start of the lift with those found.
        displacement: Mass of the water displaced at the moment [kg].
        gm: How the vessel with all that hangs on it resists heel and trim then, as metacentric heights [m].
        free_surface: What the free surfaces of its tanks take from them [m].
        after: The equilibrium at the moment.
        rounds: Rounds of the search.
        scenario: The lift file with the contents found.
    """

    vessel: str
    time: float
    time_given: float
    given: Mapping[str, float]
    contents: Mapping[str, float]
    contents_then: Mapping[str, float]
    moved: float
    attitude_given: VesselAttitude
    attitude: VesselAttitude
    attitude_before: VesselAttitude
    displacement: float
    gm: tuple[float, float]
    free_surface: tuple[float, float]
    after: Equilibrium
    rounds: int
    scenario: Scenario

    @property
    def sea_water(self) -> float:
        """What comes from the sea, all in all [kg]; negative where it goes there."""
        return math.fsum(self.contents[tank] - self.given[tank] for tank in self.contents)

    @property
    def text(self) -> str:
        """The lift file with the contents found; what did not change stays as it was written.

        Raises:
            ScenarioError: If contents are those of a type that other vessels have, too.
        """
        text, source = self.scenario.file_text, self.scenario.source
        tree = filled_in(with_libraries(parse_text(text, source), source))
        room = _room(self.scenario, self.vessel)
        changed: dict[tuple[PathPart, ...], str] = {}
        for tank, content in self.contents.items():
            if content != self.given[tank]:
                changed[self._written_at(tree, tank)] = _written(content, *room[tank])
        return text_with(text, changed)

    def _written_at(self, tree: MapNode, tank: str) -> tuple[PathPart, ...]:
        """Where the content of a tank stands; a type may not give it to other vessels, too."""
        known = self.scenario.vessels or {}
        paths = {
            name: (*afloat_path(self.scenario, name), "tanks", tank, "content")
            for name in (self.vessel, *known)
        }
        written = {name: written_at(tree, path) for name, path in paths.items()}
        here = problem_at(tree, paths[self.vessel], "")
        is_shared = [*written.values()].count(written[self.vessel]) > 1
        if is_shared or here.file is not None:
            whose = "of other vessels of this type, too" if is_shared else "of a library"
            sentence = f"is the content {whose}; give '{self.vessel}' its own, for '--write' to change"
            raise ScenarioError(self.scenario.source, [replace(here, sentence=sentence)])
        return written[self.vessel]

    def to_json(self) -> dict[str, object]:
        """All of it as a JSON object, SI units."""
        return {
            "vessel": self.vessel,
            "time": self.time,
            "time_given": self.time_given,
            "given": dict(self.given),
            "contents": dict(self.contents),
            "contents_then": dict(self.contents_then),
            "moved": self.moved,
            "sea_water": self.sea_water,
            "attitude_given": vars(self.attitude_given),
            "attitude": vars(self.attitude),
            "attitude_before": vars(self.attitude_before),
            "displacement": self.displacement,
            "gm": list(self.gm),
            "free_surface": list(self.free_surface),
        }


def solve_ballast(
    lift: str | Path | Scenario,
    *,
    vessel: str | None = None,
    time: float | None = None,
    step: str | None = None,
    heel: float = 0.0,
    trim: float = 0.0,
    draft: float | None = None,
    tanks: Sequence[str] | None = None,
    on_progress: Callable[[str], None] | None = None,
) -> BallastAnswer:
    """Contents of tanks with which a vessel floats as wanted, with the least water moved.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        vessel: The vessel; may be left out where only one has tanks.
        time: Time of the plan [s]; None for the end of the lift.
        step: In place of a time a step of the plan, at its end.
        heel: Wanted heel, to starboard positive [rad].
        trim: Wanted trim, by the stern positive [rad].
        draft: Wanted draft at half length [m]; None for any.
        tanks: Tanks whose contents may change; all of the vessel if not given.
        on_progress: Is told in words what is looked for next, before each equilibrium.

    Raises:
        CannotBeError: If it cannot be had, or the vessel would not be stable so, with the reason.
        NoEquilibriumError: If the lift as it is given has no equilibrium.
        ScenarioError: If the lift file is not right.
        QuestionError: If a vessel, a step or a tank is asked for that there is not, an angle is none, or a
            draft is not that of a vessel whose deck is dry; a ValueError that says which argument that is.
        ValueError: If no vessel of the lift has tanks.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    for argument, angle in (("heel", heel), ("trim", trim)):
        if abs(number(angle, argument, "radians")) >= math.pi / 4:
            raise QuestionError(
                argument, f"{math.degrees(angle):g} deg is too steep; less than 45 deg is right"
            )
    name = vessel_of(scenario, vessel)
    chosen = tanks_that_may_change(scenario, name, tanks)
    if draft is not None:
        number(draft, "draft", "metres")
        refuse_draft(scenario, name, draft)
    tell = told(on_progress) or (lambda _: None)
    wanted = {"heel": heel, "trim": trim} | ({} if draft is None else {"draft": draft})

    def moment(question: Statics) -> float:
        return moment_of(question, time, step)

    search = _Search(scenario, name, chosen, moment, wanted, tell)
    if draft is not None:
        search.refuse_mass(VesselAttitude(heel, trim, draft))
    first = search.now
    rounds = search.run()
    return search.answer(first, rounds)


class _Search:
    """Rounds of equilibrium and linear programme.

    The moment is asked of the lift with each try of contents: a step that ends on a condition, or comes after
    one that does, ends at another time where the vessel lies otherwise.
    """

    def __init__(
        self,
        scenario: Scenario,
        vessel: str,
        tanks: Sequence[str],
        moment: Callable[[Statics], float],
        wanted: Mapping[str, float],
        tell: Callable[[str], None],
    ) -> None:
        self._scenario, self._vessel, self._tell = scenario, vessel, tell
        self._moment, self._wanted = moment, wanted
        self._tanks = list(tanks)
        self._all = _tanks(scenario, vessel)
        given = [self._all[tank].content for tank in self._tanks]
        self._given: Floats = np.array(given)
        self._contents = self._given
        self._capacity: Floats = np.array([self._all[tank].capacity for tank in self._tanks])
        room = _room(scenario, vessel)
        self._room: Floats = np.array([room[tank] for tank in self._tanks]).T
        self._acts_against = any(isinstance(step, PumpStep) and step.until for step in scenario.plan)
        question = Statics(scenario)
        self._time = self._begun = moment(question)
        tell(f"how {vessel} floats at {self._time:g} s with the contents given")
        self.now = Afloat(question, vessel, self._time)
        self._losses: Losses = "none"
        if self.now.bears_loads():  # free to slide, a load goes down the least heel until its slings hold it
            question = Statics(scenario)
            self._time = self._begun = moment(question)
            self._losses = "held"
            self.now = Afloat(question, vessel, self._time, self._losses)

    def refuse_mass(self, wanted: VesselAttitude) -> None:
        """Refuse a draft for which there is not enough room in the tanks, or not enough water.

        Raises:
            CannotBeError: If it is one.
        """
        more = self.now.displacement_at(wanted) - self.now.displacement()
        # What something else bears too, such as a quay or a crane ashore, may come to hang on the vessel or
        # leave it; moorings only resist.
        margin = self.now.mass_of_loads()
        empty, full = ((end - self._given).sum() for end in self._room)
        if empty - margin <= more <= full + margin:
            return
        room = "have room for" if more > 0.0 else "can give"
        sentence = (
            f"a draft of {wanted.draft:g} m takes {_tonnes(more)} {'more' if more > 0.0 else 'less'} in"
        )
        sentence += f" the tanks, and they {room} {_tonnes(full if more > 0.0 else empty)}"
        now = format_quantity(self.now.attitude.draft, "m", 3)
        raise CannotBeError(f"the tanks cannot do it: {sentence} (the draft is {now} now)")

    def run(self) -> int:
        """Find contents with which the vessel floats as wanted; returns the rounds that it took.

        Raises:
            CannotBeError: If no contents do it.
        """
        reached = True
        for found in range(_ROUNDS):
            missing = self._missing(self.now)
            left = (
                (_LEFT, _DRAFT_LEFT) if self._time == self._begun else (_LEFT_BY_LOOKS, _DRAFT_LEFT_BY_LOOKS)
            )
            if all(abs(more) <= left[key == "draft"] for key, more in missing.items()):
                self._refuse_unsound()
                return found
            free = np.full(len(self._tanks), True)
            if found >= _FREE_ROUNDS:
                free = np.abs(self._contents - self._given) > _CHANGED * self._capacity
            target, reached = self._programme(missing, free)
            if not reached and not free.all():
                target, reached = self._programme(missing, np.full(len(self._tanks), True))
            if not reached and float(np.abs(target - self._contents).max()) <= 1.0:
                raise CannotBeError(f"the tanks cannot do it; {self._short_of()}")
            self._step(target, found + 1)
        # Nearest contents may go on to others that are hardly nearer for as long as one looks.
        why = f"no answer in {_ROUNDS} rounds" if reached else "the tanks cannot do it"
        raise CannotBeError(f"{why}; {self._short_of()}")

    def _missing(self, one: Afloat) -> dict[str, float]:
        return {key: value - float(getattr(one.attitude, key)) for key, value in self._wanted.items()}

    def _off(self, one: Afloat) -> float:
        """How far it is from what is wanted, as the linear programme counts [rad]."""
        counts = {"draft": _DRAFT_COUNTS}
        return math.fsum(abs(more) * counts.get(key, 1.0) for key, more in self._missing(one).items())

    def _programme(self, missing: Mapping[str, float], free: npt.NDArray[np.bool_]) -> tuple[Floats, bool]:
        """Contents that do it to first order with the least sum of changes, in tanks that are free to change.

        Those that come nearest, and False, where none do.
        """
        from scipy.optimize import linprog  # takes half a second to load

        slopes = self.now.slopes()
        places = np.array([self._place(tank) - self.now.centre for tank in self._tanks])
        slope = np.array([slopes[key][0] + places @ slopes[key][1:] for key in missing])
        scale = np.array([_DRAFT_COUNTS if key == "draft" else 1.0 for key in missing])
        slope = slope * scale[:, None]
        right = scale * np.array(list(missing.values())) + slope @ (self._contents - self._given)
        capacity = self._capacity
        least, most = np.where(free, self._room - self._given, 0.0)
        # Changes as more and less, in parts of the largest tank and of what a full one does.
        unit, effect = float(capacity.max()), float(np.abs(slope).max() * capacity.max()) or 1.0
        both = np.hstack([slope, -slope]) * (unit / effect)
        ends = [(0.0, max(0.0, end) / unit) for end in (*most, *-least)]
        changes = len(ends)
        found = linprog(np.ones(changes), A_eq=both, b_eq=right / effect, bounds=ends)
        reached = bool(found.success)
        if not reached:
            rest = np.eye(len(right))
            cost = np.concatenate([np.zeros(changes), np.ones(2 * len(right))])
            within = [*ends, *[(0.0, None)] * (2 * len(right))]
            equations = np.hstack([both, rest, -rest])
            found = linprog(cost, A_eq=equations, b_eq=right / effect, bounds=within)
            if not found.success:
                raise CannotBeError(f"the linear programme has no answer ({found.message})")
        more, less = np.split(np.asarray(found.x)[:changes], 2)
        target: Floats = np.clip(self._given + (more - less) * unit, *self._room)
        return target, reached

    def _place(self, tank: str) -> Floats:
        """Where the next drop in a tank goes, in the vessel's axes [m]."""
        one, (x, y, z) = self._all[tank], self._all[tank].bottom
        return np.array([x, y, z + one.box[2] * self.now.content(tank) / one.capacity])

    def _step(self, target: Floats, number: int) -> None:
        """To these contents, or as far towards them as the vessel floats and comes nearer to what is wanted.

        A load that still stands in part holds the vessel by its ropes in an answer to first order, and does
        not where the step waits for its share: all of such a step goes too far. Where no part of it betters
        things it is made as far as the vessel floats, which may lead past where the programme changes tanks.
        """
        lies = "; ".join(f"{key} {_shown(key, getattr(self.now.attitude, key))}" for key in _SHOWN)
        cause, off = "", self._off(self.now)
        floats: tuple[float, Afloat, Floats] | None = None
        for halving in range(_HALVINGS):
            contents = self._contents + (target - self._contents) * 0.5**halving
            nearer = f", {0.5**halving:.3g} of the way" if halving else ""
            moved = _tonnes(float(np.abs(contents - self._given).sum()))
            self._tell(f"round {number}: {lies}; tries {moved} moved{nearer}")
            try:
                changed = Statics(self._with(contents))
                time = self._moment(changed)
                tried = Afloat(changed, self._vessel, time, self._losses)
            except NoEquilibriumError as problem:
                cause = f"{problem.cause} ({problem.element})"
                continue
            except ScenarioError as problem:
                cause = problem.problems[0].sentence
                continue
            except ValueError as problem:
                cause = str(problem)
                continue
            # One that has sunk or lies on its side is at rest too, and leads nowhere.
            if not tried.keel < tried.attitude.draft < tried.deck:
                cause = f"{self._vessel} would not float with its deck dry"
                continue
            floats = floats or (time, tried, contents)
            if self._off(tried) < off:
                floats = (time, tried, contents)
                break
        if floats is None:
            raise CannotBeError(f"with such contents {cause}")
        self._time, self.now, self._contents = floats

    def _with(self, contents: Floats) -> Scenario:
        where = ".".join(afloat_path(self._scenario, self._vessel))
        texts = {
            f"{where}.tanks.{tank}.content": si_text(float(content), "mass")
            for tank, content in zip(self._tanks, contents, strict=True)
        }
        return with_values(self._scenario, texts)

    def _short_of(self) -> str:
        """What the tanks come to, and by how much that misses what is wanted."""
        parts = [
            f"{key} {_shown(key, getattr(self.now.attitude, key))}, {_shown(key, abs(more))} off"
            for key, more in self._missing(self.now).items()
        ]
        because = "; the plan itself pumps until a condition holds" if self._acts_against else ""
        return f"the nearest that was found is {'; '.join(parts)}{because}"

    def _refuse_unsound(self) -> None:
        """Contents with which the vessel, or what hangs on it, would not stay so."""
        heights = self.now.metacentric_heights()
        taken = self._free_surface()
        for height, effect, way in zip(heights, taken, ("heel", "trim"), strict=True):
            if height <= 0.0:
                sentence = f"with these contents GM for {way} is {height:.2f} m, so that it would capsize"
                raise CannotBeError(f"{sentence}; free surfaces of its tanks take {effect:.2f} m of it")
        if not self.now.rest.is_stable:
            raise CannotBeError("with these contents it floats as wanted, but it is unstable")

    def _free_surface(self) -> tuple[float, float]:
        slack = [
            Tank(tank.box[0], tank.box[1], tank.density)
            for name, tank in self._all.items()
            if _ROUNDING < self.now.content(name) / tank.capacity < 1.0 - _ROUNDING
        ]
        return free_surface_correction(slack, self.now.displacement())

    def _at_start(self, scenario: Scenario) -> Afloat:
        """How the vessel lies before the lift, with a load that stands aboard then held by its friction."""
        start = Afloat(Statics(scenario), self._vessel, 0.0)
        return Afloat(Statics(scenario), self._vessel, 0.0, "held") if start.bears_loads() else start

    def answer(self, first: Afloat, rounds: int) -> BallastAnswer:
        """What has been found."""
        now = self.now
        contents = {name: tank.content for name, tank in self._all.items()}
        contents |= dict(zip(self._tanks, self._contents.tolist(), strict=True))
        start = now if self._time == 0.0 else self._at_start(now.scenario)
        return BallastAnswer(
            vessel=self._vessel,
            time=self._time,
            time_given=self._begun,
            given={name: tank.content for name, tank in self._all.items()},
            contents=contents,
            contents_then={name: now.content(name) for name in self._all},
            moved=float(np.abs(self._contents - self._given).sum()),
            attitude_given=first.attitude,
            attitude=now.attitude,
            attitude_before=start.attitude,
            displacement=now.displacement(),
            gm=now.metacentric_heights(),
            free_surface=self._free_surface(),
            after=now.rest,
            rounds=rounds,
            scenario=now.scenario,
        )


def _shown(key: str, value: float) -> str:
    """A part of an attitude as people read it."""
    return format_quantity(float(value), _SHOWN[key], 3)


def _tonnes(mass: float) -> str:
    return format_quantity(abs(mass), "t", 1)


def _room(scenario: Scenario, vessel: str) -> dict[str, tuple[float, float]]:
    """Least and most that may be in each tank at the start [kg].

    It holds what it has then, and what the plan pumps into it and out of it.
    """
    pumped = pumped_at_most(scenario)
    tanks = _tanks(scenario, vessel)
    ends = {name: pumped.get(f"{vessel}.{name}", (0.0, 0.0)) for name in tanks}
    return {name: (-ends[name][0], one.capacity - ends[name][1]) for name, one in tanks.items()}


def _tanks(scenario: Scenario, vessel: str) -> Mapping[str, BallastTank]:
    return bodies_afloat(scenario)[vessel].tanks or {}


def _written(content: float, least: float, most: float) -> str:
    """A content as a yard writes it, to the kilogram, of those between its ends."""
    lowest, highest = math.ceil(least * (1 - _ROUNDING)), math.floor(most * (1 + _ROUNDING))
    return f"{min(max(round(content), lowest), highest) / 1e3:.3f} t"
