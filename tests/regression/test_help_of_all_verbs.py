"""The help of some verbs kept back what they end with, what options take, and what they do when left out.

`run`, the verb that most use, named no exit code but that of Ctrl-C; `ballast` and `compare` did not say
their 3, nor `gantline --help` what 130 is. `--integrator` took a `<str>`, `--records` an `<int range>`,
and of `--step`, `--duration` and `--sample-interval` it was not said whose value counts otherwise. Of
the examples `ballast --tanks row1,row2` named no tanks, and a sweep over 23 m of a sling was of the lift
that `gantline new` makes, of 12 m.
"""

from __future__ import annotations

import pytest
import typer
from typer.testing import CliRunner

from gantline.cli.app import app

GROUP = typer.main.get_command(app)
VERBS = [*(name for name in GROUP.commands if name != "cad"), "cad file", "cad block"]  # type: ignore[attr-defined]


def help_of(verb: str) -> str:
    result = CliRunner().invoke(app, [*verb.split(), "--help"])
    assert result.exit_code == 0
    return " ".join(result.stdout.split())


@pytest.mark.parametrize("verb", VERBS)
def test_options_say_what_they_take(verb: str) -> None:
    options = help_of(verb).split("Options:")[1]
    assert not [kind for kind in ("<int", "<str", "<path", "<float") if kind in options]


@pytest.mark.parametrize(
    ("verb", "codes"),
    [
        ("", ("0", "1", "2", "3", "4", "130")),
        ("run", ("1", "3", "4", "130")),
        ("statics", ("1", "3", "4")),
        ("cases", ("1", "3", "4")),
        ("seas", ("1", "4", "130")),
        ("compare", ("3", "130")),
        ("check", ("1", "4")),
        ("ballast", ("3",)),
        ("doctor", ("1",)),
    ],
)
def test_exit_codes_are_told(verb: str, codes: tuple[str, ...]) -> None:
    """Those of `docs/reference/command_line.md` that a verb may end with, but for 2 of what is not right."""
    text = help_of(verb)
    told = text.partition("Exit codes:")[2] if not verb else text.partition("Arguments:")[0]
    assert [code for code in codes if f" {code} " not in told.replace(",", " ").replace(".", " ")] == []


@pytest.mark.parametrize("option", ["integrator", "step", "sample-interval", "duration"])
def test_what_counts_where_an_option_is_left_out(option: str) -> None:
    told = help_of("run").split(f" --{option} ")[1].split(" --")[0]
    assert told.endswith("[default: that of the lift file]")
