"""A record of motion with a little noise had a way back to its beginning of hundreds of metres.

Its derivatives at both ends were those of a spline of degree 7 through single samples. Of 0.05 s and noise of
0.1 mm on a heave of 0.23 m rms the third of them is of that noise, 0.8 m/s³, a way back of 24 s long:
288 m, and 2.7 km of noise of 1 mm. Within the record waves of metres cancelled one another down to 0.1 % of
the motion, and not in its accelerations, of which the noise of 1 mm made 2.5 times those of the vessel.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from afloat import barge, lift_of, written
from gantline.assembly import assemble
from gantline.hydro import MotionRecord, write_motion_record
from gantline.scenario import load_scenario

RNG = np.random.default_rng(1)
FREQUENCIES = RNG.uniform(0.5, 1.2, 30)
AMPLITUDES = RNG.uniform(0.02, 0.1, 30)
PHASES = RNG.uniform(0.0, 2.0 * math.pi, 30)
TIME: Any = 0.05 * np.arange(3000)
TURNS = np.cos(np.outer(TIME, FREQUENCIES) + PHASES)
#: Heave, and its acceleration by the closed form, Σ -aω² cos(ωt + φ).
HEAVE, ACCELERATION = TURNS @ AMPLITUDES, -TURNS @ (AMPLITUDES * FREQUENCIES**2)


def record(noise: float) -> MotionRecord:
    """Heave with noise of this root mean square [m]."""
    motion = np.zeros((len(TIME), 6))
    motion[:, 2] = HEAVE + noise * np.random.default_rng(2).standard_normal(len(TIME))
    return MotionRecord("record", 0.05, motion - motion.mean(axis=0), np.zeros(6))


@pytest.mark.parametrize("noise", [0.0, 2e-5, 2e-4])
def test_its_accelerations_are_those_of_the_vessel(noise: float) -> None:
    """To 2 % rms, over all of it. Heave to 0.1 % of it that is left out, and to the noise."""
    waves = record(noise).harmonics()
    turns = np.exp(-1j * np.outer(TIME, waves.frequency))
    acceleration = (turns @ (-(waves.frequency**2) * waves.motion[:, 2])).real
    assert np.std(acceleration - ACCELERATION) < 0.02 * ACCELERATION.std()
    assert np.std(waves.at(TIME)[:, 2] - HEAVE) < 1e-3 * HEAVE.std() + noise
    assert np.abs(waves.motion).max() < 10 * AMPLITUDES.max()
    assert waves.too_fast is None


def test_noise_that_makes_accelerations_is_told() -> None:
    """Noise of 2 mm, 1 %, at 0.05 s: its waves below 2 s have many times the acceleration."""
    told = record(2e-3).harmonics().too_fast
    assert told is not None
    assert told[0] == "heave"
    assert told[1] > 0.9


@pytest.mark.parametrize("noise", [2e-4, 2e-3])
def test_a_lift_is_told(tmp_path: Path, noise: float) -> None:
    """White noise of 2 mm up to ω = π/0.05 s has accelerations of 2 mm · ω²/√5, 3.5 m/s²; the vessel, 0.2."""
    write_motion_record(record(noise), tmp_path / "motion.csv")
    vessel = barge(wave_motion={"record": "motion.csv", "at": ["50 m", "0 m", "4 m"]})
    warnings = assemble(load_scenario(written(tmp_path, lift_of(vessel)))).warnings
    said = "motion.csv: waves shorter than 2 s make 100 % of the acceleration of its heave, rms"
    assert any(said in one for one in warnings) == (noise > 1e-3)
