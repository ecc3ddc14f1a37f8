"""A script took NO VERDICT for a go: it ended with 0, as GO does.

`gantline check` of a run that had failed, or was stopped, `gantline run` of a lift whose `duration` is over
before its plan is, and `gantline statics` of a load that stands printed NO VERDICT and ended with 0, "done,
and every check held". So did `gantline statics` where a check fails in a bound that losses of sheaves may
hold, as it says below its table. Each ends with the code of the verdict now: 4 without one, 1 where a check
fails. What has nothing to check, a mechanism without a load, is done when it has been simulated.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.checks import Outcome, check_recording, outcome_of
from gantline.cli.app import app
from gantline.results.recording import Recording
from lift_text import BASE, changed
from sample_lift import ringing_lift

EQUALIZER = Path(__file__).parents[2] / "python" / "gantline" / "scenarios" / "equalizer.yaml"


def code_of(*words: str | Path) -> tuple[int, str]:
    """Exit code, and what is printed."""
    result = CliRunner().invoke(app, [str(word) for word in words])
    return result.exit_code, result.stdout


@pytest.mark.parametrize(("status", "code"), [("done", 0), ("failed", 4), ("stopped", 4)])
def test_a_run_that_broke_off(tmp_path: Path, status: str, code: int) -> None:
    """Nothing failed up to then, and what would have come after is not known."""
    whole = ringing_lift()
    part = Recording(whole.variables, whole.coordinates, {**whole.attributes, "status": status})
    file = part.save(tmp_path / "lift.nc")
    assert code_of("check", file)[0] == code
    ended, printed = code_of("check", file, "--json")
    assert ended == code
    outcome = json.loads(printed)["outcome"]
    assert outcome == outcome_of(check_recording(part)).value
    assert (outcome == "NO VERDICT") is (code == 4)


def test_a_rope_that_parted_is_no_go(tmp_path: Path) -> None:
    """What failed before a run broke off has failed."""
    whole = ringing_lift(events=[(30.0, "broken", "sling.S1")])
    part = Recording(whole.variables, whole.coordinates, {**whole.attributes, "status": "failed"})
    assert outcome_of(check_recording(part)) is Outcome.NO_GO
    assert code_of("check", part.save(tmp_path / "lift.nc"))[0] == 1


def test_a_run_shorter_than_its_plan(tmp_path: Path) -> None:
    """The load of `equalizer` is not off the ground after 10 s."""
    quiet = ("--no-plots", "--no-report", "-o", tmp_path)
    ended, printed = code_of("run", "equalizer", "--duration", "10 s", *quiet)
    assert (ended, "\nNO VERDICT: the run ends at 10 s" in printed) == (4, True)
    ended, printed = code_of("run", "equalizer", "--duration", "10 s", "--json", *quiet)
    assert (ended, json.loads(printed)["outcome"]) == (4, "NO VERDICT")
    assert code_of("check", tmp_path)[0] == 4


def test_a_mechanism_has_nothing_to_check(tmp_path: Path) -> None:
    """It is done; whoever asks for its checks gets no verdict."""
    quiet = ("--no-plots", "--no-report", "-o", tmp_path)
    assert code_of("run", "pulleys", "--duration", "0.1 s", *quiet)[0] == 0
    assert code_of("check", tmp_path)[0] == 4


def test_a_load_that_stands_at_rest() -> None:
    """On the ground at the start, in the air at the end."""
    ended, printed = code_of("statics", "equalizer", "--time", "0 s")
    assert (ended, "\nNO VERDICT: 'block' is not lifted" in printed) == (4, True)
    ended, printed = code_of("statics", "equalizer", "--json")
    assert (ended, json.loads(printed)["outcome"]) == (0, "GO WITH WARNINGS")


def test_a_check_that_fails_in_a_bound(tmp_path: Path) -> None:
    """Sheaves that lose 2 % each may hold a spread of 16 % either way, of 5 %."""
    lossy = changed(EQUALIZER.read_text("utf-8"), ("efficiency: 1.0", "efficiency: 0.98"))
    lift = tmp_path / "lift.yaml"
    lift.write_text(lossy, encoding="utf-8")
    ended, printed = code_of("statics", lift)
    assert "slipping along the rope: NO-GO" in printed
    assert "\nGO" in printed
    assert ended == 1


def test_cases_of_a_load_that_stands(tmp_path: Path) -> None:
    """At the start nothing hangs in any case; half a metre higher the load does, and all is as it was."""
    lift = tmp_path / "lift.yaml"
    text = BASE + "cases: {heavy: {set: {load.weight.simulate: design}}}\n"
    lift.write_text(changed(text, ("at: [0 m, 0 m, 20 m]", "at: [0 m, 0 m, 20.7 m]")), encoding="utf-8")
    ended, printed = code_of("cases", lift, "--time", "0 s")
    said = (
        "2 equilibria asked for: nothing hangs then, 'block' is not lifted, 0 % of its weight hangs at most"
    )
    assert (ended, said in " ".join(printed.split())) == (4, True)
    ended, printed = code_of("cases", lift)
    assert (ended, "2 equilibria asked for: all sound" in printed) == (0, True)
    sweep = ("--sweep", "load.weight.calculated=50 t..60 t/2")
    ended, printed = code_of("statics", lift, *sweep, "--time", "0 s")
    assert (ended, "\n  nothing hangs then, 'block' is not lifted" in printed) == (4, True)
    assert code_of("statics", lift, *sweep)[0] == 0
