"""Settings of a command have the bounds of those in a lift file; what cannot be opened takes one line."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (
            ["--integrator", "del", "--step", "100 s"],
            "--step: the step of 100 s is longer than the duration of 40 s",
        ),
        (["--integrator", "del", "--step", "1e-15 s"], "--step: '1e-15 s' is absurdly small"),
        (
            ["--integrator", "del", "--step", "1e-8 s"],
            "--step: 40 s in parts of 1e-08 s are more than 100 million",
        ),
        (["--tension-tolerance", "1e-300 N"], "--tension-tolerance: '1e-300 N' is absurdly small"),
        (["--duration", "1e-300 s"], "--duration: '1e-300 s' is absurdly small"),
        (["--duration", "10 ms"], "--duration: 0.02 s between samples are more than the duration of 0.01 s"),
        (
            ["--sample-interval", "1 us"],
            "--sample-interval: 40 s in parts of 1e-06 s are more than 1 million",
        ),
    ],
)
def test_settings(tmp_path: Path, words: list[str], says: str) -> None:
    result = CliRunner().invoke(app, ["run", "equalizer", "-o", str(tmp_path), *words])
    assert result.exit_code == 2
    assert says in result.stderr
    assert not list(tmp_path.iterdir())


def test_a_name_that_is_too_long(tmp_path: Path) -> None:
    long = str(tmp_path / (300 * "x"))
    for words in (["run", "pulleys", "-o", long], ["check", f"{long}.nc"]):
        result = CliRunner().invoke(app, words)
        assert result.exit_code == 2
        assert len(result.stderr.splitlines()) == 1 and "too long" in result.stderr.lower()


def test_a_list_for_the_type_of_a_crane(tmp_path: Path) -> None:
    reference = Path(__file__).parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
    text = reference.read_text(encoding="utf-8")
    assert "type: fixed_hook" in text
    path = tmp_path / "lift.yaml"
    path.write_text(text.replace("type: fixed_hook", "type: [fixed_hook]"), encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 2
    assert "cranes.test_hook.type: a list is not a type of crane" in result.stderr
