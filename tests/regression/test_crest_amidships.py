"""Freeboard of a vessel in waves whose crest is amidships.

Of the edge of a deck only the corners were looked at. In still water the lowest point of a side is one of its
ends; in waves it need not be. A barge as long as the waves, its deck 0.4 m over still water in waves of 1 m,
came out of the water as the crest had left its stern, and went under again as it reached its bow, with 0.9 m
of freeboard in between. `crane_barge_in_swell` in a head sea of 1.6 m every 5.5 s had 2.32 m at least in
place of 2.25 m.
"""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from afloat import DRAFT, LENGTH, barge, lift_of, written
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from gantline.simulation import simulate

#: Of waves as long as the barge, and 0.1 % more: 24 points over their length are 24 over its sides.
PERIOD = math.sqrt(2 * math.pi * 1.001 * LENGTH / 9.81)


def test_a_crest_amidships_is_over_the_deck(tmp_path: Path) -> None:
    """Grown, the crest is always somewhere along the sides: 0.4 m − 0.5 m, less what lies between points,
    0.5 m (1 − cos π/24) = 4.3 mm at most; it goes under once, and comes out no more.
    """
    low = barge(hull={"box": [f"{LENGTH} m", "30 m", f"{DRAFT + 0.4} m"]})
    wave = {"height": "1 m", "period": f"{PERIOD!r} s", "direction": "0 deg"}
    path = written(tmp_path, lift_of(low, waves={"swell": wave}, duration="40 s", start="as_given"))
    run = simulate(path)
    late = run.time > 3 * PERIOD
    freeboard = run.column("vessel_freeboard", "barge")[late]
    assert freeboard.min() > -0.1 - 1e-9
    assert freeboard.max() < -0.1 + 0.5 * (1 - math.cos(math.pi / 24))
    assert not [kind for time, kind, _ in run.events() if time > 3 * PERIOD]


@pytest.mark.parametrize(("period", "count"), [(PERIOD, 24), (1.0, 200)])
def test_points_along_the_edge(tmp_path: Path, period: float, count: int) -> None:
    """24 over the length of the waves, no more than 200 over that of the vessel; corners without."""
    wave = {"height": "1 mm", "period": f"{period!r} s", "direction": "0 deg"}
    marks = []
    for waves in ({"waves": {"swell": wave}}, {}):
        document = assemble(load_scenario(written(tmp_path, lift_of(barge(), **waves)))).document
        (edge,) = document["vessels"][0]["marks"]
        marks.append(np.array(edge["points"]))
    # Two sides and two ends of 100 × 30 m.
    assert len(marks[0]) == 2 * count + 2 * math.ceil(0.3 * count)
    assert len(marks[1]) == 4
    assert json.dumps(marks[1].tolist()) == json.dumps(marks[0][:4].tolist())
