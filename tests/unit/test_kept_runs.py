"""Runs in seas that are kept as they end, and a search that goes on from them."""

from __future__ import annotations

import json
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest

from column_in_waves import SEA, column
from gantline.checks import Check, Verdict
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation
from gantline.study import KeptRunsError, RunsInUseError, SeasResult, run_seas
from gantline.study.sea import SeaRecord
from gantline.study.side_by_side import SideBySide

HEIGHTS = [0.2, 0.6]


def lift(**given: Any) -> Scenario:
    return parse_scenario(column(SEA, **{"duration": "4 s", **given}))


def search(kept: Path | None, scenario: Scenario | None = None, **given: Any) -> SeasResult:
    wanted: dict[str, Any] = {"heights": HEIGHTS, "records": 2, "workers": 1, **given}
    return run_seas(scenario or lift(), kept=kept, **wanted)


def interrupt_after(monkeypatch: pytest.MonkeyPatch, runs: int) -> None:
    """Ctrl-C in the run after so many, which is given up: whatever it comes to is no run."""
    count = iter(range(1000))

    def at_once(pool: SideBySide, work: Callable[[], SeaRecord]) -> Future[SeaRecord]:
        done: Future[SeaRecord] = Future()
        if next(count) == runs:
            pool.give_up()
            work()
            raise KeyboardInterrupt
        done.set_result(work())
        return done

    monkeypatch.setattr(SideBySide, "submit", at_once)


def lines(kept: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in kept.read_text(encoding="utf-8").splitlines()]


def test_each_run_is_a_line_as_it_ends(tmp_path: Path) -> None:
    """Below one that says what they are of."""
    kept = tmp_path / "runs.jsonl"
    result = search(kept)
    first, *runs = lines(kept)
    assert set(first) == {"gantline", "lift_sha256", "waves", "simulated_sha256"}
    assert [(run["height"], run["record"]) for run in runs] == [(0.2, 1), (0.2, 2), (0.6, 1), (0.6, 2)]
    assert result.taken_over == 0


def test_a_search_goes_on_from_where_it_was_cut_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """To the same numbers as one that was not, by the missing run alone, which Ctrl-C had ended."""
    kept = tmp_path / "runs.jsonl"
    with monkeypatch.context() as patch:
        interrupt_after(patch, 3)
        assert search(kept).interrupted
    assert len(lines(kept)) == 1 + 3
    made: list[float] = []
    run = Simulation.run

    def counted(simulation: Simulation, **given: Any) -> Any:
        made.append(simulation.duration)
        return run(simulation, **given)

    monkeypatch.setattr(Simulation, "run", counted)
    result = search(kept)
    assert (len(made), result.taken_over) == (1, 3)
    assert result.to_json() == search(None).to_json()


def test_further_records_and_seas_cost_no_run_twice(tmp_path: Path) -> None:
    """Two heights and one in between, by two records and one more: four runs of nine are there."""
    kept = tmp_path / "runs.jsonl"
    search(kept)
    more: dict[str, Any] = {"heights": [0.2, 0.4, 0.6], "records": 3}
    result = search(kept, **more)
    assert result.taken_over == 4
    assert result.to_json() == search(None, **more).to_json()
    assert len(lines(kept)) == 1 + 9


def test_a_line_that_was_cut_off_is_run_again(tmp_path: Path) -> None:
    kept = tmp_path / "runs.jsonl"
    search(kept)
    whole = kept.read_bytes()
    kept.write_bytes(whole[:-40])
    assert search(kept).taken_over == 3
    assert kept.read_bytes() == whole


def test_one_of_the_first_line_alone_is_begun_anew(tmp_path: Path) -> None:
    kept = tmp_path / "runs.jsonl"
    kept.write_bytes(b'{"gantline": "0.')
    assert search(kept).taken_over == 0
    assert len(lines(kept)) == 1 + 4


@pytest.mark.parametrize(
    ("given", "of"),
    [
        ({"scenario": lift(least="600 kN")}, "another state of the lift file"),
        ({"duration": 3.0}, "other files that the lift names, or other settings"),
    ],
)
def test_runs_of_another_lift_are_refused(tmp_path: Path, given: dict[str, Any], of: str) -> None:
    """And stay as they are, but where the file is to be begun anew."""
    kept = tmp_path / "runs.jsonl"
    search(kept)
    before = kept.read_bytes()
    with pytest.raises(KeptRunsError, match=f"its runs are of {of}; all have to be run anew"):
        search(kept, **given)
    assert kept.read_bytes() == before
    assert search(kept, anew=True, **given).taken_over == 0
    assert kept.read_bytes() != before


def test_another_version_is_refused(tmp_path: Path) -> None:
    kept = tmp_path / "runs.jsonl"
    search(kept)
    first, *runs = lines(kept)
    kept.write_text("".join(json.dumps(line) + "\n" for line in (first | {"gantline": "0.0.1"}, *runs)))
    with pytest.raises(KeptRunsError, match="another version of gantline"):
        search(kept)


def test_two_searches_do_not_write_to_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second is refused before it has run anything, and the first one's runs are all there."""
    kept = tmp_path / "runs.jsonl"
    run, refused = Simulation.run, list[str]()

    def with_another(simulation: Simulation, **given: Any) -> Any:
        if not refused:
            with pytest.raises(RunsInUseError) as problem:
                search(kept, lift(least="600 kN"), anew=True)
            refused.append(str(problem.value))
        return run(simulation, **given)

    monkeypatch.setattr(Simulation, "run", with_another)
    search(kept)
    assert refused == [f"{kept}: another study is under way that writes its runs here"]
    assert len(lines(kept)) == 1 + 4
    assert search(kept).taken_over == 4


@pytest.mark.parametrize("line", ["a line", "[]", "{}", '{"height": 1, "period": 7, "direction": 0}'])
def test_what_is_no_run_is_told_with_its_line(tmp_path: Path, line: str) -> None:
    kept = tmp_path / "runs.jsonl"
    search(kept)
    with kept.open("a", encoding="utf-8") as file:
        file.write(line + "\n")
    with pytest.raises(KeptRunsError, match=rf"{kept}:6: is no run in a sea"):
        search(kept)


def test_a_record_reads_back_as_it_was() -> None:
    """With every entry of its checks, and a lift that could not start."""
    check = Check(
        "sling_tension",
        Verdict.WARNING,
        "what it bears",
        "1.2 / 3",
        value=1.2345678901234567,
        limit=3.0,
        at_least=True,
        unit="kN",
        digits=1,
        element="S1",
        time=0.1,
        remark="by hand",
        is_beside=True,
        cautions=("its curve",),
    )
    for record in (
        SeaRecord(number=3, time=12.5, checks=(check,), warnings=("a warning",)),
        SeaRecord(number=1, cause="too short for it", starts=False),
    ):
        assert SeaRecord.from_json(json.loads(json.dumps(record.to_json()))) == record
