"""A hinge on a tailing frame of `mechanics` was refused, and what to write instead was not said."""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from hinged_mast import RAISE, mast

FRAME = "mechanics: {bodies: {frame: {joint: {type: slider, axis: [1, 0, 0]}, mass: 20 t}}}"


def test_what_carries_a_foot_on_a_frame_is_told() -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(mast(RAISE, hinge=", held_by: frame", more=FRAME))
    assert (
        "hinges.foot.held_by: 'frame' is a body of 'mechanics', and holds no hinge: ropes of 'mechanics' "
        "from it to the load carry its foot" in str(caught.value)
    )
