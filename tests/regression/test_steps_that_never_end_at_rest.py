"""`gantline statics --steps` left out a step that never ended, and all after it, without a word.

A funnel heeled over on the ground in place of coming clear: the table had 'take up', then the end of the
lift, and who read it did not see that 'lift off' and 'hoist' were missing."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from four_slings import LIFT
from gantline.cli.app import app


@pytest.mark.parametrize(
    ("duration", "told"),
    [
        ("70 s", None),
        ("2 s", "  steps that do not end by 2 s: lift off; not begun: hoist, hold point"),
    ],
)
def test_what_a_lift_does_not_get_through_is_told(tmp_path: Path, duration: str, told: str | None) -> None:
    """The slings have 0.08 m of slack: 5 s at 1 m/min."""
    lift = tmp_path / "lift.yaml"
    lift.write_text(LIFT.replace("duration: 70 s", f"duration: {duration}"), encoding="utf-8")
    said = CliRunner().invoke(app, ["statics", str(lift), "--steps"], env={"COLUMNS": "140"}).stdout
    found = [line for line in said.splitlines() if line.startswith("  steps that")]
    assert found == ([] if told is None else [told])
