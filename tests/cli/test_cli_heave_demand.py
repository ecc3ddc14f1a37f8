"""`gantline check` of a lift that compensates heave: what its hoist needs, and that it has too little."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from compensated import BARGE, compensated_text
from gantline.cli.app import app

STILL = "  - {step: still, hold: until_end, compensate_heave: H1}\n"
DATABASE = Path(str(BARGE)).resolve().with_name("crane_barge.nc")


@pytest.mark.parametrize(
    ("can", "too_little"),
    [
        ("speed: 1 m/s, acceleration: 1 m/s^2", ""),
        ("speed: 0.2 m/s, acceleration: 1 m/s^2", "'speed' 0.88 m/s, and has 0.20 m/s"),
        (
            "speed: 1 m/s, acceleration: 0.1 m/s^2, stroke: 0.5 m",
            "'acceleration' 0.78 m/s^2, and has 0.10 m/s^2; 'stroke' 2.06 m, and has 0.50 m",
        ),
    ],
)
def test_what_compensation_needs(can: str, too_little: str, tmp_path: Path) -> None:
    """The figures themselves are those of `tests/verification/test_heave_demand.py`."""
    lift = tmp_path / "lift.yaml"
    lift.write_text(compensated_text(STILL, can=can), encoding="utf-8")
    shutil.copy(DATABASE, tmp_path)
    result = CliRunner().invoke(app, ["check", str(lift)], env={"COLUMNS": "140"})
    assert result.exit_code == 0
    said = " ".join(result.output.split())
    assert "Heave compensation, most in 3 h over step speed has acceleration has stroke has" in said
    assert "sheerleg.H1 the ground 'still'" in said
    warning = "heave compensation of sheerleg.H1 needs, at most in 3 h, "
    assert (warning + too_little in said) if too_little else (warning not in said)
