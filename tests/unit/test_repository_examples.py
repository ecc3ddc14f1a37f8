"""Lift files and Python in the documents are right: what they show can be used."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gantline

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def fenced(document: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", document.read_text(encoding="utf-8"), flags=re.M | re.S)


LIFTS = [
    pytest.param(text, id=f"{document.name}-{number}")
    for document in DOCUMENTS
    for number, text in enumerate(fenced(document, "yaml"), 1)
    if text.startswith("format: 1")
]
PYTHON = [
    pytest.param(text, id=f"{document.name}-{number}")
    for document in DOCUMENTS
    for number, text in enumerate(fenced(document, "python"), 1)
]


def test_there_are_examples() -> None:
    assert len(LIFTS) >= 3
    assert len(PYTHON) >= 2


@pytest.mark.parametrize("text", LIFTS)
def test_a_lift_file_in_a_document_can_be_simulated(text: str, tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(text, encoding="utf-8")
    recording = gantline.simulate(path)
    assert recording.attributes["status"] == "done"
    assert recording.attributes["warnings"] == []
    if "slings:" in text:
        assert recording.events("lift_off"), "the load of this example is lifted"


@pytest.mark.parametrize("text", PYTHON)
def test_python_in_a_document_is_python_with_public_names(text: str) -> None:
    compile(text, "document", "exec")
    for name in re.findall(r"\bgantline\.([A-Za-z_]\w*)", text):
        assert name in gantline.__all__, f"gantline.{name} is not public"
