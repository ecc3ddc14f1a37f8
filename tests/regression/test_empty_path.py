"""`gantline run LIFT -o ""` wrote recording, report and pictures into the folder that it was called in.

A script passes an empty word on where a variable of it is not set, and Python takes an empty path for `.`,
the folder that one is in. Every verb did so, with its options and with what it reads.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app

SAYS = "an empty path is no place; '.' is the folder that you are in"


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        (["run", "equalizer", "-o", ""], "--output"),
        (["run", "equalizer", "--output="], "--output"),
        (["run", "equalizer", "--output", "  "], "--output"),
        (["statics", "equalizer", "-o", ""], "--output"),
        (["cases", "equalizer", "-o", ""], "--output"),
        (["seas", "onto_a_platform", "-o", ""], "--output"),
        (["compare", "equalizer", "goliath", "-o", ""], "--output"),
        (["report", "none.nc", "-o", ""], "--output"),
        (["schema", "-o", ""], "--output"),
        (["cad", "none.stl", "-o", ""], "--output"),
        (["hydro", "box:10m,2m,2m", "-o", ""], "--output"),
        (["ballast", "off_a_barge", "--write", ""], "--write"),
        (["run", ""], "LIFT"),
        (["check", ""], "LIFT|RECORDING"),
        (["compare", "equalizer", ""], "B"),
        (["export", "none.nc", ""], "FILE"),
        (["new", ""], "FOLDER"),
        (["cad", "block", ""], "FILE"),
        (["hydro", ""], "HULL"),
    ],
)
def test_it_is_refused(typed: list[str], name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    found = CliRunner().invoke(app, typed)
    assert found.exit_code == 2
    assert f"{name}: {SAYS}" in found.output
    assert not list(tmp_path.iterdir())


def test_other_empty_words_are_told_as_before() -> None:
    found = CliRunner().invoke(app, ["run", "equalizer", "--step", ""])
    assert found.exit_code == 2
    assert "--step: '' is not a number with a unit" in found.output
