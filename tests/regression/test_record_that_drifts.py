"""A vessel whose record drifts never came to move by it, and nothing told.

The motion of a record grows over three mean periods of the slowest, by how often it passes its mean upwards.
A surge that drifts by 5 m over 600 s passes it once: its period was 600 s, and heave of 0.38 m rms grew over
1800 s, to a third at the end of the record, to nothing in a lift of a minute. It counts up to 20 s now, the
period of long swell. `gantline check` says until when records grow.
Nor was a run that ends before a record has grown a warning, nor one of a vessel by RAOs that ends before its
waves have: only those count that push.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from afloat import barge, lift_of, written
from carried_barge import AT, carried, table
from gantline.cli.vessels import recorded_motions
from gantline.simulation import simulate
from recorded_motion import motion_of, written_record

TIME: Any = np.arange(0.0, 600.1, 0.2)


def moved(folder: Path, surge: Any, **given: Any) -> Path:
    """The lift file of a barge that goes up and down by 0.5 m and 0.2 m, and has this surge [m]."""
    motion = np.zeros((len(TIME), 6))
    motion[:, 2] = 0.5 * np.cos(0.8 * TIME) + 0.2 * np.cos(1.1 * TIME + 1.0)
    motion[:, 0] = surge
    written_record(motion, 0.2, folder / "motion.csv")
    vessel = barge(wave_motion={"record": "motion.csv", "at": [f"{part} m" for part in AT]})
    return written(folder, lift_of(vessel, simulation={"sample_interval": "0.2 s"}, **given))


@pytest.mark.parametrize("surge", [5.0 * TIME / 600.0, 3.0 * np.cos(2.0 * math.pi * TIME / 90.0)])
def test_it_moves_by_all_of_it_after_a_minute(tmp_path: Path, surge: Any) -> None:
    """Three times 20 s."""
    run = simulate(moved(tmp_path, surge, duration="130 s"))
    assert run.rig.vessels[0].grows_over == 60.0
    assert recorded_motions(run.rig, 100)[-1].split() == ["barge", "60.0", "s"]
    late = run.time > 60.0
    want = 0.5 * np.cos(0.8 * run.time) + 0.2 * np.cos(1.1 * run.time + 1.0)
    found = motion_of(run, "barge", AT)[:, 2]
    missed = (found - want)[late]
    # The mean over the record, which motions count from, is not the mean of the cosines.
    assert np.std(missed) < 1.5e-3 * want.std()


def told(run: Any) -> list[str]:
    return [one for one in run.attributes["warnings"] if " grow" in one]


def test_a_run_that_ends_before_is_told(tmp_path: Path) -> None:
    (said,) = told(simulate(moved(tmp_path, 5.0 * TIME / 600.0, duration="100 s")))
    assert said.startswith("the run ends at 100 s, and its recorded motions grow until 60 s")
    assert not told(simulate(moved(tmp_path, 5.0 * TIME / 600.0, duration="121 s")))


def test_a_run_by_raos_that_ends_before_is_told(tmp_path: Path) -> None:
    """Nothing pushes such a vessel, and it moves by waves that grow over 3 × 9 s."""
    table(tmp_path)
    sea = {"sea": {"significant_height": "1 m", "peak_period": "9 s", "direction": "150 deg"}}
    (said,) = told(simulate(carried(tmp_path, sea, duration="40 s")))
    assert said.startswith("the run ends at 40 s, and its waves grow until 27 s")
