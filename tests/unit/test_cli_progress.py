"""Progress on the error stream: a bar on a terminal, plain lines elsewhere, both with the step under way."""

from __future__ import annotations

import io
import re
import sys
import time

import pytest

import gantline.cli.progress as module
from gantline.cli.progress import progress, speed, telling

STEPS = {5.0: "lift off", 10.0: None}
TENSIONS = {5.0: ("S3", 590.4e3), 10.0: None}


class HalfDone:
    """A run of 10 s that is at one of the times of the tables above."""

    duration = 10.0
    now = 0.0

    @property
    def current_step(self) -> str | None:
        return STEPS[self.now]

    @property
    def largest_sling_tension(self) -> tuple[str, float] | None:
        return TENSIONS[self.now]


class Terminal(io.StringIO):
    """An error stream that says it is a terminal."""

    def isatty(self) -> bool:
        return True


def shown(stream: io.StringIO, monkeypatch: pytest.MonkeyPatch, *times: float) -> str:
    """What a run of 10 s puts on the stream when it tells these times."""
    monkeypatch.setattr(sys, "stderr", stream)
    run = HalfDone()
    with progress(run) as report:
        for run.now in times:
            report(run.now)
    return stream.getvalue()


def test_plain_lines_name_the_step_under_way_and_the_largest_tension(monkeypatch: pytest.MonkeyPatch) -> None:
    first, last = shown(io.StringIO(), monkeypatch, 5.0, 10.0).splitlines()
    assert first.startswith("simulated 5.0 of 10.0 s, ")
    assert first.endswith(" s left, step 'lift off', most in sling S3: 590 kN")
    assert last.startswith("simulated 10.0 of 10.0 s, ")
    assert last.endswith(" 0 s left")


def test_the_bar_names_the_step_under_way_and_the_largest_tension(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "200")
    text = shown(Terminal(), monkeypatch, 5.0)
    assert "5.0 of 10.0 s" in text
    assert "step 'lift off', most in sling S3: 590 kN" in text


def test_a_search_says_what_it_is_at_while_nothing_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", stream := io.StringIO())
    monkeypatch.setattr(module, "_SILENCE_OF_SEARCHES", 0.02)
    with telling("ballast") as tell:
        tell("round 1")
        patience = time.monotonic() + 60.0
        while stream.getvalue().count("round 1") < 3 and time.monotonic() < patience:
            time.sleep(0.01)
    lines = stream.getvalue().splitlines()
    # A slow machine comes to its first line before it has been told anything.
    assert all(re.fullmatch(r"ballast, (round 1, )?\d+ s so far", line) for line in lines)
    assert lines[-1].startswith("ballast, round 1, ") and len(lines) > 2
    time.sleep(0.1)
    assert stream.getvalue().splitlines() == lines, "and is silent afterwards"


def test_a_quick_search_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", stream := io.StringIO())
    with telling("ballast") as tell:
        tell("round 1")
    assert stream.getvalue() == ""


def test_a_search_turns_a_wheel_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.setattr(sys, "stderr", stream := Terminal())
    with telling("ballast") as tell:
        tell("round 1: [heel]")
    assert "ballast, round 1: [heel]" in stream.getvalue()


def test_speeds_are_written_out() -> None:
    """3740 s in a second were `3.74e+03 times real time`."""
    assert speed(3741.0, 1.0) == "3,740 times real time"
    assert speed(26.53, 1.0) == "26.5 times real time"
    assert speed(1.0, 0.0) == ""
