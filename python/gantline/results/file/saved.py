"""What was asked of a lift beside its recording: cases, seas, its equilibrium with its motions, a lost load.

`gantline cases LIFT -o DIR` writes `cases.json`, and with `--simulate` `case_runs.json`; `gantline seas LIFT
-o DIR` writes `seas.json`, and `gantline statics LIFT -o DIR` `equilibrium.nc` and with `--lost LOAD`
`lost_load.json`. A report in the same folder shows them. Each names the lift file that it was made from, so
that one of another lift, or of an older file, is told apart.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

from gantline.arguments import needed
from gantline.results.file.saved_case_runs import SavedCaseRuns
from gantline.results.file.saved_json import list_in, number_in, object_of, text_in
from gantline.results.file.saved_seas import SavedSeas
from gantline.results.recording import Recording, open_recording

_T = TypeVar("_T")
_J = TypeVar("_J", "SavedCases", "SavedLostLoad", SavedCaseRuns, SavedSeas)

__all__ = [
    "CASES",
    "CASE_RUNS",
    "EQUILIBRIUM",
    "FILES_BESIDE",
    "KEPT_CASE_RUNS",
    "LOSSES",
    "LOST_LOAD",
    "QUANTITIES",
    "SEAS",
    "SEA_RUNS",
    "WORST_OF_LOSSES",
    "Beside",
    "SavedCase",
    "SavedCases",
    "SavedLostLoad",
    "SavedSwing",
    "SavedWorst",
    "beside_of",
    "digest_of",
    "read_beside",
]

#: Names of the files.
CASES = "cases.json"
CASE_RUNS = "case_runs.json"
KEPT_CASE_RUNS = "case_runs.jsonl"
EQUILIBRIUM = "equilibrium.nc"
LOST_LOAD = "lost_load.json"
SEAS = "seas.json"
SEA_RUNS = "seas_runs.jsonl"
FILES_BESIDE = (CASES, CASE_RUNS, EQUILIBRIUM, LOST_LOAD, SEAS)

#: Quantities of a lift at rest, each with the unit and decimals in which people read it.
QUANTITIES: dict[str, tuple[str, int]] = {
    "sling_tension": ("kN", 1),
    "smallest_sling_tension": ("kN", 1),
    "rope_tension": ("kN", 1),
    "hook_load": ("kN", 1),
    "hoist_load": ("kN", 1),
    "load_tilt": ("deg", 2),
    "sheave_travel": ("m", 3),
    "rod_out": ("m", 3),
    "hinge_force": ("kN", 1),
}
#: What losses of sheaves do, in words.
LOSSES: dict[str, str] = {"none": "", "forward": "slip along", "backward": "slip against"}
#: What numbers of cases are of which some have such bounds.
WORST_OF_LOSSES = (
    "of sheaves with losses the worst of three equilibria: without losses, all slip along, all slip against"
)

_OF_ANOTHER = "is of another lift file than the recording, or of that file before or after it was edited"
_INTERRUPTED = "interrupted, not all of it was worked out"
_LARGEST = 50_000_000  # bytes of a file that is read


def digest_of(scenario: str) -> str:
    """SHA-256 of the text of a lift file."""
    return hashlib.sha256(scenario.encode("utf-8")).hexdigest()


@dataclass(frozen=True)
class SavedCase:
    """One case.

    Attributes:
        name: Its name; empty for the lift as it is given.
        states: How many equilibria were asked for.
        troubles: What is wrong in them, each once: that Ctrl-C kept some from being asked for, no start or no
            equilibrium and why, instability, loads that stand and should hang, failed checks.
        remarks: What it asks for in vain, and that it changes nothing.
        has_losses: Whether some of these equilibria are bounds of what losses of sheaves do.
        partly_stands: Loads that stand with a part of their weight in the first of them, in words.
        slides: Loads that stand where a check fails, on contacts whose friction is left out.
    """

    name: str
    states: int
    troubles: Sequence[str]
    remarks: Sequence[str] = ()
    has_losses: bool = False
    partly_stands: Sequence[str] = ()
    slides: Sequence[str] = ()


@dataclass(frozen=True)
class SavedWorst:
    """The worst that happens to one element in all cases.

    Attributes:
        quantity: A key of `QUANTITIES`.
        element: Sling, rope, hook, load or moving sheave.
        given: Its worst value in the lift as it is given, whatever losses do [SI]; None where it has none.
        value: The worst value [SI].
        case: The case that has it; empty for the lift as it is given.
        label: The variant of that, and what losses do in it.
    """

    quantity: str
    element: str
    given: float | None
    value: float
    case: str
    label: str


@dataclass(frozen=True)
class SavedCases:
    """What `gantline cases` found.

    Attributes:
        scenario_sha256: Of the lift file's text.
        is_sound: Whether every state can start and has a stable equilibrium, what should hang does, and no
            check failed.
        cases: The cases in the order of the file, the lift as it is given first.
        worst: The worst of each element.
    """

    scenario_sha256: str
    is_sound: bool
    cases: Sequence[SavedCase]
    worst: Sequence[SavedWorst]

    @classmethod
    def from_json(cls, document: Any) -> SavedCases:
        """Read what `CasesResult.to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        whole = object_of(document)
        cases = {one.name: one for one in (_case(object_of(one)) for one in list_in(whole, "cases"))}
        # Files from before there was the word say nothing of it.
        for name in list_in(whole, "not_done") if "not_done" in whole else []:
            case = cases.get(str(name), SavedCase(str(name), 0, ()))
            cases[case.name] = replace(case, troubles=(_INTERRUPTED, *case.troubles))
        return cls(
            text_in(whole, "scenario_sha256"),
            whole.get("sound") is True,
            list(cases.values()),
            [_worst(object_of(one)) for one in list_in(whole, "worst")],
        )

    def worst_of(self, quantity: str) -> SavedWorst | None:
        """The worst of a quantity over all elements: the largest, of the smallest tension the smallest."""
        found = [one for one in self.worst if one.quantity == quantity]
        if quantity == "smallest_sling_tension":
            return min(found, key=lambda one: one.value, default=None)
        return max(found, key=lambda one: abs(one.value), default=None)


@dataclass(frozen=True)
class SavedSwing:
    """How a vessel swings that has lost a load.

    Attributes:
        vessel: Its name.
        towards: The way, in words.
        farthest: Angle of the first swing [rad]; None where nothing stops it.
        freeboard: There [m].
        ratio: A2 over A1.
        at_design: The same with the design weight of the load [1]; None where that is no more, or not known.
    """

    vessel: str
    towards: str
    farthest: float | None
    freeboard: float | None
    ratio: float
    at_design: float | None = None


@dataclass(frozen=True)
class SavedLostLoad:
    """What `gantline statics --lost` found.

    Attributes:
        scenario_sha256: Of the lift file's text.
        is_sound: Whether all vessels are dry with the load, come back, and rest without it.
        load: Its name.
        time: When it is lost [s].
        swings: Of the vessels that turn.
        flooded: Openings under water already with the load on, of all vessels.
    """

    scenario_sha256: str
    is_sound: bool
    load: str
    time: float
    swings: Sequence[SavedSwing]
    flooded: Sequence[str] = ()

    @classmethod
    def from_json(cls, document: Any) -> SavedLostLoad:
        """Read what `LostLoad.to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        whole = object_of(document)
        return cls(
            text_in(whole, "scenario_sha256"),
            whole.get("sound") is True,
            text_in(whole, "load"),
            number_in(whole, "time"),
            [_swing(object_of(one)) for one in list_in(whole, "swings")],
            # Files from before there was the word say nothing of it.
            [str(one) for one in list_in(whole, "flooded")] if "flooded" in whole else [],
        )


