"""What somebody writes who comes from data sheets, and what the answers did not say.

A slewing speed in `rpm` was no unit, without a word of `rev/min`; a key that a hoist step does not know was
answered with twelve others, of which neither `to` nor `by` was one; a plan that waits for a load to touch
down was told that it waits for one to leave the ground; a warning ended in `as most charts do and 5 more`;
and water carried up to `1.92e+03 t`.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import NO_WARNINGS, check_recording
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.scenario.errors import ScenarioError
from gantline.units import UnitError, quantity
from lift_text import BASE, changed
from module_lift import module_lift
from sample_lift import ringing_lift

LIFT = """\
format: 1
lift: {title: A lift}
duration: 9 s
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 20 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
plan:
  - {step: down, lower: hook, speed: 1 m/min, %s}
"""


def answer(ending: str) -> str:
    with pytest.raises(ScenarioError) as found:
        parse_scenario(LIFT % ending)
    return str(found.value)


@pytest.mark.parametrize("unit", ["rpm", "1/min", "U/min"])
def test_revolutions_per_minute_have_a_unit(unit: str) -> None:
    with pytest.raises(UnitError, match="did you mean 'rev/min'"):
        quantity(f"0.2 {unit}", "angular_speed")


def test_a_step_names_its_own_keys_before_those_of_every_step() -> None:
    assert "did you mean 'to'?" in answer("height: 3 m")
    assert "did you mean 'by'?" in answer("distance: 3 m")
    known = answer("quickly: 3 m").partition("known here: ")[2]
    assert known.startswith("'to', 'acceleration', ") and "'by'" in known


def test_a_plan_waits_for_what_it_says() -> None:
    assert "this waits for a load to come down;" in answer("until: {supports: touched}")
    assert "this waits for a load to leave the ground;" in answer("until: {supports: clear}")


@pytest.mark.parametrize(
    ("warnings", "told"),
    [
        (["first"], "first"),
        (["first", "second"], "first; and 1 more warning"),
        (["first", "second", "third"], "first; and 2 more warnings"),
    ],
)
def test_further_warnings_are_counted_as_such(warnings: list[str], told: str) -> None:
    one = ringing_lift()
    recording = Recording(one.variables, one.coordinates, {**one.attributes, "warnings": warnings})
    assert [check.remark for check in check_recording(recording) if check.name == NO_WARNINGS] == [told]


def test_more_than_a_thousand_tonnes_are_written_out() -> None:
    # Sea water on a box of 25 x 25 m, 3 m high, that is wholly under: 1.025 t/m^3 * 1875 m^3 = 1922 t.
    text = module_lift(
        6.0,
        place=(60.0, 2.0),
        speed=12.0,
        duration=60.0,
        ground="ground: {level: -30 m}\n",
        around="water: {density: 1025 kg/m^3}\n",
    )
    assert text.count("box: [4 m, 4 m, 3 m]") == 1
    wide = text.replace("box: [4 m, 4 m, 3 m]", "box: [25 m, 25 m, 3 m]")
    warnings = gantline.simulate(parse_scenario(wide)).attributes["warnings"]
    assert [one.rpartition("up to ")[2] for one in warnings if "into the water" in one] == ["1,920 t"]


def test_a_pin_that_is_pulled_and_was_not_in() -> None:
    """The advice was `locked: true`, beside a list of others; and "already" of pins that never were in."""
    one = ("{step: hold, hold: until_end}", "{step: hold, hold: until_end, pull_pins: e1.2}")
    beside = ("travel: {up: 1 m", "travel: {locked: [1], up: 1 m")
    with pytest.raises(ScenarioError) as found:
        parse_scenario(changed(BASE, one, beside))
    said = "the pin of 'e1.2' is not in; 'travel: {locked: [1, 2]}' puts it in at the start"
    assert str(found.value).endswith(said)
