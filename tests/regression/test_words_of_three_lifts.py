"""Three lifts written from the docs alone: a bridge section from a barge, a jacket leg with a tail tugger, a
machine on trunnions through a roof. What their crews say was answered with a dozen other words: `trunnions`
with 'datum' to 'tanks', `tuggers` with 'axes' to 'wind', an overhead crane with four types of crane.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import BASE, spoiled

LUGS = "  lugs:\n    L1:"
VESSEL = "vessels:\n  barge: {hull: {box: [60 m, 14 m, 3 m]}, draft: 1 m, "


def said(text: str) -> str:
    """Sentences of all problems, with their paths."""
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return "\n".join(f"{one.path}: {one.sentence}" for one in error.value.problems)


@pytest.mark.parametrize(
    ("key", "right"),
    [
        ("tuggers", "tag_lines"),
        ("clearance", "watch"),
    ],
)
def test_sections(key: str, right: str) -> None:
    assert f"'{key}' is not a key of a lift file; did you mean '{right}'?" in said(f"{BASE}{key}: {{a: 1}}\n")


@pytest.mark.parametrize(("key", "right"), [("trunnions", "lugs"), ("on", "stands_on")])
def test_of_the_load(key: str, right: str) -> None:
    text = spoiled("  stands_on: ground\n  lugs:", f"  {key}: ground\n  mine:")
    assert f"'{key}' is not a key of the load; did you mean '{right}'?" in said(text)


def test_a_tube_is_a_cylinder() -> None:
    text = spoiled("{box: [8 m, 6 m, 3 m]}", "{tube: {diameter: 2 m}}")
    assert "found 'tube'; a tube is a 'cylinder' with a 'wall'; a shape is" in said(text)


@pytest.mark.parametrize("kind", ["overhead_crane", "bridge_crane"])
def test_a_crane_of_a_hall(kind: str) -> None:
    text = spoiled("type: fixed_hook", f"type: {kind}")
    right = (
        "'type: goliath' with 'end_carriages' in place of legs, and the 'rail_level' that these run at, here"
    )
    assert f"a '{kind}' is written as {right}" in said(text)


def test_a_crane_with_two_trolleys() -> None:
    text = spoiled("type: fixed_hook", "type: double_trolley_crane")
    assert "a 'double_trolley_crane' is written as 'type: goliath' here" in said(text)


@pytest.mark.parametrize(
    ("kind", "right"),
    [
        ("river", "is 'type: dock'"),
        ("pier", "is 'type: box'"),
        ("opening", "'type: box' around it leave free"),
    ],
)
def test_structures(kind: str, right: str) -> None:
    told = said(f"{BASE}structures: {{s: {{type: {kind}}}}}\n")
    assert f"structures.s: '{kind}' is not a type that is known here; " in told
    assert right in told


def test_of_a_vessel() -> None:
    told = said(f"{BASE}water: {{level: 0 m}}\n{VESSEL}length: 60 m, at: [0 m, 0 m]}}\n")
    assert "'length' is not a key of a vessel: what of it displaces water is its 'hull', such as" in told
    assert "'at' is not a key of a vessel: where it lies is its 'position', x and y of the world" in told


@pytest.mark.parametrize(
    ("step", "told"),
    [
        ("{step: s, tandem: hook}", "'tandem' is not what a step can do; did you mean 'lead'?"),
        ("{step: s, release: tag.west}", "of a tag line by 'cut: tag.west', of a slack sling by 'detach:"),
        (
            "{step: s, hold: 1 s, release: tag.west}",
            "is not a key of a hold step: beside what it does a step",
        ),
        (
            "{step: s, lower: hook, speed: 1 m/min, until: {landed: pier}}",
            "on its supports is 'supports: touch",
        ),
        ("{step: s, hoist: hook, speed: 1 m/min, until: {load: clear}}", "hangs clear is 'supports: clear'"),
    ],
)
def test_of_the_plan(step: str, told: str) -> None:
    assert told in said(f"{BASE.partition('plan:')[0]}plan: [{step}]\n")
