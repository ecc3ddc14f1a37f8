"""Recordings of floating cranes that do not slew could not be read: "variable 'slew_angle' is missing".

Once cranes afloat could slew, `slew_angle` was asked of every recording with a boom, and only those with a
crane that slews have it. `gantline check`, `compare`, `view` and `report` refused all others, of
`crane_barge_in_swell` for one, as damaged or changed by another program. Nothing read one back.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


@pytest.mark.parametrize("name", ["crane_barge_in_swell", "revolving_crane", "upending", "goliath"])
def test_what_a_lift_records_is_read_back(name: str, tmp_path: Path) -> None:
    """Of a crane of each type the same variables, before its first step."""
    recording = gantline.Simulation(SCENARIOS / name).recording()
    again = gantline.open_recording(recording.save(tmp_path / "recording.nc"))
    assert list(again.variables) == list(recording.variables)
