"""How vessels lie at the end of a run in waves.

The table after a run had the last sample, a moment between a crest and a trough, and did not say so:
`crane_barge_in_swell` displaced 8134.8 t, of 8272.3 t that it weighs, and was trimmed by 0.082°. The report
beside it had means over three of the longest periods; so has the table now.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import waves
from afloat import LENGTH, MASS
from gantline.cli.vessels import vessels
from gantline.simulation import simulate

SWELL = {"height": "1 m", "period": "9 s", "direction": "0 deg"}


def test_means_over_three_periods(tmp_path: Path) -> None:
    """Displacement is the mass, 12 300 t, and drafts are 4 m, to a hundredth of what waves change."""
    run = simulate(waves.in_waves(tmp_path, {"swell": SWELL}, duration="121.5 s"))
    last = run.column("vessel_displacement", "barge")[-1]
    assert abs(last / MASS - 1.0) > 0.01
    head, row, remark = vessels(run)
    assert head.startswith("Vessel") and head.endswith("trim by the stern  least freeboard")
    words = row.split()
    assert words[0] == "barge"
    displaced, aft, forward, trim = (float(words[place]) for place in (1, 3, 5, 9))
    assert displaced == pytest.approx(MASS / 1e3, rel=1e-3)
    assert (aft, forward) == pytest.approx((4.0, 4.0), abs=0.02)
    # As much as drafts may be off between the ends, in degrees as printed.
    assert trim == pytest.approx(0.0, abs=math.degrees(0.02 / LENGTH) + 5e-4)
    # The least freeboard is that of the whole run.
    assert float(words[11]) == pytest.approx(run.metrics()["least_freeboard"], abs=5e-4)
    assert remark == "  means over the last 27 s; freeboard: the least of all"


def test_in_calm_water_the_last_sample(tmp_path: Path) -> None:
    run = simulate(waves.in_waves(tmp_path, {}, duration="5 s"))
    assert len(vessels(run)) == 2
