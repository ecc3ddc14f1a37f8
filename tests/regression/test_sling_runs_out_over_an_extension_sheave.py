"""A sling that ran out over an extension sheave ended a run with advice about hooks and equalizers.

A load of 60 t hangs on four lugs by three extension sheaves, without an equalizer. One of the lowest slings
is cut: its sheave goes up, and the sling above runs over the first sheave to its other end. The run ended
"at X1: it has come to the next place that sling.S1 passes, … hoist a hook less far, or give an equalizer
'stops: true'", or "at X3" where the sling of the other side was cut. It names the sheave and the sling now,
and what to look at.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from extension_lifts import DEEP
from gantline.cli.app import app

CUT_AT = 20.0  # s
#: Hung at rest, 40 m over the ground.
HUNG = (
    DEEP.replace("ground: {level: 0 m,", "ground: {level: -40 m,")
    .replace("  stands_on: ground\n", "")
    .replace("speed: 3 m/min, by: 1.5 m", "speed: 3 m/min, by: 0.5 m")
)
#: From the first sheave to either of those on the sling over it, half of that sling [m].
LEG = 10.0


def cut(sling: str) -> str:
    return HUNG.replace(f"  {sling}: {{over", f"  {sling}: {{cut_at: {CUT_AT} s, over")


@pytest.mark.parametrize("sling", ["S2", "S3"])
def test_the_run_names_the_sheave_and_the_sling(sling: str, tmp_path: Path) -> None:
    """The load falls no faster than freely: its leg grows by 10 m after √(2·10 m/g) = 1.43 s or later."""
    lift = tmp_path / "lift.yaml"
    lift.write_text(cut(sling), encoding="utf-8")
    told = CliRunner().invoke(app, ["run", str(lift), "-o", str(tmp_path / "out"), "--no-plots"])
    assert told.exit_code == 3
    said = " ".join(told.stderr.split())
    assert "at X1: the sling over it has run out to one of its ends, and nothing stops it there" in said
    assert "what hung on the other end of S1 does not hold any more" in said
    assert "stops: true" not in said and "hoist a hook" not in said
    time = float(said.split("could not go on at t = ")[1].split()[0])
    assert CUT_AT + (2 * LEG / 9.81) ** 0.5 < time < CUT_AT + 2.0
    assert "look which rope below it parted or went slack before" in " ".join(told.stdout.split())


def test_the_same_in_python() -> None:
    with pytest.raises(gantline.SimulationError, match=r"at X1: the sling over it has run out"):
        gantline.simulate(gantline.scenario.parse_scenario(cut("S2")))
