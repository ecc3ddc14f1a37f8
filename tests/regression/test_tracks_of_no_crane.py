"""Tracks of 90 m for 9 m under a crawler crane.

Stability over the ends of the tracks goes with their length, and pressure under them against it: with ten
times that length the crane could not tip, and pressed the ground with a tenth.
"""

from __future__ import annotations

import pytest

from crawler_lift import crawler_lift
from gantline.scenario import ScenarioError, parse_scenario


@pytest.mark.parametrize(
    ("length", "gauge", "is_told"), [(90, 8.4, True), (9, 84, True), (9, 8.4, False), (30, 8.4, False)]
)
def test_tracks_much_longer_than_their_gauge_or_shorter_are_refused(
    length: float, gauge: float, is_told: bool
) -> None:
    text = crawler_lift(300e3).replace("length: 9 m, width", f"length: {length} m, width")
    text = text.replace("gauge: 8.4 m", f"gauge: {gauge} m")
    if not is_told:
        parse_scenario(text)
        return
    with pytest.raises(ScenarioError, match=f"tracks of {length} m with a gauge of {gauge} m are no crane's"):
        parse_scenario(text)
