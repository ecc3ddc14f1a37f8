"""Two searches in one folder at the same time wrote their runs over each other's.

`gantline seas -o DIR` that was begun while another was under way in the same folder began `seas_runs.jsonl`
anew, and each then wrote where it took the end of the file to be: lines were lost or torn, and `--continue`
took the one for the other or refused the file. The second is refused now before it runs anything, by a lock
that ends with the program.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from column_in_waves import SEA, column
from gantline.simulation import Simulation
from plumb_lift import plumb_lift
from verbs import gantline

CASES = "heavy: {set: {load.weight.simulate: design}}"


@pytest.mark.parametrize(
    ("text", "words", "name", "runs"),
    [
        (column(SEA, duration="4 s"), ["seas", "--height", "0.1 m, 0.2 m"], "seas_runs.jsonl", 2),
        (plumb_lift(CASES), ["cases", "--simulate"], "case_runs.jsonl", 2),
    ],
)
@pytest.mark.parametrize("more", [[], ["--continue"]])
def test_the_second_is_refused(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    text: str,
    words: list[str],
    name: str,
    runs: int,
    more: list[str],
) -> None:
    lift, folder = tmp_path / "lift.yaml", tmp_path / "out"
    lift.write_text(text, encoding="utf-8")
    asked = [words[0], str(lift), *words[1:], "-o", str(folder)]
    run, second = Simulation.run, list[Any]()

    def with_another(simulation: Simulation, **given: Any) -> Any:
        if not second:
            second.append("under way")
            second[0] = gantline(*asked, *more)
        return run(simulation, **given)

    monkeypatch.setattr(Simulation, "run", with_another)
    gantline(*asked)
    assert second[0].exit_code == 2
    said = f"error: {folder / name}: another study is under way that writes its runs here; "
    assert second[0].stderr == f"{said}wait for its end, or name another folder by -o\n"
    lines = (folder / name).read_text(encoding="utf-8").splitlines()
    assert len([json.loads(line) for line in lines]) == 1 + runs
