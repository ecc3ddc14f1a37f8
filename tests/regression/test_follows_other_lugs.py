"""A module was turned over by two trolleys, and the lift file warned of speeds that nothing asked for.

The hook at its foot let go of lugs on its deck and took others on its belly. Warnings of steps that follow
took the mean of all lugs of a hook, whether their slings were on or not; the tilt at which a step ends for
the angle of the line of lugs, whichever end was hoisted; and the way there for one that begins level: for
179 deg `it would have to go 4.0 m/min x tan 89.9 deg = 2291.8 m/min`, where 7 m/min were enough.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed
from upending import between_trolleys

#: How far apart the lugs are along the column, and how far those of B are off that of A, up and down [m].
LONG, ASIDE = 19.0, 1.5
PLAN = """\
{{step: upend, hoist: gol.A, speed: 1 m/min, until: {{load_tilt: {{above: 88 deg}}}}}}
{{step: follow, traverse: two, starts: with_previous, speed: {first} m/min, keep_plumb: gol.B}}
{{step: let go, lower: gol.B, speed: 1 m/min, until: {{slings: slack, of: sling.S2}}}}
{{step: off, hold: 10 s, detach: sling.S2}}
{{step: on, hold: 10 s, attach: sling.S3}}
{{step: over, hoist: gol.B, speed: 0.2 m/min, until: {{load_tilt: {{above: 179 deg}}}}}}
{{step: follow over, traverse: two, starts: with_previous, speed: {second} m/min, keep_plumb: gol.B}}"""


def warned(first: float, second: float) -> list[str]:
    text = changed(
        between_trolleys(PLAN.format(first=first, second=second)),
        ("b: {at: [9.5 m, 0 m, 1.5 m]}", "b: {at: [9.5 m, 0 m, 3 m]}, c: {at: [9.5 m, 0 m, 0 m]}"),
        ("plan:\n", "  S3: {from: gol.B, to: column.c, length: 8.0 m}\nplan:\n"),
        ("height: 38.0 m}}\nload", "height: 39.5 m}}\nload"),
    )
    return [one for one in assemble(parse_scenario(text)).warnings if "falls behind" in one]


def test_lugs_are_those_of_slings_that_are_on() -> None:
    """From A the line goes down to b by atan(1.5/19) less and to c by as much more: 83.5 deg at 88 deg, and
    94.5 deg at 90 deg, at which it hangs from A alone, whose lug is as high as the centre of gravity.

    Past plumb it is least steep at the end: what follows over is too slow at first.
    """
    off = math.atan2(ASIDE, LONG)
    first = math.radians(88.0) - off
    second = math.pi - (math.radians(90.0) + off)
    assert not warned(1.01 * math.tan(first), 1.01 * 0.2 * math.tan(second))
    told = warned(0.99 * math.tan(first), 0.99 * 0.2 * math.tan(second))
    assert [one.partition(" falls")[0] for one in told] == ["step 'follow'", "step 'follow over'"]
    assert f"in the end it would have to go 1.0 m/min x tan {math.degrees(first):.1f} deg" in told[0]
    assert f"at first it would have to go 0.2 m/min x tan {math.degrees(second):.1f} deg" in told[1]
    keeps_up = math.degrees(math.atan(0.99 * math.tan(second)))
    assert f"falls behind down to {keeps_up:.1f} deg of the lugs over level:" in told[1]


@pytest.mark.parametrize(("tilt", "told"), [(80, False), (100, True)])
def test_a_line_that_comes_past_plumb_on_its_way_is_told(tilt: int, told: bool) -> None:
    """tan 80 deg = 5.7; at 90 deg no speed is enough."""
    plan = f"""\
{{step: upend, hoist: gol.A, speed: 1 m/min, until: {{load_tilt: {{above: {tilt} deg}}}}}}
{{step: follow, traverse: two, starts: with_previous, speed: 6 m/min, keep_plumb: gol.B}}"""
    warnings = assemble(parse_scenario(between_trolleys(plan))).warnings
    assert any("on the way it would have to go" in one for one in warnings) is told


@pytest.mark.parametrize(("hook", "other", "trolley"), [("gol.A", "gol.B", "two"), ("gol.B", "gol.A", "one")])
def test_the_higher_lug_is_less_steep_where_its_own_end_goes_down(
    hook: str, other: str, trolley: str
) -> None:
    """Lug b is 1.5 m above a: hoisting A turns the line through level, hoisting B from there on."""
    sign = -1.0 if hook == "gol.A" else 1.0
    end = math.radians(70.0) + sign * math.atan2(ASIDE, LONG)
    for share, told in ((1.01, False), (0.99, True)):
        speed = share * math.tan(end)
        plan = f"""\
{{step: upend, hoist: {hook}, speed: 1 m/min, until: {{load_tilt: {{above: 70 deg}}}}}}
{{step: follow, traverse: {trolley}, starts: with_previous, speed: {speed} m/min, keep_plumb: {other}}}"""
        text = changed(
            between_trolleys(plan),
            ("b: {at: [9.5 m, 0 m, 1.5 m]}", "b: {at: [9.5 m, 0 m, 3 m]}"),
            ("height: 38.0 m}}\nload", "height: 39.5 m}}\nload"),
        )
        warnings = assemble(parse_scenario(text)).warnings
        assert any("falls behind" in one for one in warnings) is told
