"""Hooks that a plan hoisted into their sheaves, or lowered into the ground, were in order by `check`.

A hook of a Goliath crane went 18 m below the ground while a load was turned over, and neither the check nor
the run said a word; hooks that were hoisted past the sheaves above them ended the run after minutes.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from weak_hoist import hanging

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
UP = "{step: up, hoist: crane, speed: 6 m/min, UNTIL}"
DOWN = "{step: down, lower: crane, speed: 6 m/min, UNTIL}"


def doubts_of(*plan: str) -> list[str]:
    """Of a hook at 13 m, its hook block 1 m high, with sheaves of 0.4 m and upper ones at 20 m."""
    lift = parse_scenario(hanging("\n".join(plan), 10.0, "capacity: 200 kN", 300.0))
    found = (doubt.of("lift") for doubt in assemble(lift).doubts)
    return [said for said in found if "nothing stops it" in said or "two-blocking" in said]


def test_a_way_past_the_upper_sheaves_is_told() -> None:
    """20 - 0.4 - 1 = 18.6 m is the most, which 13 m and 5.6 m come to."""
    assert not doubts_of(UP.replace("UNTIL", "by: 5.6 m"))
    (said,) = doubts_of(UP.replace("UNTIL", "by: 5.7 m"))
    assert "plan[1].by: step 'up' hoists crane to 18.70 m at least, and where it is at 18.60 m" in said
    assert said.endswith("its hook block meets the sheaves above (two-blocking); hoist it less far")
    (said,) = doubts_of(UP.replace("UNTIL", "to: 19 m"))
    assert "plan[1].to" in said and "19.00 m" in said


def test_steps_that_end_on_conditions_count_with_the_least_that_they_can_be() -> None:
    waits = UP.replace("UNTIL", "until: {slings: taut}").replace("step: up", "step: first")
    assert len(doubts_of(waits, UP.replace("UNTIL", "by: 5.7 m"))) == 1
    down = DOWN.replace("UNTIL", "until: {slings: slack}")
    assert not doubts_of(down, UP.replace("UNTIL", "by: 5.7 m"))


def test_a_way_below_the_ground_is_told_by_check_and_run() -> None:
    """13 m up, 14.5 m down: 1.5 m below, less the stretch of falls and sling as the load stands: 1.48 m."""
    assert not doubts_of(DOWN.replace("UNTIL", "by: 13 m"))
    plan = DOWN.replace("UNTIL", "by: 14.5 m")
    (said,) = doubts_of(plan)
    assert "step 'down' lowers crane to 1.50 m below the ground, or deeper: nothing stops it there" in said
    lift = parse_scenario(hanging(plan, 10.0, "capacity: 200 kN", 170.0))
    warned = [one for one in gantline.simulate(lift).attributes["warnings"] if "goes below the ground" in one]
    assert len(warned) == 1
    assert warned[0].startswith("crane goes below the ground at 13")
    assert "up to 1.48 m" in warned[0] and warned[0].endswith("nothing stops it there; lower it less far")


@pytest.mark.parametrize("name", ["goliath", "floating_crane", "upending", "monopile"])
def test_lifts_that_keep_within_have_no_word(name: str) -> None:
    lift = gantline.Simulation(SCENARIOS / name)
    assert not [one for one in lift.assembly.doubts if "two-blocking" in one.of("") or "below" in one.of("")]
