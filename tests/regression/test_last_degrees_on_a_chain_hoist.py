"""The last degrees in a hinge went by the sling as it begins, whatever its chain hoist had paid out.

A mast that a step hoists to 89 deg hangs in a sling whose chain hoist has hauled in 30 m before: its pull is
steeper, and lever and room are those of the short sling. `gantline check` told those of the long one. It did
so too where nothing says how far the chain hoist goes, or while it goes.
"""

from __future__ import annotations

import math
import re

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from hinged_mast import HEAD, RAISE, mast

HAULED = 30.0
#: The sling as the mast lies, and what is left of it [m].
LONG = math.dist((-20.0, 0.0, 100.0), (19.0, 0.0, 11.0))
SHORT = LONG - HAULED
LOWER = "  - {step: down, lower: main, speed: 6 m/min, by: 40 m}\n"
HAUL = "  - {step: in, haul: A, speed: 6 m/min, by: 30 m}\n"


def told(plan: str) -> list[str]:
    """Warnings of a lift file about its hinge, whose sling has a chain hoist."""
    text = mast(plan).replace("rope: steel}", "rope: steel, chain_hoist: {speed: 6 m/min}}")
    return [one for one in assemble(parse_scenario(text)).warnings if "hinge" in one]


@pytest.mark.parametrize(("before", "sling"), [(LOWER, LONG), (LOWER + HAUL, SHORT)])
def test_lever_and_room_are_those_of_the_sling_that_is_left(before: str, sling: float) -> None:
    """Hook over pins: h = l sin t + √(s² - l² cos² t), lever h' and room l + s - h at 89 deg."""
    (said,) = told(before + RAISE)
    angle = math.radians(89.0)
    across = HEAD * math.cos(angle)
    upwards = math.sqrt(sling**2 - across**2)
    lever = across * (1.0 + HEAD * math.sin(angle) / upwards)
    room = HEAD * (1.0 - math.sin(angle)) + sling - upwards
    numbers = re.findall(r"lever of ([\d.]+) m .* ([\d.]+) mm short", said)
    shown_lever, shown_room = (float(one) for one in numbers[0])
    # To the digits that are shown.
    assert shown_lever == pytest.approx(lever, abs=0.005)
    assert shown_room == pytest.approx(1e3 * room, abs=0.5)


def test_nothing_is_told_of_a_sling_of_no_known_length() -> None:
    until = HAUL.replace("by: 30 m", "until: {load_tilt: {above: 1 deg}}")
    assert told(LOWER + until + RAISE) == []
    first, end = RAISE.splitlines()
    beside = HAUL.replace("by:", "starts: with_previous, by:")
    assert told(f"{LOWER}{first}\n{beside}{end}\n") == []
