"""`gantline new` put the CAD file of a lift in the place of one of the same name, which was lost.

It looked for `scenario.yaml` alone: `gantline new . --from goliath`, in a folder where somebody's own
`block.3docx` lay and no lift file yet, wrote the ship block of that lift over it.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app


@pytest.mark.parametrize(
    ("lift", "file"), [("goliath", "block.3docx"), ("crane_barge_in_swell", "crane_barge.nc")]
)
def test_a_file_that_the_lift_would_bring_along_stays(lift: str, file: str, tmp_path: Path) -> None:
    (tmp_path / file).write_text("mine", encoding="utf-8")
    result = CliRunner().invoke(app, ["new", str(tmp_path), "--from", lift])
    assert result.exit_code == 2
    assert f"{tmp_path / file}: exists already; nothing was written" in result.stderr
    assert [path.name for path in tmp_path.iterdir()] == [file]
    assert (tmp_path / file).read_text(encoding="utf-8") == "mine"


def test_a_schema_that_is_there_is_made_anew(tmp_path: Path) -> None:
    """It is gantline's own file, which an editor may have had before there was a lift."""
    (tmp_path / "lift.schema.json").write_text("of an older version", encoding="utf-8")
    result = CliRunner().invoke(app, ["new", str(tmp_path)])
    assert result.exit_code == 0
    assert (tmp_path / "lift.schema.json").read_text(encoding="utf-8").startswith("{")
