"""Pages show what the program prints, and commands that it knows.

`python tools/outputs.py` writes the output on pages anew.
"""

from __future__ import annotations

import math
import re
import shlex
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import typer.main

import gantline
import shown
from gantline.assembly import assemble
from gantline.cli.app import app
from gantline.scenario import parse_scenario
from gantline.scenario.file.shipped import shipped
from shown import PAGES, ROOT, NotSaidError, Shown, lift_that_runs, lifts_on, renewed, shown_on, stale, unsaid

#: Tables of runs of lifts that come with gantline are held in tests/verification/test_every_scenario.py.
SHOWN = {
    page: commands
    for page in PAGES
    if (commands := [one for one in shown_on(page) if lift_that_runs(one.command) is None])
}


@pytest.mark.slow
@pytest.mark.usefixtures("blank_pictures")
@pytest.mark.parametrize("page", SHOWN, ids=lambda page: page.stem)
def test_a_page_shows_what_the_program_prints(page: Path, tmp_path: Path) -> None:
    shown.prepare(page, tmp_path)
    wrong = {str(one): stale(one, shown.said_by(one.command, tmp_path)) for one in SHOWN[page]}
    assert {command: lines for command, lines in wrong.items() if lines} == {}


@pytest.mark.parametrize("page", [page for page in PAGES if lifts_on(page)], ids=lambda page: page.stem)
def test_lift_files_on_pages_can_be_built(page: Path) -> None:
    for title, text in lifts_on(page).items():
        assert assemble(parse_scenario(text)).document["bodies"], title


# --- commands ------------------------------------------------------------------------------------


def commands_of(page: Path) -> list[str]:
    """Every command between fences of a page, without the folder of the program."""
    text = page.read_text(encoding="utf-8")
    fenced = re.findall(r"^```(sh|console)\n(.*?)^```", text, flags=re.M | re.S)
    lines = [
        line for kind, inside in fenced for line in inside.splitlines() if kind == "sh" or line[:2] == "$ "
    ]
    return [line.removeprefix("$ ").removeprefix(".venv/bin/") for line in lines if "gantline " in line]


COMMANDS = sorted({command for page in PAGES for command in commands_of(page)})


@cache
def command_of_all() -> Any:
    """typer has a copy of click inside, so that commands and their verbs are of no public type."""
    return typer.main.get_command(app)


def verb_of(words: list[str]) -> tuple[Any, list[str]]:
    """The verb that words call, and the words behind it."""
    command = command_of_all()
    while words and (verbs := getattr(command, "commands", None)):
        # `gantline cad X` is short for `gantline cad file X`.
        if words[0] in verbs or "file" not in verbs:
            word, *words = words
        else:
            word = "file"
        command = verbs[word]
    return command, words


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_a_page_can_be_given(command: str) -> None:
    program, *words = shlex.split(command, comments=True)
    assert program == "gantline"
    verb, rest = verb_of(words)
    given = verb.make_context(verb.name, list(rest)).params
    lift = str(given.get("lift"))
    is_name = "/" not in lift and lift not in {"None", "mylift"}
    assert not is_name or lift in shipped()


def test_there_are_commands_and_output() -> None:
    assert len(COMMANDS) >= 30
    assert {page.stem for page in SHOWN} >= {
        "afloat",
        "cases",
        "compare",
        "goliath",
        "inverse",
        "loads_from_cad",
        "tilting",
    }


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_words_in_a_sentence_name_verbs_and_their_options(page: Path) -> None:
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    for words in re.findall(r"`(?:\.venv/bin/)?gantline ([a-z][^`]*)`", text):
        verb, rest = verb_of(shlex.split(words))
        known = {name for parameter in verb.params for name in (*parameter.opts, *parameter.secondary_opts)}
        options = {word.partition("=")[0] for word in rest if re.match(r"--?[a-z]", word)}
        assert options <= known | {"--help"}, words


