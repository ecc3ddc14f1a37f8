"""A crane barge by a record of what it did in its swell, against that."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from compensated import BARGE, compensated_text
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.study.heave_demand import heave_demands
from recorded_motion import motion_of, written_record

AT = np.array([45.0, 0.0, 3.0])
"""A point of the barge, its axes [m]."""


def by_record(text: str) -> str:
    """The lift file with the barge carried by `motion.csv`."""
    by_forces = text[text.index("    radiation:") : text.index("mooring_lines:")]
    return text.replace(by_forces, "    wave_motion: {record: motion.csv, at: [45 m, 0 m, 3 m]}\n\n")


def test_the_crane_barge_by_a_record_of_itself(tmp_path: Path) -> None:
    """Peak at the hook, of hoist, tackles and slings, once the record has grown: 0.2 %. It leaves 0.1 % out.

    Waves and record have grown by different times, so that the load swings a little otherwise. Mooring lines
    have their pretension where the barge begins: of the record at its mean, of the other at rest.
    """
    text = BARGE.read_text(encoding="utf-8")
    free = simulate(parse_scenario(text, str(BARGE)))
    written_record(motion_of(free, "barge", AT), 0.1, tmp_path / "motion.csv")
    waves = text[text.index("waves:") : text.index("ropes:")]
    carried = simulate(parse_scenario(by_record(text).replace(waves, ""), str(tmp_path / "lift.yaml")))
    grown = free.time > 30.0
    ropes = free.coordinates["rope"]
    lines = [number for number, name in enumerate(ropes) if not name.startswith("mooring.")]
    for name, columns in (("hook_load", [0]), ("rope_tension", lines)):
        first, again = (run.variables[name].values[grown][:, columns].max(axis=0) for run in (free, carried))
        assert again == pytest.approx(first, rel=2e-3)


def test_of_a_record_the_sea_does_not_tell_what_heave_compensation_needs(tmp_path: Path) -> None:
    """Waves of the lift are none of the record: (HC4) of them would be of another motion."""
    samples = (
        0.5 * np.cos(0.8 * np.arange(0.0, 400.0, 0.5))[:, None] * np.ones(6) * [1, 1, 1, 0.01, 0.01, 0.01]
    )
    written_record(samples, 0.5, tmp_path / "motion.csv")
    text = compensated_text("  - {step: hold, hold: until_end, compensate_heave: H1}\n")
    assert heave_demands(parse_scenario(text, str(BARGE)))
    assert heave_demands(parse_scenario(by_record(text), str(tmp_path / "lift.yaml"))) == []
