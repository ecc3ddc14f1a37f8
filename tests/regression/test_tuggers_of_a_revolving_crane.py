"""Tag lines of constant pull from a crane that slews: equilibria that there are were not found.

The module hangs in one hook, and what turns it are two tuggers of 1 kN. On the way down such a soft valley
bends, and forces get worse before they balance. Where a step promised less than 160 times the rounding of
energies it counted by its forces alone, though it had gained 140 times of that: of 36 cases of
`revolving_crane` with tuggers in place of lines made fast 3 were told as without equilibrium.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.scenario import parse_scenario

SCENARIO = Path(__file__).parents[2] / "scenarios" / "revolving_crane" / "scenario.yaml"


def test_the_heavy_module_comes_to_rest_with_all_sheaves_slipping() -> None:
    text = SCENARIO.read_text(encoding="utf-8")
    assert text.count("rope: tag_16, pretension: 1 kN") == 2
    lift = parse_scenario(text.replace("rope: tag_16, pretension: 1 kN", "rope: tag_16, pull: 1 kN"))
    heavy = lift.changed({"load.weight.simulate": "design"})
    rest = gantline.Statics(heavy).equilibrium(losses="forward")
    for line in ("tag.fore", "tag.aft"):
        # Of rope that is wound under its pull a drum has the mean of strains with and without it.
        assert float(rest.recording.column("rope_tension", line)[-1]) == pytest.approx(1e3, rel=2e-3)
