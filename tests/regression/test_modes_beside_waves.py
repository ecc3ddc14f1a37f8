"""Modes of a vessel with another heading than 0 that were others where its lift had `waves`.

Modes are those of still water. But since water that remembers and matrices of damping had the level axes of
wave forces, statics asked for a slow heading too, of which it knew nothing: it took 0. Of a barge that heads
for 40 deg a mode with a damping of 4.5 % had 44 % with waves, and where its water remembers the fastest had
ω² = 1.53 in place of 1.14. One that heads for 0 and lies with a heel and a trim had modes that differed by
up to 0.7 % in their damping and 0.02 % in ω²: level axes are not those of its hull. In statics nothing has
moved yet, and water has the axes of the hull.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from afloat import MASS
from gantline.statics import Statics

SWELL = {"swell": {"height": "1 m", "period": "9 s", "direction": "30 deg"}}


@pytest.mark.parametrize("lift", [waves.in_waves, waves.radiating])
@pytest.mark.parametrize("heading", ["0 deg", "40 deg"])
def test_modes_are_those_of_still_water(tmp_path: Path, lift: Any, heading: str) -> None:
    """Squares of frequencies and damping with waves and without, to rounding; it lies with heel and trim."""
    masses = {"hull": {"mass": f"{MASS} kg", "at": ["48 m", "0.5 m", "5 m"]}}
    found = []
    for name, sea in (("still", {}), ("waves", SWELL)):
        (tmp_path / name).mkdir()
        path = lift(tmp_path / name, sea, {"heading": heading, "masses": masses})
        found.append([(mode.square, mode.damping_ratio or 0.0) for mode in Statics(path).modes()])
    assert len(found[0]) == 6 and max(ratio for _, ratio in found[0]) > 0.05
    assert found[1] == pytest.approx(np.array(found[0]), rel=1e-12, abs=1e-12)
