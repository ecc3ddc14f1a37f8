"""NO_COLOR, which was kept by help and progress alone.

With `NO_COLOR=1` on a terminal the verdicts of `gantline check`, warnings and errors had colours: typer
styles text whatever that variable says, and takes the styles away only where the output is no terminal.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app


@pytest.mark.parametrize(("value", "is_coloured"), [("1", False), ("", True)])
def test_no_color_takes_the_colours_away(
    value: str, is_coloured: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An empty NO_COLOR is none: no-color.org."""
    monkeypatch.setenv("NO_COLOR", value)
    result = CliRunner().invoke(app, ["check", str(tmp_path / "none.yaml")], color=True)
    assert result.exit_code == 2
    assert ("\x1b[" in result.stderr) is is_coloured
