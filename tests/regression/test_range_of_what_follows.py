"""A tail crane that was to walk in with a reactor had no range that way, and the lift file was in order.

Its travel had the range -70 m to 0 m and its heading the sign of the other way: the falls came 31 deg out
of plumb and the crane went over. Of booms the end of their range was told before a run, of trolleys and of
cranes that travel only how fast they have to go."""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from upending import LINE, between_trolleys

PLAN = """\
{{step: upend, hoist: gol.A, speed: 1 m/min, until: {{load_tilt: {{above: {tilt} deg}}}}}}
{{step: follow, traverse: two, starts: with_previous, speed: 10 m/min, keep_plumb: gol.B}}"""


def told(tilt: float, least: float) -> list[str]:
    """The trolley over the foot starts at 9.5 m and may come to `least` [m]."""
    text = between_trolleys(PLAN.format(tilt=tilt), least=least)
    return [one for one in assemble(parse_scenario(text)).warnings if "in its range" in one]


def test_what_it_has_to_go_is_held_against_its_range() -> None:
    """At 60 deg it has come nearer by L (1 - cos 60 deg), 9.5 m: to 0 m."""
    nearer = LINE * (1 - math.cos(math.radians(60.0)))
    assert pytest.approx(9.5) == nearer
    assert not told(60.0, 9.5 - nearer - 0.1)
    [doubt] = told(60.0, 4.0)
    stops = math.degrees(math.acos((LINE - 5.5) / LINE))
    assert doubt == (
        f"step 'follow': falls do not stay plumb from {stops:.1f} deg of the lugs over level on: 'gol.two' "
        "has to go 9.5 m nearer, and has 5.5 m that way in its range, 4.00 m to 60.00 m; widen it"
    )
