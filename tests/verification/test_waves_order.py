"""Steps of `adaptive` are of order 5 in waves too."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from mechanics import adaptive

#: Of positions [m] and turns, a decade apart.
TOLERANCES = 10.0 ** -np.arange(4, 10)
#: In a thousandth of which the motion is known.
EXACT = 1e-11
#: From the start [s]; the sea grows for 24 s of it.
DURATION = 60.0
SEA = {"significant_height": "1 m", "peak_period": "8 s", "direction": "40 deg", "components": 30}


def motion(document: dict[str, Any], tolerance: float) -> tuple[int, Any]:
    """Steps, and place [m] and orientation of the barge every 5 s."""
    run = adaptive(
        document, DURATION, tension_tolerance=None, position_tolerance=tolerance, sample_interval=5.0
    )
    return run.counters["steps"], np.hstack([run.body("barge"), run.body("barge", "body_orientation")])


@pytest.mark.parametrize("lift", [waves.in_waves, waves.radiating])
def test_order_in_waves(tmp_path: Path, lift: Any) -> None:
    """A free barge in seas of thirty waves, water without and with memory: the error of its way falls with
    the fifth power of the number of steps, over five decades.

    Forces of waves change with time, with the slow place and with the heading, which they follow from step to
    step. Errors are means, of their logarithms, of four seas: of three such sets the orders are 5.2 to 5.5
    without memory, 4.8 to 5.1 with it. What followed in steps of order 4 would show as 4.
    """
    counts, errors = [], []
    for seed in range(4):
        sea = {**SEA, "seed": seed}
        document = assemble(load_scenario(lift(tmp_path, {"swell": sea}, {"heading": "10 deg"}))).document
        exact = motion(document, EXACT)[1]
        found = [motion(document, tolerance) for tolerance in TOLERANCES]
        counts.append(np.log([steps for steps, _ in found]))
        errors.append(np.log([np.abs(way - exact).max() for _, way in found]))
    order = -np.polyfit(np.mean(counts, axis=0), np.mean(errors, axis=0), 1)[0]
    assert order == pytest.approx(5.0, abs=0.6)
