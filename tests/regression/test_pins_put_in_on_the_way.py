"""At rest a pin that the plan puts in held its sheave where the lift began, not where the sheave was by then.

A plan that waits for nothing is not followed: its equilibrium is sought from the start, with pins as they
are by the time asked for. So a pin of `put_in_pins` went in at the start, with the sheave at travel 0:
three sheaves that had come to +0.70, +0.18 and -0.80 m were held as if the middle one were at 0, with a pin
force of 937 kN and a tension spread of 108 % where the pin carries nothing and the spread is 0.8 %. A plan
that waits for a condition had it right.
"""

from __future__ import annotations

import pytest

import gantline

WEIGHT = 300e3 * 9.81


def statics(first: dict[str, object], locked: object) -> gantline.Statics:
    """The reference lift, hoisted clear, its second sheave pinned, and hoisted on."""
    plan = [
        {"step": "hoist", "hoist": "test_hook", "speed": "0.1 m/s", **first},
        {"step": "look", "hold": "20 s", **({"pull_pins": "e1"} if locked else {})},
        {"step": "pin", "hold": "20 s", "put_in_pins": "e1.2"},
        {"step": "further", "hoist": "test_hook", "speed": "0.1 m/s", "by": "1 m"},
        {"step": "end", "hold": "until_end"},
    ]
    changes = {"duration": "150 s", "plan": plan, "equalizers.e1.travel.locked": locked}
    return gantline.Statics(gantline.load_scenario("equalizer").changed(changes))


def travels(rest: gantline.Recording) -> list[float]:
    """Of the five sheaves, down positive [m]."""
    return [float(rest.column("sheave_travel", f"e1.{number}")[-1]) for number in range(1, 6)]


@pytest.mark.parametrize(
    ("first", "locked"),
    [({"by": "4 m"}, False), ({"by": "4 m"}, True), ({"until": {"supports": "clear"}}, False)],
    ids=["by", "by, pulled before", "until"],
)
def test_pin_put_in_at_rest_carries_nothing(first: dict[str, object], locked: object) -> None:
    """Hoisting a load that hangs clear changes nothing: travels stay, and a pin put in at rest has P = 0."""
    lift = statics(first, locked)
    end = lift.equilibrium().recording
    begun = lift.times_of("pin")[0]
    assert begun is not None
    before = lift.equilibrium(time=begun).recording
    held = lift.equilibrium(time=begun + 10.0).recording
    assert not before.events("pin_put_in")
    assert abs(travels(before)[1]) > 0.5  # 26 m beside 23 m: -1.2 m by (EZ3), and off plumb a little less
    for rest in (held, end):
        # Equilibria are found to 1e-9 of the forces that meet; ropes and slings have some 10 MN/m.
        assert travels(rest) == pytest.approx(travels(before), abs=1e-7)
        assert abs(rest.column("pin_force", "e1.2")[-1]) < 1e-6 * WEIGHT
