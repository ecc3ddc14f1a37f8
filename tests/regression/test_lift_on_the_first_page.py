"""README's lift file was GO WITH WARNINGS for another reason than those told there, that it sets no limits.

Its hook stands 0.1 m off the middle of the lugs, above the centre of gravity, and its four slings were of one
length: the module hung tilted by 0.7° (`load_tilt`) and swung its falls 18° out of plumb as it came free.
"""

import math
from pathlib import Path

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from shown import ROOT, lift_on

H = 8.059  # from the lugs up to the hook as slings A and C are taut, √(8.6² − 2.6² − 1.5²) [m]


def test_it_warns_of_what_it_does_not_say_and_of_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(lift_on(ROOT / "README.md", "Four slings lift a module of 40 t"), encoding="utf-8")
    recording = gantline.simulate(path)
    warnings = [one.name for one in check_recording(recording) if one.verdict is Verdict.WARNING]
    assert warnings == [
        "hoist_load_of_rated_capacity",
        "rope_factor_on_breaking_force",
        "lug_load_of_capacity",
    ]

    # Level to what slings of lengths in whole millimetres leave, once the load is clear.
    assert math.hypot(2.6, 1.5, H) == pytest.approx(8.6, abs=5e-4)
    assert math.hypot(2.4, 1.5, H) == pytest.approx(8.542, abs=5e-4)
    assert recording.metrics()["peak_load_tilt"] < math.radians(0.1)
