"""`gantline new` left a lift file without its schema on a full disk, and then refused to begin anew.

It said that the folder could not be written, and left `scenario.yaml` there; once there was room it ended
with "exists already; nothing was written", about the file that it had written itself.
"""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli import new as module
from gantline.cli.app import app
from gantline.replacing import replace_bytes


@pytest.fixture
def full(monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk with room for a lift file and not for its schema."""

    def write(path: Path, content: bytes) -> None:
        if path.name == "lift.schema.json":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
        replace_bytes(path, content)

    monkeypatch.setattr(module, "replace_bytes", write)


@pytest.mark.usefixtures("full")
def test_nothing_is_left_of_a_lift_for_which_there_is_no_room(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["new", str(tmp_path / "lifts" / "mine")])
    assert result.exit_code == 2
    assert "cannot be written (no space left on device)" in result.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("full")
def test_what_was_there_before_stays(tmp_path: Path) -> None:
    for name in ("notes.txt", "lift.schema.json"):
        (tmp_path / name).write_text("mine", encoding="utf-8")
    assert CliRunner().invoke(app, ["new", str(tmp_path)]).exit_code == 2
    left = {path.name: path.read_text(encoding="utf-8") for path in tmp_path.iterdir()}
    assert left == {"notes.txt": "mine", "lift.schema.json": "mine"}
