"""What pages show of the program's output, and how that is held against the program.

A page shows a command and what it prints between fences::

    ```console
    $ gantline statics equalizer
    ...
    Rope                tension
      e1.equalizing  295.772 kN
    ...
    ```

A line with nothing but `...` stands for lines left out; all else is what the program prints, line by line.
Commands of one page run one after the other in one scratch folder. Wall times belong to no page.

A figure in a sentence is held by the test that has it measured, by `unsaid`.
"""

from __future__ import annotations

import contextlib
import re
import shlex
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from pathlib import Path

from typer.testing import CliRunner

from gantline.checks import check_recording
from gantline.cli.app import app
from gantline.cli.check_table import styled
from gantline.cli.summary import summary
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.scenario.file.shipped import shipped
from hooked_lift import two_hooks

ROOT = Path(__file__).resolve().parents[2]
MECHANICS = ROOT / "docs" / "guides" / "mechanics_in_a_lift_file.md"
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
LEFT_OUT = "..."
WIDTH = 100  # columns of the terminal
#: A number that is no part of a name such as `S1`, `e1.3` or `block.L2`.
NUMBER = re.compile(r"(?<![\w.])[-+−]?\d[\d,]*(?:\.\d+)?(?:[eE][-+]?\d+)?")
#: Shares by which numbers may differ where a processor rounds otherwise: what is measured, what is counted.
MEASURED, COUNTED = 1e-3, 1e-2
#: What is written with an exponent and is less than this is a residual; rounding alone makes it.
RESIDUAL = 1e-9


@dataclass(frozen=True)
class Shown:
    """A command on a page, and what the page shows of its output.

    Attributes:
        page: The page.
        first: Line of the page on which the output begins, from 0.
        command: The command as it stands there.
        lines: What is shown below it.
    """

    page: Path
    first: int
    command: str
    lines: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT)}:{self.first}: {self.command}"


class NotSaidError(AssertionError):
    """The program prints no lines like those that a page shows."""


def shown_on(page: Path) -> Iterator[Shown]:
    """Every command of a page with the output that stands below it."""
    lines = page.read_text(encoding="utf-8").splitlines()
    fences = [number for number, line in enumerate(lines) if line.startswith("```")]
    for begin, end in zip(fences[::2], fences[1::2], strict=True):
        if lines[begin] != "```console":
            continue
        prompts = [number for number in range(begin, end) if lines[number].startswith("$ ")]
        for prompt, after in pairwise([*prompts, end]):
            yield Shown(page, prompt + 1, lines[prompt][2:], tuple(lines[prompt + 1 : after]))


# --- what the program says -----------------------------------------------------------------------


