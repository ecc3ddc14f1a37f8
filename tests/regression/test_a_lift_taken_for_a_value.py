"""`gantline statics --lost mylift`, without the load, ended with "Missing argument 'LIFT'.", beside the lift
that stood there. And the report speaks of the tolerance of positions, which `gantline run` had no option for.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("statics --lost mylift", "Missing argument 'LIFT'; 'mylift' was taken for the LOAD of --lost"),
        ("run -o mylift", "Missing argument 'LIFT'; 'mylift' was taken for the DIR of -o"),
        (
            "report --output a.html",
            "Missing argument 'RECORDING'; 'a.html' was taken for the FILE of --output",
        ),
        ("run", "Missing argument 'LIFT'."),
        ("export results/mylift --time '12 s'", "Missing argument 'FILE'."),
    ],
)
def test_what_took_the_lift_is_told(words: str, told: str) -> None:
    result = CliRunner().invoke(app, words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.endswith(f"Error: {told}\n")


def test_help_is_given_without_a_lift() -> None:
    result = CliRunner().invoke(app, "run -o out --help")
    assert (result.exit_code, result.stderr) == (0, "")


def test_positions_have_a_tolerance_as_tensions_have(tmp_path: Path) -> None:
    common = f"-o {tmp_path} --no-plots --no-report --integrator adaptive --duration 0.2s"
    result = CliRunner().invoke(app, ["run", "pulleys", *f"{common} --position-tolerance 0.02mm".split()])
    assert result.exit_code in (0, 4), result.stderr
    settings = gantline.open_recording(tmp_path / "recording.nc").attributes["settings"]
    assert settings["integrator"]["position_tolerance"] == pytest.approx(2e-5)  # 0.02 mm [m]
