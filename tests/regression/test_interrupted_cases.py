"""`gantline cases` that was interrupted kept nothing of what it had found, minutes of work in a large lift.

It shows and saves now what is there, names the cases that lack variants, and no verdict calls them sound.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from gantline.results.file.saved import SavedCases
from gantline.scenario import parse_scenario
from gantline.study import run_cases
from gantline.study.side_by_side import SideBySide
from plumb_lift import plumb_lift
from verbs import gantline

CASES = """\
heavy: {set: {load.weight.simulate: design}}
hook_levels: {vary: {cranes.A.at.z: [-1 mm, 0 mm, 1 mm]}}
cog_corners: {vary: load.centre_of_gravity.envelope, corners: all}"""
LIFT = plumb_lift(CASES, tolerance="0.01 %", envelope="[0.1 m, 0.1 m, 0 m]")


def stop_at(monkeypatch: pytest.MonkeyPatch, number: int) -> None:
    """Let Ctrl-C come as so many have been asked for, and wait for these."""
    ask = SideBySide.submit
    asked: list[Any] = []

    def submit(self: SideBySide, work: Callable[..., Any], *rest: Any, **named: Any) -> Any:
        if len(asked) == number:
            for one in asked:
                one.result()
            raise KeyboardInterrupt
        asked.append(ask(self, work, *rest, **named))
        return asked[-1]

    monkeypatch.setattr(SideBySide, "submit", submit)


def test_what_has_been_found_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """As given, `heavy`, and one of three hook levels; no corner has been begun."""
    whole = run_cases(parse_scenario(LIFT))
    stop_at(monkeypatch, 3)
    result = run_cases(parse_scenario(LIFT))
    assert result.names == ("", "heavy", "hook_levels")
    assert [len(result.of(name)) for name in result.names] == [1, 1, 1]
    assert list(result.not_done) == ["hook_levels", "cog_corners"]
    assert whole.is_sound and not whole.not_done
    assert not result.is_sound
    assert [one.label for one in result.states] == [one.label for one in whole.states[:3]]


def test_the_command_says_so_and_saves_it(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    lift, folder = tmp_path / "lift.yaml", tmp_path / "out"
    lift.write_text(LIFT, encoding="utf-8")
    stop_at(monkeypatch, 3)
    found = gantline("cases", str(lift), "-o", str(folder))
    assert found.exit_code == 130
    assert "interrupted; not all variants of these were worked out: hook_levels, cog_corners" in found.stderr
    assert "hook_levels (1 of more)" in found.stdout
    assert "interrupted, not all was asked of hook_levels, cog_corners; 2 cases, 3 equilibria" in found.stdout
    assert "all sound" not in found.stdout
    saved = SavedCases.from_json(json.loads((folder / "cases.json").read_text(encoding="utf-8")))
    assert not saved.is_sound
    troubles = {one.name: list(one.troubles) for one in saved.cases}
    assert troubles["heavy"] == []
    assert troubles["hook_levels"] == troubles["cog_corners"]
    assert troubles["cog_corners"] == ["interrupted, not all of it was worked out"]


def test_where_not_even_the_lift_as_given_is_known_it_is_an_interrupt(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    stop_at(monkeypatch, 0)
    with pytest.raises(KeyboardInterrupt):
        run_cases(parse_scenario(LIFT))
