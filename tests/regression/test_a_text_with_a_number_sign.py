"""A file with one line of words, `Lift #3`, in place of a lift ended in an IndexError, not in a message."""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario


def test_words_and_a_number_are_told_as_what_they_are() -> None:
    with pytest.raises(ScenarioError, match="found the text 'Lift'; a lift file is a mapping"):
        parse_scenario("Lift #3\n")
