"""A tank called `hull` was refused at its vessel, not at the tank.

`barge.hull: there are two of this name; every force needs its own` was said, and nobody has heard of forces;
one called `in_water` in a load would be taken for the water around that.
"""

from __future__ import annotations

import pytest

from ballasted import barge, lift, tank
from gantline.scenario import ScenarioError


@pytest.mark.parametrize(("name", "means"), [("hull", "its hull"), ("added_mass", "its added mass")])
def test_is_told_at_the_tank(name: str, means: str) -> None:
    with pytest.raises(ScenarioError) as found:
        lift(barge({name: tank((50.0, 0.0, 0.0), 100.0)}))
    (problem,) = found.value.problems
    assert problem.path == f"vessels.barge.tanks.{name}"
    assert problem.sentence == f"'barge.{name}' means {means}; this tank needs another name"
    assert problem.line is not None
