"""A hull 65 m deep for 6.5 m had a freeboard of 62 m, and no water ever came over its deck.

The limit on freeboard was ok whatever hung in the crane. A fairlead at a height of -6.5 m for 6.5 m lay under
the keel, where 10 m off the hull are allowed in all directions; both passed without a word.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


def told(**changes: object) -> list[str]:
    changed = {key.replace("__", "."): one for key, one in changes.items()}
    doubts = assemble(load_scenario("revolving_crane").changed(changed)).doubts
    return [f"{one.path}: {one.sentence}" for one in doubts]


@pytest.mark.parametrize(("depth", "shown"), [("6.5 m", None), ("32 m", None), ("65 m", "62.0 m")])
def test_higher_than_wide(depth: str, shown: str | None) -> None:
    """A barge of 90 × 30 m with a draft of 3 m: 65 m - 3 m are out of the water."""
    said = [
        f"vessels.barge.hull.box: barge has a hull that stands {shown} out of the water, and is 30 m wide: a "
        "digit of its depth or draft has slipped"
    ]
    assert told(vessels__barge__hull__box=["90 m", "30 m", depth]) == (said if shown else [])


@pytest.mark.parametrize(("height", "shown"), [("6.5 m", None), ("-1 m", None), ("-6.5 m", "6.5 m")])
def test_a_fairlead_under_the_keel(height: str, shown: str | None) -> None:
    line = "mooring_lines.bow.ps.fairlead"
    said = [f"{line}: mooring line bow.ps ends {shown} below the keel of barge; heights count up from it"]
    fairlead = ["88 m", "14 m", height]
    assert [one for one in told(**{line: fairlead}) if "keel" in one] == (said if shown else [])
