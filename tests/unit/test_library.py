"""Libraries: types, ropes and shackles of a yard in a file of their own, which lift files name."""

from __future__ import annotations

from pathlib import Path

import jsonschema
import pytest

from ballasted import barge, tank
from ballasted import text as text_of_lift
from gantline.scenario import (
    Scenario,
    ScenarioError,
    check_library,
    library_schema,
    load_scenario,
    parse_scenario,
)
from gantline.scenario.file.tree import parse_text
from gantline.simulation import Simulation
from gantline.study import solve_ballast
from program import called

PAIR = Path(__file__).resolve().parents[2] / "scenarios" / "floating_crane_and_crawlers" / "scenario.yaml"
TEXT = PAIR.read_text(encoding="utf-8")
BEGINS, ENDS = TEXT.index("crane_types:\n"), TEXT.index("equalizers:\n  E1")
#: The scenario's types of cranes, hooks and equalizers, and the rest of it, which names them.
YARD = f"format: 1\n{TEXT[BEGINS:ENDS]}"
LIFT = (TEXT[:BEGINS] + TEXT[ENDS:]).replace("format: 1\n", "format: 1\nlibrary: yard.yaml\n")


@pytest.fixture(name="folder")
def _folder(tmp_path: Path) -> Path:
    (tmp_path / "yard.yaml").write_text(YARD, encoding="utf-8")
    (tmp_path / "lift.yaml").write_text(LIFT, encoding="utf-8")
    return tmp_path


def test_a_lift_with_a_library_is_the_same_as_one_with_all_in_it(folder: Path) -> None:
    lift, whole = load_scenario(folder / "lift.yaml"), load_scenario(PAIR)
    differ = [key for key in Scenario.model_fields if getattr(lift, key) != getattr(whole, key)]
    assert differ == ["library"]
    assert lift.library == ("yard.yaml",)


def test_the_text_of_the_lift_has_the_library_below_it(folder: Path) -> None:
    """So that a recording tells what was lifted with, and another library is another lift."""
    lift = load_scenario(folder / "lift.yaml")
    assert lift.file_text == LIFT
    told = "".join(f"# {line}".rstrip() + "\n" for line in YARD.splitlines())
    assert lift.text == f"{LIFT.rstrip()}\n# library: yard.yaml\n{told}"
    other = lift.changed({"crane_types.crawler_400.base_mass": "200 t", "duration": "50 s"})
    assert "# changed: duration: 50 s\n# library: yard.yaml\n" in other.text
    assert parse_text(other.text, "") == parse_text(LIFT, "")


WRONG = [
    (
        "yard",
        "base_mass: 190 t",
        "base_mass: 190 kN",
        "yard.yaml:8: crane_types.crawler_400.base_mass: '190 kN' is",
    ),
    (
        "yard",
        "type: hook_200",
        "type: hook_20",
        "yard.yaml:16: crane_types.crawler_400.hooks.H.type: 'hook_20' is",
    ),
    (
        "yard",
        "radius: 16 m,",
        "radius: 500 m,",
        "yard.yaml:11: crane_types.crawler_400.boom.radius: the head of",
    ),
    (
        "yard",
        "rope: equalizing_46",
        "rope: equalizing",
        "yard.yaml:37: equalizer_types.EQ5-300.rope: 'equalizing'",
    ),
    ("yard", "format: 1\n", "", "yard.yaml:1: format: found none; a library begins with 'format: 1'"),
    (
        "yard",
        "format: 1\n",
        "format: 2\n",
        "yard.yaml:1: format: found '2'; a library begins with 'format: 1'",
    ),
    (
        "yard",
        "crane_types:\n",
        "cranes: {c1: {type: crawler_400}}\ncrane_types:\n",
        "yard.yaml:2: cranes: 'cranes' is not a section of a library; did you mean 'crane_types'?",
    ),
    ("yard", "crane_types:\n", "ropes: {a: 3}\ncrane_types:\n", "yard.yaml:2: ropes.a: a mapping is needed"),
    (
        "yard",
        "crane_types:\n",
        "ropes: []\ncrane_types:\n",
        "yard.yaml:2: ropes: a mapping from names to what",
    ),
    ("yard", "base_mass: 190 t", "base_mass: 190 t: 3", "yard.yaml:8: a second ':' in one value"),
    (
        "yard",
        "crane_types:\n",
        "ropes: {moor_44: {diameter: 3 mm}}\ncrane_types:\n",
        "lift.yaml:28: ropes.moor_44: 'moor_44' is given in {folder}/yard.yaml, too; each name stands once",
    ),
    (
        "lift",
        "library: yard.yaml",
        "library: yards.yaml",
        "lift.yaml:3: library: 'yards.yaml' cannot be read (no such file or directory); a library beside",
    ),
    (
        "lift",
        "library: yard.yaml",
        "library: [yard.yaml, yard.yaml]",
        "lift.yaml:3: library: a file is named twice; once is right",
    ),
    (
        "lift",
        "library: yard.yaml",
        "library: {file: yard.yaml}",
        "lift.yaml:3: library: found a mapping; the name of a file or a list of such names is needed",
    ),
    (
        "lift",
        "library: yard.yaml",
        "include: yard.yaml",
        "lift.yaml:3: include: 'include' is not a key of a lift file; did you mean 'library'?",
    ),
    (
        "lift",
        "library: yard.yaml",
        "crane_types: !include yard.yaml",
        "lift.yaml:3: the tag '!include' is not allowed; write the plain value, or 'library: FILE' for",
    ),
]


