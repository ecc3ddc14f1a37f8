"""A step that waits for a trim which a wave reaches for a moment, within a step of the method.

The condition was looked at where steps of `adaptive` end alone: of a trim that a barge in waves of 5 s
reaches for 0.3 s, at 127.3 s, nothing was seen, and the hold went on to the end.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import step_end

FILE = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell" / "scenario.yaml"


def held(hold: str) -> Recording:
    text = FILE.read_text(encoding="utf-8").replace("peak_period: 7 s", "peak_period: 5 s")
    given = "hold: 150 s, report: [hook_load, trim, draft]"
    assert given in text
    return simulate(parse_scenario(text.replace(given, hold, 1), str(FILE)), duration=135.0)


def test_a_trim_that_a_wave_reaches_for_a_moment() -> None:
    """Trims that one wave alone reaches, to 98 % of its crest, are met where the run without a condition is
    first beyond them, to a sample of 0.1 s.
    """
    trim = (free := held("hold: 150 s")).column("vessel_trim", "barge")
    for share in (0.94, 0.96, 0.98):
        level = share * float(trim.max())
        first = float(free.time[int(np.argmax(trim > level))])
        asked = f"hold: until_met, until: {{trim: {{vessel: barge, above: {np.degrees(level)!s} deg}}}}"
        assert first - 0.1 <= step_end(held(asked), "hold in the swell") <= first
