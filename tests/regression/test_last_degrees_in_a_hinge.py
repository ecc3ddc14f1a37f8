"""A hoist at full speed to 89 deg pulled its mast against the hinge with six times its weight, unannounced.

Upright is where the pull of the hook goes through the hinge. From 89 deg on that took 8 mm, the hoist took
100 mm to stop, and the sling had to stretch by the rest; the load turned with 6 deg/s there as well, where it
was to be at rest. `gantline check` said `in order`. Nor did it say of a step that waits for 89 deg that its
hook, beside the hinge, turns the load to 58 deg and no more, and pulls at the hinge from there on.
"""

from __future__ import annotations

import math
import re

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from hinged_mast import ACROSS, FOOT, HEAD, MAST, PINS, RAISE, WEIGHT, mast

#: The sling between hook and lug as the mast lies, and the hook over the pins, when both are in line [m].
SLING = math.dist((-20.0, 0.0, 100.0), (19.0, 0.0, 11.0))
IN_LINE = HEAD + SLING
STIFFNESS = 5e9 / SLING


def to_89(speed: float, acceleration: float, angle: float = 89.0) -> str:
    """The mast up to 80 deg, and when it hangs still there on to an angle, at a speed [m/min, m/s^2]."""
    plan = f"""\
  - {{step: raise, hoist: main, speed: 1.5 m/min, until: {{load_tilt: {{above: 80 deg}}}}}}
  - {{step: settle, hold: 60 s}}
  - {{step: on, hoist: main, speed: {speed} m/min, acceleration: {acceleration} m/s^2,
     until: {{load_tilt: {{above: {angle} deg}}}}}}
  - {{step: end, hold: until_end}}
"""
    wide = mast(plan, more="simulation: {sample_interval: 50 ms}").replace("900 s", "2400 s")
    return wide.replace("acceleration: 0.05 m/s^2}", "acceleration: 1 m/s^2}")


def told(text: str) -> list[str]:
    """Warnings of a lift file about its hinge."""
    return [one for one in assemble(parse_scenario(text)).warnings if "hinge" in one]


def test_it_is_told_before_with_lever_room_and_way() -> None:
    """Hook over pins: h = l sin t + √(s² - l² cos² t) at 89 deg.

    W z'/h' and the larger one of k (v²/2a - room) = 4.8 W and v √(k I)/h' 2a/(ω v) = 5.1 W.
    """
    (said,) = told(mast(RAISE))
    angle = math.radians(89.0)
    across = HEAD * math.cos(angle)
    upwards = math.sqrt(SLING**2 - across**2)
    room = IN_LINE - HEAD * math.sin(angle) - upwards
    lever = across * (1.0 + HEAD * math.sin(angle) / upwards)
    beyond = STIFFNESS * (0.1**2 / 0.1 - room)
    thrown = STIFFNESS * 2.0 * 0.05 / (STIFFNESS * lever**2 / (ACROSS + MAST * FOOT**2))
    assert beyond / WEIGHT == pytest.approx(4.8, abs=0.05)
    assert thrown / WEIGHT == pytest.approx(5.1, abs=0.05)
    pull = FOOT * math.cos(angle) / lever + max(beyond, thrown) / WEIGHT
    assert said.startswith(
        "step 'raise' hoists 'main' at 6.00 m/min to 89.0 deg: its pull has a lever of "
    ) and said.endswith(" at most, or with less tilt")
    numbers = re.findall(
        r"lever of ([\d.]+) m .* ([\d.]+) mm short .* for ([\d.]+) mm .* about ([\d.]+) times", said
    )
    # To the digits that are shown.
    for shown, by_hand, digits in zip(
        numbers[0], (lever, 1e3 * room, 100.0, pull), (2, 0, 0, 1), strict=True
    ):
        assert float(shown) == pytest.approx(by_hand, abs=0.5 * 10**-digits)
    peak = simulate(parse_scenario(mast(RAISE))).column("hook_load", "main").max()
    assert 5.0 < peak / WEIGHT < 8.0


def test_the_speed_that_it_names_is_slow_enough() -> None:
    """v √(k I)/h' is W less what bears the mast there; a run has no more than the weight at its hook."""
    (said,) = told(mast(RAISE))
    (speed,) = re.findall(r"end at ([\d.]+) m/min at most", said)
    lever, inertia = 0.954, ACROSS + MAST * FOOT**2
    by_hand = (
        WEIGHT * (1.0 - FOOT * math.cos(math.radians(89.0)) / lever) * lever / math.sqrt(STIFFNESS * inertia)
    )
    assert float(speed) == pytest.approx(60.0 * by_hand, abs=0.005)  # to the digits that are shown
    slow = to_89(float(speed), 0.05)
    assert told(slow) == []
    assert simulate(parse_scenario(slow)).column("hook_load", "main").max() < 1.05 * WEIGHT


@pytest.mark.parametrize(
    ("speed", "acceleration", "angle", "is_told"),
    [
        (2.0, 0.05, 89.0, True),  # thrown: it turns by 2 deg/s
        (0.5, 0.001, 89.0, True),  # 35 mm to stop, 8 mm of room
        (6.0, 0.5, 85.0, False),
        (2.0, 0.05, 88.0, False),
        (0.5, 0.01, 89.0, False),
    ],
)
def test_it_is_told_where_runs_have_it(
    speed: float, acceleration: float, angle: float, is_told: bool
) -> None:
    """More than one and a half of the weight at the hook."""
    text = to_89(speed, acceleration, angle)
    assert bool(told(text)) == is_told
    peak = simulate(parse_scenario(text)).column("hook_load", "main").max() / WEIGHT
    assert (peak > 1.5) == is_told


def test_a_hook_that_turns_it_no_farther() -> None:
    """It stands 30 m ahead of the pins and 49 m over them: atan(49/30), a little more as it is hoisted."""
    text = mast(RAISE, hook=(10.0, 0.0, 60.0))
    (said,) = told(text)
    (most,) = re.findall(r"waits for a tilt above 89.0 deg: 'main' turns mast to ([\d.]+) deg at most", said)
    # In line the hook is HEAD and a sling from the pins, 30 m of that level.
    sling = math.dist((10.0, 0.0, 60.0), (19.0, 0.0, 11.0))
    level = (10.0 - PINS[0]) / (HEAD + sling)
    assert float(most) == pytest.approx(math.degrees(math.acos(level)), abs=0.05)


@pytest.mark.parametrize(
    "plan",
    [
        RAISE.replace("above: 89 deg", "above: 80 deg"),
        RAISE.replace("6 m/min, until: {load_tilt: {above: 89 deg}}", "6 m/min, by: 20 m"),
        "  - {step: hold, hold: 20 s}\n  - {step: let go, hold: 5 s, open_hinges: foot}\n" + RAISE,
    ],
)
def test_nothing_is_told_of_what_is_in_order(plan: str) -> None:
    """Steps that end earlier, by a distance, or after the hinge has opened."""
    assert told(mast(plan)) == []