@pytest.mark.parametrize(("which", "old", "new", "says"), WRONG)
def test_a_message_names_the_file_in_which_what_is_wrong_stands(
    folder: Path, which: str, old: str, new: str, says: str
) -> None:
    path = folder / f"{which}.yaml"
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ScenarioError) as error:
        load_scenario(folder / "lift.yaml")
    told = str(error.value).splitlines()[0]
    beginning = says.format(folder=folder)
    assert told.startswith(f"{folder}/{beginning}")


def test_a_doubt_names_the_library(folder: Path) -> None:
    """As `gantline check` and the recording tell it."""
    text = YARD.replace("heading: 0 deg", "heading: 94.2477796 rad")
    (folder / "yard.yaml").write_text(text, encoding="utf-8")
    lift = load_scenario(folder / "lift.yaml")
    doubts = [one.of("lift.yaml") for one in Simulation(lift).assembly.doubts if "turns" in one.sentence]
    place = f"{folder}/yard.yaml:5: crane_types.crawler_400.heading"
    assert doubts == [f"{place}: 94.2477796 rad are 15 turns; '94.2477796 deg' may be meant"]


def test_a_library_is_looked_over_by_itself(folder: Path) -> None:
    """Each section, without what only a lift knows; a lift is none."""
    assert check_library(folder / "yard.yaml") == {"crane_types": 1, "hook_types": 2, "equalizer_types": 1}
    assert check_library(folder / "lift.yaml") is None
    assert check_library(folder / "none.yaml") is None
    text = YARD.replace("base_mass: 190 t", "base_mass: 190 kN").replace("height: 3.0 m", "heigth: 3.0 m")
    (folder / "yard.yaml").write_text(text.replace("radius: 16 m", "radius: 16 t"), encoding="utf-8")
    with pytest.raises(ScenarioError) as error:
        check_library(folder / "yard.yaml")
    places = [one.path for one in error.value.problems]
    assert places == [
        "crane_types.crawler_400.base_mass",
        "crane_types.crawler_400.boom.radius",
        "hook_types.hook_900.block.heigth",
    ]


def test_a_library_on_the_command_line(folder: Path) -> None:
    """In order, with what it holds; else code 2, as of a lift file."""
    result = called("check", folder / "yard.yaml")
    held = "crane_types 1, hook_types 2, equalizer_types 1"
    assert (result.returncode, result.stdout) == (0, f"{folder}/yard.yaml: a library, in order ({held})\n")
    (folder / "yard.yaml").write_text(YARD.replace("base_mass", "base_mas"), encoding="utf-8")
    result = called("check", folder / "yard.yaml")
    assert result.returncode == 2
    place = f"{folder}/yard.yaml:8: crane_types.crawler_400.base_mas"
    assert f"{place}: 'base_mas' is not a key of a crawler crane; did you mean 'base_mass'?" in result.stderr


def test_a_library_is_no_lift(folder: Path) -> None:
    with pytest.raises(
        ScenarioError, match=r"yard\.yaml: is a library and has no lift in it; a lift file na"
    ):
        load_scenario(folder / "yard.yaml")


def test_contents_of_tanks_of_a_library_are_not_written(tmp_path: Path) -> None:
    """`gantline ballast --write` writes the lift file, and no other."""
    flat = barge({"ps": tank((50, 0, 1), 300.0)})
    del flat["masses"]
    library = text_of_lift({}, vessel_types={"flat": flat}, lift=None, duration=None, vessels=None)
    (tmp_path / "fleet.yaml").write_text(_without_nulls(library), encoding="utf-8")
    masses = barge({})["masses"]
    lift = text_of_lift({"type": "flat", "masses": masses}, library="fleet.yaml")
    scenario = parse_scenario(lift, str(tmp_path / "lift.yaml"))
    with pytest.raises(ScenarioError) as error:
        print(solve_ballast(scenario, draft=3.7).text)
    told = "is the content of a library; give 'barge' its own, for '--write' to change"
    assert str(error.value).endswith(f"vessel_types.flat.tanks.ps.content: {told}")
    assert str(error.value).startswith(f"{tmp_path}/fleet.yaml:")


def _without_nulls(text: str) -> str:
    return "\n".join(line for line in text.splitlines() if not line.endswith(("null,", "null"))) + "\n"


def test_the_schema_of_libraries(folder: Path) -> None:
    """It knows the sections of a library and those alone."""
    schema = library_schema()
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    assert [error.message for error in validator.iter_errors(parse_text(YARD, ""))] == []
    for old, new in (("base_mass", "base_mas"), ("crane_types", "cranes"), ("format: 1\n", "")):
        assert not validator.is_valid(parse_text(YARD.replace(old, new, 1), ""))
