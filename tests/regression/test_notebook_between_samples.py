"""The largest sling tension that a notebook shows was that of samples, and of where a lift at rest starts.

Tables, metrics and reports have that of all steps. A sling that came to 700 kN between two samples was shown
with 650 kN, beside a metric of 700 kN.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gantline.results.recording import Recording
from sample_lift import sample_recording


def recording(**attributes: str) -> Recording:
    """Two samples; S3 has 650 kN at the first, and 700 kN between both."""
    tension = np.array([[5.0, 5.0, 6.5, 5.0, 5.0], [6.0, 5.0, 5.0, 5.0, 5.0]]) * 1e5
    found = sample_recording(np.arange(2.0), tension=tension)
    peaks = found["rope_peak_tension"]
    values = peaks.values.copy()
    values[found.coordinates["rope"].index("sling.S3")] = 7e5
    changed = {**found.variables, "rope_peak_tension": replace(peaks, values=values)}
    return Recording(changed, found.coordinates, {**found.attributes, **attributes})


def test_a_notebook_shows_what_steps_had() -> None:
    run = recording()
    assert run.metrics()["peak_sling_tension"] == 7e5
    assert "700.0 kN (sling.S3)" in run._repr_html_()


def test_a_notebook_shows_a_lift_as_it_rests() -> None:
    rest = recording(status="at rest at 1 s")
    assert rest.metrics()["peak_sling_tension"] == 6e5
    assert "600.0 kN (sling.S1)" in rest._repr_html_()
