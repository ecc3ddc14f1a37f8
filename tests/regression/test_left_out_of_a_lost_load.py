"""`gantline statics --lost --json` and `lost_load.json` kept from programs what the text told people.

Above its tables stands what an equilibrium leaves out of the lift, waves, gusts and holes; all other JSON of
statics has that as `left_out`.
"""

from __future__ import annotations

import json
from pathlib import Path

from typer.testing import CliRunner

from gantline.cli.app import app


def test_what_the_text_leaves_out_the_numbers_do(tmp_path: Path) -> None:
    question = ["statics", "crane_barge_in_swell", "--lost", "module"]
    text = CliRunner().invoke(app, [*question, "-o", str(tmp_path)]).stdout
    printed = json.loads(CliRunner().invoke(app, [*question, "--json"]).stdout)
    written = json.loads((tmp_path / "lost_load.json").read_text(encoding="utf-8"))
    (sentence,) = printed["left_out"]
    assert sentence.startswith("Still water: without the waves swell")
    assert sentence in text.splitlines()
    assert written["left_out"] == printed["left_out"]
