"""`gantline cad block`: what it prints and writes."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from gantline.cli.app import app

SIZES = ("--length", "20 m", "--breadth", "12 m", "--height", "9 m", "--mass", "120 t")


def run(*words: str | Path) -> Result:
    return CliRunner().invoke(app, ["cad", "block", *(str(word) for word in words)])


def test_a_ship_block_is_written_as_ocx_and_glb(tmp_path: Path) -> None:
    result = run(tmp_path / "new" / "mine.3docx", *SIZES)
    assert result.exit_code == 0, result.output
    assert (tmp_path / "new" / "mine.3docx").read_bytes().startswith(b"<?xml")
    assert (tmp_path / "new" / "mine.glb").read_bytes().startswith(b"glTF")
    assert "SHIP BLOCK 20X12X9" in result.output
    assert "Mass        120.000 t, centre of gravity (0.000, 0.000, " in result.output
    assert "Plates      bottom " in result.output


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("--mass", "120"), "--mass: '120' has no unit; a mass is written like '300 t' or '20 kg'"),
        (("--length", "20 t"), "--length: '20 t' is a mass; needed is a length"),
        (("--mass", "20 t"), "yards weld plates of 5 to 40 mm"),
        (("--centre-height", "high"), "--centre-height: 'high' is not a number with a unit"),
    ],
)
def test_what_is_wrong_is_one_message(tmp_path: Path, words: tuple[str, ...], says: str) -> None:
    result = run(tmp_path / "a.3docx", *SIZES, *words)
    assert result.exit_code == 2
    assert says in result.output
    assert not (tmp_path / "a.3docx").exists()


def test_a_place_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    result = run(tmp_path / "file" / "a.3docx", *SIZES)
    assert result.exit_code == 2
    assert "cannot be written" in result.output


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("mine.glb", "is where the GLB goes; the OCX file has another ending, such as '.3docx'"),
        ("", "is a folder; a file is needed"),
    ],
)
def test_the_ocx_file_has_a_place_of_its_own(tmp_path: Path, name: str, says: str) -> None:
    result = run(tmp_path / name, *SIZES)
    assert (result.exit_code, result.stderr) == (2, f"error: {tmp_path / name}: {says}\n")
    assert not list(tmp_path.iterdir())
