"""A sheave that met its stop while its load stood between two lifts was NO-GO, "with the load hanging".

Whatever came between the first and the last sample of a clear load counted as hanging, also what came while
the load had been set down and its slings were slack, where moving sheaves may well lie on their stops.
"""

import numpy as np
import pytest

from gantline.checks import Check, Verdict
from of_recording import checks_of
from sample_lift import sample_recording, sample_rig

#: Contact at each sample, one a second: set down, lifted, set down, lifted, set down.
SUPPORTED = [True, True, False, False, True, True, False, False, True, True]


def travel_used(stop_met: float) -> Check:
    """The check of a lift whose second moving sheave meets its stop at a time [s]."""
    samples = len(SUPPORTED)
    recording = sample_recording(
        np.arange(float(samples)),
        tension=np.full((samples, 5), 1e5),
        contact=np.where(np.array(SUPPORTED)[:, None], 1.0, 0.0) * np.ones(4),
        events=[(stop_met, "stop_hit", "e1.2")],
        rig=sample_rig(equalizer_travel_used=0.9),
    )
    (check,) = checks_of(recording, "equalizer_travel_used")
    return check


@pytest.mark.parametrize("time", [0.5, 4.5, 8.5])
def test_a_stop_met_by_a_load_that_stands_is_a_warning(time: float) -> None:
    check = travel_used(time)
    assert check.verdict is Verdict.WARNING
    assert check.remark == f"e1.2 met its stop at {time:.2f} s"


@pytest.mark.parametrize("time", [1.5, 2.0, 2.5, 3.5, 6.5, 7.5])
def test_a_stop_met_by_a_load_that_hangs_or_comes_or_goes_fails(time: float) -> None:
    """Within a sample of lifting off and of setting down it counts as hanging."""
    check = travel_used(time)
    assert check.verdict is Verdict.FAILED
    assert check.remark == f"met its stop at {time:.2f} s, with the load hanging: e1.2"
