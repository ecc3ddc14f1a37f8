"""What steps wait for, from words of the lift file to those of the core."""

from __future__ import annotations

from typing import Any

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import BASE, changed

G = 9.7
CRANE = """at: [0 m, 0 m, 20 m]
    rated_capacity: 100 t
    block: {mass: 2 t, height: 2 m}
    reeving: {parts_each: 4, rope: thick, sheave_diameter: 0.6 m, upper_sheaves_at: 40 m,
              rope_weight: none}
    drum: {diameter: 1 m}"""


def lift(until: str) -> str:
    """The base lift with a hook in ropes without weight, whose first step waits for something."""
    return changed(
        BASE,
        ("at: [0 m, 0 m, 20 m]\n    rated_capacity: 100 t", CRANE),
        ("start_at: 0 s, brake_from: 10 s", f"until: {until}"),
        ("sample_interval: 20 ms", f"sample_interval: 20 ms, gravity: {G} m/s^2"),
    )


def first(until: str) -> dict[str, Any]:
    found: dict[str, Any] = assemble(parse_scenario(lift(until))).document["plan"][0]["until"]
    return found


@pytest.mark.parametrize("side", ["above", "below"])
def test_a_mass_stands_for_what_it_weighs(side: str) -> None:
    """30 t under 9.7 m/s^2 are 291 kN."""
    by_mass = first(f"{{hoist_load: {{hook: hook, {side}: 30 t}}}}")
    assert by_mass["bound"] == pytest.approx(30e3 * G, rel=1e-12)
    assert by_mass == first(f"{{hoist_load: {{hook: hook, {side}: 291 kN}}}}")


def test_slings_are_slack_together_and_taut_one_by_one() -> None:
    both = [["sling.S1", 0], ["sling.S2", 0]]
    assert first("{slings: slack}") == {"type": "tension_below", "segments": both, "bound": 0.0}
    assert first("{slings: slack, of: sling.S2}")["segments"] == both[1:]
    # (max - min)/mean of two is 2 at most.
    taut = {"type": "spread", "groups": [["sling.S1", "sling.S2"]], "at_most": 2.0}
    assert first("{slings: taut}") == taut


def warned(until: str) -> list[str]:
    return [one for one in assemble(parse_scenario(lift(until))).warnings if "hoist load" in one]


def test_a_hoist_load_beyond_all_that_hangs_is_doubted() -> None:
    """Load 60 t, frame 5 t, two sheaves of 200 kg, hook block 2 t: 67.4 t; ropes weigh nothing."""
    assert warned("{hoist_load: {hook: hook, above: 67 t}}") == []
    assert warned("{hoist_load: {hook: hook, above: 70 t}}") == [
        "step 'hoist' waits for a hoist load above 70.0 t at hook; all that can hang there weighs 67.4 t "
        "with hook block and falls, and the step does not end by it"
    ]
    assert "weighs 654 kN with" in warned("{hoist_load: {hook: hook, above: 700 kN}}")[0]


def test_a_hoist_load_below_the_empty_hook_is_doubted() -> None:
    """The hook block weighs 2 t."""
    assert warned("{hoist_load: {hook: hook, below: 2.1 t}}") == []
    assert warned("{hoist_load: {hook: hook, below: 1.9 t}}") == [
        "step 'hoist' waits for a hoist load below 1.90 t at hook; hook block and falls alone weigh 2.00 t, "
        "and the step does not end by it"
    ]


@pytest.mark.parametrize(
    ("step", "turns"),
    [
        ("hold: until_met, until: {load_tilt: {above: 80 deg}}", True),
        ("hold: until_met, until: {load_tilt: {below: 1 deg}}", False),
        ("hold: 10 s, require: {load_tilt: above 85 deg}", True),
        ("hold: 10 s, require: {load_tilt: below 1 deg}", False),
    ],
)
def test_a_plan_says_that_it_turns_its_load(step: str, turns: bool) -> None:
    text = changed(BASE, ("hold: until_end", step))
    plan = assemble(parse_scenario(text)).rig["plan"]
    assert [one.get("turns", False) for one in plan] == [False, turns]
