"""Lift files and Python in the documents are right: what they show can be used."""

from __future__ import annotations

import re
import textwrap
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import gantline
from gantline.scenario import json_schema
from gantline.scenario.file.tree import parse_text

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def fenced(document: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", document.read_text(encoding="utf-8"), flags=re.M | re.S)


def examples(language: str) -> dict[str, str]:
    """What documents have between fences in a language, each by where it stands."""
    return {
        f"{document.relative_to(ROOT)}-{number}": text
        for document in DOCUMENTS
        for number, text in enumerate(fenced(document, language), 1)
    }


WHOLE = {place: text for place, text in examples("yaml").items() if text.startswith("format: 1")}
PARTS = {place: text for place, text in examples("yaml").items() if place not in WHOLE}
PYTHON = examples("python")
#: What examples in Python do over and over, and how often it is done here: what they show is in that already.
FEWER = {
    "docs/reference/python.md-9": ("size=(100, ", "size=(3, "),
    "docs/guides/afloat.md-1": (
        '("1 m", "2 m", "3 m"):\n    for seed in (1, 2, 3)',
        '("3 m",):\n    for seed in (3,)',
    ),
    "docs/guides/afloat.md-2": ("range(0, 360, 30)", "range(0, 360, 180)"),
}


def test_there_are_examples() -> None:
    assert len(WHOLE) >= 3
    assert len(PARTS) >= 30
    assert len(PYTHON) >= 2


@pytest.mark.parametrize("text", WHOLE.values(), ids=WHOLE)
def test_a_lift_file_in_a_document_can_be_simulated(text: str, tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(text, encoding="utf-8")
    recording = gantline.simulate(path)
    assert recording.attributes["status"] == "done"
    assert recording.attributes["warnings"] == []
    if "slings:" in text:
        assert recording.events("lift_off"), "the load of this example is lifted"


@cache
def kinds() -> list[jsonschema.Draft7Validator]:
    """A lift file and every mapping within one, of each of which any part may be left out."""

    def loosened(schema: Any) -> Any:
        if isinstance(schema, list):
            return [loosened(item) for item in schema]
        if not isinstance(schema, dict):
            return schema
        kept = {
            key: value for key, value in schema.items() if not isinstance(value, list) or key != "required"
        }
        # Without the keys that tell them apart, a value may be of several kinds.
        return {"anyOf" if key == "oneOf" else key: loosened(value) for key, value in kept.items()}

    root = loosened(json_schema())
    parts = [part for part in root["$defs"].values() if "properties" in part]
    return [jsonschema.Draft7Validator({**part, "$defs": root["$defs"]}) for part in [root, *parts]]


@pytest.mark.parametrize("text", PARTS.values(), ids=PARTS)
def test_a_part_of_a_lift_file_in_a_document_is_one(text: str) -> None:
    """Its keys, units and words are those of a lift file, or of a mapping in one; `…` is what is left out."""
    text = textwrap.dedent(text).replace(", …}", "}")
    if not re.search(r"^[^#\n]", text, flags=re.M):
        return  # remarks alone
    if text.startswith("- "):
        text = "plan:\n" + text
    part = parse_text(text, "the example")
    whole = [f"{error.json_path}: {error.message}" for error in kinds()[0].iter_errors(part)]
    assert whole == [] or any(kind.is_valid(part) for kind in kinds()), whole


def test_a_part_with_a_mistake_is_found() -> None:
    for text in ("ropes: {sling: {axial_stifness: 1 MN}}", "plan: [{step: a, hold: 3}]", "loads: {a: b}"):
        assert not any(kind.is_valid(parse_text(text, "the example")) for kind in kinds()), text


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which the lifts and recordings lie that examples in Python speak of."""
    folder = tmp_path_factory.mktemp("examples")
    (folder / "scenarios").symlink_to(ROOT / "scenarios")
    recording = gantline.simulate("equalizer")
    for place in ("build/demo", "results/mylift"):
        (folder / place).mkdir(parents=True)
        recording.save(folder / place / "recording.nc")
    return folder


@pytest.mark.parametrize("place", PYTHON)
def test_python_in_a_document_runs_and_needs_public_names_only(
    place: str, recorded: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = PYTHON[place]
    if place in FEWER:
        many, few = FEWER[place]
        assert many in text
        text = text.replace(many, few)
    for name in re.findall(r"\bgantline\.([A-Za-z_]\w*)", text):
        assert name in dir(gantline), f"gantline.{name} is not public"
    monkeypatch.chdir(recorded)
    exec(compile(text, "document", "exec"), {"gantline": gantline})
