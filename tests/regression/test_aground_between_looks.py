"""A barge whose keel went into the floor of its dock for a second of an hour was not told.

Vessels were looked at at sixty moments, a minute apart in a run of an hour: one that heaves, as after a load
is lost, is back before the next.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from afloat import BREADTH, DRAFT, LENGTH, barge, lift_of, written
from gantline import simulate

#: It begins as much too high [m], and is damped in heave by this share of what is critical.
HIGH, DAMPING = 0.2, 0.1
#: How far it goes below its rest, after half a period [m].
BELOW = HIGH * math.exp(-math.pi * DAMPING / math.sqrt(1.0 - DAMPING**2))
#: That half period, ω² = ρ g A/m = g/draft of a box [s].
HALF_PERIOD = math.pi / math.sqrt(9.81 / DRAFT * (1.0 - DAMPING**2))


@pytest.mark.parametrize("duration", ["60 s", "3600 s"])
@pytest.mark.parametrize(("under_keel", "is_told"), [(BELOW - 0.05, True), (BELOW + 0.01, False)], ids=str)
def test_a_keel_that_dips_into_the_floor(
    tmp_path: Path, under_keel: float, is_told: bool, duration: str
) -> None:
    """Room under the keel at rest that is 5 cm less than what it dips by, and 1 cm more."""
    dock = {"type": "dock", "x": ["-10 m", f"{LENGTH + 10} m"], "y": [f"{-BREADTH} m", f"{BREADTH} m"]}
    given = lift_of(
        barge(draft=f"{DRAFT - HIGH} m", water_damping={"critical": {"heave": f"{100 * DAMPING} %"}}),
        duration=duration,
        start="as_given",
        ground={"level": "3.5 m"},
        structures={"dock": {**dock, "floor": f"{-DRAFT - under_keel} m"}},
        simulation={"sample_interval": "0.1 s"},
    )
    found = [
        one for one in simulate(written(tmp_path, given)).attributes["warnings"] if "in the ground" in one
    ]
    assert len(found) == is_told
    for one in found:
        assert one.startswith("barge is 0.05 m in the ground at ")
        assert float(one.split(" at ")[1].split(" s")[0]) == pytest.approx(HALF_PERIOD, abs=0.1)
