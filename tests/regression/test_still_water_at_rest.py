"""Statics of a lift in waves is that of still water but for their mean drift forces, freeboard too.

`gantline statics` took the freeboard of its equilibrium against the wave that passes at that time of the
plan: 3.30 m at 133 s for the barge of `crane_barge_in_swell`, where 3.51 m are right; checks of `cases` with
it. And no verb said that its answer leaves out the waves of the file.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.statics import Statics

FOLDER = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell"
DEPTH, BREADTH = 6.5, 30.0
LEFT_OUT = "Still water: without the waves swell, but with their mean drift forces if there are any"


def test_freeboard_at_rest_is_above_still_water() -> None:
    """Depth of the hull − draft at the deeper end − what heel takes, at any time of the plan."""
    question = Statics(FOLDER)
    for time in (100.0, 133.0):
        rest = question.equilibrium(time).recording
        drafts = [rest.column(f"vessel_draft_{end}", "barge")[-1] for end in ("aft", "forward")]
        heel = abs(rest.column("vessel_heel", "barge")[-1])
        expected = DEPTH - max(drafts) - BREADTH / 2 * heel
        assert rest.column("vessel_freeboard", "barge")[-1] == pytest.approx(expected, abs=1e-6)
        assert "vessel_wave_elevation" not in rest


@pytest.mark.parametrize("verb", [["statics"], ["cases"], ["statics", "--level"]])
def test_answers_say_that_the_water_is_still(verb: list[str], tmp_path: Path) -> None:
    """Waves of the file are named as left out."""
    folder = tmp_path / "lift"
    shutil.copytree(FOLDER, folder)
    lift = folder / "scenario.yaml"
    # One of its cases says it as well as all of them.
    lift.write_text(
        re.sub(r"^  (cog_corners|sling_lengths): .*\n", "", lift.read_text("utf-8"), flags=re.M), "utf-8"
    )
    found = CliRunner().invoke(app, [verb[0], str(folder), *verb[1:]])
    assert LEFT_OUT in " ".join(found.output.split())
    if "--level" not in verb:
        document = json.loads(CliRunner().invoke(app, [verb[0], str(folder), "--json"]).stdout)
        assert document["left_out"] == [LEFT_OUT]


def test_waves_of_a_run_stand_with_its_title() -> None:
    looked_over = CliRunner().invoke(app, ["check", str(FOLDER)])
    assert "Waves: swell: 0.80 m significant height, 7.0 s peak period" in looked_over.output
