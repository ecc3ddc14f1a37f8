"""`gantline check` of recordings and simulated lifts, and the checks as JSON."""

from __future__ import annotations

import json
import math
import os
import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

import gantline
from gantline.checks import LIMITS, check_recording
from gantline.cli.app import app
from gantline.cli.check_table import check_table
from gantline.results.recording import Recording
from lift_text import BASE, changed
from sample_lift import ringing_lift, sample_rig

LIFT = Path(__file__).parents[2] / "scenarios" / "equalizer"


def says(*words: str | Path, width: int = 100) -> Result:
    columns = {"COLUMNS": str(width), "TERM": "dumb"}
    return CliRunner().invoke(app, [str(word) for word in words], env={**os.environ, **columns})


def saved(folder: Path, **limits: Any) -> Path:
    return ringing_lift(rig=sample_rig(**limits)).save(folder / "lift.nc")


def test_a_recording_is_checked_with_formula_and_source(tmp_path: Path) -> None:
    result = says("check", saved(tmp_path, rule="own", load_tilt=math.radians(2.0)))
    assert (result.exit_code, result.stderr) == (0, "")
    lines = [" ".join(line.split()) for line in result.stdout.splitlines()]
    at = next(
        number
        for number, line in enumerate(lines)
        if line.startswith("warning load_tilt 0.00 deg <= 2.00 deg")
    )
    assert lines[at + 1 : at + 3] == ["largest angle of the load's own z axis from plumb", "[own]"]
    at = next(
        number for number, line in enumerate(lines) if line.startswith("ok lug_load_of_capacity 90.1 %")
    )
    assert "= peak 706.8 kN / 784.8 kN" in lines[at : at + 4]
    assert "GO WITH WARNINGS; nearest to their limits: hoist_load_of_rated_capacity" in " ".join(
        result.stdout.split()
    )
    assert sorted(path.name for path in tmp_path.iterdir()) == ["lift.nc"]


def test_a_failed_check_of_a_recording_ends_with_one(tmp_path: Path) -> None:
    result = says("check", saved(tmp_path, sling_factor_on_breaking_force=5.0))
    assert result.exit_code == 1
    assert "\nFAILED       sling_factor_on_breaking_force" in result.stdout
    assert "NO-GO: 1 failed, sling_factor_on_breaking_force" in result.stdout


def test_checks_as_json(tmp_path: Path) -> None:
    result = says("check", saved(tmp_path, rule="own", load_tilt=math.radians(2.0)), "--json")
    assert result.exit_code == 0
    document = json.loads(result.stdout)
    assert (document["rule"], document["failed"], document["status"]) == ("own", False, "done")
    assert document["verdict"].startswith("GO WITH WARNINGS; ")
    by_name = {check["name"]: check for check in document["checks"]}
    lug = by_name["lug_load_of_capacity"]
    assert (lug["element"], lug["verdict"], lug["limit"], lug["source"]) == (
        "block.L2",
        "ok",
        1.0,
        "by definition",
    )
    assert lug["utilisation"] == pytest.approx(lug["value"])
    assert by_name["skew_load_factor"]["verdict"] == "not checked"
    assert set(by_name) <= set(LIMITS)


def test_a_folder_that_run_wrote_is_checked_as_the_run_was(tmp_path: Path) -> None:
    run = says("run", LIFT, "-o", tmp_path, "--no-plots", "--json")
    assert run.exit_code == 0
    assert "recording.nc" in run.stderr
    document = json.loads(run.stdout)
    assert json.loads(says("check", tmp_path, "--json").stdout) == document
    names = [check["name"] for check in document["checks"]]
    assert names == [
        check.name for check in check_recording(gantline.open_recording(tmp_path / "recording.nc"))
    ]


def test_a_lift_can_be_simulated_for_its_checks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = says("check", LIFT, "--simulate")
    assert result.exit_code == 0
    assert "simulated 40.0 of 40.0 s" in result.stderr
    assert "equalizer_load_of_rated_capacity" in result.stdout
    assert "= static 2943.0 kN / 3237.3 kN (peak" in result.stdout  # 300 t of 330 t
    assert list(tmp_path.iterdir()) == []