@dataclass(frozen=True)
class Beside:
    """What lies beside a recording and belongs to it.

    Attributes:
        equilibrium: The lift at rest, with the attributes `statics` and `modes`; None where there is none.
        cases: Its cases; None where there are none.
        lost_load: A load that it loses; None where nobody asked.
        seas: The seas in which it was simulated; None where nobody asked.
        case_runs: Its cases, simulated; None where nobody asked.
        left_out: Why a file that is there is not shown, a sentence each.
    """

    equilibrium: Recording | None = None
    cases: SavedCases | None = None
    lost_load: SavedLostLoad | None = None
    seas: SavedSeas | None = None
    case_runs: SavedCaseRuns | None = None
    left_out: Sequence[str] = ()


def beside_of(given: Beside | None) -> Beside | None:
    """What lies beside a recording, as it is.

    Raises:
        TypeError: If it is something else, such as a folder.
    """
    right = "`beside` is found in the folder of the report where it is not given"
    return None if given is None else needed(given, Beside, "what lies beside a recording", right)


def read_beside(folder: Path, recording: Recording) -> Beside:
    """Read what lies in a folder and belongs to a recording of the same lift file."""
    own = digest_of(str(recording.attributes.get("scenario", "")))
    left_out: list[str] = []

    def belonging(
        name: str, command: str, read: Callable[[Path], _T], digest: Callable[[_T], str]
    ) -> _T | None:
        path = folder / name
        try:
            if not path.is_file():
                return None
            if path.stat().st_size > _LARGEST:
                raise ValueError(f"is larger than {_LARGEST // 1_000_000} MB")
            found = read(path)
        except (OSError, ValueError) as problem:
            left_out.append(f"{name}: {problem}")
            return None
        if digest(found) == own:
            return found
        left_out.append(f"{name}: {_OF_ANOTHER}; '{command}' renews it, 'gantline run' the recording")
        return None

    def of_json(name: str, command: str, kind: type[_J]) -> _J | None:
        return belonging(name, command, _reader(kind.from_json, command), lambda found: found.scenario_sha256)

    cases = of_json(CASES, "gantline cases", SavedCases)
    equilibrium = belonging(
        EQUILIBRIUM,
        "gantline statics",
        _read_equilibrium,
        lambda found: digest_of(str(found.attributes.get("scenario", ""))),
    )
    lost = of_json(LOST_LOAD, "gantline statics --lost", SavedLostLoad)
    seas = of_json(SEAS, "gantline seas", SavedSeas)
    case_runs = of_json(CASE_RUNS, "gantline cases --simulate", SavedCaseRuns)
    return Beside(equilibrium, cases, lost, seas, case_runs, left_out)


