"""Runs that are many, each in a file as it ends, from which a study that was cut off goes on.

The first line says what they are runs of; each further one is one run. Each line is one JSON object. A last
line that was cut off itself, as by a power cut, is left out.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock
from typing import Any, BinaryIO, Generic, TypeVar

from gantline.locked import InUseError, locked
from gantline.results.file.saved import digest_of
from gantline.results.file.saved_json import object_of, text_in
from gantline.simulation import Simulation
from gantline.study.held_run import HeldRun
from gantline.version import version

__all__ = ["KeptRuns", "KeptRunsError", "RunKind", "RunsInUseError", "kept_runs", "simulated_digest"]

_R = TypeVar("_R", bound=HeldRun)

#: Where a run belongs among all of a study.
Place = Mapping[str, float | str]

#: What differs, by the entry of the first line that tells it, the most telling first.
_OTHERS = {
    "gantline": "another version of gantline",
    "lift_sha256": "another state of the lift file",
    "waves": "other waves of the lift",
    "simulated_sha256": "other files that the lift names, or other settings",
}
#: Digits by which a number is known: a height has others as one of four than as one of seven, by rounding.
_DIGITS = 12


class KeptRunsError(ValueError):
    """A study cannot go on from a file of runs."""


class RunsInUseError(KeptRunsError):
    """Another study writes its runs to the file."""


@dataclass(frozen=True)
class RunKind(Generic[_R]):
    """What runs there are in a file.

    Attributes:
        name: What one is called.
        place: What tells where each belongs: names of entries, with what reads them.
        read: Makes one of its line.
    """

    name: str
    place: Mapping[str, Callable[[Mapping[str, Any], str], float | str]]
    read: Callable[[Mapping[str, Any]], _R]


@dataclass
class KeptRuns(Generic[_R]):
    """The runs of one lift, of which each is made once where there is a file for them.

    Attributes:
        taken_over: How many runs were taken from the file.
    """

    _file: BinaryIO | None
    _of: Mapping[str, str]
    _known: Mapping[tuple[str, ...], _R] = field(default_factory=dict)
    #: Bytes of the file that stay; none of one that is begun anew.
    _whole: int = 0
    _lock: Lock = field(default_factory=Lock)
    taken_over: int = 0

    def made(self, place: Place, make: Callable[[], _R], goes_on: Callable[[], bool]) -> _R:
        """A run: taken over if the file has it, or made and written; threads may do so side by side.

        Args:
            place: Where it belongs.
            make: Makes it.
            goes_on: Whether it has not been given up, asked once it has ended.

        Raises:
            OSError: If it cannot be written.
        """
        known = self._known.get(_key(place))
        if known is not None:
            with self._lock:
                self.taken_over += 1
            return known
        run = make()
        # A run that was given up ends early: nobody is to take it for a whole one.
        if self._file is not None and goes_on():
            self._keep(self._file, {**place, **run.to_json()})
        return run

    def _keep(self, file: BinaryIO, line: Mapping[str, Any]) -> None:
        with self._lock:
            lines = [line] if self._whole else [self._of, line]
            text = "".join(json.dumps(one, allow_nan=False) + "\n" for one in lines).encode("utf-8")
            # Over what was cut off behind the last whole line, or over all of what is begun anew.
            file.seek(self._whole)
            file.write(text)
            file.truncate()
            file.flush()
            self._whole += len(text)


@contextmanager
def kept_runs(
    path: Path | None, kind: RunKind[_R], simulation: Simulation, *, anew: bool, **more: str
) -> Iterator[KeptRuns[_R]]:
    """The file of the runs of a lift, which nobody else writes to meanwhile.

    Args:
        path: The file; there need not be one yet, and there is none if no run has ended. None for none.
        kind: What runs it has.
        simulation: The lift, ready to run.
        anew: Whether to begin a new file where there is one.
        more: What else they are runs of, as `waves`.

    Raises:
        RunsInUseError: If somebody else writes to it.
        KeptRunsError: If the file is of another lift, or of nothing of the kind.
        OSError: If it cannot be read and written.
    """
    of = {
        "gantline": version(),
        "lift_sha256": digest_of(simulation.scenario.text),
        **more,
        "simulated_sha256": simulated_digest(simulation),
    }
    if path is None:
        yield KeptRuns(None, of)
        return
    try:
        with locked(path) as file:
            yield KeptRuns(file, of) if anew else _read(path, file, kind, of)
    except InUseError:
        raise RunsInUseError(f"{path}: another study is under way that writes its runs here") from None


def simulated_digest(simulation: Simulation) -> str:
    """Of what is simulated: with the same one, runs are the same to the last digit."""
    assembly = simulation.assembly
    return digest_of("\n".join([assembly.document_text(), json.dumps([simulation.settings, assembly.rig])]))


def _read(path: Path, file: BinaryIO, kind: RunKind[_R], of: Mapping[str, str]) -> KeptRuns[_R]:
    """What a file has.

    Raises:
        KeptRunsError: As of `kept_runs`.
    """
    known: dict[tuple[str, ...], _R] = {}
    whole = 0
    for number, line in enumerate(file.read().splitlines(keepends=True), 1):
        if not line.endswith(b"\n"):
            break
        try:
            found = object_of(json.loads(line))
            if number == 1:
                _compare(path, {name: text_in(found, name) for name in of}, of)
            else:
                place = {name: entry_in(found, name) for name, entry_in in kind.place.items()}
                known[_key(place)] = kind.read(found)
        except KeptRunsError:
            raise
        except ValueError as error:
            raise KeptRunsError(f"{path}:{number}: is no {kind.name}: {error}") from None
        whole += len(line)
    return KeptRuns(file, of, known, whole)


def _compare(path: Path, found: Mapping[str, str], of: Mapping[str, str]) -> None:
    for name, other in _OTHERS.items():
        if name in of and found[name] != of[name]:
            raise KeptRunsError(f"{path}: its runs are of {other}; all have to be run anew")


def _key(place: Place) -> tuple[str, ...]:
    return tuple(one if isinstance(one, str) else f"{one:.{_DIGITS}g}" for one in place.values())
