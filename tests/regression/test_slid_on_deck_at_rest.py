"""A reactor set down on the deck of its ship: `statics --steps` FAILED and did not say why.

Contacts are without friction unless they are asked for with it, the deck leans by half a degree, and the
reactor slid until its slings pulled at it, which took their hooks out of plumb. `--held` all was in order.
"""

from __future__ import annotations

import shutil
from pathlib import Path

from program import called

_SCENARIO = Path(__file__).parents[2] / "scenarios" / "heavy_lift_ship"
_TOLD = "reactor stands where a check fails, free to slide; --held has friction hold what it can"


def test_it_is_told_what_holds_it(tmp_path: Path) -> None:
    lift = tmp_path / "lift"
    shutil.copytree(_SCENARIO, lift)
    steps = called("statics", lift, "--steps").stdout
    assert "falls_out_of_plumb failed: " in steps
    assert f"  {_TOLD}\n" in steps
