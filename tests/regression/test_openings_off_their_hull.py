"""An opening 350 m ahead of its vessel was in order, and the freeboard of the one that was meant unknown."""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import LENGTH, barge, lift_of, written
from gantline.scenario import ScenarioError, load_scenario


def test_an_opening_off_its_hull_is_refused(tmp_path: Path) -> None:
    """Of 100 m from the stern to the bow."""
    given = lift_of(barge(openings={"vent": ["450 m", "0 m", "9 m"]}))
    with pytest.raises(ScenarioError) as caught:
        load_scenario(written(tmp_path, given))
    [problem] = caught.value.problems
    assert problem.path == "vessels.barge.openings.vent"
    assert problem.sentence == (
        f"this is {450 - LENGTH:g} m outside the hull of 'barge'; it counts along the vessel's axes, from "
        "stern, keel and centre plane"
    )


def test_one_high_above_the_deck_is_not(tmp_path: Path) -> None:
    lift = load_scenario(written(tmp_path, lift_of(barge(openings={"vent": ["50 m", "0 m", "40 m"]}))))
    assert lift.vessels is not None
    assert lift.vessels["barge"].openings == {"vent": (50.0, 0.0, 40.0)}
