"""What is wrong with a text that is not YAML, in words of who wrote it and not of the parser."""

from __future__ import annotations

import re
from typing import Any, Final

from ruamel.yaml.error import MarkedYAMLError

from gantline.scenario.errors import Problem, shorten
from gantline.units import DIMENSIONS

__all__ = ["problem_of"]

_CLOSING: Final = {"[": "]", "{": "}"}
_ONE_COLUMN: Final = "keys of one mapping begin in one column"
#: How a thing with a name begins, in a mapping.
_NAMED: Final = re.compile(r"[\w.-]+:(?:\s|$)")
_ENTRY: Final = "an entry of a list begins with '- ', a dash and a blank"
#: Braces behind a name without a ':' and a blank.
_OPENED: Final = re.compile(r"\s*(?:- )?([\w.-]+)\s*:?\{")
#: Several keys in one line without braces: what stands before them, and the first of them.
_SEVERAL_KEYS: Final = re.compile(
    r"\s*((?:- )?(?:[\w.-]+:\s+(?=[\w.-]+:\s))?)([\w.-]+:\s+[^,'\"]+),\s*[\w.-]+:\s"
)
#: A value behind which a comment begins, where a comma or bracket would be.
_CUT_OFF: Final = re.compile(r"[^\s,{\[]\s+#")
#: A value of words, up to a ':' within it.
_OF_WORDS: Final = re.compile(r"\b(?:title|remark|step|rule|number|source|origin|name)\s*:\s+[^,:]*$")
_UNITS: Final = frozenset(unit for units in DIMENSIONS.values() for unit in units if unit)
#: Where a line ends in YAML.
_NEW_LINE: Final = re.compile("\r\n|[\r\n\x85\u2028\u2029]")


def problem_of(error: MarkedYAMLError, text: str) -> Problem:
    """The problem for which the parser gave up, with the line in which something has to be changed.

    Args:
        error: What the parser says.
        text: The whole text.
    """
    at = error.problem_mark or error.context_mark
    found, context = str(error.problem or error.context or "unknown"), str(error.context or "")
    if at is None:
        return Problem(None, "", _as_found(found))
    # Where that begins within which the parser was; brackets, quotes and keys are to be mended there.
    begin = error.context_mark or at
    if context.endswith(("flow sequence", "flow mapping")):
        return _in_brackets(found, begin, at, text)
    if "quoted scalar" in context and "escape" not in found:
        return Problem(begin.line + 1, "", "a quote opens here and is not closed")
    if context.endswith("simple key"):
        key = _shown(text, begin)
        return Problem(begin.line + 1, "", f"'{key}' has no ':'; a line is 'key: value', and {_ENTRY}")
    is_behind = found.startswith("mapping values") or found.endswith("mapping start>'")
    if is_behind and (above := _without_colon(at, text)) is not None:
        line, words = above
        return Problem(line, "", f"'{words}' has no ':'; a line is 'key: value', and {_ENTRY}")
    return Problem(at.line + 1, "", _in_line(found, context, at, text))


def _without_colon(at: Any, text: str) -> tuple[int, str] | None:
    """The line above a place and its words, where these begin in the same column and lack a ':'."""
    lines = _NEW_LINE.split(text[: at.index])
    indent = len(lines[-1]) - len(lines[-1].lstrip())
    for number in range(len(lines) - 1, 0, -1):
        words = re.sub(r"(^|\s)#.*", "", lines[number - 1]).rstrip()
        if words:
            is_beside = len(words) - len(words.lstrip()) == indent
            is_text = ":" not in words and not words.lstrip().startswith("-")
            return (number, shorten(words.strip())) if is_beside and is_text else None
    return None


