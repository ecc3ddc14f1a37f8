"""Words that a newcomer looks for and that have another place were answered with whatever is written alike.

`losses` of an equalizer had a list of unlike keys, `upend` in a step "did you mean 'speed', which is there
already?", and `body_contacts` beside the load twelve keys of a lift file, without `mechanics` among them.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, load_scenario, parse_scenario


def said(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return [f"{one.path}: {one.sentence}" for one in error.value.problems]


@pytest.mark.parametrize("key", ["losses", "loss", "sheave_efficiency"])
def test_losses_of_an_equalizer(key: str) -> None:
    """What is said in their place is right, too."""
    text = load_scenario("equalizer").text
    hangs = "    hangs_from: test_hook\n"
    assert text.count(hangs) == 1
    assert said(text.replace(hangs, f"{hangs}    {key}: 2 %\n")) == [
        f"equalizers.e1.{key}: '{key}' is not a key of an equalizer: losses of its sheaves stand under "
        "'sheaves', such as 'sheaves: {loss: 2 %}' or '{bearing: roller}'"
    ]
    bare = text.replace(" efficiency: 1.0,", "")
    right = bare.replace(hangs, f"{hangs}    sheaves: {{loss: 2 %}}\n")
    equalizers = parse_scenario(right).equalizers
    assert equalizers is not None and equalizers["e1"].sheaves is not None


def test_upending() -> None:
    told = "a load is upended by one hook that hoists or lowers, 'until: {load_tilt: {above: 80 deg}}'"
    text = LIFT.replace("{step: hoist, hoist: crane", "{step: up, upend: module, hoist: crane")
    assert said(text) == [f"plan[2].upend: 'upend' is not a key of a hoist step: {told}"]
    text = LIFT.replace("{step: hoist, hoist: crane", "{step: up, upend: crane")
    (verb,) = said(text)
    assert "'upend' is not what a step can do; did you mean 'hoist'?" in verb


@pytest.mark.parametrize("key", ["bodies", "body_contacts", "contacts", "drums"])
def test_what_stands_under_mechanics(key: str) -> None:
    assert said(f"{LIFT}{key}: {{}}\n") == [
        f"{key}: '{key}' is not a key of a lift file: it stands under 'mechanics'"
    ]
