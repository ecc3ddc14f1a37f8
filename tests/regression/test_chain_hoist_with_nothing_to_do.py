"""`gantline statics --level` had a step of 0.0000 m for a chain hoist that has nothing to do.

Of a load that hangs level it said `veer: sling.B, by: 0.0000 m`, as a step of the plan, where a length has to
be above zero.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from levelled import TWO
from program import called

PLAN = "  - {step: look, hold: until_end}"


def test_it_is_not_named(tmp_path: Path) -> None:
    """A load whose centre of gravity is in the middle of two slings alike is level; 1 m off it is not."""
    path = tmp_path / "lift.yaml"
    path.write_text(replace(TWO, centre=(0.0, 0.0, 2.0)).text(PLAN, duration=5.0), encoding="utf-8")
    level = called("statics", path, "--level", "--adjust", "B")
    assert level.returncode == 0, level.stderr
    assert "0.0000 m" not in level.stdout
    assert "chain hoists" not in level.stdout
    path.write_text(TWO.text(PLAN, duration=5.0), encoding="utf-8")
    askew = called("statics", path, "--level", "--adjust", "B")
    assert "veer: sling.B, by: 0.0" in askew.stdout or "haul: sling.B, by: 0.0" in askew.stdout
