"""Which sheaves stick in motions about a lift that friction holds was said by rounding.

As the crane barge has taken its module, all twelve sheaves of its hoist hold what they can. One of them stuck
in its motions on a processor with fused multiplications, none on one without: GM was 21.93 m or 21.91 m, that
of `floating_crane` 25.93 m or 26.20 m. A lift that stands there sticks, at the bounds of friction too.
"""

from __future__ import annotations

from itertools import pairwise

import pytest

from gantline.scenario import load_scenario
from gantline.statics import Statics


def test_every_lossy_sheave_of_a_lift_that_is_held_sticks() -> None:
    """Each sheave at its bound, a ratio of 1/0.98, and a row of what holds for each."""
    statics = Statics(load_scenario("crane_barge_in_swell"))
    recording = statics.equilibrium(losses="held").recording
    segments = [name for name in recording.coordinates["segment"] if name.startswith("hoist.")]
    tension = [float(recording.column("segment_tension", name)[-1]) for name in segments]
    for one, other in pairwise(tension):
        assert max(one, other) / min(one, other) == pytest.approx(1 / 0.98, abs=1e-3)
    assert len(statics.linear_model().held) == len(segments) - 1 == 12
