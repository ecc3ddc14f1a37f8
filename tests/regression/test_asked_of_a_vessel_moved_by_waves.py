"""What a vessel with `wave_motion` cannot be asked for, and what was said of it.

A step that waits for her trim was told that she "does not float freely; only what has a hull and six motions
does", which she has; `gantline ballast` asked for 'tanks', which are refused beside 'wave_motion'. Tables and
the first page showed her heel and trim without a word that no load has a part in them, and sent to
`gantline statics` for her GM and for what a lost load does.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.cli.vessels import vessels
from gantline.hydro.raos import write_raos
from gantline.report.afloat import afloat_facts, vessel_tables
from gantline.report.subject import Subject
from gantline.results.afloat.vessels import AS_CARRIED
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from gantline.study.ballast_question import vessel_of
from table_of_raos import goes_with_the_water

VESSEL = """
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    wave_motion: {raos: vessel.csv, phases: lag, at: [50 m, 0 m, 4 m]}
"""
LIFT = f"format: 1\nlift: {{title: A vessel}}\nduration: 9 s\nvessels:\n  vessel:{VESSEL}"
TANKS = """
  other:
    position: [200 m, 0 m]
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {all: {mass: 12200 t, at: [50 m, 0 m, 5 m]}}
    radii_of_gyration: [11 m, 27 m, 27 m]
    tanks: {mid: {box: [10 m, 10 m, 5 m], bottom: [50 m, 0 m, 0 m], content: 100 t}}
"""


@pytest.mark.parametrize("angle", ["heel", "trim"])
def test_no_step_waits_for_its_lie(tmp_path: Path, angle: str) -> None:
    write_raos(goes_with_the_water(), tmp_path / "vessel.csv")
    step = f"{{step: wait, hold: until_met, until: {{{angle}: {{vessel: vessel, below: 1 deg}}}}}}"
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(f"{LIFT}plan:\n  - {step}\n", str(tmp_path / "lift.yaml"))
    assert "'vessel' moves by its 'wave_motion', and nothing that the plan does heels or trims it" in str(
        problem.value
    )


@pytest.mark.parametrize(("others", "name"), [("", None), ("", "vessel"), (TANKS, "vessel")])
def test_no_ballast_is_found_for_it(tmp_path: Path, others: str, name: str | None) -> None:
    scenario = parse_scenario(LIFT + others, str(tmp_path / "lift.yaml"))
    with pytest.raises(ValueError, match="vessel moves by its 'wave_motion', whatever its tanks hold"):
        vessel_of(scenario, name)


def test_another_vessel_still_is_asked(tmp_path: Path) -> None:
    assert vessel_of(parse_scenario(LIFT + TANKS, str(tmp_path / "lift.yaml")), None) == "other"


def test_tables_say_what_has_no_part_in_its_lie(tmp_path: Path) -> None:
    """Of the one that is carried, and not of the one that floats."""
    write_raos(goes_with_the_water(), tmp_path / "vessel.csv")
    recording = simulate(parse_scenario(LIFT + TANKS, str(tmp_path / "lift.yaml")))
    assert [line for line in vessels(recording) if AS_CARRIED in line] == [f"  vessel: {AS_CARRIED}"]
    tables = {one["name"]: one for one in vessel_tables(Subject(recording))}
    assert {name: AS_CARRIED in one["when"] for name, one in tables.items()} == {
        "vessel": True,
        "other": False,
    }
    assert {name: one["may_have_gm"] for name, one in tables.items()} == {"vessel": False, "other": True}


@pytest.mark.parametrize(("others", "is_asked"), [("", False), (TANKS, True)])
def test_nobody_is_sent_to_ask_what_has_no_answer(tmp_path: Path, others: str, is_asked: bool) -> None:
    """A load that is lost moves vessels that float."""
    write_raos(goes_with_the_water(), tmp_path / "vessel.csv")
    recording = simulate(parse_scenario(LIFT + others, str(tmp_path / "lift.yaml")))
    said = dict(afloat_facts(Subject(recording)))["sudden release of the load"]
    assert said.startswith("not simulated") == is_asked
