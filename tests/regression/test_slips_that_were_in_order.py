"""Mistakes in a lift file that `gantline check` found in order, or answered with something else.

`calculated: 4800 t` for 480 t under a Goliath crane of 900 t was in order; with a digit more the load sank
into its supports, and the slings should be made longer. Two slings less left an equalizer empty, and without
the equalizer the plan still hoisted its hook. `heading: 90 rad` turned a frame by 14 turns.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from four_slings import HANDED_OVER, LIFT
from gantline.assembly import assemble
from gantline.assembly.doubts.weight import doubtful_weight
from gantline.scenario import StartError, load_scenario, parse_scenario, resolve
from gantline.scenario.errors import Doubt
from lift_text import BASE, changed

GOLIATH = Path(__file__).parents[2] / "scenarios" / "goliath"
SLIPPED = "; a unit or digit has slipped"
RATED = "may carry 46 t in all"


def warnings(text: str, words: str) -> list[str]:
    return [said for said in assemble(parse_scenario(text)).warnings if words in said]


@pytest.mark.parametrize(
    ("calculated", "says"),
    [
        ("46 t", []),
        ("47 t", [f"the load weighs 47 t, and what its slings hang from {RATED}"]),
        ("92 t", [f"the load weighs 92 t, and what its slings hang from {RATED}"]),
        ("400 t", [f"the load weighs 400 t, and what its slings hang from {RATED}{SLIPPED}"]),
    ],
)
def test_a_load_too_heavy_for_its_crane_is_told(calculated: str, says: list[str]) -> None:
    """The crane may carry 46 t; from twice that on nothing can be meant."""
    assert warnings(LIFT.replace("calculated: 40 t", f"calculated: {calculated}"), "in all") == says


def test_a_hook_without_a_rating_may_carry_anything() -> None:
    """The second hook of a lift that is handed over has none."""
    assert not warnings(HANDED_OVER.replace("calculated: 40 t", "calculated: 400 t"), "in all")


def test_the_least_of_hooks_trolleys_and_crane_counts() -> None:
    """Of the hooks of a trolley that trolley, of both trolleys the crane: less than the sum of all hooks."""
    lift = load_scenario(GOLIATH)
    rigging = resolve(lift)
    assert list(doubtful_weight(lift, rigging)) == []
    heavy = lift.changed({"load.weight.calculated": "4800 t"})
    told = f"the load weighs 4,800 t, and what its slings hang from may carry 900 t in all{SLIPPED}"
    assert list(doubtful_weight(heavy, rigging)) == [Doubt(("load", "weight"), told)]


def test_a_start_that_only_the_weight_makes_impossible_is_told_by_it() -> None:
    heavy = changed(LIFT, ("calculated: 40 t", "calculated: 600000 t"))
    with pytest.raises(StartError) as refused:
        assemble(parse_scenario(heavy))
    said = {problem.path: problem.sentence for problem in refused.value.problems}
    assert list(said) == ["ground.stiffness", "load.weight"]  # as they stand in the file
    assert said["load.weight"] == f"the load weighs 600,000 t, and what its slings hang from {RATED}{SLIPPED}"


def test_an_equalizer_without_a_sling_is_told() -> None:
    second = "  e2:\n" + BASE.split("  e1:\n")[1].split("slings:")[0]
    empty = BASE.replace("slings:\n  S1", f"{second}slings:\n  S1")
    assert warnings(BASE, "no sling hangs from equalizer") == []
    assert warnings(empty, "no sling hangs from equalizer") == ["no sling hangs from equalizer e2"]


def test_a_hook_that_is_hoisted_with_nothing_in_it_is_told() -> None:
    """The first step that moves it is named."""
    hoist = "hoist: {speed: 3 m/min, acceleration: 0.1 m/s^2}"
    other = f"  other: {{type: fixed_hook, at: [9 m, 0 m, 11 m], {hoist}}}\n"
    text = LIFT.replace("slings:\n", f"{other}slings:\n")
    assert warnings(text, "nothing hangs") == []
    moved = text.replace("{step: hoist, hoist: crane,", "{step: hoist, hoist: [crane, other],")
    assert warnings(moved, "nothing hangs") == ["nothing hangs in hook other, which step 'hoist' hoists"]


@pytest.mark.parametrize(("heading", "is_told"), [("90 rad", True), ("6.29 rad", True), ("6.28 rad", False)])
def test_a_heading_of_many_turns_is_told(heading: str, is_told: bool) -> None:
    """A turn is 6.283 rad; 90 rad are 14.3 of them. Of degrees 450 deg may be meant."""
    said = warnings(headed(heading), " turns; ")  # crossed slings of a frame so turned are told, too
    assert len(said) == is_told
    if heading == "90 rad":
        assert said == ["90 rad are 14.3 turns; '90 deg' may be meant"]
    assert not warnings(headed("450 deg"), " turns; ")


def headed(heading: str) -> str:
    return BASE.replace("hangs_from: hook\n", f"hangs_from: hook\n    heading: {heading}\n")
