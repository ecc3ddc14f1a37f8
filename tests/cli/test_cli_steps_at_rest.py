"""`gantline statics --steps`: what it prints and refuses, and that it is what `--time` says."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from crane_off_quay import taken_at_once
from gantline.cli.app import app
from gantline.statics import Statics
from gantline.statics.inclining import metacentric_heights
from gantline.study import run_steps
from lift_text import weight_on_a_rope

EQUALIZER = Path(__file__).parents[2] / "python/gantline/scenarios/equalizer.yaml"


def asked(*arguments: str | Path) -> tuple[int, str, str]:
    result = CliRunner().invoke(app, ["statics", *map(str, arguments)], env={"COLUMNS": "140"})
    return result.exit_code, result.stdout, result.stderr


def test_start_steps_and_end_stand_in_a_table() -> None:
    """The plan of `equalizer` is one hoist; its load of 300 t and the rigging hang in one hook then."""
    code, said, _ = asked("equalizer", "--steps")
    assert code == 0
    assert re.search(r"^  start +0\.0 s +0\.0 % .* ok$", said, re.MULTILINE)
    assert re.search(r"^  hoist +26\.0 s +100\.0 % .* ok$", said, re.MULTILINE)
    assert re.search(r"^  end of the lift +40\.0 s +100\.0 % .* ok$", said, re.MULTILINE)
    assert "equalizer_travel_used past a limit that only warns: hoist, end of the lift" in said


def test_a_vessel_is_as_at_each_of_these_times_alone() -> None:
    """Every fourth moment of a floating crane is asked for anew: same drafts and GM, to the last bit."""
    scenario = taken_at_once("970 s")
    found = list(run_steps(Statics(scenario)))
    assert [one.name for one in found[:3]] == ["start", "take up slack", "equalise"]
    assert found[-1].name == "end of the lift" and found[-1].state.time == 970.0
    again = found[1::4]
    assert len(again) == 3
    for one in again:
        question = Statics(scenario)
        alone = question.equilibrium(one.state.time)
        heights = metacentric_heights(question, alone)["barge"]
        assert one.heights["barge"].yielding.tolist() == heights.yielding.tolist()
        assert one.state.rest is not None
        for name in ("vessel_draft_aft", "vessel_trim", "hook_load", "rope_tension"):
            here = one.state.rest.recording[name].values[-1]
            assert here.tolist() == alone.recording[name].values[-1].tolist()
    # A load that hangs clear does not hold its crane to the quay, and the pontoon's own GM is left.
    clear, held = (next(one for one in found if one.name == name) for name in ("lift off", "hold point 4"))
    assert held.heights["barge"].longitudinal > 5.0 * clear.heights["barge"].longitudinal


def test_numbers_in_si_units() -> None:
    code, said, _ = asked("crane_barge_in_swell", "--steps", "--json")
    assert code == 0
    steps = json.loads(said)["steps"]
    assert [one["steps"] for one in steps] == [[], ["hold in the swell"], ["hoist in the swell"], []]
    assert [one["time"] for one in steps] == [0.0, 150.0, 205.0, 300.0]
    barge = steps[0]["vessels"]["barge"]
    assert barge["draft_aft"] == pytest.approx(2.989, abs=5e-4)
    assert barge["gm_transverse"] == pytest.approx(21.91, abs=5e-3)


def test_what_a_step_requires_is_checked_where_it_ends(tmp_path: Path) -> None:
    """Of five slings under 300 t, 588.4 kN each were they plumb, one has 593.2 kN at rest."""
    text = EQUALIZER.read_text(encoding="utf-8")
    step = "  - {step: hoist,"
    assert text.count(step) == 1
    lift = tmp_path / "lift.yaml"
    lift.write_text(text.replace(step, f"{step} require: {{sling_tension: below 590 kN}},"), encoding="utf-8")
    code, said, _ = asked(lift, "--steps")
    assert code == 1
    assert re.search(r"^  hoist +26\.0 s .* FAILED$", said, re.MULTILINE)
    assert re.search(r"^  end of the lift .* ok$", said, re.MULTILINE)
    assert "  sling_tension failed: hoist\n" in said
    code, said, _ = asked(lift, "--time", "26 s")
    assert code == 0
    assert "a run checks what steps require, and 'gantline statics --steps'" in " ".join(said.split())


def test_friction_that_holds_is_said() -> None:
    _, free, _ = asked("equalizer", "--steps")
    _, held, _ = asked("equalizer", "--steps", "--held")
    assert "  contacts without friction\n" in free
    assert "  friction of contacts and sheaves holds what it can, from where the lift was\n" in held


def test_a_lift_that_falls_shows_the_steps_before(tmp_path: Path) -> None:
    """The rope is cut at 0.5 s: at its start the weight hangs, at the end of the lift it falls."""
    lift = tmp_path / "lift.yaml"
    cut = "length: 5 m\n      cut_at: 0.5 s"
    lift.write_text(weight_on_a_rope("100 kg").replace("length: 5 m", cut), encoding="utf-8")
    code, said, _ = asked(lift, "--steps")
    assert code == 3
    assert re.search(r"^  start +0\.0 s .*ok$", said, re.MULTILINE)
    assert re.search(r"^  end of the lift +1\.0 s .*NONE$", said, re.MULTILINE)
    assert re.search(r"no equilibrium: nothing holds it.*: end of the lift", said)


def test_what_does_not_go_with_it_is_refused() -> None:
    code, _, said = asked("equalizer", "--steps", "--time", "3 s")
    assert code == 2
    assert "--steps: shows the ends of all steps; --time does not go with it, --held and --json do" in said
