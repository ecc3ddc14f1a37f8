"""Words for what holds a load to a deck or a bed: `seafastening` met a list of keys that it is none of.

Of `lashings` it said "did you mean 'slings', which is there already?", of `suction` "did you mean
'simulation'?". Both are ropes of `mechanics`: lashings, which a step lets go of, and mud or suction, which
breaks at what it takes to come free.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import BASE, spoiled

LASHED = "are ropes under 'mechanics', each from it to there, with 'length: as_routed', until a step lets go"
STUCK = "is a rope under 'mechanics' from it to the world or the deck"


def said(text: str) -> str:
    """Sentences of all problems, with their paths."""
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return "\n".join(f"{one.path}: {one.sentence}" for one in error.value.problems)


@pytest.mark.parametrize(
    ("key", "right"),
    [("seafastening", LASHED), ("sea_fastenings", LASHED), ("lashings", LASHED), ("suction", STUCK)],
)
def test_sections(key: str, right: str) -> None:
    told = said(f"{BASE}{key}: {{a: {{at: [0 m, 0 m, 0 m]}}}}\n")
    assert f"{key}: '{key}' is not a key of a lift file: what holds a load to" in told
    assert right in told


@pytest.mark.parametrize(
    ("key", "right"), [("seafastened_to", LASHED), ("fixed_to", LASHED), ("breakout_force", STUCK)]
)
def test_of_the_load(key: str, right: str) -> None:
    told = said(spoiled("  stands_on: ground\n", f"  stands_on: ground\n  {key}: deck\n"))
    assert f"'{key}' is not a key of the load: what holds a load to" in told
    assert right in told
