"""Seas in which every run stopped were told to last as long as the longest of these came.

`gantline seas` of a lift of 20 s that gave up at 3 s had "3 s" in its head line, as if that were the plan,
and nothing there said that records had not come to their end; the report had the same.
"""

from __future__ import annotations

from typing import Any

import pytest

from column_in_waves import SEA, column
from gantline.cli.seas_table import seas_table
from gantline.results.file.saved_seas import SavedSeas
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation, SimulationError
from gantline.study.seas import run_seas


def head_of(saved: SavedSeas) -> str:
    """The head line of the table, which is told over two."""
    lines = seas_table(saved, 300)
    return lines[1]


def test_the_head_line_has_the_duration_of_the_plan_and_how_many_stopped(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    run = Simulation.run

    def breaks(self: Simulation, **how: Any) -> Any:
        short = Simulation(self.scenario, duration=3.0)
        recording = run(short)
        raise SimulationError(recording, 3.0, "sling.S1", "it gave up", b"")

    monkeypatch.setattr(Simulation, "run", breaks)
    found = run_seas(parse_scenario(column(SEA, duration="20 s")), heights=[0.5, 1.0], records=2)
    saved = SavedSeas.from_json(found.to_json())
    assert (saved.duration, saved.runs, saved.stopped, saved.unstarted) == (20.0, 2, 2, 0)
    assert ", 20 s; 2 of 2 stopped on the way; share" in head_of(saved)


def test_what_came_to_its_end_is_not_told() -> None:
    found = run_seas(parse_scenario(column(SEA, duration="20 s")), heights=[0.5])
    saved = SavedSeas.from_json(found.to_json())
    assert saved.short == ""
    assert ", 1 record of each sea, 20 s; share" in head_of(saved)


def test_files_of_older_versions_have_what_came_to_its_end() -> None:
    document = run_seas(parse_scenario(column(SEA, duration="20 s")), heights=[0.5]).to_json()
    del document["duration"]
    assert SavedSeas.from_json(document).duration == 20.0
    document["seas"][0]["records"][0].update(cause="it gave up", time=3.0)
    assert SavedSeas.from_json(document).duration == 0.0
    assert ", 1 record of each sea; 1 of 1 stopped on the way; share" in head_of(
        SavedSeas.from_json(document)
    )
