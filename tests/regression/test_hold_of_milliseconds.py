"""A hold point of 30 ms for 30 s passed at its first sample, and the lift was GO.

What the hold point required was looked at as the step before it ended, and the plan went on at once.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario


@pytest.mark.parametrize(("hold", "is_told"), [("20 s", False), ("0.5 s", False), ("20 ms", True)])
def test_a_hold_of_no_length(hold: str, is_told: bool) -> None:
    text = LIFT.replace("hold: 20 s", f"hold: {hold}")
    said = "step 'hold point' holds for 20 ms: nobody sees anything in that; a unit has slipped, ms for s"
    assert [one.sentence for one in assemble(parse_scenario(text)).doubts] == ([said] if is_told else [])
