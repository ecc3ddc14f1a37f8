"""A ship block hung on its upper lugs alone, and a warning counted with the tilt of two steps before.

It was turned `until` 78 deg by a step that said so, and by the next until the lower slings were slack, which
leaves it at 88 deg. The lower hook then took lugs on the other side, and the lift file warned that its
trolley `falls behind down to 81.5 deg: at first it would have to go 3.0 m/min x tan 86.7 deg = 52.1 m/min`:
86.7 deg is the line of lugs at 78 deg. At 88 deg it is 76.9 deg, and 12.9 m/min do. A tilt that a step leaves
unsaid is that of the load hanging from its other end where the step lets go of one, and else not known.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed
from upending import between_trolleys

#: How far apart the lugs are along the column, and how far c is below a, upright [m].
LONG, ASIDE = 19.0, 1.5
#: How far the lug of A is above the centre of gravity [m], which is 9.5 m beside it.
HIGHER = 0.5
TURNED = """\
{step: upend, hoist: gol.A, speed: 1 m/min, until: {load_tilt: {above: 78 deg}}}
{step: follow, traverse: two, starts: with_previous, speed: 10 m/min, keep_plumb: gol.B}
"""
LET_GO = """\
{step: let go, lower: gol.B, speed: 0.1 m/min, until: {slings: slack, of: sling.S2}}
{step: follow it, traverse: two, starts: with_previous, speed: 10 m/min, keep_plumb: gol.B}
{step: off, hold: 10 s, detach: sling.S2}
{step: on, hold: 10 s, attach: sling.S3}
{step: over, hoist: gol.B, speed: 0.2 m/min, until: {load_tilt: {above: 178 deg}}}
"""
UNSAID = """\
{step: further, hoist: gol.A, speed: 0.1 m/min, until: {hoist_load: {hook: gol.A, above: 70 t}}}
{step: back, lower: gol.A, speed: 1 m/min, until: {load_tilt: {below: 20 deg}}}
"""


def warned(plan: str, speed: float) -> list[str]:
    """What is said of a step that follows at this speed [m/min] beside the last of a plan."""
    follow = "{step: follow over, traverse: two, starts: with_previous, keep_plumb: gol.B, "
    last = f"{follow}speed: {speed} m/min}}"
    third = "  S3: {from: gol.B, to: column.c, length: 8.0 m}\n" if "S3" in plan else ""
    text = changed(
        between_trolleys(TURNED + plan + last),
        ("a: {at: [-9.5 m, 0 m, 1.5 m]}", f"a: {{at: [-9.5 m, 0 m, {1.5 + HIGHER} m]}}"),
        ("b: {at: [9.5 m, 0 m, 1.5 m]}", "b: {at: [9.5 m, 0 m, 3 m]}, c: {at: [9.5 m, 0 m, 0.5 m]}"),
        ("plan:\n", f"{third}plan:\n"),
        ("height: 38.0 m}}\nload", "height: 39.5 m}}\nload"),
    )
    warnings = assemble(parse_scenario(text)).warnings
    return [one for one in warnings if "step 'follow over' falls behind" in one]


def test_it_hangs_from_its_other_end_once_one_lets_go() -> None:
    """From a the centre of gravity is 9.5 m along and 0.5 m down: it hangs at acos(0.5/9.51) = 87.0 deg.

    Lug c is 1.5 m down over 19 m: the line from a is atan(1.5/19) = 4.5 deg past that of the column.
    """
    tilt = math.acos(HIGHER / math.hypot(LONG / 2, HIGHER))
    first = math.pi - (tilt + math.atan2(ASIDE, LONG))
    assert not warned(LET_GO, 1.01 * 0.2 * math.tan(first))
    (told,) = warned(LET_GO, 0.99 * 0.2 * math.tan(first))
    assert f"at first it would have to go 0.2 m/min x tan {math.degrees(first):.1f} deg" in told


@pytest.mark.parametrize(("share", "told"), [(1.01, False), (0.99, True)])
def test_nothing_is_made_of_a_tilt_that_is_not_known(share: float, told: bool) -> None:
    """In the end b, 1 m over a, is down by 20 deg less atan(1/19): tan 17.0 deg = 0.31, of 1 m/min.

    At first it is steeper, at 78 deg or wherever the step before has left it: nothing says.
    """
    end = math.tan(math.radians(20.0) - math.atan2(1.0, LONG))
    assert bool(warned(UNSAID, share * end)) is told
