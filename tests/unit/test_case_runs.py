"""Cases that are simulated: the runs that they are, what is left out, and what of them is worst."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from cad_loads import obj
from gantline.checks import Outcome
from gantline.cli.case_runs_table import case_runs_table
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation, simulate
from gantline.study import CaseRun, CaseRuns, KeptRunsError, run_cases, simulate_cases
from gantline.study.side_by_side import SideBySide
from lift_text import BASE, CASES, changed
from solids import box

ADAPTIVE = ("{integrator: del, step: 1 ms, sample_interval: 20 ms}", "{sample_interval: 20 ms}")
STOPS = ("down: 1 m}", "down: 1 m, stops: true}")
#: From a sheave 15 m up to its lug, 3 m up and 2.2 m aside, it is 12.2 m; the hook goes up by 0.5 m.
SLACK = ("length: 13 m", "length: 12.45 m")
#: By how much its 60 t have sunk into the ground at the start, 200 MN/m at each of four corners [m].
SUNK = 60e3 * 9.81 / (4 * 200e6)
HEAVY_CASE = "cases:\n  heavy: {set: {load.weight.simulate: design}}\n"
#: Of the case `heavy` by hand.
HEAVY = {"load.weight.simulate": "design", "load.weight.contingency": 1.1}


def lift(cases: str = CASES, *changes: tuple[str, str]) -> Scenario:
    return parse_scenario(changed(BASE, ADAPTIVE, STOPS, *(changes or [SLACK])) + cases)


@cache
def whole() -> CaseRuns:
    return simulate_cases(lift())


def only(case: str) -> CaseRun:
    (run,) = whole().of(case)
    return run


def test_each_variant_is_a_run() -> None:
    """In the order of the file; two offsets by one are two, patterns of lengths those of `gantline cases`."""
    found = whole()
    assert found.names == ("", "heavy", "hook_level", "lengths", "sling_cut", "both_cut")
    assert [run.variant for run in found.of("hook_level")] == [
        "cranes.hook.at.z −0.2 m, cranes.hook.at.x +10 mm",
        "cranes.hook.at.z +0.2 m, cranes.hook.at.x +10 mm",
    ]
    at_rest = run_cases(lift())
    states = [state.variant for state in at_rest.of("lengths") if state.losses == "none"]
    assert [run.variant for run in found.of("lengths")] == states
    assert not found.left_out and not found.not_done


@pytest.mark.parametrize(
    ("case", "changes"),
    [("", {}), ("heavy", HEAVY), ("both_cut", {"slings.S1.cut_at": "15 s", "slings.S2.cut_at": "15 s"})],
)
def test_a_run_is_that_of_the_lift_with_its_change(case: str, changes: dict[str, Any]) -> None:
    """To the last digit: it starts as the lift does, and goes on as a run by itself."""
    run, recording = only(case), simulate(lift("").changed(changes) if changes else lift(""))
    metrics = recording.metrics()
    assert run.peaks == {name: metrics[name] for name in run.peaks}
    assert run.peaks["peak_sling_tension"] > 0.0
    assert run.time == recording.time[-1]


def test_a_cut_at_a_step_is_made_as_that_begins() -> None:
    """In the run of the lift as it is given: `hold` begins as the hoist has braked, the cut is 1 s later."""
    begin = only("").begins["hold"]
    run = only("sling_cut")
    assert run.variant == f"at {begin + 1.0:.4g} s"
    recording = simulate(lift("").changed({"slings.S1.cut_at": f"{begin + 1.0!r} s"}))
    assert run.peaks["peak_sling_tension"] == recording.metrics()["peak_sling_tension"]
    assert run.outcome is Outcome.NO_GO
    assert "rope_parted" in run.failed


def test_slings_that_are_too_short_for_the_start_cannot_start() -> None:
    """With 10 mm of slack a sling that is 31 mm shorter would pull at the start; a longer one does not."""
    tight = lift(
        "cases:\n  lengths: {vary: slings.tolerance, pattern: each}\n", ("length: 13 m", "length: 12.21 m")
    )
    found = simulate_cases(tight)
    told = {run.variant[:4]: run.starts for run in found.of("lengths")}
    assert told == {"S2 +": True, "S2 −": False}
    (short,) = (run for run in found.runs if not run.starts)
    assert short.outcome is Outcome.NO_GO
    assert short.cause.startswith("slings.S2: the sling is 12.1795 m")
    assert short.short == pytest.approx(math.hypot(12.0 + SUNK, 2.2) - 12.1795, abs=1e-4)
    assert not found.is_go


def test_variants_that_cannot_start_say_what_lets_all_of_them_start() -> None:
    """The hook 0.2 m higher, of two slings the one that lacks most: 0.187 m along it.

    With the hook lower by that over the cosine of its angle, 12.2 m over 12.4 m, every variant starts.
    """
    cases = "cases:\n  level: {vary: {cranes.hook.at.z: [-0.1 m, 0.1 m, 0.2 m]}}\n"
    tight = ("length: 13 m", "length: 12.21 m")
    found = simulate_cases(lift(cases, tight))
    *_, high = found.of("level")
    missing = math.hypot(12.2 + SUNK, 2.2) - 12.21
    assert high.short == pytest.approx(missing, abs=1e-4)
    assert high.cause.startswith("2 slings are too short for the start, most of all slings.S1: ")
    told = " ".join(" ".join(case_runs_table(found, width=100, variants=False)).split())
    assert told.count("cannot start") == 1
    assert "with its hooks 0.19 m lower at the start" in told
    lower = missing * math.hypot(12.2, 2.2) / 12.2
    more = ("at: [0 m, 0 m, 20 m]", f"at: [0 m, 0 m, {20.0 - lower - 1e-3!r} m]")
    slack = simulate_cases(lift(cases, tight, more), duration=1.0)
    assert all(run.starts and not run.short for run in slack.runs)


def test_files_that_know_nothing_of_short_slings() -> None:
    document = {"case": "heavy", **only("heavy").to_json()}
    del document["short"]
    assert CaseRun.from_json(document) == only("heavy")


@pytest.mark.parametrize(
    ("case", "why"),
    [
        ("{cut: S1}", "a cut is simulated at its own time, and this one has none"),
        ("{cut: S1, at_step: never}", "the lift as it is given does not come to 'never'"),
    ],
)
def test_what_is_not_simulated_says_why(case: str, why: str) -> None:
    steps = "  - {step: hold, hold: until_end}"
    later = "  - {step: hold, hold: 60 s}\n  - {step: never, hold: until_end}"
    found = simulate_cases(lift(f"cases:\n  cut: {case}\n", SLACK, (steps, later)))
    assert list(found.left_out) == ["cut"]
    assert found.left_out["cut"].startswith(why)
    assert found.names == ("",)
    assert not found.is_go


def test_the_worst_of_each_limit() -> None:
    """Most of a limit first; each check once, by the run that uses most of it."""
    worst = whole().worst
    names = [check.name for check, _ in worst]
    assert len(set(names)) == len(names)
    for check, run in worst:
        assert check.utilisation is not None and check in run.checks
        others = [one.utilisation for other in whole().runs for one in other.checks if one.name == check.name]
        assert check.utilisation == pytest.approx(max(share for share in others if share is not None))
    (heaviest,) = (run for check, run in worst if check.name == "lug_load_of_capacity")
    assert heaviest.case in ("heavy", "sling_cut")


def test_no_matter_how_many_work_at_a_time() -> None:
    assert simulate_cases(lift(), workers=1).to_json() == whole().to_json()


def test_ctrl_c_keeps_what_is_done(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three runs of the lift, `heavy` and one hook level; what goes on ends early, and is none of them."""
    submit, asked = SideBySide.submit, list[Any]()

    def submitting(pool: SideBySide, work: Callable[..., Any], *rest: Any, **named: Any) -> Any:
        if len(asked) == 3:
            for one in asked:
                one.result()
            raise KeyboardInterrupt
        asked.append(submit(pool, work, *rest, **named))
        return asked[-1]

    expected = whole().runs[:3]
    monkeypatch.setattr(SideBySide, "submit", submitting)
    found = simulate_cases(lift())
    assert list(found.runs) == list(expected)
    assert list(found.not_done) == ["hook_level", "lengths", "sling_cut", "both_cut"]
    assert not found.is_go


