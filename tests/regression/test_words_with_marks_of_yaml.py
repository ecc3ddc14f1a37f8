"""Titles with a colon or a number sign in them, and wind that comes from somewhere.

`title: Bow: turned by 90 deg` was answered "a ',' or '}' is missing before 'Bow: turned by 90 deg'", and
`title: Bow section #12` by a bracket that is not closed two lines below: what is missing are quotes. `from`
of wind was answered by a list of keys, with `direction` among them, which is the other way round.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario

QUOTES = "a text with a ':' in it stands in quotes"
COMMENT = "' #' begins a comment, and a text with it stands in quotes"


def _said(line: str) -> str:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(f"format: 1\n{line}\nduration: 3 s\n")
    return str(caught.value)


@pytest.mark.parametrize(
    "line",
    [
        "lift: {title: 'A', remark: Bow: turned by 90 deg}",
        "lift: {title: Bow: turned by 90 deg, number: A-1}",
        "plan: [{step: down: slowly, hold: 3 s}]",
    ],
)
def test_a_colon_in_words_is_told(line: str) -> None:
    assert QUOTES in _said(line)


def test_a_comma_that_is_missing_is_told_alone() -> None:
    """Between two keys with quantities no quotes are missing."""
    said = _said("wind: {speed: 9 m/s direction: 30 deg}")
    assert "is missing before 'direction: 30 deg}'" in said and QUOTES not in said


def test_a_number_sign_in_words_is_told() -> None:
    """It cuts the bracket off that would close."""
    assert COMMENT in _said("lift: {title: Bow section #12, number: A-1}")
    # A remark at the end of a line is none of that.
    assert COMMENT not in _said("lift: {title: Bow section,  # the twelfth")


@pytest.mark.parametrize(
    "what", ["wind: {speed: 9 m/s", "current: {speed: 1 m/s", "waves: {w: {peak_period: 6 s"]
)
def test_where_it_comes_from(what: str) -> None:
    """`direction` is where it goes to: the opposite, 30 deg + 180 deg."""
    end = "}}" if what.startswith("waves") else "}"
    said = _said(f"{what}, from: 30 deg{end}")
    assert "what comes from 30 deg has 'direction: 210 deg'" in said
