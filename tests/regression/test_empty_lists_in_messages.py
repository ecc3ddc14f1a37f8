"""An empty list where a list is needed: `found a list; a list of offsets is needed`.

What is wrong is that nothing stands in it, which the message did not say; of mappings neither.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ("vary: {cranes.crane.at.z: []}", "found an empty list; a list of offsets is needed"),
        ("set: {}", "found an empty mapping; a mapping of paths to values is needed"),
    ],
)
def test_what_is_empty_is_called_so(case: str, words: str) -> None:
    with pytest.raises(ScenarioError) as found:
        parse_scenario(f"{LIFT}cases:\n  one: {{{case}}}\n")
    assert words in str(found.value)
