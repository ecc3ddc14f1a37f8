"""A run that was asked to be longer than the record by which its vessel moves.

`gantline run LIFT --duration 2000s` of a lift of a minute with a record of 1000 s went on past its end: by
the way back from the last sample to the first, which nobody recorded, and then from the first one again.
Only the duration of the lift file was held against the record.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from afloat import barge, lift_of, written
from gantline.cli.app import app
from gantline.overrides import SettingError
from gantline.simulation import Simulation
from recorded_motion import written_record

#: 300.0 s.
SAMPLES = 0.3 * np.cos(0.16 * np.arange(1501))[:, None] * [0, 0, 1, 0, 0, 0]
RIGHT = "motion.csv: lasts 300.0 s and the run 300.1 s; a record at least as long is right"


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    written_record(SAMPLES, 0.2, tmp_path / "motion.csv")
    vessel = barge(wave_motion={"record": "motion.csv", "at": ["50 m", "0 m", "4 m"]})
    afloat = barge(position=["0 m", "100 m"])
    return written(tmp_path, lift_of(vessel, duration="60 s", vessels={"tug": afloat, "barge": vessel}))


def test_it_is_refused(lift: Path) -> None:
    with pytest.raises(SettingError, match=RIGHT):
        Simulation(lift, duration=300.1)
    assert Simulation(lift, duration=300.0).duration == 300.0


def test_the_command_says_so(lift: Path, tmp_path: Path) -> None:
    found = CliRunner().invoke(app, ["run", str(lift), "--duration", "300.1 s", "-o", str(tmp_path / "out")])
    assert found.exit_code == 2
    assert f"--duration: {RIGHT}" in " ".join(found.stderr.split())
