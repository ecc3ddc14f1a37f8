"""A thing without its name, `waves: {significant_height: 1 m, …}`, was told once for each of its keys.

They were taken for names. Of a vessel there were eight sentences, among them "vessels.hull: 'hull' is
missing", and none said that the name of the vessel was.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario

VESSEL = "vessels:\n  position: [9 m, 0 m]\n  draft: 3 m\n  hull: {box: [60 m, 20 m, 5 m]}\n"
CRANE = (
    "  crane:\n    {type: fixed_hook, at: [0 m, 0 m, 11 m], rated_capacity: 46 t,\n"
    "     hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}\n"
)


def said(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return [f"{one.line}: {one.path}: {one.sentence}" for one in error.value.problems]


def needed(key: str, of: str, right: str) -> str:
    wrong = f"'{key}' is a key of {of}, and stands where the name of one is needed"
    return f"{wrong}; a name of yours comes before it, such as '{right}'"


@pytest.mark.parametrize(
    ("old", "new", "where", "sentence"),
    [
        (
            "load:\n",
            "waves: {significant_height: 1 m, peak_period: 8 s, direction: 150 deg}\nload:\n",
            "7: waves.significant_height",
            needed("significant_height", "waves", "waves: {first: {significant_height: 1 m, …}}"),
        ),
        (
            "load:\n",
            f"{VESSEL}load:\n",
            "8: vessels.position",
            needed("position", "a vessel", "vessels: {first: {position: …, …}}"),
        ),
        (
            CRANE,
            "  type: fixed_hook\n  at: [0 m, 0 m, 11 m]\n  hoist: {speed: 3 m/min}\n",
            "19: cranes.type",
            needed("type", "a crane", "cranes: {first: {type: fixed_hook, …}}"),
        ),
        (
            "    A: {at: [-2.5 m,  1.5 m, 3 m], capacity: 13.2 t}\n",
            "    at: [-2.5 m,  1.5 m, 3 m]\n",
            "14: load.lugs.at",
            needed("at", "a lug", "lugs: {first: {at: …, …}}"),
        ),
    ],
)
def test_the_name_is_asked_for_once(old: str, new: str, where: str, sentence: str) -> None:
    assert old in LIFT
    assert said(LIFT.replace(old, new)) == [f"{where}: {sentence}"]


def test_what_has_a_name_and_is_no_mapping_is_told_as_before() -> None:
    text = LIFT.replace("  A: {from: crane, to: module.A, length: 8.6 m, rope: sling}", "  A: 8.6 m")
    (told,) = said(text)
    assert "slings.A: found '8.6 m'; a sling is a mapping with keys such as to, from, over" in told
