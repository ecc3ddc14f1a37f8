"""A hook that was hoisted into the sheaves above it ended a run with a riddle and without a table.

The jacket of a sheerlegs came to 74 deg as its hook met the boom head. The run ended with "it has come to the
next place that hoist.fc.P.1 passes", which nobody reads as two-blocking, and printed nothing of the 2281 s
before: neither the hook loads nor that the chart had been passed.
"""

from __future__ import annotations

import json
from pathlib import Path

from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.scenario import parse_scenario
from gantline.scenario.failed import failed_at
from weak_hoist import hanging

#: Upper sheaves at 20 m, hook at 13 m, a hook block 1 m high: the falls are 6 m long at the start.
PLAN = "{step: up, hoist: crane, speed: 6 m/min, by: 7 m}"
SAID = (
    "at crane: its hook block has come up to the sheaves above it (two-blocking), and nothing stops it there"
)


def run(folder: Path, *words: str) -> tuple[int, str, str]:
    lift = folder / "lift.yaml"
    lift.write_text(hanging(PLAN, 10.0, "capacity: 200 kN", 90.0), encoding="utf-8")
    told = CliRunner().invoke(app, ["run", str(lift), "-o", str(folder / "out"), "--no-plots", *words])
    return told.exit_code, told.stdout, " ".join(told.stderr.split())


def test_the_run_says_two_blocking_and_what_is_known_up_to_then(tmp_path: Path) -> None:
    """6 m at 0.1 m/s, and 1 s to half of which comes up to speed: about 61 s, less what the ropes give."""
    code, table, said = run(tmp_path)
    assert code == 3
    assert f"{SAID}: hoist it less far; 'highest' of a hook is checked" in said
    assert "it has come to the next place" not in said
    assert 58.0 < float(said.split("could not go on at t = ")[1].split()[0]) < 64.0
    assert "what would have come after is not checked" in said
    assert "hook load" in table and "hook_falls_margin" in table and "NO-GO" in table


def test_its_checks_come_as_json_too(tmp_path: Path) -> None:
    code, document, _ = run(tmp_path, "--json")
    assert code == 3
    checks = json.loads(document)
    assert checks["status"] == "failed" and checks["outcome"] == "NO-GO"


def test_other_things_that_fail_keep_their_words() -> None:
    scenario = parse_scenario(hanging(PLAN, 10.0, "capacity: 200 kN", 90.0))
    met = "it has come to the next place that fall passes, and nothing stops it there"
    assert failed_at(scenario, "sheave", met) == ("sheave", met)
    assert failed_at(scenario, "crane", "the equations are singular here") == (
        "crane",
        "the equations are singular here",
    )
