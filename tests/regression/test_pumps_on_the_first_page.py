"""The first page said `pump`, and nothing of from where to where, how fast and how much.

Of `monopile` the report read "31 against heel 3027.3 s pump", while every other line told speed and way: who
stands at the valves needs the tanks, 6300 t/h and 950 t.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from afloat import barge, lift_of, written
from gantline.assembly import assemble
from gantline.report.steps import step_rows
from gantline.report.subject import Subject
from gantline.scenario import load_scenario
from sample_lift import ringing_lift, sample_rig


@pytest.mark.parametrize(
    ("source", "ends", "said"),
    [
        ("sea", {"by": "12.5 t"}, "pump sea to barge.deep 1800 t/h by 12.5 t"),
        ("deep", {"until": {"heel": {"vessel": "barge", "below": "0.1 deg"}}}, "pump deep to sea 1800 t/h"),
    ],
)
def test_the_first_page_says_what_is_pumped(
    tmp_path: Path, source: str, ends: dict[str, Any], said: str
) -> None:
    tank = {"box": ["20 m", "10 m", "5 m"], "bottom": ["50 m", "0 m", "0 m"], "content": "100 t"}
    target = "barge.deep" if source == "sea" else "sea"
    # 500 kg/s are 3600 * 0.5 t = 1800 t in an hour.
    way = {"from": source, "to": target}
    step: dict[str, Any] = {"step": "tank", "pump": way, "rate": "500 kg/s", **ends}
    given = lift_of(barge(tanks={"deep": tank}), duration="100 s", plan=[step])
    rig = sample_rig()
    rig["plan"] = assemble(load_scenario(written(tmp_path, given))).rig["plan"]
    assert step_rows(Subject(ringing_lift(rig=rig)))[0]["does"] == said
