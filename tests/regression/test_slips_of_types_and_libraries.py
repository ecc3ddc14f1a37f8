"""Slips in types and libraries that were told wrongly, many times, or by nothing.

A crane type with `type: crawlr` that no crane names yet, as all of a library, was told by nothing. A library
of 6 MB, or in UTF-16, was answered with "a library beside the lift file is needed", without what would help.
A lift file named in place of its library, itself for instance, had a line of all sections for each of its
keys. Beside a type of the name `crawler` every type of that kind was told, too. The schema took a type that
is empty, since beside a `$ref` nothing counts.
"""

from __future__ import annotations

from pathlib import Path

import jsonschema
import pytest

from gantline.scenario import ScenarioError, load_scenario, parse_scenario
from gantline.scenario.file.alone import check_library
from gantline.scenario.file.schema import library_schema
from module_on_a_barge import LIFT as LIFT_ON_A_BARGE

#: A lift with next to nothing in it; what is wrong with its library is told first.
LIFT = "format: 1\nlibrary: yard.yaml\nlift: {title: A lift}\nduration: 1 s\nplan: []\n"


def told(folder: Path, library: str | bytes, named: str = "yard.yaml") -> list[tuple[str, str]]:
    """File, or path, and sentence of what is wrong where a lift names a library."""
    content = library if isinstance(library, bytes) else library.encode()
    (folder / "yard.yaml").write_bytes(content)
    lift = folder / "lift.yaml"
    lift.write_text(LIFT.replace("yard.yaml", named), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        load_scenario(lift)
    name = Path(caught.value.source).name
    return [(one.path or name, one.sentence) for one in caught.value.problems]


@pytest.mark.parametrize("kind", ["crawlr", "[crawler]", "crawler_crane"])
def test_a_kind_that_there_is_not(tmp_path: Path, kind: str) -> None:
    library = tmp_path / "yard.yaml"
    library.write_text(f"format: 1\ncrane_types: {{c: {{type: {kind}, base_mass: 3 t}}}}\n", encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        check_library(library)
    (problem,) = caught.value.problems
    assert (problem.line, problem.path) == (2, "crane_types.c.type")


def test_what_would_help_is_said(tmp_path: Path) -> None:
    """5 MB is the most of a file, 6 MB the size of this one."""
    text = "format: 1\nropes: {a: {inextensible: true}}\n"
    assert told(tmp_path, text + "#" * 6_000_000) == [
        ("library", "'yard.yaml' has 6.0 MB; a library has at most 5 MB")
    ]
    ((_, sentence),) = told(tmp_path, text.encode("utf-16"))
    assert sentence.endswith("save the file as UTF-8")
    assert told(tmp_path, text, named="nothing.yaml") == [
        (
            "library",
            "'nothing.yaml' cannot be read (no such file or directory); a library beside the lift file is "
            "needed",
        )
    ]


def test_a_lift_file_is_no_library(tmp_path: Path) -> None:
    ((name, sentence),) = told(tmp_path, "", named="lift.yaml")
    assert name == "lift.yaml"
    assert sentence.startswith("is a lift file, with 'library', 'lift', 'duration' and 'plan'; a library has")


def test_a_library_names_no_other(tmp_path: Path) -> None:
    assert told(tmp_path, "format: 1\nlibrary: other.yaml\nropes: {a: {inextensible: true}}\n") == [
        (
            "library",
            "a library names no other one; a lift file names several, [cranes.yaml, ropes.yaml]",
        )
    ]


def test_a_blank_that_is_none(tmp_path: Path) -> None:
    """A no-break space behind a colon, named as in a lift file; it was "nothing is given here"."""
    assert told(tmp_path, "format: 1\nropes:\n  a:\u00a0{inextensible: true}\n") == [
        (
            "yard.yaml",
            "what looks like a blank and is none (U+00A0, no-break space) stands in column 5: write a blank",
        )
    ]


def test_a_type_by_the_name_of_a_kind_is_told_once(tmp_path: Path) -> None:
    library = tmp_path / "yard.yaml"
    types = "crawler: {type: crawler, base_mass: 3 t}, other: {type: crawler, base_mass: 4 t}"
    library.write_text(f"format: 1\ncrane_types: {{{types}}}\n", encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        check_library(library)
    assert [one.path for one in caught.value.problems] == ["crane_types.crawler"]


@pytest.mark.parametrize("section", ["vessel_types", "mooring_line_types", "crane_types", "guide_types"])
def test_an_empty_type_is_red_in_editors(section: str) -> None:
    """Reading refuses it: 'a mapping of what things of this type have is needed'."""
    schema = jsonschema.Draft7Validator(library_schema())
    assert not schema.is_valid({"format": "1", section: {"a": {}}})


def test_a_type_of_a_type_is_red_in_editors() -> None:
    """Reading refuses it: 'a type of vessel has no type itself'."""
    schema = jsonschema.Draft7Validator(library_schema())
    assert schema.is_valid({"format": "1", "vessel_types": {"a": {"draft": "3 m"}}})
    assert not schema.is_valid({"format": "1", "vessel_types": {"a": {"draft": "3 m", "type": "b"}}})


def test_a_key_of_a_type_is_told_once() -> None:
    """It was "known here: 'type', …" of the type alone, and "but of 'added_mass' in it" of the vessel."""
    text = LIFT_ON_A_BARGE.replace("PULL", "pretension: 20 kN, type: spring")
    text = text.replace("  barge:\n", "  barge:\n    type: flat\n")
    text += "vessel_types:\n  flat:\n    database: {file: some.nc}\n"
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text)
    (problem,) = caught.value.problems
    assert problem.path == "vessel_types.flat.database"
    assert problem.sentence.endswith("but of 'added_mass' in it: it stands too far out")
