"""Characters of word processors, web pages and other keyboards that YAML takes for letters and people do not.

A no-break space after a colon leaves the line without a value, typographic quotes are no quotes. What the
reader says of that is true and helps nobody, since the line looks right. Within words all of them are fine.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Sequence
from typing import Final, TypeVar

from gantline.scenario.errors import Problem, ScenarioError

__all__ = ["read"]

T = TypeVar("T")

_QUOTES: Final = {
    **dict.fromkeys("\u201c\u201d\u201e\u201f«»", '"'),
    **dict.fromkeys("\u2018\u2019\u201a\u201b‹›", "'"),
}
_COMMENT: Final = re.compile(r"(?:^|\s)#.*")
#: A dash where an entry of a list begins.
_BULLET: Final = re.compile("^\\s*(?:- )*([\u2010-\u2015\u2022\u2212])(?=\\s)")
#: Full-width forms of the characters from `!` to `~`, and how far they are from these.
_WIDE: Final = range(0xFF01, 0xFF5F)
_FROM_WIDE: Final = 0xFEE0
#: Most lines that are read once more without such characters.
_MOST: Final = 10


def read(text: str, source: str, plainly: Callable[[str, str], T]) -> T:
    """What stands in the text of a file.

    Args:
        text: of the file.
        source: the file as messages name it.
        plainly: reads a text of that source, and knows nothing of such characters.

    Raises:
        ScenarioError: What `plainly` says is wrong, with such characters named in place of the problems
            that they alone are the cause of.
    """

    def problems_of(another: str) -> Sequence[Problem]:
        try:
            plainly(another, source)
        except ScenarioError as error:
            return error.problems
        return ()

    try:
        return plainly(text, source)
    except ScenarioError as error:
        raise _named(error, text, problems_of) from None


def _named(error: ScenarioError, text: str, problems_of: Callable[[str], Sequence[Problem]]) -> ScenarioError:
    lines = text.split("\n")
    problems, found, seen = tuple(error.problems), list[Problem](), set[int]()
    while len(seen) < _MOST and (suspects := _suspects(lines, problems) - seen):
        number = min(suspects)
        seen.add(number)
        line = lines[number - 1]
        for plain, sentence in _mended(line):
            tried = [*lines[: number - 1], plain, *lines[number:]]
            left = tuple(problems_of("\n".join(tried)))
            is_better = {_place(one) for one in problems} - {_place(one) for one in left}
            if is_better and not any(one.line == number and not one.path for one in left):
                found.append(Problem(number, "", sentence))
                lines, problems = tried, left
                break
    return type(error)(error.source, [*found, *problems]) if found else error


def _place(problem: Problem) -> tuple[int | None, str]:
    return problem.line, problem.path


def _suspects(lines: Sequence[str], problems: Sequence[Problem]) -> set[int]:
    """Lines with such characters that have a problem, or come last before one, from 1."""
    odd = [number for number, line in enumerate(lines, start=1) if _odd(line) is not None]
    blamed = set[int]()
    for line in (one.line or len(lines) for one in problems):
        blamed.update(odd[at] for at in [sum(number <= line for number in odd) - 1] if at >= 0)
    return blamed


def _instead(character: str) -> str | None:
    """What is written in place of a character; None of one that may stand."""
    if character.isascii():
        return None
    if character in _QUOTES:
        return _QUOTES[character]
    if ord(character) in _WIDE:
        return chr(ord(character) - _FROM_WIDE)
    kind = unicodedata.category(character)
    if kind == "Nd":
        return str(unicodedata.digit(character))
    return {"Zs": " ", "Cf": ""}.get(kind)


def _odd(line: str) -> tuple[int, str] | None:
    """Where the first such character of a line stands, and what is written instead; None without one."""
    return next(_all_odd(_COMMENT.sub("", line)), None)


def _all_odd(line: str) -> Iterator[tuple[int, str]]:
    if (bullet := _BULLET.match(line)) is not None:
        yield bullet.start(1), "-"
    for at, character in enumerate(line):
        if (instead := _instead(character)) is not None:
            yield at, instead


def _plain(line: str) -> str:
    """A line without such characters."""
    characters = list(line)
    for at, instead in _all_odd(line):
        characters[at] = instead
    return "".join(characters)


def _mended(line: str) -> Iterator[tuple[str, str]]:
    """A line as it may be right, and what is to be said to that."""
    yield _plain(line), _sentence(line)
    if _instead(line[0]) == " ":  # at the left edge a blank would be one too many
        yield _plain(line).lstrip(), _sentence(line).replace("write a blank", "take it out")


def _sentence(line: str) -> str:
    at, instead = _odd(line) or (0, "")
    character = line[at]
    name = unicodedata.name(character, "character without a name").lower()
    what = f"(U+{ord(character):04X}, {name}) stands in column {at + 1}"
    if instead == "":
        return f"an invisible character {what}: take it out"
    if instead == " ":
        return f"what looks like a blank and is none {what}: write a blank"
    if character in _QUOTES:
        quote = "'\"'" if instead == '"' else '"\'"'
        return f"'{character}' {what}: quotes are written {quote}, and few texts need any"
    return f"'{character}' {what}: write '{instead}'"
