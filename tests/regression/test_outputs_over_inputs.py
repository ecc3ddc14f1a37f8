"""Outputs that took the place of what they were made from.

`gantline report eq -o eq/recording.nc` put its page where the recording was and ended well; `gantline compare
sw/b.nc sw/a.nc -o sw` swapped the two recordings. A link that leads to the recording was followed.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from sample_lift import ringing_lift

LOST = "is read here and would be lost"
REFUSED = {
    "report sw -o sw/recording.nc": "sw/recording.nc: ends with '.nc' as recordings do; "
    "a report is a file such as report.html",
    "report sw -o new.nc": "new.nc: ends with '.nc' as recordings do; a report is a file such as report.html",
    "report sw -o link.html": f"link.html: {LOST}; --output needs another file",
    "report sw -o ./sw/cases.json": f"sw/cases.json: {LOST}; --output needs another file",
    "report linked": f"linked/report.html: {LOST}; --output needs another file",
    "export sw link.csv": f"link.csv: {LOST}; FILE is another one",
    "compare sw/b.nc sw/a.nc -o sw": f"sw/a.nc: {LOST}; --output needs another folder",
    "compare sw/a.nc sw/recording.nc -o sw/../sw": f"sw/../sw/a.nc: {LOST}; --output needs another folder",
    "compare equalizer sw/b.nc -o sw": f"sw/b.nc: {LOST}; --output needs another folder",
    "hydro hull.svg -o hull.svg": f"hull.svg: {LOST}; --output needs another file",
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Recordings in a folder, and links that lead to one."""
    monkeypatch.chdir(tmp_path)
    for place in ("sw", "linked"):
        (tmp_path / place).mkdir()
    for name in ("recording.nc", "a.nc"):
        ringing_lift().save(tmp_path / "sw" / name)
    ringing_lift(events=[]).save(tmp_path / "sw" / "b.nc")
    (tmp_path / "sw" / "cases.json").write_text("{}", encoding="utf-8")
    (tmp_path / "hull.svg").write_text("no hull", encoding="utf-8")
    for link in ("link.html", "link.csv", "linked/recording.nc", "linked/report.html"):
        (tmp_path / link).symlink_to(tmp_path / "sw" / "recording.nc")
    return tmp_path


@pytest.mark.parametrize("words", REFUSED)
def test_what_is_read_is_not_replaced(folder: Path, words: str) -> None:
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    result = CliRunner().invoke(app, words)
    assert (result.exit_code, result.stderr) == (2, f"error: {REFUSED[words]}\n")
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