def lift_with_cases() -> str:
    """The lift of the page on cases: the first lift, its sheaves with inertia, and the cases on that page."""
    page = (ROOT / "docs" / "concepts" / "cases.md").read_text(encoding="utf-8")
    cases = re.search(r"^```yaml\n(cases:\n.*?)^```", page, flags=re.M | re.S)
    assert cases is not None
    text = (ROOT / "scenarios" / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    return text.replace("rotating_mass: 0 kg", "rotating_mass: 150 kg") + cases[1]


def lift_out_of_range() -> str:
    """The lift of the guide on Goliath cranes, with trolleys that go 10 m too far."""
    text = (ROOT / "scenarios" / "goliath" / "scenario.yaml").read_text(encoding="utf-8")
    assert "by: 75 m" in text
    return text.replace("by: 75 m", "by: 85 m")


def lifts_on(page: Path) -> dict[str, str]:
    """Whole lift files that a page shows, by title."""
    text = page.read_text(encoding="utf-8")
    files = re.findall(r"^```yaml\n(format: 1\n.*?)^```", text, flags=re.M | re.S)
    return {parse_scenario(file).lift.title: file for file in files}


def lift_on(page: Path, title: str) -> str:
    """The lift file of that title that a page shows."""
    return lifts_on(page)[title]


#: The lift file `mylift` of pages that have one of their own.
LIFTS: dict[str, Callable[[], str]] = {
    "cases.md": lift_with_cases,
    "goliath.md": lift_out_of_range,
    "inverse.md": two_hooks,
    "mechanics_in_a_lift_file.md": partial(lift_on, MECHANICS, "A module on a spreader bar"),
}


def prepare(page: Path, folder: Path) -> None:
    """Put what the commands of a page begin with into their scratch folder."""
    if page.name in LIFTS:
        (folder / "mylift").mkdir()
        (folder / "mylift" / "scenario.yaml").write_text(LIFTS[page.name](), encoding="utf-8")


def said_by(command: str, folder: Path) -> str:
    """What `gantline` prints when it is called in a folder: its output, or its complaint."""
    program, *words = shlex.split(command)
    assert program == "gantline", command
    with contextlib.chdir(folder):
        result = CliRunner().invoke(app, words, env={"COLUMNS": str(WIDTH)})
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result.stdout or result.stderr


def table_of(recording: Recording) -> str:
    """The table that `gantline run` prints of a lift, up to the line on the time that it took."""
    lines = summary(recording, check_recording(recording), styled, WIDTH)
    return re.sub(r"\x1b\[[\d;]*m", "", "\n".join(lines))


def lift_that_runs(command: str) -> str | None:
    """Name of the lift that a command simulates once as it comes with gantline."""
    words = shlex.split(command)
    is_run = words[:2] == ["gantline", "run"] and "--refine" not in words
    return words[2] if is_run and words[2] in shipped() else None


# --- the one held against the other --------------------------------------------------------------


def stale(shown: Shown, said: str) -> list[str]:
    """Where a page shows something else than the program says, each in one line."""
    return [
        f"shows   {old}\n  but is  {new}"
        for old, new in zip(shown.lines, renewed(shown, said), strict=True)
        if not _alike(old, new)
    ]


def renewed(shown: Shown, said: str) -> list[str]:
    """The lines that a page shows, as the program says them now.

    Raises:
        NotSaidError: if lines are shown that differ from those of the program by more than numbers.
    """
    lines = [line.rstrip() for line in said.strip("\n").splitlines()]
    fresh: list[str] = []
    place, may_skip = 0, False
    for piece, is_last in _pieces(shown.lines):
        starts = range(place, len(lines) - len(piece) + 1) if may_skip else [place]
        fits = [at for at in starts if _texts(lines[at : at + len(piece)]) == _texts(piece)]
        if not fits or (is_last and max(fits) + len(piece) < len(lines)):
            raise NotSaidError(f"{shown}\nthe program says nothing like\n" + "\n".join(piece))
        # Of several places, such as one table at each hold point, that which is most like what is shown.
        best = max(fits, key=lambda at: (_same_lines(lines[at : at + len(piece)], piece), -at))
        place = max(fits) if is_last else best
        fresh += lines[place : place + len(piece)]
        place += len(piece)
        if not is_last:
            fresh.append(shown.lines[len(fresh)])
        may_skip = True
    return fresh


def _pieces(lines: tuple[str, ...]) -> Iterator[tuple[list[str], bool]]:
    """Runs of lines between those that are left out; whether a run is the last one."""
    piece: list[str] = []
    for line in lines:
        if line.strip() == LEFT_OUT:
            yield piece, False
            piece = []
        else:
            piece.append(line)
    yield piece, True


def _same_lines(some: list[str], others: list[str]) -> int:
    return sum(one.split() == other.split() for one, other in zip(some, others, strict=True))


def _texts(lines: list[str]) -> list[str]:
    """Lines without their numbers but those in quoted names, and without the widths that columns have."""
    pattern = re.compile(rf"(?<!\w)'[^']*'(?!\w)|{NUMBER.pattern}")
    kept = (pattern.sub(lambda found: found[0] if found[0][0] == "'" else "#", line) for line in lines)
    return [" ".join(line.split()) for line in kept]


def _alike(shown: str, said: str) -> bool:
    """Whether lines with the same text have the same numbers, as far as processors agree on them."""
    return all(map(_near, NUMBER.findall(shown), NUMBER.findall(said)))


def _near(shown: str, said: str) -> bool:
    one, other = (float(text.replace(",", "").replace("−", "-")) for text in (shown, said))
    if "e" in shown and abs(one) < RESIDUAL:
        return abs(other) < RESIDUAL
    digits, _, exponent = shown.partition("e")
    decimals = len(digits.partition(".")[2])
    if not decimals and not exponent:
        return abs(one - other) <= COUNTED * abs(one)
    last = 10.0 ** (int(exponent or 0) - decimals)
    return abs(one - other) <= 1.001 * last + MEASURED * abs(one)


# --- figures in sentences ------------------------------------------------------------------------


def unsaid(page: str, *sentences: str) -> list[str]:
    """Those of the sentences that a page does not have, in these words and, up to rounding, these numbers.

    Args:
        page: Path from the root.
        sentences: What was measured, in the words of the page; line breaks are spaces.
    """
    text = " ".join((ROOT / page).read_text(encoding="utf-8").split())
    return [sentence for sentence in sentences if not _is_said(text, " ".join(sentence.split()))]


def _is_said(text: str, sentence: str) -> bool:
    words = map(re.escape, NUMBER.split(sentence))
    found = re.finditer(f"({NUMBER.pattern})".join(words), text)
    return any(all(map(_near, match.groups(), NUMBER.findall(sentence))) for match in found)
