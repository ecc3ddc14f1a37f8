"""A boom of 60 kg on a crane of 360 t was in order, as its chart alone says what it may carry.

`gantline check` told a boom with kg for t where the crane has a `rated_capacity`. Crawler and mobile cranes
have a chart in place of it as a rule: theirs was not looked at, and neither was a trolley without a rated
capacity of its own on a crane that has one.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def slipped(folder: Path, changes: dict[str, object]) -> list[str]:
    lift = load_scenario(folder).changed(changes)
    return [one for one in assemble(lift).warnings if "a unit has slipped, kg for t" in one]


def test_a_boom_is_held_against_the_most_of_its_chart() -> None:
    """A hundredth of the 360 t of its chart are 3.6 t; the boom has 60 t."""
    lift, mass = SCENARIOS / "floating_crane_and_crawlers", "cranes.c1.boom.mass"
    assert slipped(lift, {}) == []
    assert slipped(lift, {mass: "4 t"}) == []
    [told] = slipped(lift, {mass: "60 kg"})
    assert "the boom of c1 weighs 60 kg, and the rated capacity is 360.0 t" in told


@pytest.mark.parametrize(("mass", "count"), [("300 kg", 1), ("10 t", 0)])
def test_a_trolley_is_held_against_its_crane(mass: str, count: int, tmp_path: Path) -> None:
    """A hundredth of the 900 t of the crane are 9 t."""
    folder = shutil.copytree(SCENARIOS / "goliath", tmp_path / "goliath")
    text = (folder / "scenario.yaml").read_text()
    own = "        mass: 300 t\n        rated_capacity: 600 t\n"
    assert own in text
    (folder / "scenario.yaml").write_text(text.replace(own, f"        mass: {mass}\n"))
    assert len(slipped(folder, {})) == count
