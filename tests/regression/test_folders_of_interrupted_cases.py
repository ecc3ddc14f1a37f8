"""`gantline cases -o` that was interrupted left an empty folder, as if there were results of a lift in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline.study
from gantline.cli.app import app


@pytest.mark.parametrize("is_new", [True, False])
def test_an_interrupted_study_leaves_no_new_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_new: bool
) -> None:
    """One that was there before stays."""

    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(gantline.study, "run_cases", interrupted)
    folder = tmp_path / "out"
    if not is_new:
        folder.mkdir()
    result = CliRunner().invoke(app, ["cases", "goliath", "-o", str(folder)])
    assert result.exit_code != 0
    assert folder.exists() is not is_new
