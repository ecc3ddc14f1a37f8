"""Free sheaves without stops under unlike slings got "no step brings its forces closer to balance".

With the load on the ground and slings slack only they weigh on the equalizing rope. A sheave that less hangs
on than on its neighbours runs up; where that was in the middle, between two that are heavier, the search for
rest ended at the sheave and not at its rope, of which alone the message said what would be right.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gantline
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import NoEquilibriumError

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
RIGHT = (
    "a moving sheave that less hangs on than on the others runs up to the fixed ones; 'stops: true' under "
    "'travel' ends its way, 'locked: true' holds it"
)


def lift(heavier: str, travel: str = "locked: false") -> str:
    """The equalizer at rest on the ground, some slings on a rope of 2 kg/m."""
    text = FILE.read_text(encoding="utf-8").replace("start: settled", "start: rest")
    rope = "{axial_stiffness: 300 MN, damping_time: 2 ms, mass: 2 kg/m, minimum_breaking_force: 5 MN}"
    text = text.replace("\nropes:\n", f"\nropes:\n  heavy: {rope}\n")
    text = text.replace("down: 1.9 m, locked: false}", f"down: 1.9 m, {travel}}}")
    return re.sub(rf"(  S[{heavier}]: .*?rope: )sling", r"\1heavy", text)


@pytest.mark.parametrize("heavier", ["24", "1"])
def test_it_says_what_is_right(heavier: str) -> None:
    with pytest.raises(ScenarioError) as told:
        gantline.Simulation(parse_scenario(lift(heavier)))
    assert str(told.value).endswith(RIGHT)
    with pytest.raises(NoEquilibriumError) as none:
        gantline.Statics(parse_scenario(lift(heavier))).equilibrium(0.0)
    assert none.value.cause.endswith(RIGHT)


@pytest.mark.parametrize("travel", ["stops: true, locked: false", "locked: true"])
def test_that_is_right(travel: str) -> None:
    assert gantline.Statics(parse_scenario(lift("24", travel))).equilibrium(0.0).is_stable
