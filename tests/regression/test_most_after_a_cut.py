"""What a sling has at most after another was cut is the peak that its table has, and not that of the samples.

The report of `equalizer_sling_cut` said "after that sling.S5 has most, 4504.0 kN, 148 % of its minimum
breaking force" above a table with 4543 kN and 149 %: between two samples, 20 ms apart, it had 39 kN more.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gantline.results.recording import Recording
from of_recording import checks_of
from sample_lift import ringing_lift

CUT = (12.5, "cut", "sling.S2")  # s
#: Of S3, whose samples have at most 0.99 times 600 + 100 kN; S1 has 600 + 100 sin(2π 2.24 s/s) kN = 699.8 kN.
PEAK = 720e3  # N


def remark_of_a_cut(at: float) -> str:
    """What the check says of S2, where S3 has its peak at a time between two samples [s]."""
    recording = ringing_lift(events=[(9.99, "lift_off", "block"), CUT])
    row = recording.coordinates["rope"].index("sling.S3")
    variables = dict(recording.variables)
    for name, value in (("rope_peak_tension", PEAK), ("rope_peak_time", at)):
        values = np.array(recording[name].values)
        values[row] = value
        variables[name] = replace(recording[name], values=values)
    [check] = checks_of(Recording(variables, recording.coordinates, recording.attributes), "rope_parted")
    return check.remark


@pytest.mark.parametrize(
    ("at", "said"), [(15.247, "sling.S3 has most, 720.0 kN"), (11.247, "sling.S1 has most, 699.8 kN")]
)
def test_peaks_between_samples_count_once_it_is_cut(at: float, said: str) -> None:
    assert f"after that {said}" in remark_of_a_cut(at)