def test_what_was_cut_off_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """From half a line: two of nine runs are made, the others are taken over, and all is as in one go."""
    kept = tmp_path / "runs.jsonl"
    assert simulate_cases(lift(), workers=1, kept=kept).to_json() == whole().to_json()
    lines = kept.read_bytes().splitlines(keepends=True)
    assert len(lines) == 1 + len(whole().runs)
    kept.write_bytes(b"".join(lines[:-2]) + lines[-2][:50])
    run, made = Simulation.run, list[Simulation]()

    def counted(simulation: Simulation, **given: Any) -> Any:
        made.append(simulation)
        return run(simulation, **given)

    monkeypatch.setattr(Simulation, "run", counted)
    found = simulate_cases(lift(), workers=1, kept=kept)
    assert (len(made), found.taken_over) == (2, len(lines) - 3)
    assert found.to_json() == whole().to_json()
    assert list(found.runs) == list(whole().runs)
    assert kept.read_bytes() == b"".join(lines)


def test_those_that_cannot_start_are_asked_again(tmp_path: Path) -> None:
    """They are no runs; to the same numbers all the same."""
    tight = lift(
        "cases:\n  lengths: {vary: slings.tolerance, pattern: each}\n", ("length: 13 m", "length: 12.21 m")
    )
    kept = tmp_path / "runs.jsonl"
    first = simulate_cases(tight, kept=kept)
    assert (
        len(kept.read_bytes().splitlines()) == 1 + sum(run.starts for run in first.runs) < 1 + len(first.runs)
    )
    assert simulate_cases(tight, kept=kept).to_json() == first.to_json()