def test_a_lift_file_alone_is_looked_over() -> None:
    result = says("check", LIFT)
    assert result.exit_code == 0
    assert "in order" in result.stdout
    assert "load_tilt" not in result.stdout


def test_slings_that_are_put_on_later_are_listed_with_their_mass(tmp_path: Path) -> None:
    """Half of the 130 kg of S2 and its shackles would hang at its lug; all of it hangs at its sheave."""
    path = tmp_path / "lift.yaml"
    kind = ("2 ms, mass: none}", "2 ms, mass: 10 kg/m}")
    weighs = ("tolerance: 0.25 %}", "tolerance: 0.25 %, rope_weight: lumped}")
    on = ("hold: until_end}", "hold: until_end, attach: sling.S2}")
    path.write_text(changed(BASE, kind, weighs, on), encoding="utf-8")
    result = says("check", path)
    assert result.exit_code == 0, result.stderr
    assert re.search(r"^Sling put on later +by step +all its mass hangs at +mass$", result.stdout, re.M)
    assert re.search(r"^  S2 +'hold' +e1\.2 +130\.0 kg$", result.stdout, re.M)
    path.write_text(BASE, encoding="utf-8")
    assert "put on later" not in says("check", path).stdout


def test_kinds_of_rope_have_their_stiffness_in_a_unit_of_its_size(tmp_path: Path) -> None:
    """A tag line of 150 kN beside slings of 100 MN: it read `0.1 MN`."""
    path = tmp_path / "lift.yaml"
    path.write_text(BASE.replace("ropes:\n", "ropes:\n  tag: {axial_stiffness: 150 kN}\n"), encoding="utf-8")
    table = says("check", path).stdout
    assert re.search(r"^  tag +- +150 kN ", table, re.M)
    assert re.search(r"^  sling +- +100 MN ", table, re.M)


def test_a_run_that_was_stopped_is_checked_as_far_as_it_went(tmp_path: Path) -> None:
    whole = ringing_lift()
    part = Recording(whole.variables, whole.coordinates, {**whole.attributes, "status": "stopped"})
    result = says("check", part.save(tmp_path / "part.nc"))
    assert "this run was stopped at 40.00 s" in result.stderr
    assert "what would have come after is not checked" in result.stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["check", "{nc}", "--simulate"], "its lift has been simulated already"),
        (
            ["check", str(LIFT), "--json"],
            "--json prints the checks of a recording, or of a lift with --simulate",
        ),
        (["check", "{missing}"], "missing.nc"),
        (["check", "{text}"], "text.nc"),
    ],
)
def test_bad_input_ends_with_two(words: list[str], message: str, tmp_path: Path) -> None:
    text = tmp_path / "text.nc"
    text.write_text("no recording", encoding="utf-8")
    places = {"nc": saved(tmp_path), "missing": tmp_path / "missing.nc", "text": text}
    result = says(*(word.format(**places) for word in words))
    assert (result.exit_code, result.stdout) == (2, "")
    assert message in result.stderr
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize("width", [80, 100, 120])
@pytest.mark.parametrize("full", [False, True])
def test_the_table_keeps_to_its_width(width: int, full: bool) -> None:
    rig = sample_rig(rule="example", load_tilt=0.01, wind_speed=3.0)
    rig["ropes"][2]["minimum_breaking_force"] = None
    checks = check_recording(ringing_lift(rig=rig))
    lines = check_table(checks, "example", style=lambda one: f"{one.value:<11}", width=width, full=full)
    assert max(map(len, lines)) <= width
    assert {check.name for check in checks} <= {word for line in lines for word in line.split()}
    starts = [line.find(" kN") for line in lines if line.startswith("not checked  ") and " kN" in line]
    assert len(starts) > 1 and len(set(starts)) == 1  # numbers stand below each other


def test_a_long_rule_has_a_line_of_its_own() -> None:
    checks = check_recording(ringing_lift(rig=sample_rig(load_tilt=0.01)))
    rule = "Yard rule 17, heavy lifts over docks, edition of the third of May"
    lines = check_table(checks, rule, width=100, full=False)
    assert lines[0].strip() == f"Check ({rule})"
    assert lines[1].split() == ["value", "limit", "used"]
