"""What is refused, or doubted, of rating charts that hooks of a boom have of their own."""

from __future__ import annotations

import pytest

from boom_lift import boom_lift
from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario

AUX = "{outreach: [20 m, 80 m], rated: [100 t, 60 t]}"
MAIN = "    rating: {outreach: [20 m, 80 m], rated: [900 t, 300 t]}\n"


def lift(aux: str, main: str = MAIN, own: str = "") -> str:
    """A lift with a main hook, with a chart `own` if it is given, and a hook on a jib with `aux`."""
    hooks = (
        f"H1: {{type: H, height: 40 m{f', rating: {own}' if own else ''}}}\n"
        f"H2: {{type: H, along: 12 m, height: 60 m, rating: {aux}}}"
    )
    return boom_lift(hooks=hooks).replace("    luffing:", main + "    luffing:")


def refusal(text: str) -> str:
    with pytest.raises(ScenarioError) as found:
        parse_scenario(text)
    assert len(found.value.problems) == 1
    return str(found.value)


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        (
            lift("{radius: [20 m, 80 m], rated: [100 t, 60 t]}"),
            "cranes.fc.hooks.H2.rating.radius",
            "'outreach' is right",
        ),
        (
            lift("{outreach: [20 m, 80 m], rated: [100 t, 60 t], hooks_share: 50 %}"),
            "cranes.fc.hooks.H2.rating.hooks_share",
            "this chart is for 'H2' alone, which has the whole row; leave 'hooks_share' out",
        ),
        (
            lift(AUX, ""),
            "cranes.fc.hooks.H1",
            "this hook has no rating chart, nor has fc, and 'H2' has one of its own; give it a 'rating' too",
        ),
        (
            lift(AUX, own=AUX),
            "cranes.fc.rating",
            "each hook of fc has a rating chart of its own, so that this one rates none; leave it out",
        ),
        (
            lift("{outreach: [20 m, 80 m], rated: [100 t, 80 t, 60 t]}"),
            "cranes.fc.hooks.H2.rating.rated",
            "3 loads stand beside 2 places of 'outreach'",
        ),
    ],
)
def test_what_is_wrong_with_charts_of_hooks_is_told_with_its_place(text: str, path: str, words: str) -> None:
    message = refusal(text)
    assert path in message
    assert words in message


@pytest.mark.parametrize(
    ("aux", "words"),
    [
        ("{outreach: [20 m, 80 m], rated: [60 t, 100 t]}", "fc.H2 has 100.0 t at 80.0 m and only"),
        ("{outreach: [20 m, 190 m], rated: [100 t, 60 t]}", "fc.H2 has a row at 190.0 m"),
        ("{angle: [20 deg, 70 deg], rated: [60 t, 100 t]}", "fc.H2 has nothing between 20.0 deg"),
    ],
)
def test_charts_of_hooks_in_doubt_are_told_as_those_of_cranes(aux: str, words: str) -> None:
    found = [str(one) for one in assemble(parse_scenario(lift(aux))).doubts if words in str(one)]
    assert len(found) == 1
    assert "cranes.fc.hooks.H2.rating" in found[0]
