"""Static values, dynamic factors and requirements of a lift in waves.

A mean over the last 5 s is no static value where waves of 7 s lift the hook up and down: with holds of 5.5 to
10 s at the end of `crane_barge_in_swell`, in a sea of 2 m, the static hook load came to 1200 to 1221 kN in
place of 1186 kN, and the dynamic factor of the slings to 1.047 in place of 1.085. A requirement at the end
of a step was held against that one sample, so that it was met or not by where in a wave the step ended.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.checks import Verdict, check_recording
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

FILE = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell" / "scenario.yaml"
#: Module, four slings and their shackles in the hook: `test_crane_barge.py`.
HOOK_LOAD = (120e3 + 4 * (179.6 + 2 * 27.0)) * 9.81
RISE = 3 * 7.0


@pytest.fixture(scope="module")
def run() -> Recording:
    """A step of 5.5 s at the end, of 2 m significant height; the hoist takes 10 m."""
    text = FILE.read_text(encoding="utf-8")
    for given, other in (
        ("duration: 300 s", "duration: 150.5 s"),
        ("significant_height: 0.8 m", "significant_height: 2 m"),
        ("hold: 150 s", "hold: 40 s"),
        ("by: 5 m}", "by: 10 m}"),
        (
            "report: [hook_load, trim, draft]}\n  - {step: hoist",
            "require: {trim: below 1 deg}}\n  - {step: hoist",
        ),
    ):
        assert given in text
        text = text.replace(given, other)
    return simulate(parse_scenario(text, str(FILE)))


def test_static_hook_load_in_waves(run: Recording) -> None:
    """The weight in the hook, to 0.1 %; the mean over the last 5.5 s is 1 % more."""
    assert run.rig.sea is not None and run.rig.sea.rise_time == pytest.approx(RISE, rel=1e-12)
    assert run.metrics()["static_hook_load"] == pytest.approx(HOOK_LOAD, rel=1e-3)


def test_a_requirement_holds_over_whole_waves(run: Recording) -> None:
    """The largest trim in the last 21 s of the step, not that of its last sample."""
    check = next(one for one in check_recording(run) if one.step == "hold in the swell")
    trim = np.abs(run.column("vessel_trim", "barge"))
    late = (run.time >= 40.0 - RISE - 1e-9) & (run.time <= 40.0 + 1e-9)
    assert check.value == pytest.approx(trim[late].max(), rel=1e-12)
    assert check.value > 1.1 * trim[late][-1]
    assert check.verdict is Verdict.OK