def _in_line(found: str, context: str, at: Any, text: str) -> str:
    """What is wrong at a place, where the line of that place is the one to change."""
    rest = _shown(text, at)
    if found.startswith("found character '\\t'"):
        return "a tab stands here; indent and part words with blanks"
    if found.endswith("that cannot start any token"):
        return f"a text that begins with '{rest[:1]}' is put into quotes: \"{rest}\""
    if found.startswith("found unknown escape"):
        return f"'\\{rest[:1]}' means nothing between double quotes; use single ones"
    if found.startswith("mapping values"):
        if ":" in _before(text, at):
            return _second_colon(_before(text, at) + rest)
        return f"the line is indented more than the one above, which has its value already; {_ONE_COLUMN}"
    if found.endswith(("found '}'", "found ']'")):
        return f"'{rest[:1]}' closes what nothing opens"
    if found.endswith("mapping start>'") and "end>" in found:
        return (
            f"the line begins in column {at.column + 1}, and nothing to which it could belong; {_ONE_COLUMN}"
        )
    if found.endswith("'<scalar>'"):
        if (right := _unit_behind_a_list(_before(text, at), rest)) is not None:
            return right
        return f"'{rest}' stands behind a value; a quote is not closed, here or above, or ends too early"
    if context.endswith("collection"):
        of_mapping = "; named things of a mapping have none" if _NAMED.match(rest) else ""
        return f"'{rest}' stands in a list; {_ENTRY}{of_mapping}"
    if found.startswith("sequence entries"):
        return "'- ' begins an entry of a list, which stands in a line of its own"
    if "end>, but found" in found:
        return f"'{rest}' stands where a key is needed"
    if found.startswith("expected '<document start>'"):
        return f"'{rest}' is no part of what begins above; {_ONE_COLUMN}"
    return _as_found(found)


def _in_brackets(found: str, begin: Any, at: Any, text: str) -> Problem:
    """What is wrong in a list or mapping that a bracket opened: one that is not closed, or a comma."""
    opening = text[begin.index]
    closing = _CLOSING[opening]
    if at.line > begin.line:
        sentence = f"'{opening}' opens here and is not closed before line {at.line + 1}"
        missing = f"a '{closing}' is missing, or a ',' at the end of a line"
        if _CUT_OFF.search(_NEW_LINE.split(text[begin.index :], maxsplit=1)[0]):
            missing += "; ' #' begins a comment, and a text with it stands in quotes"
        return Problem(begin.line + 1, "", f"{sentence}: {missing}")
    if (right := _unit_behind_a_list(_before(text, at), _shown(text, at))) is not None:
        return Problem(at.line + 1, "", right)
    # The parser sees that a comma is missing only at the colon behind the next key.
    key = re.findall(r"[^\s,:{\[]*\s*$", _before(text, at))[0] if found.endswith("got ':'") else ""
    rest = shorten(key + _shown(text, at)) or "the end"
    sentence = f"a ',' or '{closing}' is missing before '{rest}'"
    if key and _OF_WORDS.search(_before(text, at)):
        sentence += "; a text with a ':' in it stands in quotes"
    return Problem(at.line + 1, "", sentence)


def _second_colon(line: str) -> str:
    """What is wrong with a line in which something has two values: braces, a blank or quotes are missing."""
    if (opened := _OPENED.match(line)) is not None:
        return f"'{opened[1]}' and its braces are parted by a ':' and a blank: write '{opened[1]}: {{'"
    if (keys := _SEVERAL_KEYS.match(line)) is not None:
        braces = f"{keys[1]}{{{keys[2].strip()}, ...}}"
        return f"several keys in one line stand in braces, '{shorten(braces)}'; a text with a colon in quotes"
    return "a second ':' in one value; a text with a colon is put into quotes"


def _unit_behind_a_list(before: str, rest: str) -> str | None:
    """What is to be said where one unit stands behind the numbers of a list; None where none does."""
    numbers = re.search(r"\[([^\[\]]*)\]\s*$", before)
    unit = re.split(r"[,}]", rest)[0].strip()
    if numbers is None or unit not in _UNITS:
        return None
    items = ", ".join(f"{item.strip()} {unit}" for item in numbers[1].split(","))
    return f"'{unit}' stands behind a list; each number in it has its own unit: {shorten(f'[{items}]')}"


def _before(text: str, at: Any) -> str:
    """The line of a place up to there."""
    return _NEW_LINE.split(text[: at.index])[-1]


def _shown(text: str, at: Any) -> str:
    """The rest of a line from a place on, without a remark, fit to be repeated."""
    return shorten(re.sub(r"\s#.*", "", _NEW_LINE.split(text[at.index :], maxsplit=1)[0]))


def _as_found(found: str) -> str:
    plain = shorten(found).replace("<", "").replace(">", "")
    return f"not YAML: {plain}; check indentation and brackets"
