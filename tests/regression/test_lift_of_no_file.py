"""A lift built from dictionaries had errors headed `scenario.yaml:8:`, and no such file exists."""

from __future__ import annotations

from typing import Any

import pytest

from gantline.scenario import ScenarioError, parse_scenario

WRONG: dict[str, Any] = {"format": 1, "lift": {"title": "A lift"}, "duration": "10"}


def test_its_errors_name_no_file_and_no_line() -> None:
    with pytest.raises(ScenarioError) as told:
        parse_scenario(WRONG)
    assert str(told.value).startswith("mapping: duration: '10' has no unit")
    assert told.value.source == "mapping"


def test_a_source_that_is_given_has_lines() -> None:
    with pytest.raises(ScenarioError, match=r"^made\.json:\d+: duration: '10' has no unit"):
        parse_scenario(WRONG, source="made.json")


def test_a_text_is_a_lift_file() -> None:
    with pytest.raises(ScenarioError, match=r"^scenario\.yaml:3: duration: '10' has no unit"):
        parse_scenario("format: 1\nlift: {title: A lift}\nduration: 10\n")
