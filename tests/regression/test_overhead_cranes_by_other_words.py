"""Overhead cranes as a stranger writes them: words of other crews, and rails left on the floor.

`rail_level` left out, or mistyped as 140 m, was taken in silence: the girder was then 15 m below, or 126 m
above, the sheaves of its own falls, its end carriages were watched there, and its corners had the pull of
falls out of plumb with that lever. `type: overhead` and `eot` were no crane, a limit `wheel_load` none of the
limits, `wheel_base` no key; under `watch`, `hall.legs` was asked whether it meant the hook `hall.B`.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from shown import ROOT, lift_on

LIFT = lift_on(ROOT / "docs" / "concepts" / "goliath.md", "An overhead crane carries a machine")
RAILS, CARRIAGES = "rail_level: 14 m", "end_carriages: {mass: 12 t, base: 5.6 m}"


def doubts(old: str, new: str) -> tuple[str, ...]:
    assert old in LIFT
    return assemble(parse_scenario(LIFT.replace(old, new, 1))).warnings


def refusal(text: str) -> str:
    with pytest.raises(ScenarioError) as found:
        assemble(parse_scenario(text))
    return str(found.value)


@pytest.mark.parametrize(
    ("rails", "underside"),
    [("wind_limit: 20 m/s", "0.6 m"), ("rail_level: 140 m", "140.6 m"), ("rail_level: 2 m", "2.6 m")],
)
def test_rails_far_from_the_sheaves_are_a_warning(rails: str, underside: str) -> None:
    (said,) = doubts(RAILS, rails)
    assert said == (
        f"the girder of hall has its underside at {underside}, and the upper sheaves of hall.A are at "
        "15.5 m, both in the world; 'rail_level' is the height of the rails, 'underside' of the girder its "
        "own above these"
    )


@pytest.mark.parametrize("rails", ["rail_level: 14 m", "rail_level: 12 m", "rail_level: 15 m"])
def test_sheaves_on_a_girder_or_under_it_are_none(rails: str) -> None:
    assert doubts(RAILS, rails) == ()


@pytest.mark.parametrize("word", ["overhead", "eot", "hall_crane", "overhead_travelling_crane"])
def test_types_by_other_words(word: str) -> None:
    said = refusal(LIFT.replace("type: goliath", f"type: {word}"))
    assert f"a '{word}' is written as 'type: goliath' with 'end_carriages' in place of legs" in said


@pytest.mark.parametrize(
    ("old", "new", "meant"),
    [
        ("base: 5.6 m", "wheel_base: 5.6 m", "base"),
        ("plan:\n", "limits: {wheel_load: 400 kN}\nplan:\n", "corner_load"),
    ],
)
def test_keys_by_other_words(old: str, new: str, meant: str) -> None:
    assert f"did you mean '{meant}'?" in refusal(LIFT.replace(old, new))


def test_what_a_girder_stands_on_is_watched_by_its_kind() -> None:
    """Of an overhead crane carriages, of one on legs these."""
    watch = "watch: [{between: [machine, hall.legs], smallest: 1 m}]\n"
    assert "'hall.legs' has no shape; did you mean 'hall.end_carriages'?" in refusal(LIFT + watch)
    legs = LIFT.replace(CARRIAGES, "legs: {fixed: 5 t, hinged: 5 t}").replace(RAILS, "wind_limit: 20 m/s")
    said = refusal(
        legs.replace("underside: 0.6 m", "underside: 14.6 m") + watch.replace("legs", "end_carriages")
    )
    assert "'hall.end_carriages' has no shape; did you mean 'hall.legs'?" in said
