"""A run that is held against the limits of its lift, one of many whose recordings nobody keeps."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Self

from gantline.checks import Check, Outcome, check_recording, failed_names, governing, outcome_of, verdict_of
from gantline.results.file.saved_json import list_in, number_in, object_of, text_in
from gantline.results.recording import Recording
from gantline.scenario import Scenario, ScenarioError
from gantline.simulation import Simulation, SimulationError

__all__ = ["HeldRun"]


def _why_not(error: ScenarioError) -> dict[str, Any]:
    """Why a lift cannot start; of slings alone that are too short for it the one that lacks most."""
    if not all(problem.short > 0.0 for problem in error.problems):
        return {"cause": error.problems[0].message}
    worst = max(error.problems, key=lambda problem: problem.short)
    count = len(error.problems)
    head = f"{count} slings are too short for the start, most of all " if count > 1 else ""
    return {"cause": head + worst.message, "short": worst.short}


@dataclass(frozen=True, kw_only=True)
class HeldRun:
    """What one run of many came to.

    Attributes:
        time: Simulated time that it got to [s].
        checks: Its checks.
        warnings: Of lift file and run, sentences.
        cause: Why it could not start or not go on, in one sentence; empty where it did.
        starts: Whether it could start.
        short: By how much a sling is too short for the start, the one that lacks most, where a lower hook
            helps [m]; 0 where none is.
    """

    time: float = 0.0
    checks: Sequence[Check] = ()
    warnings: Sequence[str] = ()
    cause: str = ""
    starts: bool = True
    short: float = 0.0

    @classmethod
    def of(
        cls,
        lift: Callable[[], Scenario],
        overrides: Mapping[str, Any],
        *,
        goes_on: Callable[[], bool],
        note: Callable[[Recording], dict[str, Any]] = lambda _: {},
        through: Callable[[Simulation, Callable[[], Self]], Self] = lambda _, run: run(),
        **known: Any,
    ) -> Self:
        """Simulate a lift from its start to its end.

        Args:
            lift: Makes it; what is wrong with it then is why it could not start.
            overrides: Settings of `simulate`.
            goes_on: Whether to go on; asked about ten times a second.
            note: What else to keep of its recording, attributes of a class made of this one by name.
            through: Is given what is ready to run and what runs it, and gives the run: that one, or one which
                it knows. Not asked of a lift that cannot start.
            known: Further attributes of such a class.
        """
        try:
            simulation = Simulation(lift(), **overrides)
        except ScenarioError as error:
            return cls(starts=False, **_why_not(error), **known)
        return through(simulation, partial(cls._run, simulation, goes_on, note, known))

    @classmethod
    def _run(
        cls,
        simulation: Simulation,
        goes_on: Callable[[], bool],
        note: Callable[[Recording], dict[str, Any]],
        known: Mapping[str, Any],
    ) -> Self:
        try:
            recording = simulation.run(on_progress=lambda _: goes_on())
        except SimulationError as stop:
            checks = tuple(check_recording(stop.recording))
            return cls(time=stop.time, checks=checks, cause=str(stop), **note(stop.recording), **known)
        return cls(
            time=float(recording.time[-1]),
            checks=tuple(check_recording(recording)),
            warnings=tuple(str(one) for one in recording.attributes.get("warnings") or ()),
            **note(recording),
            **known,
        )

    @property
    def outcome(self) -> Outcome:
        """Go or no-go; a lift that cannot start or go on is none."""
        return Outcome.NO_GO if self.cause else outcome_of(self.checks)

    @property
    def governing(self) -> Check | None:
        """The check that uses most of its limit; None where there is none with a limit."""
        return governing(self.checks)

    @property
    def failed(self) -> tuple[str, ...]:
        """Names of the checks that failed."""
        return failed_names(self.checks)

    @property
    def used(self) -> float:
        """Largest share of a limit that is used [1]; infinite of what failed without a number."""
        check = self.governing
        if self.cause or (check is not None and check.utilisation is None):
            return math.inf
        return 0.0 if check is None or check.utilisation is None else check.utilisation

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        check = self.governing
        return {
            "outcome": self.outcome.value,
            "time": self.time,
            "starts": self.starts,
            "short": self.short,
            "cause": self.cause,
            "failed": list(self.failed),
            "governing": None
            if check is None
            else {"check": check.name, "element": check.element, "utilisation": check.utilisation},
            "verdict": "" if self.cause else verdict_of(self.checks),
            "warnings": list(self.warnings),
            "checks": [one.to_json() for one in self.checks],
        }

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Read what `to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        return cls(
            time=number_in(document, "time"),
            checks=tuple(Check.from_json(object_of(one)) for one in list_in(document, "checks")),
            warnings=tuple(str(one) for one in list_in(document, "warnings")),
            cause=text_in(document, "cause"),
            starts=document.get("starts") is True,
            # Files from before there was the word say nothing of it.
            short=number_in(document, "short") if "short" in document else 0.0,
            **cls._more_in(document),
        )

    @classmethod
    def _more_in(cls, document: Mapping[str, Any]) -> dict[str, Any]:
        """Further attributes of a class made of this one, from its JSON object.

        Raises:
            ValueError: If there are none.
        """
        return {}
