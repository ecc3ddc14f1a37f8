"""Statics of a lift: how it hangs at a time of its plan, how it swings about that, how errors change it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import cached_property, wraps
from itertools import islice
from numbers import Integral
from pathlib import Path
from threading import RLock
from typing import Any, Concatenate, Literal, ParamSpec, TypeVar

import numpy as np

from gantline import _core
from gantline.arguments import direction as direction_of
from gantline.arguments import is_number, listed, needed, number
from gantline.assembly import Assembly, assemble
from gantline.assembly.afloat.vessels import drifted
from gantline.assembly.origin import FALLS, refused, with_advice
from gantline.assembly.parts import axial_stiffness
from gantline.results.afloat.immersion import dry_hulls, loads_in_bed
from gantline.results.afloat.pressed import pressed_through
from gantline.results.derive import recording_of
from gantline.results.recording import Recording
from gantline.results.rig import Rig, at_rest
from gantline.results.ropes.beyond_curve import beyond_curve
from gantline.results.ropes.flows import drum_warnings
from gantline.scenario import Scenario, load_scenario
from gantline.scenario.afloat.tanks import holed_tanks
from gantline.scenario.errors import nearest
from gantline.statics.answers import (
    KINDS,
    OF_ROPES,
    ContactForce,
    Equilibrium,
    Losses,
    Mode,
    NoEquilibriumError,
    Sensitivity,
    likely,
)
from gantline.statics.asked import increment_of, losses_of, swing_of
from gantline.statics.come_free import come_free, without
from gantline.statics.linear import LinearModel, linear_model
from gantline.statics.motion import drums_of, in_words
from gantline.statics.pieces import Pieces
from gantline.statics.righted import of_equilibrium
from gantline.statics.streaming import leading_away, leading_straight, leads_straight, motions, streams
from gantline.version import version

#: What happens at the end of the lift is looked at so much later [s].
_PAST = 1e-3
#: Largest displacement of a mode that is shown, of any body's centre of gravity [m] or turn [rad].
_SHOWN = 0.5


_P = ParamSpec("_P")
_R = TypeVar("_R")


def _one_at_a_time(
    ask: Callable[Concatenate[Statics, _P], _R],
) -> Callable[Concatenate[Statics, _P], _R]:
    """What is asked while another thread is being answered waits for that."""

    @wraps(ask)
    def waiting(self: Statics, /, *args: _P.args, **kwargs: _P.kwargs) -> _R:
        with self._lock:
            return ask(self, *args, **kwargs)

    return waiting


def _pairs(parameters: Sequence[Any]) -> list[tuple[str, str]]:
    """The same, looked at one by one.

    Raises:
        TypeError: If one is no pair of a kind and a name.
    """
    several: list[Any] = [parameters]
    if not isinstance(parameters, str):
        several = listed(parameters, "a list of parameters", 'such as [("length", "sling.S1")]')
    for one in several:
        if isinstance(one, str) or not isinstance(one, Sequence) or len(one) != 2:
            like = 'pairs such as ("length", "sling.S1")'
            raise TypeError(f"parameters: {one!r} is no pair of a kind and a name; a list has {like}")
    return [(kind, name) for kind, name in several]


class Statics:
    """A lift whose equilibria are asked for, by one thread at a time: others wait.

    What is asked of the equilibrium found last is so of whichever thread found it.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        goes_on: Asked before every part of a plan that is followed, for threads, which Ctrl-C does not reach;
            where it says no there is no equilibrium, since the search was stopped.
        assembly: What has been assembled of the scenario, where that is there already.

    Raises:
        ScenarioError: If the lift file is not right, or the lift has no statics (lengths that are adjusted).
        TypeError: If `goes_on` is no function.
    """

    def __init__(
        self,
        lift: str | Path | Scenario,
        *,
        goes_on: Callable[[], bool] | None = None,
        assembly: Assembly | None = None,
    ) -> None:
        if goes_on is not None and not callable(goes_on):
            raise TypeError(f"goes_on: a function is needed, not {type(goes_on).__name__}")
        self.scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
        self.assembly = assemble(self.scenario) if assembly is None else assembly
        try:
            self._core = _core.Statics(self.assembly.document_text())
        except ValueError as problem:
            raise refused(self.scenario, str(problem)) from problem
        self._whole = self._core
        self._lock = RLock()
        self._goes_on = goes_on
        self._last: Losses | NoEquilibriumError | None = None
        self._modes: list[Mode] = []
        self._streams = streams(self.assembly.document)
        self._is_stable = True
        self._bodies = {body["name"]: body for body in self.assembly.document["bodies"]}

    def __repr__(self) -> str:
        return f"<Statics {self.assembly.rig.get('title', '')!r}>"

    @cached_property
    def rig(self) -> Rig:
        """Who carries whom, in still water and steady wind."""
        return Rig.from_json(at_rest(self.assembly.rig))

    @_one_at_a_time
    def equilibrium(
        self,
        time: float | None = None,
        *,
        losses: Losses = "none",
        slide: Sequence[float] | None = None,
        increment: Sequence[float] | None = None,
    ) -> Equilibrium:
        """The equilibrium that lies downhill of the start of the lift.

        Brakes, locking pins and dry friction given in newtons hold what they hold at the start, pins that the
        plan puts in where the lift at rest has come to by then. What stands for mud or suction is gone where
        it would carry what it comes free at.

        Args:
            time: Time of the plan [s], at which drives are where it says; None for the end of the lift. A
                plan that waits for conditions, or has put in pins, is followed from rest to rest; so is a
                lift with drums that remember what they wind, and one whose friction holds.
            losses: What friction of sheaves and contacts does: `none`, sheaves are ideal, which is the middle
                of what they may hold, and contacts slide freely; `forward` and `backward`, all sheaves slip
                towards the end or the start of their ropes' routes, which bounds it; `held`, sheaves and
                contacts hold where they are at the start, with no more than their friction.
            slide: A direction of the world along which all contacts have slid: friction, as large as it can
                be, pulls back along it.
            increment: How far each degree of freedom starts from the start of the lift [m or rad].

        Raises:
            NoEquilibriumError: If there is none.
            TypeError: If an increment is no number.
            ValueError: If the time is not one of the lift, there are no such losses, or what slides does so
                in no direction.
        """
        duration = self.scenario.duration
        moment = duration if time is None else time
        if not (is_number(moment) and 0.0 <= moment <= duration + _PAST):
            lasts = f"lasts from 0 s to {duration:g} s"
            if not is_number(moment):
                raise ValueError(f"time: {moment!r} is no number of seconds; the lift {lasts}")
            raise ValueError(f"time: {moment:g} s is no time of the lift, which {lasts}")
        start, losses = increment_of(increment), losses_of(losses)
        way = None if slide is None else direction_of(slide, "slide")
        self._last = None
        self._core, gone = self._whole, set[str]()
        while True:
            try:
                found = self._core.settle(moment, start, losses, way, self._goes_on)
            except RuntimeError as problem:
                raise self._nowhere(moment, *problem.args) from None
            free = self._come_free()
            if free <= gone:
                return self._found(found, losses)
            gone |= free
            self._core = _core.Statics(without(self.assembly.document, gone))

    @_one_at_a_time
    def equilibrium_of(self, state: bytes, *, losses: Losses = "held") -> Equilibrium:
        """The equilibrium of where a simulation has got to, as if everything stopped there.

        Drives and drums stay where they are, with what they have wound; what sticks may go on sticking.

        Args:
            state: What `gantline.simulation.Simulation.save` gave, of the same lift with any settings.
            losses: See `equilibrium`.

        Raises:
            NoEquilibriumError: If there is none.
            TypeError: If it is no bytes at all.
            ValueError: If it is no state of this lift, or there are no such losses.
        """
        self._last, losses = None, losses_of(losses)
        needed(state, bytes, "a saved state", "`save` of a simulation gives one, in bytes")
        try:
            found = self._core.settle_saved(state, losses)
        except RuntimeError as problem:
            raise self._nowhere(self._core.time(), *problem.args) from None
        return self._found(found, losses)

    @_one_at_a_time
    def slid(self, direction: Sequence[float], time: float | None = None) -> Equilibrium | None:
        """Where loads come to rest that slide along a direction of the world.

        From where the plan has brought them: friction of their contacts, as large as it can be, pulls them
        back, and slings pull them on. None where nothing but friction holds them.

        Args:
            direction: Of the world.
            time: As in `equilibrium`.

        Raises:
            NoEquilibriumError: If there is none for another cause.
            ValueError: If it is no direction, or the time not one of the lift.
        """
        try:
            return self.equilibrium(time, slide=direction_of(direction, "direction"))
        except NoEquilibriumError as problem:
            if problem.cause == FALLS:
                return None
            raise

    @_one_at_a_time
    def stick_range(
        self, direction: Sequence[float], time: float | None = None
    ) -> tuple[Equilibrium | None, Equilibrium | None]:
        """Where loads come to rest that slide along a direction, and against it.

        Between these two friction of their contacts holds them wherever they are put; where one is None the
        range is open on that side. For the rest see `slid`.
        """
        way = direction_of(direction, "direction")
        return self.slid(way, time), self.slid([-part for part in way], time)

    @_one_at_a_time
    def step_off(self) -> Equilibrium | None:
        """From the unstable equilibrium found last to the stable one downhill of it.

        It steps off along the motion that leads away fastest, by 0.02 rad (where nothing turns, 0.02 m), in
        the direction in which the first of the coordinates that move most grows. None where the equilibrium
        found last is not unstable, or what leads away in wind or current only swings out ever farther; where
        none was asked for, that at the end of the lift counts.

        Raises:
            NoEquilibriumError: If nothing holds it there.
        """
        losses = self._of_last()
        if self._is_stable or (self._streams and not leads_straight(self._core.linear())):
            return None
        try:
            found = self._core.step_off(losses)
        except RuntimeError as problem:
            raise self._nowhere(self._core.time(), *problem.args) from None
        return None if found is None else self._found(found, losses)

    @_one_at_a_time
    def lose(self, load: str) -> Equilibrium:
        """The equilibrium of everything else where a load is lost at the equilibrium found last.

        The load, with what is fixed to it, and all ropes and contacts that reach it are gone at once; hooks,
        spreaders and what hangs below them stay. Modes, sensitivities and further losses are then of that,
        until an equilibrium of the lift itself is asked for. Where none was asked for, that at the end of the
        lift counts.

        Args:
            load: Its name.

        Raises:
            NoEquilibriumError: If there is none without it.
            ValueError: If the lift has no such load.
        """
        bodies = {one.name: one.body for one in self.rig.loads}
        if load not in list(bodies):
            known = ", ".join(bodies) or "none"
            raise ValueError(f"the lift has no load {load!r}; its loads: {known}")
        losses = self._of_last()
        try:
            found = self._core.lose(bodies[load], losses)
        except RuntimeError as problem:
            raise self._nowhere(self._core.time(), *problem.args) from None
        return self._found(found, losses)

    @_one_at_a_time
    def heavier(self, more: Mapping[str, float]) -> tuple[Statics, Recording]:
        """The same lift with bodies that weigh more, at rest downhill of the equilibrium found last.

        Drives stay where they are, drums as wound and tanks as full. Sensitivities of the lift that is given
        back are about that equilibrium; this one stays at its own.

        Args:
            more: By how much bodies are heavier, at their centres of gravity, by their names [kg].

        Returns:
            That lift, and how it rests.

        Raises:
            NoEquilibriumError: If there is none, or none with that weight.
            TypeError: If a weight is no number, or they are not by names.
            ValueError: If the lift has no such body.
        """
        if not isinstance(more, Mapping):
            like = f"such as {{{next(iter(self._bodies))!r}: 1e3}}"
            wrong = f"a dictionary of masses by names of bodies is needed, not {type(more).__name__}"
            raise TypeError(f"{wrong}; {like}")
        for body in more:
            if body not in self._bodies:
                raise ValueError(f"the lift has no body {body!r}; {nearest(str(body), self._bodies)}")
        added = [(body, number(mass, f"more of {body}", "kilograms")) for body, mass in more.items()]
        losses = self._of_last()
        other = copy(self)
        try:
            other._core, other._lock = self._core.heavier(added, losses), RLock()
            other._whole, other._modes = other._core, []
        except RuntimeError as problem:
            raise NoEquilibriumError(self._core.time(), *problem.args) from None
        return other, other._recording("at rest with more weight")

    def _of_last(self) -> Losses:
        """What losses the equilibrium found last has; finds that at the lift's end if none was asked for.

        Raises:
            NoEquilibriumError: If there is none there, or was none where one was asked for last.
        """
        last = self._last
        if isinstance(last, NoEquilibriumError):
            raise NoEquilibriumError(last.time, last.element, last.cause)
        return self.equilibrium().losses if last is None else last

    def _nowhere(self, moment: float, element: str, cause: str) -> NoEquilibriumError:
        """That there is none; noted, so that nothing is asked about it."""
        self._modes = []
        self._last = NoEquilibriumError(moment, element, with_advice(self.scenario, element, cause))
        return self._last

    def _come_free(self) -> set[str]:
        """Ropes that stand for mud or suction, and carry too much for it where the core has come to rest."""
        if not any(rope.comes_free for rope in self.rig.ropes):
            return set()
        tensions = self._core.columns()["rope_tension"][-1]
        return come_free(self.rig, dict(zip(self._core.names()["rope"], tensions, strict=True)))

    def _found(self, found: dict[str, Any], losses: Losses) -> Equilibrium:
        self._last, self._modes = losses, []
        moment = float(found["time"])
        recording = self._recording(f"at rest at {moment:g} s")
        for _, _, crane in recording.events("tipping"):  # downhill of the start lies the crane on its back
            raise self._nowhere(moment, crane, "the crane tips over")
        straight, swinging, neutral = found["unstable"], 0, found["neutral"]
        if self._streams:  # the core tells by half of the tangent
            straight, swinging, neutral = leading_away(self._core.linear())
        elif straight:  # pins and brakes yield a little there, which may lead away alone
            straight, freed = leading_straight(self._core.modes(straight, None)["square"], straight)
            neutral += freed
        unstable = straight + swinging
        self._is_stable = not unstable
        rest = Equilibrium(
            time=moment,
            recording=recording,
            residual=found["residual"],
            neutral=neutral,
            unstable=unstable,
            swinging=swinging,
            steps=found["steps"],
            lossy=tuple(found["lossy"]),
            losses=losses,
            slides=tuple(found["slides"]),
            contacts=tuple(
                ContactForce(name, support, np.asarray(friction), bound)
                for name, support, friction, bound in found["contacts"]
            ),
        )
        return rest.with_rest(of_equilibrium(self, rest))

    @_one_at_a_time
    def modes(self, count: int | None = None) -> list[Mode]:
        """Natural motions about the equilibrium found last, slowest first, after those that lead away.

        Where none was asked for, that at the end of the lift counts.

        Args:
            count: How many; None for all. A few of a large lift take much less time than all of them.

        Raises:
            NoEquilibriumError: If there is none.
            ValueError: If the count is no whole number from 0 on.
        """
        if count is not None and not (isinstance(count, Integral) and count >= 0):
            raise ValueError(f"count: {count!r} is no whole number from 0 on; None asks for all modes")
        self._of_last()
        whole = motions(self._core.linear())[:count] if self._streams else None
        found = self._core.modes(count, whole)
        ratios = found["damping_ratio"]
        names, turned = self._core.names()["body"], self._core.columns()["body_orientation"][-1]
        drums = drums_of(self.assembly.document)
        vessels = {vessel.body for vessel in self.rig.vessels}

        def mode(number: int, square: float) -> Mode:
            flows = {name: float(found["shape"][number][dof]) for name, dof in found["flows"]}
            motion = found["body_motion"][number]
            return Mode(
                number=number,
                square=square,
                damping_ratio=None if math.isnan(ratios[number]) else float(ratios[number]),
                body_motion=motion,
                bodies=tuple(names),
                motion=in_words(motion, names, self._bodies, turned, flows, drums, vessels),
                flows=flows,
            )

        self._modes = [mode(number, float(square)) for number, square in enumerate(found["square"])]
        return list(self._modes)

    @_one_at_a_time
    def linear_model(self, frequency: float | None = None) -> LinearModel:
        """Matrices of small motions about the equilibrium found last.

        Ropes that are taut there stay so, and slack ones slack; contacts and brakes likewise. Where none was
        asked for, that at the end of the lift counts.

        Args:
            frequency: Circular frequency [rad/s] of which water that remembers has its added mass and
                damping; None for an infinite one, without damping. Of no meaning for any other water.

        Raises:
            NoEquilibriumError: If there is none.
            ValueError: If the frequency is no number above zero.
        """
        if frequency is not None and not (is_number(frequency) and 0.0 < frequency < math.inf):
            raise ValueError(f"frequency: {frequency!r} is no frequency above zero in radians per second")
        self._of_last()
        return linear_model(self._core.linear(frequency), self._core.names())

    @_one_at_a_time
    def swing(self, mode: Mode, *, amplitude: float = _SHOWN, frames: int = 61) -> Recording:
        """One period of a mode as a recording, so that everything that shows recordings shows it.

        Args:
            mode: Of the modes found last.
            amplitude: Largest displacement of any body, or of rope over a sheave or drum [m], or turn [rad].
            frames: Samples, from 1 on.

        Raises:
            ValueError: If it is no mode found last, or amplitude or frames are not right.
        """
        amplitude, frames = swing_of(mode, self._modes, amplitude, frames)
        moved = mode.body_motion.reshape(-1, 2, 3)
        largest = max([float(np.linalg.norm(moved, axis=2).max()), *map(abs, mode.flows.values())])
        self._core.swing(mode.number, amplitude / largest if largest > 0.0 else 0.0, frames)
        return self._recording(f"mode {mode.number + 1}: {mode.motion}")

    @_one_at_a_time
    def sensitivities(
        self, parameters: Sequence[tuple[str, str]] | None = None, *, standing: bool = False
    ) -> list[Sensitivity]:
        """Derivatives of tensions and motions about the equilibrium found last, from its factorised tangent.

        Where none was asked for, that at the end of the lift counts.

        Args:
            parameters: Pairs of a kind and a name such as `("length", "sling.S1")`, see `Sensitivity`; None
                for the lengths and stiffnesses of all slings and the centres of gravity and masses of all
                loads.
            standing: Friction holds what stands on vessels, and nothing else; what it does in the equilibrium
                if not.

        Raises:
            NoEquilibriumError: If there is none, or none that answers smoothly.
            TypeError: If the parameters are no pairs.
            ValueError: If there is no such kind, rope or body, or a drum or a sheave feeds the rope.
        """
        self._of_last()
        wanted = _pairs(parameters) if parameters is not None else self._uncertain()
        names = Pieces(self.rig, self._core.names())
        for kind, name in wanted:
            if kind not in KINDS:
                raise ValueError(f"there is no sensitivity to {kind!r}; there are {', '.join(KINDS)}")
            known = names.ropes if kind in OF_ROPES else names.bodies
            if name not in known:
                raise ValueError(f"there is no {name} to ask the {kind} of; there are {likely(name, known)}")
        asked = [names.asked(kind, name) for kind, name in wanted]
        try:
            found = self._core.sensitivities([one for each in asked for one in each], standing)
        except RuntimeError as problem:
            raise NoEquilibriumError(self._core.time(), *problem.args) from None
        parts = zip(found["rope_tension"], found["body_motion"], found["held"], strict=True)
        loads = self._core.columns()["rope_tension"][-1]
        return [
            names.answer(kind, name, list(islice(parts, len(each))), loads)
            for (kind, name), each in zip(wanted, asked, strict=True)
        ]

    @_one_at_a_time
    def times_of(self, step: str) -> tuple[float | None, float | None]:
        """When a step of the plan began and ended on the way to the equilibrium found last [s].

        None where it had not.

        Raises:
            ValueError: If the plan has no such step.
        """
        self._refuse_unknown(step)
        return self._core.times_of(step)

    @_one_at_a_time
    def when(self, step: str, moment: Literal["begins", "ends"]) -> float | None:
        """When a step of the plan begins or ends [s]; None if that is not before the end of the lift.

        The lift is followed from rest to rest, no farther than that. No equilibrium has been asked for then.

        Raises:
            NoEquilibriumError: If there is none on the way.
            ValueError: If the plan has no such step, or the moment is neither.
        """
        self._refuse_unknown(step)
        if moment not in ("begins", "ends"):
            raise ValueError(f"moment: {moment!r} is none; a step 'begins' or 'ends'")
        self._last, self._modes = None, []
        try:
            return self._core.when(step, moment == "ends", self.scenario.duration, self._goes_on)
        except RuntimeError as problem:
            raise self._nowhere(self._core.time(), *problem.args) from None

    def _refuse_unknown(self, step: str) -> None:
        known = [one.step for one in self.scenario.plan]
        if step not in known:
            raise ValueError(f"the plan has no step {step!r}; its steps are {', '.join(known)}")

    def _uncertain(self) -> list[tuple[str, str]]:
        rig = self.rig
        slings = [(kind, sling.rope) for kind in ("length", "stiffness") for sling in rig.slings]
        kinds = ("centre_x", "centre_y", "centre_z", "mass")
        return [*slings, *((kind, load.body) for load in rig.loads for kind in kinds)]

    def _recording(self, status: str) -> Recording:
        # Freeboard is not against a wave that passes at that time of the plan, nor wind a gust.
        columns, names = self._core.columns(), self._core.names()
        loads = {load.name: load.body for load in self.rig.loads}
        depth = None if self.scenario.water is None else self.scenario.water.depth
        warnings = [*self.assembly.warnings, *dry_hulls(self.assembly.document, columns, names)]
        warnings += loads_in_bed(columns, names, self.assembly.scene, loads, depth)
        warnings += drum_warnings(self.rig, columns, names)
        if holed := list(holed_tanks(self.scenario)):
            sentence = f"nothing runs through the holes of {', '.join(holed)} in equilibria"
            warnings.append(f"{sentence}: of times in the plan they have what is in at the start")
        places = dict(zip(names["body"], columns["body_position"][-1], strict=True))
        warnings += drifted(self.scenario, self.assembly.document, places)
        warnings += pressed_through(self.assembly.document, self.rig.fenders, columns, names)
        warnings += beyond_curve(self.rig.ropes, columns, names)
        return recording_of(
            columns,
            names,
            at_rest(self.assembly.rig),
            title=str(self.assembly.rig.get("title", "")),
            gantline_version=version(),
            scenario=self.scenario.text,
            settings=self.assembly.settings,
            axial_stiffness=self._stiffness(),
            warnings=warnings,
            scene=self.assembly.scene,
            counters={},
            status=status,
        )

    def _stiffness(self) -> dict[str, float]:
        """Axial stiffness of ropes that stretch [N]."""
        materials = {rope["name"]: rope["material"] for rope in self.assembly.document["ropes"]}
        # All pieces of one with nodes are of one stiffness.
        materials |= {rope.name: materials[f"{rope.name}/0"] for rope in self.rig.ropes if rope.nodes}
        known = {name: axial_stiffness(one) for name, one in materials.items()}
        return {name: stiffness for name, stiffness in known.items() if stiffness is not None}
