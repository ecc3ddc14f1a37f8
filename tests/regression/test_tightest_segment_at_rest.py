"""The factor on the breaking force of a rope whose sheaves slip, at rest.

Cases and bounds of statics ask what a hoist rope carries where all its sheaves slip along it, or against. The
tension of such a rope is the mean of its segments, which was held against its breaking force: 20.09 for the
lower hook of the Goliath crane, where the tightest of thirteen segments leaves 17.85. In a run, where peaks
are kept of every segment, it was right.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.checks import values_of
from gantline.scenario import parse_scenario
from gantline.statics import Losses, Statics
from mechanics import G

FILE = Path(__file__).parents[2] / "scenarios" / "goliath" / "scenario.yaml"
ROPE, PARTS, EFFICIENCY = "hoist.goliath.L.1", 12, 0.98


@pytest.mark.parametrize("losses", ["forward", "backward"])
def test_the_tightest_segment_counts(losses: Losses) -> None:
    """From end to end tensions differ by 1/e^12; what breaks the rope is the largest of them."""
    question = Statics(parse_scenario(FILE.read_text(encoding="utf-8"), str(FILE)))
    rest = question.equilibrium(400.0, losses=losses).recording
    segments = [f"{ROPE}/{place}" for place in range(PARTS + 1)]
    tensions = [float(rest.column("segment_tension", one)[-1]) for one in segments]
    assert max(tensions) / min(tensions) > 0.99 * EFFICIENCY**-PARTS
    strength = rest.rig.minimum_breaking_force(ROPE)
    assert strength is not None
    said = values_of(rest, "rope_factor_on_breaking_force")[ROPE]
    # Of 44 mm, at the upper sheaves; the falls are all of one length but for the lead line.
    falls = max(float(rest.column("segment_length", one)[-1]) for one in segments[1:])
    own = falls / 2 * 0.409 * 44**2 / 100 * G
    # With the contingency of the load: hook block and falls, too.
    (load,) = rest.rig.loads
    assert load.design_mass and load.simulated_mass
    raised = load.design_mass / load.simulated_mass
    assert raised == pytest.approx(1.05, rel=2e-3)
    assert said == pytest.approx(strength / (raised * max(tensions) + own), rel=1e-6)
