"""Compensators on the command line: what `gantline check` and `gantline statics` print, and exit codes."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from lift_text import changed
from shown import ROOT, lift_on

TEXT = lift_on(ROOT / "docs" / "concepts" / "compensator.md", "A manifold under a passive compensator")


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "lift.yaml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_check_says_what_hangs_on_the_gas(lift: Path) -> None:
    """By hand: 72 t are 706.3 kN, V = 9.731 m, x = V (1 - (600/706.3)^(1/1.1)) = 1.341 m, and with
    F' = 1.1 x 706.3/8.390 kN/m a period of 5.54 s.
    """
    result = CliRunner().invoke(app, ["check", str(lift)], env={"COLUMNS": "140"})
    assert result.exit_code == 0
    (line,) = (line for line in result.stdout.splitlines() if line.startswith("  PHC"))
    assert line.split() == [
        "PHC",
        "600.0",
        "kN",
        "900.0",
        "kN",
        "in",
        "air",
        "706.3",
        "kN",
        "1.341",
        "m",
        "5.54",
        "s",
    ]


def test_statics_says_where_the_rod_is(lift: Path) -> None:
    """Against its seals, 706.3 - 20 kN: x = V (1 - (600/686.3)^(1/1.1)) = 1.119 m."""
    result = CliRunner().invoke(app, ["statics", str(lift)])
    assert "  PHC        1.119 m  3.000 m  37.3 %  686.3 kN" in result.stdout.splitlines()
    assert "PHC.gas" not in result.stdout


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "rod_out: 900 kN",
            "rod_out: 500 kN",
            "30: compensators.PHC.pull.rod_out: 500.0 kN is not more",
        ),
        (
            "from: hook, to: PHC",
            "from: hook, to: PCH",
            "37: slings.grommet.to: 'PCH' is not a lug; did",
        ),
        ("    stroke: 3 m\n", "", "25: compensators.PHC: 'stroke' is missing; a compensator needs it"),
    ],
)
def test_a_mistake_is_one_message_and_code_2(lift: Path, old: str, new: str, says: str) -> None:
    lift.write_text(changed(TEXT, (old, new)), encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(lift)])
    assert result.exit_code == 2
    assert f"{lift}:{says}" in result.stderr
    assert len(result.stderr.splitlines()) == 1
