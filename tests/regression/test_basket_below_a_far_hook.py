"""A basket whose falls went through its load was in order as soon as its hook was high.

Falls were looked at in 200 places from eye to hook. Below a hook 200 m up these are 1 m apart, and none
but the eye itself was in a pipe of 1 m: eyes 0.3 m from its sides, whose falls cut through it, were in
order, and below a hook of 6 m they were told.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed
from pipe_in_baskets import pipe_in_baskets


@pytest.mark.parametrize("hooks", [6.0, 200.0])
def test_falls_that_cut_are_told_at_any_height(hooks: float) -> None:
    text = changed(
        pipe_in_baskets(hooks=hooks, rope="axial_stiffness: 60 MN"),
        ("0.5 m, 0.1 m", "0.2 m, 0.1 m"),
        ("length: 11 m", "length: as_routed"),
    )
    [doubt] = [one for one in assemble(parse_scenario(text)).warnings if " through " in one]
    assert doubt.startswith("west and east go through pipe, up to 0.")
