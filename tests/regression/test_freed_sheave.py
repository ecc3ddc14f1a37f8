"""A moving sheave that nothing holds any more runs up to the fixed ones.

The sling of an equalizer without stops was cut, its sheave ran up between the fixed ones, and where the parts
of the rope beside it came to nothing the run stood still: a million steps of 50 ns, and no word.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline

LIFT = Path(__file__).parents[2] / "scenarios" / "equalizer" / "scenario.yaml"


@pytest.mark.parametrize("sling", ["S2", "S3"])
def test_a_freed_sheave_ends_the_run_with_its_name(tmp_path: Path, sling: str) -> None:
    text = LIFT.read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.strip().startswith(f"{sling}:"))
    assert line.rstrip().endswith("}")
    path = tmp_path / "scenario.yaml"
    path.write_text(text.replace(line, line.rstrip()[:-1] + ", cut_at: 28 s}"), encoding="utf-8")
    with pytest.raises(
        gantline.SimulationError, match=rf"at e1\.{sling[1]}: it has come to the next place"
    ) as failed:
        gantline.simulate(path)
    # The sheave of 300 kg is let go under 296 kN on either side: 2 m take some hundredths of a second.
    assert 28.0 < failed.value.time < 28.5
    # What is recorded goes on to the last sample before that.
    interval = gantline.load_scenario(LIFT).sample_interval
    assert 0.0 <= failed.value.time - failed.value.recording.time[-1] <= interval


def test_a_sling_that_is_too_long_ends_the_run_too(tmp_path: Path) -> None:
    """With S1 of 28 m in place of 23 m its sheave stood at the fixed ones in steps of 10 µs, for hours."""
    text = (LIFT.parents[1] / "equalizer_yard" / "scenario.yaml").read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.strip().startswith("S1:"))
    assert "length: 23 m" in line
    path = tmp_path / "scenario.yaml"
    path.write_text(text.replace(line, line.replace("23 m", "28 m")), encoding="utf-8")
    with pytest.raises(gantline.SimulationError, match=r"at e1\.1: it has come to the next place"):
        gantline.simulate(path)


def test_so_does_one_that_no_step_is_short_enough_for(tmp_path: Path) -> None:
    """Under a frame that tilts the run found no step at all, and said only that forces change too fast."""
    text = LIFT.read_text(encoding="utf-8")
    changes = {"damping: 0 kN m s}": "damping: 0 kN m s, tilts: true}", "locked: false": "locked: [5]"}
    for before, after in changes.items():
        assert text.count(before) == 1
        text = text.replace(before, after)
    path = tmp_path / "scenario.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(gantline.SimulationError, match=r"at e1\.4: it has come to the next place"):
        gantline.simulate(path)
