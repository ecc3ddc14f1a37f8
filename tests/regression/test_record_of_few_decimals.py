"""Records of motion as programs print them, to a few decimals, were refused.

Times of three samples a second are 0.33, 0.67 and 1.00 s: single intervals of them differ by 3 %, and 0.1 %
of the first was allowed. Motions to 0.01 m are off by 0.01/√12 m, 0.8 % of a heave of 0.38 m, both
rms: to come as near as 0.1 % to them took more than 2000 waves of nothing but rounding, which was refused as
noise; of shorter records it was accepted, and vessels shook by it.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.hydro import DatabaseError, read_motion_record
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation

TIME: Any = 0.1 * np.arange(6000)


def heave(time: Any) -> Any:
    return 0.5 * np.cos(0.8 * time) + 0.2 * np.cos(1.1 * time + 1.0)


def written(folder: Path, time: Any, decimals: int, of_time: int = 2) -> Path:
    path = folder / "motion.csv"
    lines = [f"{at:.{of_time}f},{way:.{decimals}f}" for at, way in zip(time, heave(time), strict=True)]
    path.write_text("\n".join(["time [s],heave [m]", *lines]) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(("interval", "decimals"), [(1 / 3, 2), (1 / 30, 2), (1 / 64, 3), (0.16, 1)])
def test_times_of_few_decimals_are_even(tmp_path: Path, interval: float, decimals: int) -> None:
    """The interval is theirs but for rounding at both ends of all."""
    time = interval * np.arange(900)
    found = read_motion_record(written(tmp_path, time, 4, decimals))
    assert found.interval == pytest.approx(interval, abs=10.0**-decimals / 899)


@pytest.mark.parametrize("gone", [1, 5, 450, 897])
def test_a_line_that_is_missing_is_found(tmp_path: Path, gone: int) -> None:
    """Of times at thirds of a second: 0.66 or 0.67 s from the line before. The title is line 1."""
    path = written(tmp_path, np.delete(np.arange(900) / 3, gone), 4)
    with pytest.raises(
        DatabaseError, match=rf":{gone + 2}: 0\.6[67] s after the line before; most lines are"
    ):
        read_motion_record(path)


def test_times_of_whole_seconds_at_thirds_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DatabaseError, match="3: 0 s is not after the line before"):
        read_motion_record(written(tmp_path, np.arange(900) / 3, 4, 0))


def test_rounding_is_not_followed(tmp_path: Path) -> None:
    """To 0.01 m: as near as its last decimal leaves it open, and accelerations to 5 %, rms."""
    record = read_motion_record(written(tmp_path, TIME, 2))
    assert record.decimal == pytest.approx([1, 1, 0.01, 1, 1, 1], rel=1e-9)
    waves = record.harmonics()
    way = heave(TIME)
    assert np.std(waves.at(TIME)[:, 2] - way) < 0.01 / math.sqrt(12.0) + 1e-3 * way.std()
    turns = np.exp(-1j * np.outer(TIME, waves.frequency))
    found = (turns @ (-(waves.frequency**2) * waves.motion[:, 2])).real
    want = -0.32 * np.cos(0.8 * TIME) - 0.242 * np.cos(1.1 * TIME + 1.0)
    assert np.std(found - want) < 0.05 * want.std()


def test_too_few_decimals_are_told(tmp_path: Path) -> None:
    """0.1/√12 m of 0.381 m rms, √(0.5² + 0.2²)/√2: 7.6 %."""
    written(tmp_path, TIME, 1)
    text = """
format: 1
lift: {title: A barge}
duration: 60 s
vessels:
  barge:
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    wave_motion: {record: motion.csv, at: [50 m, 0 m, 4 m]}
"""
    told = Simulation(parse_scenario(text, str(tmp_path / "lift.yaml"))).assembly.warnings
    assert any("its last decimal leaves 8 % of its heave open, rms; more decimals" in one for one in told)
