"""Heights of hooks did not count what a step led them: warnings of the plan were false, or missing.

A beam was led up by 9 m and lowered by 17 m, to 6 m over the ground, and `gantline check` said that its hooks
came to 3 m below it. Led into the sheaves of its booms, or down into the ground, it said nothing.
"""

from __future__ import annotations

import pytest

from gantline.assembly.assemble import assemble
from led_pair import led

_RAMPS = "speed: 6 m/min, acceleration: 0.02 m/s^2"
_GROUND = "ground: {level: 0 m}\n"
#: Boom heads are 3 m + 30 m sin 60 deg up; the upper sheaves are 1 m lower, their hook block is 1.5 m high,
#: and sheaves of 0.7 m to the middle of their rope touch with that between their centres: 25.78 m.
_MEETS = 3.0 + 30.0 * 0.75**0.5 - 1.0 - 1.5 - 0.7


def _told(*steps: str) -> list[str]:
    doubts = [str(one) for one in assemble(led(*steps, rest=_GROUND)).warnings]
    return [one for one in doubts if "below the ground" in one or "two-blocking" in one]


def _lead(*by: float) -> str:
    x, y, z = by
    return f"{{step: l, lead: [a.H, b.H], by: [{x} m, {y} m, {z} m], {_RAMPS}}}"


def test_hooks_led_up_and_lowered_are_above_the_ground() -> None:
    """From 14 m by 9 m up and by 17 m down, that is 6 m."""
    assert _told(_lead(0, 0, 9), "{step: down, lower: [a.H, b.H], by: 17 m, speed: 6 m/min}") == []


def test_hooks_led_below_the_ground_are_told() -> None:
    """14 m less 15 m."""
    found = _told(_lead(0, 0, -15))
    assert len(found) == 2
    assert "step 'l' leads a.H to 1.00 m below the ground, or deeper" in found[0]


def test_hooks_led_down_and_lowered_further_are_told_where_they_get_there() -> None:
    found = _told(_lead(0, 0, -8), "{step: down, lower: [a.H, b.H], by: 8 m, speed: 6 m/min}")
    assert ["step 'down' lowers" in one for one in found] == [True, True]


def test_hooks_led_into_their_sheaves_are_told() -> None:
    found = _told(_lead(0, 0, 13))
    assert len(found) == 2
    assert f"leads b.H to 27.00 m at least, and where it is at {_MEETS:.2f} m" in found[1]


def test_booms_that_flatten_bring_their_sheaves_down_to_their_hooks() -> None:
    """Level outwards by 8 m from a radius of 17 m: heads at 3 m + sqrt(30^2 - 23^2) m, 6.7 m lower.

    Hooks at 24 m are 1.78 m under where they meet their sheaves at first, and in them at the end.
    """
    found = _told(_lead(0, 0, 10), _lead(0, 8, 0).replace("step: l", "step: out"))
    assert ["step 'out' leads" in one for one in found] == [True, True]


@pytest.mark.parametrize("way", [(3, 5, 2), (0, 0, 11.5)])
def test_ways_in_the_clear_are_not_told(way: tuple[float, float, float]) -> None:
    assert _told(_lead(*way)) == []
