"""A run that a program pauses, and whose recording said that it had come to its end.

`equalizer` lasts 40 s; paused at 26.5 s, half a second into its last hold, its recording was `done`, "ran
to its end, 26.5 s", and GO WITH WARNINGS, as if nothing were left, though the load had hung for 0.5 s of 14
s. The same recording of a run that Ctrl-C ended there was `stopped`, and no verdict. Paused within its
first step, its one sample was taken for an equilibrium; and a callback that raised in the middle left a run
that was `ready` to begin.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.checks import Outcome, check_recording, outcome_of
from gantline.results.stability import stability_of


def told(recording: gantline.Recording) -> tuple[str, str]:
    found = [one.remark for one in check_recording(recording) if one.name == "plan_finished"]
    return str(recording.attributes["status"]), found[0] if found else ""


def test_what_is_left_is_told(tmp_path: Path) -> None:
    """The hold goes on until 40 s; a check of the file knows as much as one of the run."""
    run = gantline.Simulation("equalizer")
    run.advance_to(26.5)
    paused = gantline.open_recording(run.recording().save(tmp_path / "paused.nc"))
    assert told(paused) == ("paused", "the run was paused at 26.5 s")
    assert outcome_of(check_recording(paused)) is Outcome.NO_VERDICT
    stable = stability_of(paused)
    assert next(iter(stable.sentences())) == "PAUSED at 26.50 s: what follows compares what there is"
    assert not stable.is_sound


def test_what_a_callback_saves_is_no_end(tmp_path: Path) -> None:
    """A recording that is made while the run goes on says so, in checks and in how sound it is."""
    run = gantline.Simulation("equalizer")
    run.run(until=26.5)
    found = []

    def looks(time: float) -> bool:
        found.append(run.recording())
        return False

    run.run(until=38.0, on_progress=looks)
    status, remark = told(found[0])
    assert (status, remark) == ("running", f"the run was under way at {found[0].time[-1]:.4g} s")
    assert outcome_of(check_recording(found[0])) is Outcome.NO_VERDICT


def test_one_that_goes_on_to_the_end_is_done() -> None:
    run = gantline.Simulation("pulleys", duration=0.2)
    run.run(until=0.1)
    assert run.status == "paused"
    state = run.save()
    assert told(run.run()) == ("done", "")
    run.restore(state)
    assert run.recording().attributes["status"] == "paused"
    run.advance_to(0.2)
    assert run.recording().attributes["status"] == "done"


def test_its_first_sample_is_no_equilibrium() -> None:
    run = gantline.Simulation("pulleys", duration=0.2)
    run.advance_to(0.001)
    first = run.recording()
    assert len(first.time) == 1
    assert not first.is_equilibrium


def test_a_callback_that_raises_leaves_a_run_that_goes_on() -> None:
    run = gantline.Simulation("goliath", duration=30.0)
    seen = []

    def breaks(time: float) -> bool:
        seen.append(run.status)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        run.run(on_progress=breaks)
    assert seen == ["running"]
    assert run.status == "paused"
    assert run.recording().attributes["status"] == "paused"
