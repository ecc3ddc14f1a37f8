"""Simulate a lift: from a lift file to a recording."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import Any, NoReturn

from gantline import _core
from gantline.arguments import is_number, needed, told
from gantline.assembly import assemble
from gantline.assembly.afloat.moorings import lost_pretensions
from gantline.assembly.afloat.side_by_side import shared_files
from gantline.assembly.afloat.vessels import adrift, misplaced, off_their_decks, vessel_hulls
from gantline.assembly.origin import refused
from gantline.assembly.plan.commands import CommandError, command_of, commanded
from gantline.interrupt import noted_interrupt
from gantline.overrides import overridden, with_adjusting_factor, with_locked_equalizers
from gantline.results.afloat.grounding import grounding_warnings
from gantline.results.afloat.immersion import (
    askew_in_water,
    dry_hulls,
    feels_water,
    immersion_warnings,
    loads_in_bed,
    misplaced_areas,
    never_wet,
    out_of_water,
)
from gantline.results.afloat.pressed import pressed_through
from gantline.results.afloat.tanks import hole_warnings, pump_warnings
from gantline.results.afloat.unfollowed import parted_neighbours, unfollowed
from gantline.results.afloat.vessels import AtRest, vessel_warnings, with_rest
from gantline.results.cranes.crawler import tipping_warnings
from gantline.results.derive import present_of, recording_of
from gantline.results.file.layout import DIMS
from gantline.results.loads.clearances import clearance_events, contact_warnings
from gantline.results.loads.guides import missed_guides
from gantline.results.method_warnings import method_warnings
from gantline.results.recording import Recording
from gantline.results.rig import Resting, Rig, with_resting
from gantline.results.ropes.beyond_curve import beyond_curve
from gantline.results.ropes.crossing import crossed_ropes
from gantline.results.ropes.flows import drum_warnings
from gantline.results.ropes.longer_falls import longer_falls
from gantline.results.run_warnings import (
    command_warnings,
    compensation_warnings,
    ground_warnings,
    missed_bumps,
    missed_crests,
    missed_incidents,
    missed_peaks,
    sheave_warnings,
    still_growing,
    stop_warnings,
)
from gantline.results.surroundings import ground_in
from gantline.results.variable import Columns, FloatArray, Names
from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.scenario.afloat.water import Water
from gantline.scenario.failed import failed_at
from gantline.statics import Statics
from gantline.statics.hung import resting_loads
from gantline.statics.righted import Waypoint, at_end, at_start, on_the_way
from gantline.version import version

Progress = Callable[[float], bool | None]


class SimulationError(RuntimeError):
    """The simulation could not go on.

    Attributes:
        recording: What was recorded up to then.
        time: Simulated time of the failure [s].
        element: The rope, body or contact at which it failed; empty if it belongs to none.
        cause: What failed, in one sentence.
        state: The last good state, for `Simulation.restore`.
    """

    def __init__(self, recording: Recording, time: float, element: str, cause: str, state: bytes) -> None:
        place = f" at {element}" if element else ""
        super().__init__(f"the simulation could not go on at t = {time:.3f} s{place}: {cause}")
        self.recording = recording
        self.time = time
        self.element = element
        self.cause = cause
        self.state = state

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.recording, self.time, self.element, self.cause, self.state)


def simulate(
    lift: str | Path | Scenario, *, on_progress: Progress | None = None, **overrides: Any
) -> Recording:
    """Simulate a lift from its start to its end.

    Ctrl-C stops cleanly; the recording then reaches as far as the simulation got and its attribute `status`
    is `stopped`.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        on_progress: Called about ten times a second with the simulated time [s]; returning False stops.
        overrides: Settings in place of those of the lift file: `integrator` ("adaptive", "del", "explicit"),
            `tension_tolerance` [N] and `position_tolerance` [m] of `adaptive`, `step` [s] of `del` and
            `explicit`, `paper` and `geometric_stiffness` of `del`, `duration` [s], `sample_interval` [s],
            `adjusting_factor` of all equalizers that are approximated, `equalizers` ("locked" to pin all
            moving sheaves where they start: the lift as it would be without equalizers).

    Returns:
        The recording.

    Raises:
        ScenarioError: If the lift file is not right.
        SettingError: If an override is not right.
        SimulationError: If the simulation could not go on; it carries what was recorded.
    """
    return Simulation(lift, **overrides).run(on_progress=on_progress)


class Simulation:
    """A lift that is ready to run, to be stopped, saved, and gone on with.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        overrides: Settings in place of those of the lift file, see `simulate`.

    Raises:
        ScenarioError: If the lift file is not right.
        SettingError: If an override is not right.
    """

    def __init__(self, lift: str | Path | Scenario, **overrides: Any) -> None:
        self.scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
        factor = overrides.pop("adjusting_factor", None)
        if factor is not None:
            self.scenario = with_adjusting_factor(self.scenario, factor)
        equalizers = overrides.pop("equalizers", None)
        if equalizers is not None:
            self.scenario = with_locked_equalizers(self.scenario, equalizers)
        self.assembly = assemble(self.scenario)
        self.settings = overridden(self.scenario, self.assembly.settings, overrides)
        self.status = "ready"
        self.integration_time = 0.0
        self._failure: dict[str, Any] | None = None
        self._present: tuple[float, dict[str, FloatArray]] | None = None
        self._rest_at_end: AtRest | None = None
        self._rest_on_the_way: list[tuple[float, AtRest]] = []
        self._resting: dict[str, list[Resting]] | None = None
        try:
            self._core = _core.Simulation(
                self.assembly.document_text(), json.dumps(self.settings, allow_nan=False)
            )
        except ValueError as problem:
            raise refused(self.scenario, str(problem)) from problem

    def __repr__(self) -> str:
        title = self.assembly.rig.get("title", "")
        return f"<Simulation {title!r}: at {self._core.time():g} s of {self.duration:g} s, {self.status}>"

    def __reduce__(self) -> NoReturn:
        """For pickle and copy, which would share what runs, or end in words of the core."""
        raise TypeError("a Simulation cannot be copied or pickled; `save` gives its state, in bytes")

    @property
    def duration(self) -> float:
        """Simulated time at which the run ends [s]."""
        return float(self.settings["duration"])

    @property
    def time(self) -> float:
        """Simulated time that it has got to [s]."""
        return self._core.time()

    @property
    def ended(self) -> bool:
        """True at the end of the lift, within rounding, since sums of 0.1 s may never give its duration."""
        return self._core.ended()

    @property
    def current_step(self) -> str | None:
        """Name of the step of the plan that goes, of several that one which began last; None without one."""
        return self._core.current_step()

    @property
    def largest_sling_tension(self) -> tuple[str, float] | None:
        """The sling that carries most now, and what it carries [N]; None in a lift without slings."""
        tension = self._core.current_tension()
        pulls = ((name, tension[index]) for name, index in self._slings)
        return max(pulls, key=lambda pull: pull[1], default=None)

    @cached_property
    def _slings(self) -> list[tuple[str, int]]:
        """Name of every sling, and the place of its rope among all, of one with nodes of its upper piece."""
        places: dict[str, int] = {}
        for index, rope in enumerate(self._core.names()["rope"]):
            places.setdefault(rope.partition("/")[0], index)
        return [(sling["name"], places[sling["rope"]]) for sling in self.assembly.rig.get("slings", ())]

    def run(self, *, until: float | None = None, on_progress: Progress | None = None) -> Recording:
        """Go on to the end, or to a time.

        Args:
            until: Simulated time after whose first step to pause [s], no step if it is past; None for the end
                of the lift.
            on_progress: Called about ten times a second with the simulated time [s]; returning False stops.

        Returns:
            Everything recorded so far.

        Raises:
            ValueError: If `until` is no time.
            TypeError: If `on_progress` cannot be called.
            SimulationError: If the simulation could not go on.
        """
        if until is not None and not (is_number(until) and until >= 0.0):
            raise ValueError(f"until: {until!r} is no time in seconds from 0 on; None goes on to the end")
        tell = told(on_progress)
        with noted_interrupt() as is_interrupted:

            def goes_on(now: float) -> bool:
                return not (is_interrupted() or (tell is not None and tell(now) is False))

            self._go(goes_on, until)
        return self.recording()

    def advance_to(self, to: float) -> None:
        """Go on to exactly a time, for programs that look at the lift there, or command it.

        `adaptive` ends a step there, so that the run goes on from it by other steps than one that does not
        pause, and by the same motion within the tolerances. Methods with fixed steps pause after the first
        step that reaches the time. Ctrl-C raises KeyboardInterrupt between two steps.

        Args:
            to: Simulated time [s]; beyond the end of the lift, or short of it by rounding, it is the end.

        Raises:
            ValueError: If it is no time, or is past.
            SimulationError: If the simulation could not go on.
        """
        if not (is_number(to) and math.isfinite(to)):
            raise ValueError(f"to: {to!r} is no time in seconds")
        if to < self.time * (1 - 1e-12):
            raise ValueError(f"to: {to:g} s is past, it is {self.time:g} s; `restore` goes back to a state")
        # A sum of 0.1 s that misses the end by rounding ends the run, and `time` would stay short of it.
        is_end = to >= self.duration * (1 - 1e-12) - 1e-12
        self._go(None, self.duration if is_end else to, exact=True)

    def _go(self, goes_on: Callable[[float], bool] | None, until: float | None, **how: bool) -> None:
        started = time.perf_counter()
        # What a callback or Ctrl-C raises leaves a run that can go on.
        self.status, left = "running", "paused"
        try:
            outcome = self._core.run(goes_on, until, **how)
            left = str(outcome["status"])
        finally:
            self.integration_time += time.perf_counter() - started
            self.status = left if left != "done" or self.ended else "paused"
        self._failure = None
        if self.status == "failed":
            cause = str(outcome.get("cause") or outcome.get("message", ""))
            element, cause = failed_at(self.scenario, str(outcome.get("element", "")), cause)
            self._failure = {"time": float(outcome["time"]), "element": element, "cause": cause}
            raise SimulationError(self.recording(), state=self.save(), **self._failure)

    def command(
        self, name: str, *, speed: float, acceleration: float | None = None, motion: str | None = None
    ) -> None:
        """Let a hook, trolley, crane, boom, drum or winch change to a speed from now on.

        What the plan says of it later is no longer heard: its steps begin and end without it. It keeps the
        speed until the next command, and comes to rest at the end of its range. An emergency stop of the
        lift file stops it too, and ends all commands. Commands are part of `save` and of the recording.

        Args:
            name: Its name as a step of the plan has it, such as `U1`.
            speed: [m/s, of booms rad/s], positive as `motion` says, negative the other way.
            acceleration: With which it changes [m/s^2, of booms rad/s^2]; its own limit in the lift file if
                not given. A change takes 1 ms at least.
            motion: Verb of the plan, for a name that can move in several ways: `hoist`, `traverse`,
                `travel`, `luff` (up), `slew`, `pay_out`, `veer`.

        Raises:
            CommandError: If there is nothing of this name, it is no speed for it, or the run has ended.
        """
        one = commanded(self.scenario, name, motion)
        document = command_of(one, speed, acceleration, self._core.drive)
        try:
            self._core.command(json.dumps(document, allow_nan=False))
        except ValueError as problem:
            raise CommandError(str(problem).replace("`", "'")) from problem

    def drive_state(self, name: str, *, motion: str | None = None) -> tuple[float, float]:
        """Where something that can be commanded is now, and how fast it moves there.

        Args:
            name: As for `command`.
            motion: As for `command`.

        Returns:
            Position as `to` of the plan counts it [m or rad], of drums and winches rope paid out since the
            start [m], and speed [m/s or rad/s].

        Raises:
            CommandError: If there is nothing of this name.
        """
        return commanded(self.scenario, name, motion).state(self._core.drive)

    def now(self, variable: str, name: str | None = None) -> FloatArray:
        """A value of the present, without a recording.

        Args:
            variable: As in a recording, such as `rope_tension`, `body_position`, `hook_load`, `load_tilt`,
                `sheave_travel`, `vessel_heel`, `tank_content`; not those of cranes, such as `hook_height`:
                where hooks are `drive_state` tells. What the core gives as it is, such as the first two,
                costs least.
            name: Name along it, such as `sling.S1`, as for `Recording.column`; None for all names, in their
                order.

        Returns:
            A number, or of a vector its components, in units of the recording; shape () or (3,), of all names
            (name,) or (name, 3).

        Raises:
            KeyError: If there is no such variable or name.
        """
        needed(variable, str, "the name of a variable", "such as 'rope_tension'")
        if self._present is None or self._present[0] != self.time:
            self._present = self.time, self._core.present()
        present = present_of(self._present[1], self._names, self._rig, variable)
        if variable not in present:
            why = f"there is no {variable!r} at present"
            if variable in DIMS:
                why = f"{variable!r} is worked out for recordings alone, see `recording`"
            raise KeyError(f"{why}; there are {', '.join(present)}")
        value: FloatArray = (present[variable].values if name is None else present.column(variable, name))[0]
        return value

    @cached_property
    def _names(self) -> dict[str, list[str]]:
        """Names along the columns of the present; its events are those of when it was asked first."""
        return self._core.names()

    @cached_property
    def _rig(self) -> Rig:
        return Rig.from_json(self.assembly.rig)

    def recording(self) -> Recording:
        """Everything recorded so far."""
        remainder = self._core.energy_remainder()
        columns, names = clearance_events(self._rig, *self._so_far())
        failure = {} if self._failure is None else {"failure": self._failure}
        found = recording_of(
            columns,
            names,
            self._rig_afloat(columns, names),
            self._core.columns(of_pulls=True),
            title=str(self.assembly.rig.get("title", "")),
            gantline_version=version(),
            scenario=self.scenario.text,
            settings=self._settings_used(),
            warnings=self._warnings(columns, names, remainder),
            scene=self.assembly.scene,
            counters=self._core.counters(),
            energy_remainder=remainder,
            status=self.status,
            **failure,
        )
        return self._with_resting(found)

    def _so_far(self) -> tuple[dict[str, FloatArray], dict[str, list[str]]]:
        """Columns, and names of as many events: another thread may go on between one and the other."""
        columns, names = self._core.columns(), self._core.names()
        events = len(columns["event_time"])
        return columns, names | {name: names[name][:events] for name in ("event_kind", "event_name")}

    def _warnings(self, columns: Columns, names: Names, remainder: float) -> list[str]:
        """What is doubtful about the lift as it was given, and as it went so far."""
        # By the name of the file alone: its folder is that of one machine.
        file = Path(self.scenario.source).name
        warnings = [doubt.of(file) for doubt in self.assembly.doubts]
        warnings += method_warnings(
            self.settings, self._rig, columns, names, self._core.counters(), remainder
        )
        warnings += sheave_warnings(self.assembly.rig, columns, names)
        rig = self._rig
        diameters = {rope.name: rope.diameter for rope in rig.ropes}
        warnings += crossed_ropes(self.assembly.document.get("ropes", ()), diameters, columns, names)
        warnings += contact_warnings(rig, columns, names)
        warnings += missed_peaks(rig, columns, names) + missed_bumps(rig, columns, names)
        warnings += pressed_through(self.assembly.document, rig.fenders, columns, names)
        warnings += missed_guides(self.assembly.document, rig.guides, columns, names)
        warnings += beyond_curve(rig.ropes, columns, names)
        warnings += missed_crests(rig, columns)
        warnings += still_growing(self.assembly.document, rig, columns, names)
        warnings += missed_incidents(self.assembly.document, rig, self.duration, names["event_kind"])
        warnings += drum_warnings(rig, columns, names) + longer_falls(rig, columns, names)
        warnings += tipping_warnings(columns, names, rig.crawlers)
        warnings += vessel_warnings(columns, names)
        if len(columns["time"]):
            warnings += unfollowed(self.assembly.document, columns, names)
        loads = {load.name: load.body for load in rig.loads}
        water = self.scenario.water or Water()
        dry = {load: body for load, body in loads.items() if not feels_water(self.assembly.document, body)}
        warnings += immersion_warnings(columns, names, self.assembly.scene, dry, water.density, rig.sea)
        warnings += loads_in_bed(columns, names, self.assembly.scene, loads, water.depth)
        warnings += askew_in_water(self.assembly.document, columns, names)
        warnings += out_of_water(self.assembly.document, columns, names)
        if self.ended:
            warnings += never_wet(self.assembly.document, columns, names, self.assembly.scene, loads)
        has_water = self.assembly.scene.get("water") is not None
        warnings += misplaced_areas(self.assembly.document, columns, names, water.level, has_water=has_water)
        warnings += dry_hulls(self.assembly.document, columns, names)
        if len(columns["time"]):
            at_start, turned = (
                dict(zip(names["body"], columns[name][0], strict=True))
                for name in ("body_position", "body_orientation")
            )
            warnings += misplaced(self.assembly.document, loads.values(), at_start)
        if rig.vessels and len(columns["time"]):
            afloat = [vessel.body for vessel in rig.vessels]
            warnings += adrift(self.assembly.document, afloat, at_start, turned)
            tensions = dict(zip(names["rope"], columns["rope_tension"][0], strict=True))
            warnings += lost_pretensions(self.scenario, tensions)
            decks = _decks(rig, columns, names)
            warnings += off_their_decks(self.assembly.document, decks, at_start, turned)
            hulls = vessel_hulls(self.assembly.document, afloat)
            together = shared_files(self.scenario) if self.scenario.waves else []
            warnings += parted_neighbours(self.assembly.document, columns, names, together, hulls)
            ground = ground_in(self.assembly.scene)
            warnings += grounding_warnings(columns, names, rig.vessels, hulls, ground, water.depth)
        warnings += pump_warnings(rig, columns, names)
        warnings += hole_warnings(rig, columns, names)
        if self.scenario.ground is not None:
            warnings += ground_warnings(rig, self.scenario.ground.level, columns, names)
        warnings += command_warnings(columns, names)
        warnings += compensation_warnings(columns, names)
        warnings += stop_warnings(rig, columns, names)
        return warnings

    def _with_resting(self, found: Recording) -> Recording:
        """The recording of a run that has ended, with how loads rest of which slings alone do not tell."""
        loads = self._rig.loads
        asked = any(load.other_ropes or load.tanks or load.in_water is not None for load in loads)
        if not (self.ended and self.status == "done" and asked):
            return found
        if self._question is None:
            return found
        if self._resting is None:
            self._resting = resting_loads(self._question, found, self._core.save(alone=True))
        rig = with_resting(found.attributes["rig"], self._resting)
        return Recording(found.variables, found.coordinates, {**found.attributes, "rig": rig})

    def _rig_afloat(self, columns: Columns, names: Names) -> dict[str, Any]:
        """The JSON of the rig, with what rights vessels where the run begins at rest, ends, and in between.

        A run of perfect symmetry stays upright there: nothing pushes but rounding. A load that is set down
        at the end no longer hangs above its vessel: GM is least while it does, so that every end of a step
        counts, and every moment at which a tank gets a surface or loses it.
        """
        found = self.assembly.rig
        floats = [vessel.body for vessel in self._rig.vessels if not vessel.is_carried]
        if not floats or self._question is None:
            return found
        if self.settings["start"] == "rest":
            found = with_rest(found, 0.0, self._rest_at_start)
        for waypoint in map(Waypoint._make, self._core.waypoints(len(self._rest_on_the_way))):
            said = on_the_way(self._question, waypoint, columns, names)
            self._rest_on_the_way.append((waypoint.time, said))
        for at, said in self._rest_on_the_way:
            found = with_rest(found, at, said)
        if self.ended and self.status == "done":
            if self._rest_at_end is None:
                lie = {body: self.now("body_orientation", body) for body in floats}
                self._rest_at_end = at_end(self._question, self.time, self._core.save(alone=True), lie)
            found = with_rest(found, self.time, self._rest_at_end)
        return found

    @cached_property
    def _question(self) -> Statics | None:
        """The lift at rest; None of one without statics."""
        try:
            return Statics(self.scenario, assembly=self.assembly)
        except ScenarioError:
            return None

    @cached_property
    def _rest_at_start(self) -> AtRest:
        return AtRest({}, {}) if self._question is None else at_start(self._question)

    def _settings_used(self) -> dict[str, Any]:
        """The settings with what they leave to a default, and `start` in the lift file's own word."""
        used = {f"{name}_tolerance": value for name, value in self._core.tolerances().items()}
        integrator = {**self.settings["integrator"], **used}
        return {**self.settings, "integrator": integrator, "start": self.scenario.starts}

    def measure(self) -> None:
        """Measure from now on where the time goes; costs a few per cent."""
        self._core.measure()

    def stages(self) -> dict[str, float]:
        """Wall time by stage of what was measured [s]: kinematics, assembly, factorisation, and so on."""
        return self._core.stages()

    def save(self) -> bytes:
        """The state of the simulation, from which `restore` goes on with the same bytes of results.

        What was recorded so far is part of it, so that a run that goes on from it, also in another process,
        hands out the whole recording. For this version of gantline, this lift and these settings.
        """
        return self._core.save()

    def restore(self, state: bytes) -> None:
        """Go back (or on) to a saved state of the same lift with the same settings.

        Args:
            state: What `save` gave.

        Raises:
            ValueError: If it is no state of this lift and these settings, is damaged, or was saved by another
                version of gantline; the simulation is then as before.
            TypeError: If it is no bytes at all.
        """
        self._core.restore(
            needed(state, bytes, "a saved state", "`save` of a simulation gives one, in bytes")
        )
        self._present = None
        self._rest_at_end = self._resting = None
        self._rest_on_the_way = []
        self.status = "done" if self.ended else "paused" if self.time > 0.0 else "ready"
        self._failure = None


def _decks(rig: Rig, columns: Columns, names: Names) -> dict[str, list[str]]:
    """What may move of what each load stands on as a run begins, by the name of its body."""
    pressed = dict(zip(names.get("contact", ()), columns["contact_force"][0], strict=False))
    return {
        load.body: [under for contact, under in load.meets.items() if pressed.get(contact, 0.0) > 0.0]
        for load in rig.loads
    }
