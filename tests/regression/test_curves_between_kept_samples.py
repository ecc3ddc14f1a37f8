"""A sling of 850 kN that read 2402 kN in the player.

Curves of a page are decimated: of each of some hundred stretches it had the first, the least, the largest and
the last sample. Drawn at one stretch for each pixel that is the same picture. But at a moment of a rope that
rings legend, tip, label and colour of the rope read a straight line between two of them, up to 1.5 MN off in
`equalizer_sling_cut`, and a plot into which somebody zoomed had corners that the recording has not.
"""

from __future__ import annotations

import numpy as np

from gantline.viewer import pack
from packed_arrays import unpacked
from sample_lift import SLINGS, sample_recording

#: Of the range of a curve; half of what is kept below, and rounding to float32.
BOUND = 5e-4


def test_a_page_reads_what_was_recorded_at_every_sample() -> None:
    time = np.linspace(0.0, 70.0, 7001)
    # As a sling that is cut leaves the others: 1.3 MN to and fro at 3 Hz, and less by and by.
    rings = 1.4e6 + 1.3e6 * np.exp(-np.maximum(time - 40.0, 0.0) / 5.0) * np.sin(19.0 * time) * (time > 40.0)
    packed = pack(sample_recording(time, tension=np.outer(rings, np.ones(5))))
    curve = next(one for one in packed.header["curves"] if one["name"] == SLINGS[0])
    part = slice(curve["first"], curve["first"] + curve["count"])
    at = unpacked(packed, "curve_sample")[part].astype(int)
    read = 1e3 * np.interp(time, time[at], unpacked(packed, "curve_value")[part])
    assert np.abs(read - rings).max() <= BOUND * np.ptp(rings)
    # Not by keeping all: the first 40 s are a straight line.
    assert len(at) < 3500
