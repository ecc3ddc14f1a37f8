"""`gantline check` told of sheaves whose mass nobody gave `half of 57.7079 kg`: an estimate with six digits.

It comes from the hook block, or from the sizes of rope and sheave; a tenth of a kilogram is more than is
known of it.
"""

from __future__ import annotations

import pytest

from gantline.scenario.mechanics import Sheave
from gantline.scenario.sheave import sheave_losses


@pytest.mark.parametrize(
    ("own_mass", "text"),
    [(57.7079, "half of 57.7 kg"), (200.0, "half of 200 kg"), (1234.56, "half of 1234.6 kg")],
)
def test_where_the_inertia_comes_from_has_the_digits_that_are_known(own_mass: float, text: str) -> None:
    given = {
        "type": "sheave",
        "body": "b",
        "axis": ["0", "1", "0"],
        "diameter": "0.6 m",
        "efficiency": "98 %",
    }
    found = sheave_losses(Sheave.model_validate(given), 0.3, 2.76, own_mass)
    assert (found.inertia_from, found.inertia) == (text, own_mass / 2)
