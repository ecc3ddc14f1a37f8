"""A crawler crane whose hook bears less than the crane was told that a mass of it is too large.

With 45 t at 12 m and at 16 m, what its falls bear, the chart has 15 % of what tips the crane, "where 75 % is
usual". A chart that falls with the radius comes from what tips the crane; one that is level does not.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


@pytest.mark.parametrize(
    ("rated", "is_told"),
    [(["45 t", "45 t"], False), (["60 t", "45 t"], True), (["360 t", "231 t"], False)],
)
def test_a_chart_that_is_level(rated: list[str], is_told: bool) -> None:
    changes = {"cranes.c1.rating.radius": ["12 m", "16 m"], "cranes.c1.rating.rated": rated}
    found = assemble(load_scenario("floating_crane_and_crawlers").changed(changes)).warnings
    assert any("of what tips the crane by its masses" in one for one in found) is is_told
