"""A mobile crane on `outriggers` was answered with a list of keys that says nothing of them.

"'outriggers' is not a key of a crawler crane; known here: 'rated_capacity', 'tracks', ..." was all.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, parse_scenario

GUIDE = Path(__file__).resolve().parents[2] / "docs" / "concepts" / "crawler.md"
LIFT = """
format: 1
lift: {title: A mobile crane}
cranes:
  mc:
    type: crawler
    %s: {length: 8.5 m, gauge: 8.3 m}
"""


@pytest.mark.parametrize("key", ["outriggers", "outrigger_pads", "stabilisers"])
def test_outriggers_are_answered_with_tracks(key: str) -> None:
    """The words are those of the page of the crane."""
    with pytest.raises(ScenarioError) as error:
        parse_scenario(LIFT % key)
    said = "a mobile crane has its outriggers as 'tracks: {length: 8.5 m, width: 0.6 m, gauge: 8.3 m, "
    assert f"{said}outrigger_mats: 4 m^2}}'" in str(error.value)
    assert "tracks: {length: 8.5 m, width: 0.6 m, gauge: 8.3 m, outrigger_mats: 4 m^2" in GUIDE.read_text()
