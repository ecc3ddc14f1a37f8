"""`gantline import load.3docx` was asked `Did you mean 'report', 'export'?`, which write, where `cad` reads;
and of `simulate`, `show`, `validate`, `modes`, `sweep` and `help` it was told that there is no such command.
"""

from __future__ import annotations

import re

import pytest
from typer.main import get_command
from typer.testing import CliRunner

from gantline.cli.app import OTHER_WORDS, app


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("import load.3docx", "'import' is no verb; 'gantline cad FILE' reads CAD files"),
        ("simulate mylift", "'simulate' is no verb; 'gantline run LIFT' simulates a lift"),
        ("show results/mylift", "'show' is no verb; 'gantline view RECORDING' shows a result"),
        ("version", "'version' is no verb; 'gantline --version' shows it"),
    ],
)
def test_what_there_is_here_is_named(words: str, told: str) -> None:
    result = CliRunner().invoke(app, words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.endswith(f"Error: {told}\n")


def test_what_is_named_is_there() -> None:
    verbs = set(get_command(app).commands)  # type: ignore[attr-defined]
    named = {verb for text in OTHER_WORDS.values() for verb in re.findall(r"gantline ([a-z]+)", text)}
    assert named <= verbs
    assert not verbs & set(OTHER_WORDS)
