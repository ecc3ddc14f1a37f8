"""`gantline check` said of a tugger of constant tension that what hangs on it is too heavy.

A winch of 1 kN under `mechanics` that keeps a tag line of a load of 40 t taut pulls all it can at rest, as
docs/concepts/winch.md has winches of constant tension do: "what hangs there is too heavy for it, it does not
hoist it or lets it down". Whether one is meant so the lift file does not say; the warning does now.
"""

from __future__ import annotations

from beside_a_winch import LIFT
from gantline.scenario import parse_scenario
from gantline.study.weak_motors import weak_motors
from weak_hoist import standing

MEANT = "it pulls all of that: a winch of constant tension is meant to; for any other what hangs there is too"


def test_of_a_winch_the_warning_says_what_is_meant_so() -> None:
    [found] = weak_motors(parse_scenario(LIFT))
    assert MEANT in found.sentence


def test_a_hoist_is_none() -> None:
    up = "{step: up, hoist: crane, speed: 6 m/min, by: 1 m}"
    [found] = weak_motors(parse_scenario(standing(up, 8.0, "capacity: 12 kN", 30.0)))
    assert "it pulls all of that: what hangs there is too heavy for it" in found.sentence