def _reader(read: Callable[[Any], _T], command: str) -> Callable[[Path], _T]:
    """What reads a file of JSON that a command has written."""

    def from_file(path: Path) -> _T:
        try:
            return read(json.loads(path.read_text(encoding="utf-8")))
        except (RecursionError, ValueError) as problem:
            raise ValueError(f"is not what '{command}' writes ({problem})") from None

    return from_file


def _read_equilibrium(path: Path) -> Recording:
    found = open_recording(path)
    if not isinstance(found.attributes.get("statics"), dict) or not len(found.time):
        raise ValueError("holds no equilibrium of 'gantline statics'")
    modes = found.attributes.get("modes")
    if not isinstance(modes, list) or not all(isinstance(mode, dict) for mode in modes):
        raise ValueError("holds no motions of 'gantline statics'")
    return found


def _swing(given: Mapping[str, Any]) -> SavedSwing:
    farthest, freeboard, at_design = (
        None if given.get(name) is None else number_in(given, name)
        for name in ("farthest", "freeboard", "ratio_at_design")
    )
    towards, ratio = text_in(given, "towards"), number_in(given, "ratio")
    return SavedSwing(text_in(given, "vessel"), towards, farthest, freeboard, ratio, at_design)


def _case(given: Mapping[str, Any]) -> SavedCase:
    states = [object_of(one) for one in list_in(given, "states")]
    troubles: list[str] = []
    remarks: list[str] = []
    slides: list[str] = []
    for state in states:
        # Files from before there was the word say nothing of it.
        vain = list_in(state, "in_vain") if "in_vain" in state else []
        remarks += [f"nothing is cut: {one}" for one in vain if isinstance(one, str)]
        if state.get("equilibrium") is not True:
            # Of files from before there was the word, every state could start.
            what = "cannot start" if state.get("starts") is False else "no equilibrium"
            troubles.append(f"{what}: {text_in(state, 'cause')}")
        elif state.get("stable") is not True:
            troubles.append("unstable")
        standing = list_in(state, "stands") if "stands" in state else []
        troubles += [f"{load} stands" for load in standing if isinstance(load, str)]
        troubles += [f"{name} failed" for name in list_in(state, "failed") if isinstance(name, str)]
        sliding = list_in(state, "fails_as_it_slides") if "fails_as_it_slides" in state else []
        slides += [load for load in sliding if isinstance(load, str)]
    if states and all(state.get("changes_nothing") is True for state in states):
        remarks.append("changes nothing")
    remarks += [f"{load} is free to slide there" for load in slides]
    told, said, free = (tuple(dict.fromkeys(each)) for each in (troubles, remarks, slides))
    has_losses = any(state.get("losses") != "none" for state in states)
    # Files from before there was the word say nothing of it.
    partly = list_in(states[0], "partly_stands") if states and "partly_stands" in states[0] else []
    stands = [one for one in partly if isinstance(one, str)]
    return SavedCase(text_in(given, "case"), len(states), told, said, has_losses, stands, free)


def _worst(given: Mapping[str, Any]) -> SavedWorst:
    quantity = text_in(given, "quantity")
    if quantity not in QUANTITIES:
        raise ValueError(f"'{quantity}' is no quantity of cases")
    label = [text_in(given, "variant"), LOSSES.get(text_in(given, "losses"), "")]
    return SavedWorst(
        quantity,
        text_in(given, "element"),
        None if given.get("given") is None else number_in(given, "given"),
        number_in(given, "value"),
        text_in(given, "case"),
        ", ".join(part for part in label if part),
    )
