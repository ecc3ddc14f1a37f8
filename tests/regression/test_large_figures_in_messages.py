"""A box given in m for mm was warned of in powers of ten.

"the load weighs 6e+04 kg, less than the air in its box, 1.728e+11 kg", its centre of gravity lay "1.4e+03
mm" above its underside; a shackle of 1500 t broke "at 1.2e+04 kN". Nobody reads a list of weights so.
"""

from __future__ import annotations

import re

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from gantline.scenario.errors import ScenarioError
from lift_text import spoiled

#: A power of ten.
POWER = re.compile(r"[0-9]e[+-]?[0-9]")


def test_a_load_that_weighs_less_than_air() -> None:
    """8000 x 6000 x 3000 m3 of air at 1.2 kg/m3 weigh 172.8e6 t."""
    lift = spoiled("box: [8 m, 6 m, 3 m]", "box: [8000 m, 6000 m, 3000 m]")
    warned = assemble(parse_scenario(lift)).warnings
    assert any("the load weighs 60 t, less than the air in its box, 172,800,000 t;" in one for one in warned)
    assert any("is 1,500 mm above the underside of a load 3000 m high" in one for one in warned)
    assert not any(POWER.search(one) for one in warned)


def test_a_shackle_that_breaks_below_its_limit() -> None:
    """1500 t weigh 14715 kN."""
    broken = "{working_load_limit: 1500 t, minimum_breaking_force: 12000 kN, mass: 0 kg}"
    with pytest.raises(
        ScenarioError, match="would break at 12000 kN, below its working load limit of 14715 kN;"
    ):
        parse_scenario(spoiled("{working_load_limit: 40 t, mass: 0 kg}", broken))
