"""A brake that is weaker than what hangs, let in by an emergency stop.

The end of the step before the stop was judged with the brake in already: it could not hold, and the step was
cut just before the stop, for ever.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from winch_lift import winch_lift


def test_it_slips_with_the_weight_less_the_brake(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(winch_lift("50 kN"), encoding="utf-8")
    recording = gantline.simulate(path)
    assert recording.attributes["status"] == "done"
    # (10 t + 2 t) a = 10 t x g - 50 kN; the rope's ringing, 100 rad/s, has gone by then. What comes off the
    # drum is strained by 58 kN/36 MN: the load goes that much faster than the drum.
    strain = 58e3 / 36e6
    a = (10e3 * 9.81 - 50e3) / 12e3
    first, last = np.searchsorted(recording.time, [11.0 - 1e-9, 12.0 - 1e-9])
    speed = recording.column("body_velocity", "load")[:, 2]
    assert speed[first] - speed[last] == pytest.approx(a * 1.0, rel=strain)
    assert recording["segment_tension"].values[last, 0] == pytest.approx(10e3 * (9.81 - a), rel=strain)
