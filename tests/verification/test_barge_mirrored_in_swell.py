"""A crane barge in swell and its mirror image at its centre plane: forces are the same, heel and sway turned.

Ropes of the hook weigh nothing and lose nothing, for reeving has a hand of its own: with sheaves that lose
2 % its parts pull unlike, and the lead line is on one side. Then the tilt of the load differs by 5e-3 of its
largest, and by 1e-8 where the reeving is mirrored too.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

FOLDER = Path(__file__).resolve().parents[2] / "scenarios" / "crane_barge_in_swell"
ASIDE = 0.3


def mirrored(side: int) -> Recording:
    """The barge with its load aside, hoisted in swell onto one bow or the other."""
    text = (FOLDER / "scenario.yaml").read_text(encoding="utf-8")

    def placed(found: re.Match[str]) -> str:
        return f"{found[1]}{side * float(found[2])} m,{found[3]}"

    # Fairleads, anchors and lugs.
    text, places = re.subn(r"((?:fairlead: |to: |\{at: )\[[^],]*, *)([-\d.]+) m,([^]]*\])", placed, text)
    assert places == 14, "two of each line, four lugs, heel pins, centre of gravity"
    changes = {
        "crane_barge.nc": str(FOLDER / "crane_barge.nc"),
        "direction: 150 deg": f"direction: {side * 150} deg",
        "[107.2 m, 0 m, 10.9 m]": f"[107.2 m, {side * ASIDE} m, 10.9 m]",
        "sheave_efficiency: 0.98": "rope_weight: none",
        "duration: 300 s": "duration: 30 s",
        "hold: 150 s": "hold: 5 s",
        "by: 5 m": "by: 1 m",
    }
    for old, new in changes.items():
        assert old in text, old
        text = text.replace(old, new)
    return simulate(parse_scenario(text))


def test_a_barge_and_its_mirror_image() -> None:
    """To 1e-7 of the largest that each quantity gets to, a thousandth of what a step is allowed."""
    one, other = mirrored(1), mirrored(-1)
    for name in ("hook_load", "rope_tension", "vessel_heel", "vessel_trim", "vessel_draft", "load_tilt"):
        given, found = one[name].values, other[name].values
        found = -found if name == "vessel_heel" else found
        assert np.abs(found - given).max() < 1e-7 * np.abs(given).max(), name
    assert np.abs(one["vessel_heel"].values).max() > 1e-3
    way = one["body_position"].values - one["body_position"].values[0]
    image = other["body_position"].values - other["body_position"].values[0]
    assert np.abs(image * [1, -1, 1] - way).max() < 1e-7 * np.abs(way).max()