@pytest.mark.parametrize(
    ("cases", "given", "of"),
    [
        ("cases:\n  heavy: {set: {load.weight.simulate: calculated}}\n", {}, "state of the lift file"),
        (HEAVY_CASE, {"duration": 4.0}, "files that the lift names, or other settings"),
    ],
)
def test_runs_of_another_lift_are_refused(tmp_path: Path, cases: str, given: dict[str, Any], of: str) -> None:
    kept = tmp_path / "runs.jsonl"
    simulate_cases(lift(HEAVY_CASE), duration=3.0, kept=kept)
    before = kept.read_bytes()
    with pytest.raises(KeptRunsError, match=f"its runs are of (an)?other {of}; all have to be run anew"):
        simulate_cases(lift(cases), kept=kept, **{"duration": 3.0, **given})
    assert kept.read_bytes() == before


def test_a_search_in_seas_is_no_run_of_a_case(tmp_path: Path) -> None:
    kept = tmp_path / "runs.jsonl"
    simulate_cases(lift(HEAVY_CASE), duration=3.0, kept=kept)
    first, *_ = kept.read_bytes().splitlines(keepends=True)
    record = {"height": 1.0, "period": 7.0, "direction": 0.0, "record": 1}
    kept.write_bytes(first + json.dumps(record).encode() + b"\n")
    with pytest.raises(KeptRunsError, match=rf"{kept}:2: is no run of a case: 'case' is no text"):
        simulate_cases(lift(HEAVY_CASE), duration=3.0, kept=kept)


def test_a_file_that_a_case_names_has_changed(tmp_path: Path) -> None:
    """The lift file is the same, and so is the lift as it is given; the run of the case is made anew."""
    text = changed(BASE, ADAPTIVE, STOPS, SLACK)
    text += "cases:\n  drawn: {set: {load.shape: {cad: drawn.obj, units: m}}}\n"

    def drawn(height: float) -> CaseRuns:
        model = box((8.0, 6.0, height), (0.0, 0.0, height / 2))
        (tmp_path / "drawn.obj").write_text(obj(model), encoding="utf-8")
        scenario = parse_scenario(text, str(tmp_path / "lift.yaml"))
        return simulate_cases(scenario, kept=tmp_path / "runs.jsonl", duration=3.0)

    assert [drawn(height).taken_over for height in (3.0, 3.0, 4.0, 4.0)] == [0, 2, 1, 2]
