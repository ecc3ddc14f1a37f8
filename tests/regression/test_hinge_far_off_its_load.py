"""A hinge whose place is counted in the world, 180 m outside the box of its load: nothing was said of it.

Lugs, outfitting and ends of tag lines so far off were refused, and told from 1 m on; the load turned about a
place in the air, and what the hinge bears was that of a lever that is not there.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from hinged_mast import mast

HOLD = "  - {step: hold, hold: until_end}\n"


def lift(x: float) -> str:
    return mast(HOLD, hook=(19.0, 0.0, 60.0)).replace("at: [-20 m,", f"at: [{x} m,")


def test_it_is_refused() -> None:
    """The box is 40 m long: 200 - 20 = 180 m, more than half of that."""
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(lift(-200.0))
    assert (
        "hinges.foot.at: this hinge is 180 m outside the load's box; positions are measured from its bottom "
        "centre"
    ) in str(caught.value)


def test_nearer_it_is_told() -> None:
    warnings = assemble(parse_scenario(lift(-24.0))).warnings
    assert "hinge foot holds the load 4 m outside the load's box" in warnings


def test_a_frame_beside_the_load_is_not() -> None:
    """Pins of a hinge frame stand a little off what they hold."""
    assert not [one for one in assemble(parse_scenario(lift(-20.9))).warnings if "hinge" in one]
