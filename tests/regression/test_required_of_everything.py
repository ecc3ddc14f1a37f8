"""Requirements at the end of a step that nothing can miss, by a slip of the unit: GO, and not a word.

A heel of 50 deg and a tilt of 2000 deg under `limits` were told as limits that let everything pass. The same
at a hold point, `require: {load_tilt: below 200 deg}`, was taken as it was, and the hold point passed.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

HOLD = "{step: hold point, hold: 20 s"


def told(required: str) -> list[str]:
    """Warnings of the module's lift file that name what its hold point requires."""
    text = LIFT.replace(HOLD, f"{HOLD}, require: {{{required}}}")
    doubts = assemble(parse_scenario(text, "x.yaml")).doubts
    return [f"{doubt.path}: {doubt.sentence}" for doubt in doubts if "require" in doubt.path]


@pytest.mark.parametrize(
    ("required", "key", "said"),
    [
        (
            "load_tilt: below 200 deg",
            "load_tilt",
            "200 deg lets everything pass; a unit or digit has slipped",
        ),
        ("load_yaw: below 200 deg", "load_yaw", "200 deg lets everything pass; a unit or digit has slipped"),
        (
            "equalizer_travel_used: below 6000 %",
            "equalizer_travel_used",
            "6000 % lets everything pass; 100 % is all there is, and a unit or digit has slipped",
        ),
    ],
)
def test_what_everything_meets_is_told(required: str, key: str, said: str) -> None:
    assert told(required) == [f"plan[3].require.{key}: a limit of {said}"]


@pytest.mark.parametrize(
    "required", ["load_tilt: below 1 deg", "load_tilt: below 170 deg", "load_yaw: above 2 deg"]
)
def test_what_something_misses_is_not(required: str) -> None:
    """A load that is turned over comes to 180 deg; what has to be above an angle is another matter."""
    assert told(required) == []
