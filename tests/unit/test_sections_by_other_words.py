"""Sections of a lift file in words of other crews."""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.file.other_sections import SECTIONS_INSTEAD, SECTIONS_MEANT
from gantline.scenario.model import Scenario

TEXT = (Path(__file__).resolve().parents[2] / "scenarios" / "spreader_bar" / "scenario.yaml").read_text(
    "utf-8"
)
KEYS = Scenario.keys()


def told(key: str) -> str:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(f"{TEXT}{key}: {{a: {{b: 3 m}}}}\n")
    return error.value.problems[0].sentence


@pytest.mark.parametrize("key", sorted(SECTIONS_MEANT))
def test_the_section_that_is_meant_is_named(key: str) -> None:
    """Also where the file has it already, and whatever else is written like the word."""
    (section,) = SECTIONS_MEANT[key]
    assert section in KEYS
    there = ", which is there already" if f"\n{section}:" in TEXT else ""
    assert told(key) == f"'{key}' is not a key of a lift file; did you mean '{section}'{there}?"


@pytest.mark.parametrize("key", sorted(SECTIONS_INSTEAD))
def test_what_there_is_instead_is_said(key: str) -> None:
    assert key not in KEYS
    assert told(key) == f"'{key}' is not a key of a lift file: {SECTIONS_INSTEAD[key]}"
