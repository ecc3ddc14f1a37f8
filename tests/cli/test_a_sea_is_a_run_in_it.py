"""A record of a sea of `gantline seas` is a run of the lift file with that sea and that seed in it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from column_in_waves import SEA, column
from verbs import gantline


@pytest.mark.parametrize(("height", "period"), [("0.4 m", "6 s"), ("0.8 m", "7.5 s")])
def test_checks_are_those_of_the_run(height: str, period: str, tmp_path: Path) -> None:
    """Each record has the checks of the run by itself, every number and sentence, to the last digit."""
    lift = tmp_path / "lift.yaml"
    lift.write_text(column(SEA, duration="30 s"), encoding="utf-8")
    asked = ("--height", height, "--period", period, "--direction", "30 deg", "--duration", "15 s")
    result = gantline("seas", str(lift), *asked, "--records", "2", "--every", "--json")
    (sea,) = json.loads(result.stdout)["seas"]
    assert [record["record"] for record in sea["records"]] == [1, 2]
    for record in sea["records"]:
        words = (
            f"{{significant_height: {height}, peak_period: {period}, direction: 30 deg, components: 20, "
            f"seed: {record['record']}}}"
        )
        alone = tmp_path / f"alone_{record['record']}.yaml"
        alone.write_text(column(words, duration="15 s"), encoding="utf-8")
        checked = json.loads(gantline("check", "--simulate", str(alone), "--json").stdout)
        assert record["checks"] == checked["checks"]
        assert record["verdict"] == checked["verdict"]
    first, second = (record["checks"] for record in sea["records"])
    assert first != second
