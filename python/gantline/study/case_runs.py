"""The cases of a lift file, simulated: the whole plan of each, held against the limits of the lift."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from gantline.arguments import told
from gantline.checks import Check, Outcome, foremost
from gantline.results.file.saved import digest_of
from gantline.results.file.saved_json import number_in, object_of, text_in
from gantline.results.progress import spans
from gantline.results.recording import Recording
from gantline.scenario import Scenario, load_scenario
from gantline.scenario.file.case import TOLERANCE
from gantline.scenario.file.variants import variants_of, with_lengths, with_ropes_cut, without_cases
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.study.cases import lengths_off
from gantline.study.held_run import HeldRun
from gantline.study.kept_runs import RunKind, kept_runs, simulated_digest
from gantline.study.pattern import pattern_label
from gantline.study.side_by_side import SideBySide
from gantline.study.state import State, settled

__all__ = ["PEAKS", "CaseRun", "CaseRuns", "simulate_cases"]

#: Metrics of a recording that are kept of each run.
PEAKS = (
    "peak_sling_tension",
    "least_sling_tension_when_clear",
    "peak_hook_load",
    "peak_load_tilt",
    "travel_used_up",
    "travel_used_down",
)
_NO_TIME = "a cut is simulated at its own time, and this one has none; 'at' or 'at_step' says when"


@dataclass(frozen=True, kw_only=True)
class CaseRun(HeldRun):
    """One run of a case, or of the lift as it is given.

    Attributes:
        case: Name of the case; empty for the lift as it is given.
        variant: What is different in it; empty where the case has this one alone.
        peaks: Those of `PEAKS` that there are, SI units.
        begins: When each step of the plan began [s].
    """

    case: str
    variant: str = ""
    peaks: Mapping[str, float] = field(default_factory=dict)
    begins: Mapping[str, float] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        more = {"variant": self.variant, "peaks": dict(self.peaks), "begins": dict(self.begins)}
        return {**more, **super().to_json()}

    @classmethod
    def _more_in(cls, document: Mapping[str, Any]) -> dict[str, Any]:
        numbers = {name: object_of(document.get(name)) for name in ("peaks", "begins")}
        return {
            "case": text_in(document, "case"),
            "variant": text_in(document, "variant"),
            **{name: {one: number_in(found, one) for one in found} for name, found in numbers.items()},
        }


#: Runs that are kept. What a case names, such as another file, may have changed while the lift file has not.
_RUNS = RunKind(
    "run of a case", {"case": text_in, "variant": text_in, "simulated_sha256": text_in}, CaseRun.from_json
)


@dataclass(frozen=True)
class CaseRuns:
    """A lift and its cases, simulated.

    Attributes:
        title: Title of the lift.
        scenario: Text of its lift file.
        runs: The lift as it is given, then every variant of every case, in the order of the file.
        left_out: Why cases were not simulated, by name.
        not_done: Names of cases of which Ctrl-C kept variants from being simulated.
        taken_over: How many runs were taken from those that had been kept.
    """

    title: str
    scenario: str
    runs: Sequence[CaseRun]
    left_out: Mapping[str, str] = field(default_factory=dict)
    not_done: Sequence[str] = ()
    taken_over: int = 0

    def __repr__(self) -> str:
        return f"<CaseRuns {self.title!r}: {len(self.names) - 1} cases, {len(self.runs)} runs in all>"

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the cases; the lift as it is given is the first and has an empty one."""
        return tuple(dict.fromkeys(run.case for run in self.runs))

    def of(self, case: str) -> list[CaseRun]:
        """All runs of a case; '' is the lift as it is given.

        Raises:
            KeyError: If there is no such case.
        """
        if case not in self.names:
            raise KeyError(f"there is no case {case!r}; there are {', '.join(map(repr, self.names))}")
        return [run for run in self.runs if run.case == case]

    @property
    def worst(self) -> list[tuple[Check, CaseRun]]:
        """Of each check the run that uses most of its limit, most first; of those alike the first."""
        known = [(check, run) for run in self.runs for check in run.checks if check.utilisation is not None]
        runs = {id(check): run for check, run in known}
        return [(check, runs[id(check)]) for check in foremost([check for check, _ in known])]

    @property
    def is_go(self) -> bool:
        """Whether the lift is a go in every case, with warnings or without, and all of them were run."""
        outcomes = (Outcome.GO, Outcome.GO_WITH_WARNINGS)
        return not (self.not_done or self.left_out) and all(run.outcome in outcomes for run in self.runs)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units; the lift as it is given is the case with the name ''."""
        return {
            "title": self.title,
            "scenario_sha256": digest_of(self.scenario),
            "go": self.is_go,
            "left_out": dict(self.left_out),
            "not_done": list(self.not_done),
            "cases": [
                {"case": name, "runs": [run.to_json() for run in self.of(name)]} for name in self.names
            ],
            "worst": [
                {"case": run.case, "variant": run.variant, **check.to_json()} for check, run in self.worst
            ],
        }


def simulate_cases(
    lift: str | Path | Scenario,
    time: float | None = None,
    *,
    workers: int | None = None,
    kept: str | Path | None = None,
    anew: bool = False,
    on_progress: Callable[[str], None] | None = None,
    **overrides: Any,
) -> CaseRuns:
    """Simulate a lift as it is given and each of its cases, from start to end.

    A case that cannot start, or not go on, is a result. Each starts as the lift does. Runs go on side by
    side; what is found does not depend on how many at a time. Ctrl-C ends it with what there is, unless the
    lift as it is given is not done.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        time: Time of the plan at whose equilibrium the worst patterns of lengths are looked for [s]; None for
            the end of the lift.
        workers: Runs at a time; None for as many as there are processors.
        kept: A file that each run is written to as soon as it ends, and that runs are taken from, as of
            `run_seas`.
        anew: Whether to begin that file anew.
        on_progress: Is told in words how far it is.
        overrides: Settings of `simulate`.

    Raises:
        ScenarioError: If the lift file is not right, or a case asks for what cannot be.
        SettingError: If an override is not right.
        KeptRunsError: If `kept` is of another lift, or of nothing of the kind, or another study writes to it;
            a ValueError.
        OSError: If `kept` cannot be read or written.
    """
    tell = told(on_progress) or (lambda _: None)
    scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
    base = without_cases(scenario)
    # What is wrong with the lift as such, or with a setting, is no matter of a case.
    simulation = Simulation(base, **overrides)
    path = None if kept is None else Path(kept)
    pending: list[tuple[str, Future[CaseRun]]] = []
    left_out: dict[str, str] = {}
    whole: list[str] = []
    with (
        kept_runs(path, _RUNS, simulation, anew=anew) as known,
        SideBySide(workers) as pool,
    ):

        def submit(case: str, variant: str, changed: Callable[[], Scenario]) -> None:
            def through(ready: Simulation, run: Callable[[], CaseRun]) -> CaseRun:
                place = {"case": case, "variant": variant, "simulated_sha256": simulated_digest(ready)}
                return known.made(place, run, pool.goes_on)

            run = partial(CaseRun.of, changed, overrides, goes_on=pool.goes_on, note=_note, through=through)
            pending.append((case, pool.submit(partial(run, case=case, variant=variant))))

        try:
            submit("", "", lambda: base)
            for name, case in (scenario.cases or {}).items():
                tell(f"preparing '{name}'")
                try:
                    if case.cut:
                        when = _moment(scenario, name, pending[0][1])
                        submit(
                            name,
                            f"at {when:.4g} s",
                            partial(with_ropes_cut, scenario, name, when, to_run=True),
                        )
                    elif case.vary == TOLERANCE:
                        for longer in _lengths(scenario, base, name, time, tell):
                            changed = partial(with_lengths, scenario, name, longer, to_run=True)
                            submit(name, pattern_label(longer), changed)
                    else:
                        for variant in variants_of(scenario, name, to_run=True):
                            submit(name, variant.label, partial(_itself, variant.scenario))
                except _NotRunError as reason:
                    left_out[name] = str(reason)
                whole.append(name)
            for done, (_, one) in enumerate(pending):
                tell(f"{done} of {len(pending)} runs done")
                one.result()
        except KeyboardInterrupt:
            # What still goes on is given up now, and would end early.
            lacking = {name for name, one in pending if not one.done()}
            pending = [(name, one) for name, one in pending if one.done()]
            pool.give_up()
            if "" in lacking or not pending:
                raise
            whole = [name for name in whole if name not in lacking]
    runs = [one.result() for _, one in pending]
    not_done = [name for name in scenario.cases or {} if name not in whole]
    return CaseRuns(scenario.lift.title, scenario.text, runs, left_out, not_done, known.taken_over)


class _NotRunError(Exception):
    """A case cannot be simulated; its text says why."""


def _itself(scenario: Scenario) -> Scenario:
    return scenario


def _note(recording: Recording) -> dict[str, Any]:
    """What is kept of a recording."""
    metrics = recording.metrics()
    begins = {step: begin for step, (begin, _) in spans(recording).items()}
    return {"peaks": {name: metrics[name] for name in PEAKS if name in metrics}, "begins": begins}


def _moment(scenario: Scenario, name: str, given: Future[CaseRun]) -> float:
    """When the ropes of a case are cut [s], by the plan as the lift as it is given follows it.

    Raises:
        _NotRunError: If that is never.
    """
    case = (scenario.cases or {})[name]
    if case.at is not None:
        return case.at
    if case.at_step is None:
        raise _NotRunError(_NO_TIME)
    begin = given.result().begins.get(case.at_step)
    if begin is None:
        raise _NotRunError(f"the lift as it is given does not come to '{case.at_step}'")
    return begin + (case.after or 0.0)


def _lengths(
    scenario: Scenario, base: Scenario, name: str, time: float | None, tell: Callable[[str], None]
) -> Iterator[dict[str, float]]:
    """By how much slings are longer in each pattern of a case of tolerances [m].

    Raises:
        _NotRunError: If there is none.
    """
    question = Statics(base)
    given = settled(question, time, State(name, "", "none", 0.0))
    if given.rest is None:
        raise _NotRunError(f"patterns are looked for at rest, and there is no equilibrium: {given.cause}")
    found = lengths_off(scenario, name, (question, given, time), tell)
    if not found.patterns:
        when = "the end of the lift" if time is None else f"{time:g} s"
        raise _NotRunError(
            f"no sling with a tolerance bears anything at {when}, or lengths change no tension then; "
            "'--time' names another moment"
        )
    yield from map(found.longer, found.patterns)
