"""`gantline cases` said nothing where Ctrl-C ended it early, and too little while it prepared variants.

Interrupted before the equilibrium of the lift as it is given was found it ended with 130 and no word. While
the patterns of tolerances were prepared, half a minute with `goliath`, it told "variants of 'sling_lengths'"
and nothing of what it was at or of what had been found meanwhile.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import gantline.study
from gantline.cli.messages import INTERRUPTED
from gantline.scenario import parse_scenario
from gantline.study import run_cases
from plumb_lift import plumb_lift
from verbs import gantline as run_gantline

LIFT = plumb_lift("sling_lengths: {vary: slings.tolerance, pattern: worst}", tolerance="0.01 %")


def test_an_interrupt_before_anything_is_found_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def interrupted(*_: Any, **__: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(gantline.study, "run_cases", interrupted)
    path = tmp_path / "lift.yaml"
    path.write_text(LIFT, encoding="utf-8")
    result = run_gantline("cases", str(path))
    assert result.exit_code == INTERRUPTED
    said = "interrupted before the equilibrium of the lift as it is given was found: no case is known"
    assert result.stderr == f"warning: {said}\n"
    assert result.stdout == ""


def test_what_is_prepared_is_told() -> None:
    told: list[str] = []
    run_cases(parse_scenario(LIFT), workers=1, on_progress=told.append)
    assert told[0] == "preparing the lift as it is given"
    of_lengths = [text for text in told if text.startswith("preparing 'sling_lengths'")]
    assert [text.partition(": ")[2].partition(",")[0] for text in of_lengths] == [
        "",
        "equilibrium without tolerances",
        "how lengths change tensions",
    ]
    assert all(text.endswith(" of 1 variants so far") for text in of_lengths)
