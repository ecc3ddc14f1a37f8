"""Runs of a lift in its seas, each in a file as it ends, from which a search that was cut off goes on.

The first line says what they are runs of; each further one is one run. Each line is one JSON object. A last
line that was cut off itself, as by a power cut, is left out.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from threading import Lock

from gantline.results.file.saved import digest_of
from gantline.results.file.saved_json import number_in, object_of, text_in
from gantline.simulation import Simulation
from gantline.study.sea import NoSeaError, Sea, SeaRecord
from gantline.version import version

__all__ = ["KeptRuns"]

#: What differs, by the entry of the first line that tells it, the most telling first.
_OTHERS = {
    "gantline": "another version of gantline",
    "lift_sha256": "another state of the lift file",
    "waves": "other waves of the lift",
    "simulated_sha256": "other files that the lift names, or other settings",
}
#: Digits by which a sea is known: a height has others as one of four than as one of seven, by rounding.
_DIGITS = 12


class KeptRuns:
    """The file of the runs of one lift.

    Args:
        path: The file; there need not be one yet, and there is none before the first run has ended.
        simulation: The lift in its own seas, ready to run.
        waves: Name of the waves that are varied.
        anew: Whether to begin a new file where there is one.

    Raises:
        NoSeaError: If the file is of another lift, or of nothing of the kind.
        OSError: If it cannot be read.
    """

    def __init__(self, path: Path, simulation: Simulation, waves: str, *, anew: bool) -> None:
        self.path = path
        self.taken_over = 0
        self._of = _description(simulation, waves)
        self._known: dict[tuple[str, ...], SeaRecord] = {}
        self._lock = Lock()
        #: Bytes of the file that stay; none of one that is begun anew.
        self._whole = 0
        if not anew and path.exists():
            self._read()

    def find(self, sea: Sea, number: int) -> SeaRecord | None:
        """A record of a sea, if the file has it; counted as taken over."""
        known = self._known.get(_key(sea.height, sea.period, sea.direction, number))
        if known is not None:
            with self._lock:
                self.taken_over += 1
        return known

    def keep(self, sea: Sea, record: SeaRecord) -> None:
        """Write a run that has ended; threads may do so side by side.

        Raises:
            OSError: If it cannot be written.
        """
        place = {"height": sea.height, "period": sea.period, "direction": sea.direction}
        with self._lock:
            lines = [place | record.to_json()] if self._whole else [self._of, place | record.to_json()]
            text = "".join(json.dumps(line, allow_nan=False) + "\n" for line in lines).encode("utf-8")
            with self.path.open("r+b" if self._whole else "wb") as file:
                # Over what was cut off behind the last whole line.
                file.seek(self._whole)
                file.write(text)
                file.truncate()
            self._whole += len(text)

    def _read(self) -> None:
        """Take in what the file has.

        Raises:
            NoSeaError: As of the class.
        """
        lines = self.path.read_bytes().splitlines(keepends=True)
        for number, line in enumerate(lines, 1):
            if not line.endswith(b"\n"):
                break
            try:
                found = object_of(json.loads(line))
                if number == 1:
                    self._compare({name: text_in(found, name) for name in _OTHERS})
                else:
                    place = [number_in(found, name) for name in ("height", "period", "direction")]
                    record = SeaRecord.from_json(found)
                    self._known[_key(*place, record.number)] = record
            except NoSeaError:
                raise
            except ValueError as error:
                raise NoSeaError("kept", f"{self.path}:{number}: is no run in a sea: {error}") from None
            self._whole += len(line)

    def _compare(self, found: Mapping[str, str]) -> None:
        for name, other in _OTHERS.items():
            if found[name] != self._of[name]:
                raise NoSeaError("kept", f"{self.path}: its runs are of {other}; all have to be run anew")


def _description(simulation: Simulation, waves: str) -> dict[str, str]:
    """What runs are of: with the same description they are the same to the last digit."""
    assembly = simulation.assembly
    parts = [assembly.document_text(), json.dumps([simulation.settings, assembly.rig])]
    return {
        "gantline": version(),
        "lift_sha256": digest_of(simulation.scenario.text),
        "waves": waves,
        "simulated_sha256": digest_of("\n".join(parts)),
    }


def _key(*place: float) -> tuple[str, ...]:
    return tuple(f"{value:.{_DIGITS}g}" for value in place)
