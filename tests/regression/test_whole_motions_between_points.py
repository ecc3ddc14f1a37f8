"""Where all of a motion is by waves that a file has none close to, it was "1e+02 % of what moves it"."""

from __future__ import annotations

from pathlib import Path

import waves
from gantline.assembly import assemble
from gantline.scenario import load_scenario


def test_all_of_a_motion_is_100_percent(tmp_path: Path) -> None:
    """Waves of 4 s between two of its directions 30° apart: κ L/2 is 12.6, κ L/2 Δβ 6.6."""
    swell = {"height": "10 cm", "period": "4 s", "direction": "45 deg"}
    said = "\n".join(assemble(load_scenario(waves.in_waves(tmp_path, {"swell": swell}))).warnings)
    assert "far apart for waves of 4 s and shorter, which are " in said
    assert " % of what moves it in " in said and "e+0" not in said
