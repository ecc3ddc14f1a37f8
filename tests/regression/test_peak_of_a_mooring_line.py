"""The largest tension of a mooring line, within a step.

Of ropes the largest tension within a step is found, of catenaries that at its ends. In swell, where steps are
as long as a tenth of a wave, the peak of a line was up to 0.5 % less than its own samples beside it, in
tables, checks and metrics: 309.7 kN of a barge in waves of 3 m every 11 s, whose plot went up to 311.2 kN.
"""

from __future__ import annotations

import gantline
from gantline.results import series


def test_no_sample_is_above_the_peak() -> None:
    """Of every line; one at least has its peak within a step."""
    run = gantline.simulate("crane_barge_in_swell", duration=60.0)
    metrics = run.metrics()
    within = 0
    for line in run.rig.mooring_lines:
        samples = run.column("mooring_tension", line.name)
        assert metrics[f"peak_mooring_tension.{line.name}"] >= samples.max()
        highest, time = series.rope_peak(run, line.rope)
        assert highest == metrics[f"peak_mooring_tension.{line.name}"]
        at_ends = float(run.column("rope_peak_tension", line.rope))
        if highest > at_ends:
            within += 1
            assert samples[run.time == time] == highest
    assert within > 0
