"""Recordings of floating cranes that do not slew could not be read: "variable 'slew_angle' is missing".

Once cranes afloat could slew, `slew_angle` was asked of every recording with a boom, and only those with a
crane that slews have it. `gantline check`, `compare`, `view` and `report` refused all others, of
`crane_barge_in_swell` for one, as damaged or changed by another program. Nothing read one back.
"""

from __future__ import annotations

from pathlib import Path

import gantline

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def test_what_a_lift_records_is_read_back(tmp_path: Path) -> None:
    """The same variables, before its first step; `test_every_scenario.py` has all other lifts."""
    recording = gantline.Simulation(SCENARIOS / "crane_barge_in_swell").recording()
    again = gantline.open_recording(recording.save(tmp_path / "recording.nc"))
    assert list(again.variables) == list(recording.variables)
