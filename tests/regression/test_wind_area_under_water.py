"""A wind area that went under water with its load: wind pushed on, without a word.

16 m deep the manifold of `splash_zone` hung 81 mm aside by a wind of 12 m/s. A run told of current areas in
the air, and of nothing the other way round.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import load_scenario

AREA = {"area": "32 m^2", "coefficient": "1.2", "along": "y", "at": ["0 m", "0 m", "2 m"]}


@pytest.mark.parametrize(("duration", "is_told"), [("40 s", False), ("120 s", True)])
def test_it_is_told_once_it_goes_under(duration: str, is_told: bool) -> None:
    """It is lowered after 40 s, by 14 m in 70.3 s: 2 m over an underside that began 6 m above the water, the
    area is then 6 m under it, and what ropes stretch, 0.11 m.
    """
    changes = {
        "wind": {"speed": "12 m/s", "direction": "90 deg"},
        "load.wind_areas": {"side": AREA},
        "waves": {"ripple": {"height": "1 mm", "period": "6 s", "direction": "0 deg"}},
        "duration": duration,
    }
    recording = gantline.simulate(load_scenario("splash_zone").changed(changes))
    found = [one for one in recording.attributes["warnings"] if "the wind area side of manifold is" in one]
    assert bool(found) is is_told
    if found:
        assert "m under the water, first at" in found[0]
        assert float(found[0].split("up to ")[1].split(" m")[0]) == pytest.approx(6.11, abs=0.02)


def test_nothing_is_told_where_there_is_no_water() -> None:
    """What is below the zero of a yard, as in a dry dock, is in the air: 9 m below a load that is at 0."""
    lift = load_scenario("spreader_bar").changed(
        {
            "wind": {"speed": "8 m/s", "direction": "90 deg"},
            "load.wind_areas": {"side": {**AREA, "at": ["0 m", "0 m", "-9 m"]}},
            "duration": "20 s",
        }
    )
    recording = gantline.simulate(lift)
    assert not [one for one in recording.attributes["warnings"] if "under the water" in one]
