"""`gantline run mylift --report lift.html` ended with "Got unexpected extra argument(s) (lift.html)": that
`--report` is a switch, and where the report goes, nothing said.
"""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app

SWITCH = "is a switch and takes no value"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (
            "run a --report b.html",
            f"--report {SWITCH}; 'b.html' stands behind it; --output says where it is written",
        ),
        (
            "run a --no-plots out/b",
            f"--no-plots {SWITCH}; 'out/b' stands behind it; --output says where it is written",
        ),
        ("run a --live 8080", f"--live {SWITCH}; '8080' stands behind it"),
        ("check a --simulate 3", f"--simulate {SWITCH}; '3' stands behind it"),
        ("run a b", "Got unexpected extra argument(s) (b)"),
        ("run --report a b", "Got unexpected extra argument(s) (b)"),
    ],
)
def test_a_word_behind_a_switch_is_told(words: str, told: str) -> None:
    result = CliRunner().invoke(app, words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.endswith(f"Error: {told}\n")


def test_a_lift_may_stand_behind_a_switch() -> None:
    result = CliRunner().invoke(app, "check --json nowhere.yaml")
    assert result.exit_code == 2
    assert "nowhere.yaml: cannot be read" in result.stderr
