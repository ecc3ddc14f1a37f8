"""Words of other crews, which the answer did not repeat or took for others.

`lift: hook` and `wait: 5 s` in a step were answered with all twelve things that a step can do, and `lift` was
not named; `steps:` was asked "did you mean 'cases'?", `sling_angle` "did you mean 'fleet_angle'?"; of `typ:`
nothing was said but that `type` is missing, and of a cylinder nothing but what a shape is. `until: supports
clear` was told that `until` is a mapping, and not which.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.scenario.errors import ScenarioError
from lift_text import spoiled

VERBS = (
    "a step says what is done: it has one of the keys 'hoist', 'lower', 'traverse', 'travel', 'luff', "
    "'slew', 'lead', 'haul_in', 'pay_out', 'haul', 'veer', 'pump' and 'hold'"
)


def answer(old: str, new: str) -> str:
    """What is said first, without file and line."""
    with pytest.raises(ScenarioError) as found:
        parse_scenario(spoiled(old, new))
    return str(found.value).splitlines()[0].partition(": ")[2]


@pytest.mark.parametrize(
    ("key", "verb"),
    [("lift", "hoist"), ("hoists", "hoist"), ("raise", "hoist"), ("wait", "hold"), ("turn", "slew")],
)
def test_a_step_that_does_something_else_is_named(key: str, verb: str) -> None:
    said = answer("{step: hoist, hoist: hook", f"{{step: hoist, {key}: hook")
    assert said == f"step 'hoist', plan[1]: '{key}' is not what a step can do; did you mean '{verb}'?"


def test_a_step_that_does_nothing_is_told_what_there_is() -> None:
    assert (
        answer("{step: hoist, hoist: hook", "{step: hoist, pull_pins: e1")
        == f"step 'hoist', plan[1]: {VERBS}"
    )


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("plan:\n", "steps:\n", "steps: 'steps' is not a key of a lift file; did you mean 'plan'?"),
        (
            "load_tilt: 2 deg",
            "sling_angle: 30 deg",
            "limits.sling_angle: 'sling_angle' is not a key of limits; "
            "did you mean 'sling_angle_from_vertical'?",
        ),
        (
            "limits: {",
            "rules: {daf: 1.1}\nlimits: {",
            "rules.daf: 'daf' is not a key of rules; did you mean 'dynamic_amplification_factor'?",
        ),
        (
            "    type: fixed_hook",
            "    typ: fixed_hook",
            "cranes.hook: 'type' is missing; a crane is one of 'fixed_hook', 'goliath', 'floating_crane', "
            "'crawler' (is 'typ' meant for 'type'?)",
        ),
        (
            "{box: [8 m, 6 m, 3 m]}",
            "{cylinder: [3 m, 8 m]}",
            "load.shape.cylinder: found a list; a cylinder is a mapping with keys such as diameter, length, "
            "along, end_diameter, wall",
        ),
        (
            "{top: wb40, bottom: wb40}",
            "wb40",
            "slings.S1.shackles: found 'wb40'; the shackles of a sling are a mapping with keys such as top, "
            "bottom; write {top: wb40, bottom: wb40}",
        ),
        (
            "shackles: {top: wb40, bottom: wb40}",
            "bends_about: 300 mm",
            "slings.S1.bends_about: found '300 mm'; what the eyes of a sling lie on are a mapping with keys "
            "such as top, bottom; write {top: 300 mm}",
        ),
    ],
)
def test_the_answer_says_what_is_meant(old: str, new: str, says: str) -> None:
    assert answer(old, new) == says


@pytest.mark.parametrize(
    ("until", "what", "keys", "right"),
    [
        ("supports clear", "until is", "load_transferred, supports", "{supports: clear}"),
        ("load_transferred 2 %", "until is", "load_transferred, supports", "{load_transferred: 2 %}"),
        ("{load_tilt: above 70 deg}", "load_tilt is", "above, below", "{above: 70 deg}"),
    ],
)
def test_a_mapping_in_words_is_written_out(until: str, what: str, keys: str, right: str) -> None:
    said = answer("start_at: 0 s, brake_from: 10 s}", f"until: {until}}}")
    assert f"; {what} a mapping with keys such as {keys}" in said
    assert said.endswith(f"; write {right}")


def test_a_mapping_in_other_words_is_not_guessed() -> None:
    said = answer("start_at: 0 s, brake_from: 10 s}", "until: clear}")
    assert said.startswith("step 'hoist', plan[1].until: found 'clear'; until is a mapping")
    assert "write" not in said
