"""`rate: 500 t/s`, for 500 t/h, emptied a tank within its ten seconds of starting and stopping: in order."""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import barge, lift_of, written
from gantline.assembly import assemble
from gantline.scenario import load_scenario


@pytest.mark.parametrize(("rate", "is_told"), [("500 t/s", True), ("20000 t/h", False)])
def test_pumps_of_no_vessel_are_told(tmp_path: Path, rate: str, is_told: bool) -> None:
    tank = {"box": ["20 m", "10 m", "5 m"], "bottom": ["50 m", "0 m", "0 m"], "content": "0 t"}
    step = {"step": "fill", "pump": {"from": "sea", "to": "barge.deep"}, "rate": rate, "by": "100 t"}
    given = lift_of(barge(tanks={"deep": tank}), duration="100 s", plan=[step])
    said = "step 'fill' pumps 1,800,000 t in an hour, more than any ballast system: see its unit"
    assert list(assemble(load_scenario(written(tmp_path, given))).warnings) == ([said] if is_told else [])
