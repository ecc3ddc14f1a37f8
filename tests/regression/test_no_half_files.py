"""Outputs that were written in place, so that whoever read them meanwhile, or after trouble, met half a file.

Recordings, pictures and reports took the place of older ones at once; what `export`, `compare`, `schema`,
`hydro`, `cad block` and `new` write did not, nor did the last good state of a run. A file that is replaced
leaves another hard link to the old one as it was; one that is written in place does not.
"""

from __future__ import annotations

import ast
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.export.video import VideoError, write_video
from lift_text import DEAD_CENTRE
from sample_lift import ringing_lift

SOURCE = Path(gantline.__file__).parent
SHIP_BLOCK = "cad block new/ship.3docx --length 12m --breadth 8m --height 4m --mass 60t"
VERBS = {
    "export lift.nc new/a.csv": ["a.csv"],
    "export lift.nc new/a.glb": ["a.glb"],
    "export lift.nc new/a.png": ["a.png"],
    "export lift.nc new/a.gif --speed 400": ["a.gif"],
    "compare lift.nc lift.nc -o new --no-plots": ["comparison.json", "comparison.txt"],
    "schema -o new/lift.schema.json": ["lift.schema.json"],
    "hydro box:100m,30m,8m -o new/hull.svg": ["hull.svg"],
    SHIP_BLOCK: ["ship.3docx", "ship.glb"],
    "new new": ["lift.schema.json"],
    "run stuck.yaml -o new --no-plots": ["state.bin"],
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    ringing_lift().save(tmp_path / "lift.nc")
    (tmp_path / "stuck.yaml").write_text(DEAD_CENTRE, encoding="utf-8")
    (tmp_path / "new").mkdir()
    return tmp_path


@pytest.mark.parametrize("words", VERBS)
def test_a_file_that_is_there_is_replaced_at_once(folder: Path, words: str) -> None:
    for name in VERBS[words]:
        (folder / "new" / name).write_text("old", encoding="utf-8")
        os.link(folder / "new" / name, folder / name)
    result = CliRunner().invoke(app, words)
    assert result.exit_code == (3 if "stuck" in words else 0), result.output
    for name in VERBS[words]:
        assert (folder / name).read_bytes() == b"old", f"{name} was written in place"
        assert (folder / "new" / name).stat().st_size > 3
    assert not list(folder.rglob("*.part"))


def test_a_table_of_parquet_is_replaced_at_once(folder: Path) -> None:
    pytest.importorskip("pyarrow")
    (folder / "a.parquet").write_text("old", encoding="utf-8")
    os.link(folder / "a.parquet", folder / "old")
    gantline.export.write_parquet(ringing_lift(), folder / "a.parquet")
    assert (folder / "old").read_bytes() == b"old"
    assert (folder / "a.parquet").read_bytes()[:4] == b"PAR1"


def test_a_film_that_fails_leaves_the_one_before(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A program called ffmpeg writes half a film and gives up."""
    programs = folder / "programs"
    programs.mkdir()
    script = (
        '#!/bin/sh\nfor last; do :; done\nprintf half > "$last"\ncat > /dev/null\necho full >&2; exit 1\n'
    )
    (programs / "ffmpeg").write_text(script, encoding="utf-8")
    (programs / "ffmpeg").chmod(0o755)
    monkeypatch.setenv("PATH", str(programs), prepend=os.pathsep)
    film = folder / "new" / "lift.mp4"
    film.write_text("old", encoding="utf-8")
    with pytest.raises(VideoError, match="ffmpeg could not make the film: full"):
        write_video(ringing_lift(), film, speed=400.0)
    assert film.read_text(encoding="utf-8") == "old"
    assert [one.name for one in (folder / "new").iterdir()] == ["lift.mp4"]


def test_nothing_writes_a_file_by_its_own_name() -> None:
    """What is written goes through `gantline.replacing`, or to the file that it gives."""
    found = [
        f"{path.relative_to(SOURCE)}:{node.lineno}"
        for path in SOURCE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute) and node.attr in ("write_text", "write_bytes")
    ]
    assert [one.partition(":")[0] for one in found] == ["replacing.py"], found
