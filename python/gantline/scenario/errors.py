"""What is wrong with a lift file: problems with their place, and the error that carries them."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

__all__ = [
    "MOST_SHOWN",
    "Doubt",
    "Problem",
    "ScenarioError",
    "StartError",
    "closest",
    "is_or_are",
    "join_path",
    "nearest",
    "shorten",
]

#: Most problems that one message lists.
MOST_SHOWN: Final = 20

#: So many known words that are equally near to an unknown one are no guess.
_TOO_MANY: Final = 4

#: Longest piece of a user's text that a message repeats.
_LONGEST: Final = 60

PathPart = str | int


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong.

    Attributes:
        line: its line, from 1; None for the file as a whole.
        path: its path in the file, empty where it has none.
        sentence: what is wrong, and what would be right.
        step: name of the step of the plan that it is in, empty where it is in none that has a name.
        file: the library in which it is; None of the lift file.
        short: by how much a sling is too short for the start, where a lower hook helps [m].
    """

    line: int | None
    path: str
    sentence: str
    step: str = ""
    file: str | None = None
    short: float = 0.0

    @property
    def message(self) -> str:
        """Path and sentence, the step's name before its place in the plan, which nobody has counted."""
        if not self.path:
            return self.sentence
        named = f"step '{shorten(self.step)}'"
        is_named = not self.step or named in self.sentence
        return f"{self.path}: {self.sentence}" if is_named else f"{named}, {self.path}: {self.sentence}"

    def of(self, source: str) -> str:
        """The problem as one line of a message, behind the name of its file."""
        file = source if self.file is None else self.file
        place = file if self.line is None else f"{file}:{self.line}"
        return f"{place}: {self.message}"


class Doubt(NamedTuple):
    """What a lift file may have and cannot well mean: its path, where one is to blame, and a sentence."""

    path: tuple[PathPart, ...]
    sentence: str


class ScenarioError(ValueError):
    """A lift file cannot be used; ``str()`` is the whole message, one problem per line.

    Attributes:
        source: the file as the user named it.
        problems: every problem found, in the order of the file.
    """

    def __init__(self, source: str, problems: Sequence[Problem]) -> None:
        """Order the problems by line, each one once."""
        unique = dict.fromkeys(problems)
        self.source = source
        self.problems = tuple(sorted(unique, key=lambda one: (one.file or "", one.line or 0)))
        super().__init__(self._message())

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.source, self.problems)

    def _message(self) -> str:
        lines = [problem.of(self.source) for problem in self.problems[:MOST_SHOWN]]
        if len(self.problems) > MOST_SHOWN:
            lines.append(f"{self.source}: and {len(self.problems) - MOST_SHOWN} more")
        return "\n".join(lines)


class StartError(ScenarioError):
    """A lift file that is right as such describes a start that cannot be put together."""


def join_path(path: Sequence[PathPart]) -> str:
    """Path as a message shows it; places in lists count from 1: ``plan[2].speed``."""
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part + 1}]"
        else:
            text += f".{shorten(part)}" if text else shorten(part)
    return text


def shorten(text: str) -> str:
    """A user's text made fit to be repeated in one line of a message."""
    text = " ".join(text.split())
    text = "".join(character if character.isprintable() else "?" for character in text)
    return text if len(text) <= _LONGEST else text[:_LONGEST] + "..."


def closest(word: str, known: Iterable[str]) -> str | None:
    """The known word that is written most like a word, alone ends in it after a dot, or begins with it.

    None if there is no such word, or if many are equally like it.
    """
    by_lower = {name.lower(): name for name in reversed(list(known))}
    in_full = [name for lower, name in by_lower.items() if lower.endswith(f".{word.lower()}")]
    if len(in_full) == 1 and word.lower() not in by_lower:
        return in_full[0]
    of_it = [name for lower, name in by_lower.items() if lower.startswith(f"{word.lower()}.")]
    if of_it and word.lower() not in by_lower:
        return of_it[-1]  # `row1` of `row1.1`, `row1.2`; they are in reverse
    begun = [name for lower, name in by_lower.items() if "_" in word and lower.startswith(f"{word.lower()}_")]
    if begun and word.lower() not in by_lower:
        return begun[-1]  # `sling_angle` of `sling_angle_from_vertical`
    lower = word.lower()[:200]
    near = difflib.get_close_matches(lower, list(by_lower), n=_TOO_MANY, cutoff=0.6)
    alike = {difflib.SequenceMatcher(None, one, lower).ratio() for one in near}
    if len(near) == _TOO_MANY and len(alike) == 1:
        return None  # `rowx` is as near to each of `row1.1`, `row1.2`, ...: to name one were to guess
    return by_lower[near[0]] if near else None


def is_or_are(what: str) -> str:
    """The verb of what a message names: "a sling" is, "the shackles of a sling" are."""
    return "are" if what.partition(" of ")[0].endswith("s") else "is"


def nearest(word: str, known: Iterable[str]) -> str:
    """Second half of a sentence about an unknown word: the closest known one, or all of them if few."""
    known = list(known)
    likely = closest(word, known)
    if likely is not None:
        return f"did you mean '{likely}'?"
    if not known:
        return "there is none"
    listed = ", ".join(f"'{name}'" for name in known[:12])
    return f"known here: {listed}" + (", ..." if len(known) > 12 else "")
