"""Vessels that move by a record of their motion, docs/concepts/wave_motion.md."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from afloat import barge, lift_of, written
from carried_barge import AT, HUNG, carried, table
from gantline.simulation import simulate
from recorded_motion import motion_of, written_record

INTERVAL = 0.2
#: Waves of 18 s to 4.5 s, none of them a harmonic of any record: amplitudes of metres, and of radians.
FREQUENCIES = np.linspace(0.35, 1.4, 40) + np.random.default_rng(3).uniform(-5e-3, 5e-3, 40)
AMPLITUDES = np.random.default_rng(4).normal(size=(40, 6)) * [0.05, 0.05, 0.1, 4e-3, 3e-3, 1e-3]
PHASES = np.random.default_rng(5).uniform(0.0, 6.28, (40, 6))
#: What the record has beside it, and a vessel by it has not [m, rad].
ASIDE = np.array([3.0, -2.0, 55.0, 0.02, -0.01, 0.3])


def motion(time: Any) -> Any:
    """What a vessel did (n, 6) [m, rad]."""
    turns = FREQUENCIES[:, None] * np.asarray(time)[:, None, None] + PHASES
    return np.einsum("kj,tkj->tj", AMPLITUDES, np.cos(turns))


def recorded(folder: Path, samples: Any, interval: float, **given: Any) -> Path:
    """The lift file of the barge that moves by these samples."""
    written_record(samples, interval, folder / "motion.csv")
    vessel = barge(wave_motion={"record": "motion.csv", "at": [f"{part} m" for part in AT]})
    return written(folder, lift_of(vessel, **given))


@pytest.mark.parametrize(("method", "step"), [("adaptive", {}), ("del", {"step": "10 ms"})])
def test_it_moves_as_its_record_has_it(tmp_path: Path, method: str, step: dict[str, str]) -> None:
    """From its mean, and once it has grown: over three mean periods of its slowest motion.

    The waves that it is taken for leave 0.1 % rms of it out. Of the record nothing is told between samples;
    the vessel is held against what was sampled, at times that were not.
    """
    samples = motion(np.arange(0.0, 200.01, INTERVAL)) + ASIDE
    path = recorded(
        tmp_path,
        samples,
        INTERVAL,
        duration="190 s",
        simulation={"sample_interval": "0.07 s", "integrator": method, **step},
    )
    run = simulate(path)
    found, want = motion_of(run, "barge", AT), motion(run.time) + ASIDE - samples.mean(axis=0)
    grown = run.time > 40.0
    missed = np.sqrt(np.mean((found - want)[grown] ** 2, axis=0)) / samples.std(axis=0)
    assert missed.max() < 1e-3


def test_what_hangs_from_it_feels_its_accelerations(tmp_path: Path) -> None:
    """A barge by its RAOs in a sea, and one by a record of what that did: a load of 1 t that a post takes up
    and down, and that does not swing, pulls alike once waves and record have grown.

    Of accelerations the record leaves more out than of ways, whose slow waves are the largest.
    """
    table(tmp_path)
    sea = {"sea": {"significant_height": "1.5 m", "peak_period": "9 s", "direction": "150 deg"}}
    guided = copy.deepcopy(HUNG)
    guided["mechanics"]["bodies"]["held"]["joint"] = {"type": "slider", "axis": [0, 0, 1]}
    given = {"duration": "200 s", "simulation": {"sample_interval": "0.1 s"}, **guided}
    first = simulate(carried(tmp_path, sea, **given))
    other = simulate(recorded(tmp_path, motion_of(first, "barge", AT), 0.1, **given))
    fall, again = (run.variables["rope_tension"].values[first.time > 60.0, 0] for run in (first, other))
    assert fall.std() > 300.0
    assert np.sqrt(np.mean((fall - again) ** 2)) < 5e-3 * fall.std()
