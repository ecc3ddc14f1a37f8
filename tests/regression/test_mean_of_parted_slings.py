"""A sling that was cut counted in the mean of its equalizer, in the picture "From the mean when clear".

Four slings that carry alike stood at +25 % from the moment on that the fifth was cut, and that one at -100 %,
beside a title that said "largest spread 0.00 %": the spread does not count what has parted.
"""

from __future__ import annotations

import numpy as np

from gantline.plot.traces import sling_tension
from gantline.results import series
from sample_lift import sample_recording

CUT = 5.0


def test_what_has_parted_is_in_no_mean() -> None:
    time = np.arange(11.0)
    tension = np.full((11, 5), 600e3)
    tension[time > CUT, 0] = 0.0
    recording = sample_recording(time, tension=tension, events=[(CUT, "cut", "sling.S1")])
    whole = series.are_whole(recording, recording.rig.equalizers[0].slings)
    assert not whole[0, time > CUT].any()
    assert whole[0, time <= CUT].all()
    assert whole[1:].all()
    figure = sling_tension(recording)
    assert figure is not None
    drawn = [np.asarray(line.get_ydata(), dtype=np.float64) for line in figure.axes[1].get_lines()]
    curves = [values for values in drawn if len(values) == len(time)]
    assert len(curves) == 5
    assert np.isnan(curves[0][time > CUT]).all()
    assert all(np.nanmax(np.abs(values)) == 0.0 for values in curves)
