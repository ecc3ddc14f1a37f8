"""A step that hauled one tag line twice was told that it "names a mooring twice; each mooring stands once".

The message took the first word of what `haul` moves, "mooring or tag line"; there was no mooring in the lift.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from reference_lift import ROOT

LIFT = (ROOT / "scenarios" / "spreader_bar" / "scenario.yaml").read_text(encoding="utf-8")
LINE = """tag_lines:
  west: {at: [-5.5 m, -2 m, 0.2 m], to: [-5.5 m, -27 m, 0 m], rope: sling_36, length: as_routed,
         winch: {speed: 10 m/min, acceleration: 0.1 m/s^2}}
plan:
  - {step: haul, haul: [tag.west, west], speed: 1 m/min, by: 0.1 m}
"""


def test_a_tag_line_is_no_mooring() -> None:
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(LIFT.replace("plan:\n", LINE, 1))
    assert "haul: names a line twice; each line stands once" in str(refused.value)
