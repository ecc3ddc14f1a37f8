"""What is doubtful about a type was told once for each thing that has it.

A boom of 60 kg in a type of two crawler cranes had two lines at one place of the file, which differed in the
name of the crane alone; a type of twelve mooring lines would have twelve.
"""

from __future__ import annotations

from pathlib import Path

from gantline.assembly import assemble
from gantline.assembly.doubts.of_types import said_once
from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.scenario.errors import Doubt

SCENARIO = Path(__file__).parents[2] / "scenarios/floating_crane_and_crawlers/scenario.yaml"


def lift(more: str = "") -> Scenario:
    text = SCENARIO.read_text(encoding="utf-8")
    assert text.count("radius: 16 m, mass: 60 t") == 1
    text = text.replace("radius: 16 m, mass: 60 t", "radius: 16 m, mass: 60 kg")
    crane = "c2: {type: crawler_400, "
    assert text.count(crane) == 1
    return parse_scenario(text.replace(crane, crane + more), str(SCENARIO))


def told(scenario: Scenario) -> list[tuple[str, str]]:
    return [(one.path, one.sentence) for one in assemble(scenario).doubts if "weighs 60 kg" in one.sentence]


def test_it_stands_once_with_the_other_name() -> None:
    ((path, sentence),) = told(lift())
    assert path == "crane_types.crawler_400.boom"
    assert sentence.startswith("the boom of c1 weighs 60 kg, ")
    assert sentence.endswith("; a unit has slipped, kg for t (c2 alike)")


def test_what_a_crane_says_itself_stands_by_itself() -> None:
    """The same mass, said by the second crane: a line of its own, at its own place."""
    found = told(lift("boom: {mass: 60 kg}, "))
    assert [path for path, _ in found] == [
        "crane_types.crawler_400.boom",
        "crane_types.crawler_400.boom",
    ] or [path for path, _ in found] == ["crane_types.crawler_400.boom", "cranes.c2.boom"]


def test_figures_keep_them_apart() -> None:
    scenario = load_scenario(SCENARIO)
    place = ("boom", "mass")
    doubts = [
        Doubt(("cranes", name, *place), f"{name}.H: {figure} t") for name, figure in (("c1", 1), ("c2", 2))
    ]
    assert [one.sentence for one in said_once(scenario, doubts)] == ["c1.H: 1 t", "c2.H: 2 t"]
    alike = [Doubt(("cranes", name, *place), f"{name}.H: 1 t") for name in ("c1", "c2")]
    assert [one.sentence for one in said_once(scenario, alike)] == ["c1.H: 1 t (c2 alike)"]
