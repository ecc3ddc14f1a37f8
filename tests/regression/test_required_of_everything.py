"""Requirements at the end of a step that nothing can miss, by a slip of the unit: GO, and not a word.

A heel of 50 deg and a tilt of 2000 deg under `limits` were told as limits that let everything pass. The same
at a hold point, `require: {load_tilt: below 200 deg}`, was taken as it was, and the hold point passed.
So did slings below 1000 MN, for kN, of a module of 40 t, and slings that were to keep 10 N, for kN.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

HOLD = "{step: hold point, hold: 20 s"


def told(required: str) -> list[str]:
    """Warnings of the module's lift file that name what its hold point requires."""
    text = LIFT.replace(HOLD, f"{HOLD}, require: {{{required}}}")
    doubts = assemble(parse_scenario(text, "x.yaml")).doubts
    return [f"{doubt.path}: {doubt.sentence}" for doubt in doubts if "require" in doubt.path]


@pytest.mark.parametrize(
    ("required", "key", "said"),
    [
        (
            "load_tilt: below 200 deg",
            "load_tilt",
            "200 deg lets everything pass; a unit or digit has slipped",
        ),
        ("load_yaw: below 200 deg", "load_yaw", "200 deg lets everything pass; a unit or digit has slipped"),
        (
            "equalizer_travel_used: below 6000 %",
            "equalizer_travel_used",
            "6000 % lets everything pass; 100 % is all there is, and a unit or digit has slipped",
        ),
    ],
)
def test_what_everything_meets_is_told(required: str, key: str, said: str) -> None:
    assert told(required) == [f"plan[3].require.{key}: a limit of {said}"]


@pytest.mark.parametrize(
    "required", ["load_tilt: below 1 deg", "load_tilt: below 170 deg", "load_yaw: above 2 deg"]
)
def test_what_something_misses_is_not(required: str) -> None:
    """A load that is turned over comes to 180 deg; what has to be above an angle is another matter."""
    assert told(required) == []


#: What all of the module of 40 t with its contingency of 1.15 weighs [N].
WEIGHT = 40e3 * 1.15 * 9.81


@pytest.mark.parametrize(
    ("required", "times", "passes"),
    [
        ("sling_tension: below 1,000 MN", f"is {1e9 / WEIGHT:,.0f} times what all", "lets everything pass"),
        ("hook_load: below 500 MN", f"is {5e8 / WEIGHT:,.0f} times what all", "lets everything pass"),
        ("sling_tension: above 10 N", f"is one part in {WEIGHT / 10:,.0f}", "what is all but slack has that"),
    ],
)
def test_a_force_that_everything_keeps_is_told(required: str, times: str, passes: str) -> None:
    key, _, bound = required.partition(": ")
    (said,) = told(required.replace(",", ""))
    assert said.startswith(f"plan[3].require.{key}: {bound} {times}")
    assert said.endswith(f"{passes}; a unit or digit has slipped")


@pytest.mark.parametrize(
    "required",
    [
        "sling_tension: below 1 MN",
        "sling_tension: above 1 kN",
        "hook_load: below 9 MN",
        "hook_load: above 1 N",
    ],
)
def test_a_force_that_something_misses_is_not(required: str) -> None:
    """Level slings bear some times the load, and that something hangs in a hook at all may be asked."""
    assert told(required) == []


def test_a_least_tension_in_newtons_is_told() -> None:
    """The same under `limits`, where slings are to stay taut while the load is clear."""
    text = LIFT + "limits: {rule: example, smallest_sling_tension_when_clear: 10 N}\n"
    doubts = [one for one in assemble(parse_scenario(text, "x.yaml")).doubts if "limits" in one.path]
    assert [one.path for one in doubts] == ["limits.smallest_sling_tension_when_clear"]
