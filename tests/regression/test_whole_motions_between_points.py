"""Where all of a motion is by waves that a file has none close to, it was "1e+02 % of what moves it"."""

from __future__ import annotations

from pathlib import Path

import waves
from gantline.assembly import assemble
from gantline.scenario import load_scenario


def test_all_of_a_motion_is_100_percent(tmp_path: Path) -> None:
    """Waves of 4 s abeam but for 1°, between two directions of the file 30° apart."""
    swell = {"height": "10 cm", "period": "4 s", "direction": "89 deg"}
    said = "\n".join(assemble(load_scenario(waves.in_waves(tmp_path, {"swell": swell}))).warnings)
    assert "far apart for waves of 4 s and shorter, which are 100 % of what moves it in roll" in said
