"""Slips that `gantline check` had in order, or told by something else: posts, hook blocks, hoists.

A post with `diameter: 48 m` for 48 mm was told by the lean of its cone, one with its foot below the ground,
a highest position above the boom head, a hook block of 3 mm, a hoist with 2 m/s^2 or 5 m/s, and a slew
`to: 450 deg` by nothing.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario, parse_scenario
from guided_lift import guided_lift

FRAME = "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m}"
CONE = "cone: {length: 0.5 m, tip_diameter: 20 mm}"


def guide(post: str) -> list[tuple[str, str]]:
    """What is told of one guide under a load that comes down right over it."""
    text = guided_lift(f"  bolt: {{post: {{{post}, {CONE}}}, {FRAME}, friction: 0.2}}", height=2.0)
    return [(one.path, one.sentence) for one in assemble(parse_scenario(text)).doubts]


def told(scenario: str, key: str, value: str) -> list[tuple[str, str]]:
    doubts = assemble(load_scenario(scenario).changed({key: value})).doubts
    return [(one.path, one.sentence) for one in doubts]


def test_a_post_of_metres_for_millimetres() -> None:
    said = guide("at: [3.5 m, 0 m, 0 m], diameter: 48 m, height: 1 m")
    slip = "the post of guide bolt has a diameter of 48.00 m; a unit has slipped, m for mm"
    assert ("guides.bolt.post.diameter", slip) in said
    assert not [one for _, one in said if "leans by" in one]


def test_a_post_with_its_foot_below_the_ground() -> None:
    said = guide("at: [3.5 m, 0 m, -1.2 m], diameter: 48 mm, height: 2 m")
    assert [one for path, one in said if path == "guides.bolt.post.at"] == [
        "the foot of the post of guide bolt is 1.20 m below the ground, and its height counts from there; "
        "from the ground on it is right with z at 0 m"
    ]
    assert not [one for path, one in guide("at: [3.5 m, 0 m, 0 m], diameter: 48 mm, height: 2 m")]


@pytest.mark.parametrize(
    ("scenario", "key", "value", "sentence"),
    [
        # Upper sheaves at 88 m, less a sheave of 1 m and a hook block of 3 m: 84 m.
        (
            "goliath",
            "hook_types.hook_300.highest",
            "720 m",
            "the highest position of goliath.U1 is 720.0 m, and its hook block meets the sheaves above at "
            "84.0 m (two-blocking); a digit has slipped, or it is of another crane",
        ),
        (
            "goliath",
            "hook_types.hook_300.block.height",
            "3.0 mm",
            "the hook block of goliath.U1 has its sheaves 3 mm above the bearing of its hook, and they have "
            "a diameter of 1,000 mm; a unit has slipped",
        ),
        (
            "goliath",
            "hook_types.hook_300.hoist.acceleration",
            "2 m/s^2",
            "the hoist of goliath.U1 starts and stops with 2 m/s^2; 0.05 to 0.5 m/s^2 is usual, and a digit "
            "or a unit has slipped",
        ),
        (
            "goliath",
            "hook_types.hook_300.hoist.speed",
            "5 m/s",
            "300 m/min: hoists do up to 120 m/min; a unit or digit has slipped",
        ),
    ],
)
def test_it_is_told_once_at_its_key(scenario: str, key: str, value: str, sentence: str) -> None:
    assert [one for path, one in told(scenario, key, value) if path == key] == [sentence]


def test_a_boom_raises_what_a_hook_comes_to() -> None:
    """Of a boom that luffs its steepest angle counts.

    Heel pins 7.5 m above the keel, 3 m of draft, 55 m of boom at 76 deg; below its head hang 1 m to the upper
    sheaves, a sheave of 0.8 m and a hook block of 2.2 m.
    """
    height = 7.5 - 3.0 + 55.0 * math.sin(math.radians(76.0)) - 1.0 - 0.8 - 2.2
    key = "hook_types.hook_300.highest"
    [said] = [one for path, one in told("off_a_barge", key, "200 m") if path == key]
    assert f"sheaves above at {height:.1f} m with its boom at its steepest" in said
    assert not [path for path, _ in told("off_a_barge", key, f"{height + 1.5} m") if path == key]


@pytest.mark.parametrize(
    ("key", "angle", "sentence"),
    [
        # From -60 deg; 450 - 360 is 90 deg.
        ("to", "450 deg", "by 510.0 deg, all the way round; 'to: 90 deg' is the same heading"),
        ("to", "300 deg", "by 360.0 deg, all the way round; its heading is then as before"),
        ("by", "-380 deg", "by -380.0 deg, all the way round; 'by: -20 deg' is the same heading"),
        ("to", "290 deg", None),
    ],
)
def test_a_slew_all_the_way_round(key: str, angle: str, sentence: str | None) -> None:
    """Of the crane of `wind_turbine`, which stands at -60 deg; its next slew, back to 0 deg, is not told."""
    text = load_scenario("wind_turbine").text
    step = "slew: main, speed: 12 deg/min, to: -22 deg}"
    assert text.count(step) == 1
    text = text.replace(step, f"slew: main, speed: 12 deg/min, {key}: {angle}}}")
    doubts = assemble(parse_scenario(text)).doubts
    said = [one.sentence for one in doubts if "all the way round" in one.sentence]
    assert said == ([] if sentence is None else [f"step 'slew' slews main {sentence}"])
