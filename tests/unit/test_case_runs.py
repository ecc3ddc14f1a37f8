"""Cases that are simulated: the runs that they are, what is left out, and what of them is worst."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import pytest

from gantline.checks import Outcome
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.study import CaseRun, CaseRuns, run_cases, simulate_cases
from gantline.study.side_by_side import SideBySide
from lift_text import BASE, CASES, changed

ADAPTIVE = ("{integrator: del, step: 1 ms, sample_interval: 20 ms}", "{sample_interval: 20 ms}")
STOPS = ("down: 1 m}", "down: 1 m, stops: true}")
#: From a sheave 15 m up to its lug, 3 m up and 2.2 m aside, it is 12.2 m; the hook goes up by 0.5 m.
SLACK = ("length: 13 m", "length: 12.45 m")
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
    assert not found.is_go


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
