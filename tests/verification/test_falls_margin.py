"""How near a hook block comes to its upper sheaves, by heights: the hoist in 16 parts, raised by 5 m."""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from of_recording import checks_of

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
#: Height of the hook at the start, of its hook block, and diameter of the sheaves [m].
HOOK, HOOK_BLOCK, SHEAVES = 16.75, 3.0, 1.0


@pytest.mark.parametrize(
    ("upper", "verdict"), [(60.0, Verdict.OK), (25.5, Verdict.FAILED)], ids=["far", "two-blocked"]
)
def test_it_is_what_is_left_between_the_sheaves(upper: float, verdict: Verdict) -> None:
    """Upper sheaves - hook - hook block - rise - diameter; the falls are plumb."""
    text = FILE.read_text(encoding="utf-8").replace("upper_sheaves_at: 60 m", f"upper_sheaves_at: {upper} m")
    recording = gantline.simulate(parse_scenario(text))
    height = recording.column("body_position", "hook")[:, 2]
    left = upper - HOOK - HOOK_BLOCK - float(height.max() - height[0]) - SHEAVES
    (found,) = checks_of(recording, "hook_falls_margin")
    assert found.value == pytest.approx(left, abs=1e-9)
    assert found.verdict is verdict
