"""Lift files pasted from web pages and word processors, whose blanks and quotes are others than YAML's.

A no-break space behind a colon was answered with "'duration: 120 s' has no ':'", one behind a key with
"'stands_on' is not a key of the load; did you mean 'stands_on'?", and one in an empty line with "'' has no
':'". Typographic quotes were "not a number with a unit". Each line looked right. Of `2 000 kN s/m` with a
no-break or thin space between thousands '000 kN s/m' was no unit, and `12,5 s` was told how a time is
written, not to write 12.5 s.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import BASE

BLANK = "what looks like a blank and is none (U+00A0, no-break space) stands in column"


def said(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text)
    return [problem.of("x") for problem in caught.value.problems]


def changed(old: str, new: str) -> tuple[str, int]:
    """The base with a text replaced, and the line of that."""
    assert BASE.count(old) == 1
    return BASE.replace(old, new), BASE[: BASE.index(old)].count("\n") + 1


@pytest.mark.parametrize(
    ("written", "sentence"),
    [
        ("duration:\u00a0{}", f"{BLANK} 10: write a blank"),
        ("duration\u00a0: {}", f"{BLANK} 9: write a blank"),
        ("\u00a0duration: {}", f"{BLANK} 1: take it out"),
        ("\u00a0\nduration: {}", f"{BLANK} 1: write a blank"),
        (
            "duration: \u201c{}\u201d",
            "'\u201c' (U+201C, left double quotation mark) stands in column 11: "
            "quotes are written '\"', and few texts need any",
        ),
        (
            "\u2018duration\u2019: {}",
            "'\u2018' (U+2018, left single quotation mark) stands in column 1: "
            'quotes are written "\'", and few texts need any',
        ),
        (
            "duration: \u200b{}",
            "an invisible character (U+200B, zero width space) stands in column 11: take it out",
        ),
        ("duration\uff1a {}", "'\uff1a' (U+FF1A, fullwidth colon) stands in column 9: write ':'"),
    ],
)
def test_the_character_is_named(written: str, sentence: str) -> None:
    (line,) = [one for one in BASE.splitlines() if one.startswith("duration: ")]
    text, number = changed(line, written.format(line.removeprefix("duration: ")))
    assert said(text) == [f"x:{number}: {sentence}"]


def test_several_lines_and_what_else_is_wrong_are_told_at_once() -> None:
    (line,) = [one for one in BASE.splitlines() if one.startswith("duration: ")]
    text, number = changed(line, line.replace(": ", ":\u00a0"))
    text += "rules:\u00a0{several_cranes_factor: 1.2}\nwatches: []\n"
    last = text.count("\n")
    told = said(text)
    assert told[:2] == [f"x:{number}: {BLANK} 10: write a blank", f"x:{last - 1}: {BLANK} 7: write a blank"]
    assert told[2].startswith(f"x:{last}: ") and "did you mean" in told[2]


def test_such_characters_within_words_are_no_mistake() -> None:
    """They stand in the title, and what is wrong elsewhere is told as it is."""
    text, _ = changed("A test lift", "\u201cLift\u00a03\u201d of a module")
    parse_scenario(text)
    (found,) = said(f"{text}durations: 3 s\n")
    assert "'durations' is not a key" in found and "column" not in found


@pytest.mark.parametrize(
    ("written", "sentence"),
    [
        ("2\u00a0000 s", "'2 000 s': thousands are written without a mark, '2000 s'"),
        ("2\u2009000 s", "'2 000 s': thousands are written without a mark, '2000 s'"),
        ("12,5 s", "'12,5 s' has a decimal comma; a decimal point is needed: write '12.5 s'"),
    ],
)
def test_numbers_are_told_as_they_are_to_be_written(written: str, sentence: str) -> None:
    (line,) = [one for one in BASE.splitlines() if one.startswith("duration: ")]
    text, number = changed(line, f"duration: {written}")
    assert said(text) == [f"x:{number}: duration: {sentence}"]
