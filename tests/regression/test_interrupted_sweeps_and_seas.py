"""Ctrl-C in a sweep threw all of its equilibria away without a word, and in seas it told what is not known.

`gantline statics --sweep` of a thousand values ended with nothing. `gantline seas` had "none" as the height
that is allowed where no sea had been run, which were "higher than a sea in which the lift is no go".
"""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import gantline.study
from column_in_waves import SEA, column
from four_slings import LIFT
from gantline.cli.seas_table import seas_table
from gantline.results.file.saved_seas import SavedSeas
from gantline.scenario import parse_scenario
from gantline.study.seas import run_seas
from verbs import gantline as says


def test_a_sweep_shows_what_it_has_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = gantline.study.run_sweep

    def interrupted(*given: Any) -> Iterator[Any]:
        for number, point in enumerate(whole(*given)):
            if number == 1:
                signal.raise_signal(signal.SIGINT)
            yield point

    monkeypatch.setattr(gantline.study, "run_sweep", interrupted)
    lift = tmp_path / "lift.yaml"
    lift.write_text(LIFT)
    result = says("statics", str(lift), "--sweep", "load.weight.calculated=20 t..30 t/11")
    assert result.exit_code == 130
    assert [line.split()[:2] for line in result.stdout.splitlines()[1:3]] == [["20", "t"], ["21", "t"]]
    assert "22 t" not in result.stdout
    assert result.stderr == "warning: interrupted after 2 of 11 values\n"


def test_seas_that_were_not_run_show_nothing() -> None:
    """As if Ctrl-C had come before the first had been run."""
    document = run_seas(parse_scenario(column(SEA, duration="2 s")), heights=[0.5, 1.0]).to_json()
    for sea in document["seas"]:
        sea |= {"records": [], "worst_record": None, "allowed": False, "refused": False}
    for one in document["allowed"]:
        one["height"] = None
    lines = seas_table(SavedSeas.from_json(document), 100)
    assert [line.split()[1:] for line in lines if line.startswith("  allowed")] == [["-"]]
    assert lines[-1] == "  not run: the search was interrupted before"
    assert not any("higher than" in line for line in lines)