def test_the_first_lift_changes_as_its_guide_says() -> None:
    lift = gantline.load_scenario("equalizer")
    slow = {"plan.1.speed": "0.05 m/s", "plan.1.brake_from": "50 s", "duration": "65 s"}
    usual, slower, shorter, off = (
        gantline.simulate(lift.changed(changes)).metrics()
        for changes in ({}, slow, {"slings.S3.length": "25.8 m"}, {"load.centre_of_gravity.at.x": "0.1 m"})
    )
    peaks = [f"{metrics['peak_sling_tension'] / 1e3:.0f} kN" for metrics in (slower, usual)]
    assert (
        unsaid(
            "docs/guides/first_lift.md",
            f"The slings then peak at {peaks[0]}, not {peaks[1]}",
            f"The load tilts by up to {math.degrees(off['peak_load_tilt']):.1f}°",
        )
        == []
    )
    static = "static_sling_tension.sling.S3"
    assert shorter[static] == pytest.approx(usual[static], rel=1e-3)


# --- the rule itself -----------------------------------------------------------------------------

SAID = """\
Title

Sling  tension       at
  S1    5.04 kN  20.52 s
  S2   12.00 kN  20.52 s
Residual 3.1e-12, 120 steps
"""


def excerpt(*lines: str) -> Shown:
    return Shown(ROOT / "README.md", 1, "gantline run lift", lines)


@pytest.mark.parametrize(
    ("line", "is_right"),
    [
        ("  S1    5.04 kN  20.52 s", True),
        ("  S1     5.04 kN  20.52 s", True),  # a column is as wide as its widest number
        ("  S1    5.05 kN  20.52 s", True),
        ("  S1    5.06 kN  20.52 s", False),
        ("  S1    5.04 kN  20.60 s", False),
        ("Residual 9.9e-10, 120 steps", True),
        ("Residual 9.9e-04, 120 steps", False),
        ("Residual 3.1e-12, 121 steps", True),
        ("Residual 3.1e-12, 124 steps", False),
    ],
)
def test_numbers_may_differ_as_processors_round(line: str, is_right: bool) -> None:
    assert (stale(excerpt("...", line, "..."), SAID) == []) is is_right


@pytest.mark.parametrize(
    "lines",
    [
        ("...", "  S3    5.04 kN  20.52 s", "..."),  # another name
        ("...", "  S1    5.04 MN  20.52 s", "..."),  # another unit
        ("  S1    5.04 kN  20.52 s", "..."),  # what stands before is not said to be left out
        ("...", "  S1    5.04 kN  20.52 s"),  # nor what stands behind
        ("...", "Residual 3.1e-12, 120 steps", "...", "Title", "..."),  # the other way round
    ],
)
def test_other_words_are_not_what_the_program_prints(lines: tuple[str, ...]) -> None:
    with pytest.raises(NotSaidError):
        stale(excerpt(*lines), SAID)


def test_a_figure_in_a_sentence_is_found_or_not() -> None:
    licence, years = "Construction 61 (2016) 98–111", "Construction 61 (2036) 98–111"
    assert unsaid("README.md", licence, years, "Ham, Roh and Lea") == ["Ham, Roh and Lea"]
    assert unsaid("README.md", "Construction 63 (2016) 98–111") == ["Construction 63 (2016) 98–111"]


def test_old_numbers_are_written_anew_and_what_is_left_out_stays_out() -> None:
    old = excerpt("Title", "...", "  S2   11.00 kN  20.52 s", "  ...", "Residual 1.0e-12, 99 steps")
    fresh = ["Title", "...", "  S2   12.00 kN  20.52 s", "  ...", "Residual 3.1e-12, 120 steps"]
    assert renewed(old, SAID) == fresh


def test_numbers_in_quoted_names_are_names() -> None:
    """Hold point 2 was taken for hold point 1 where more numbers of that had stayed."""
    first = "At the end of 'hold point 1', 10.00 s\n  trim 0.14 deg\n"
    said = first + "At the end of 'hold point 2', 21.00 s\n  trim 0.15 deg\n"
    old = excerpt("...", "At the end of 'hold point 2', 20.00 s", "  trim 0.14 deg", "...")
    assert renewed(old, said)[1:3] == ["At the end of 'hold point 2', 21.00 s", "  trim 0.15 deg"]
