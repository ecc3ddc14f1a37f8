"""A lift in a storm that was meant as a breeze, and does not come to rest in it.

`start: rest` and `gantline statics` ended in "no step brings its forces closer to balance (module)", of use
to nobody: the message says now with what the wind pushes.
"""

from __future__ import annotations

import pytest

from gantline.assembly.origin import with_advice
from gantline.scenario import Scenario, load_scenario, shipped
from gantline.scenario.afloat.stream import Wind
from gantline.statics import NoEquilibriumError, Statics

NO_STEP = "no step brings its forces closer to balance"
SIDE = {"area": "38 m^2", "coefficient": 1.2, "along": "y", "at": ["0 m", "0 m", "1.75 m"]}


def blown(speed: float) -> Scenario:
    """The 45 t module of a scenario on the ground, in wind onto its side."""
    lift = load_scenario(shipped()["spreader_bar"])
    wind = {"speed": f"{speed} m/s", "direction": "90 deg"}
    return lift.changed({"wind": wind, "load.wind_areas": {"side": SIDE}})


def test_what_the_wind_pushes_with_is_in_the_message() -> None:
    """½ · 1.225 · 1.2 · 38 · 120² N = 402 kN on 45 t, of 441 kN: 91 %."""
    said = with_advice(blown(120.0), "module", NO_STEP)
    assert said == f"{NO_STEP}; the wind of 120.0 m/s pushes module with 402 kN, 91 % of its weight"


def test_a_breeze_is_not_blamed() -> None:
    """12 m/s push with 4 kN, 0.9 % of its weight."""
    assert with_advice(blown(12.0), "module", NO_STEP) == NO_STEP


def test_statics_say_so() -> None:
    """Nothing but friction, which statics leave out, keeps a module on the ground in 120 m/s."""
    with pytest.raises(NoEquilibriumError) as error:
        Statics(blown(120.0)).equilibrium(0.0)
    assert error.value.cause.endswith("pushes module with 402 kN, 91 % of its weight")


@pytest.mark.parametrize(("heading", "pushed"), [(0.0, 1.0), (60.0, 0.5), (90.0, 0.0)])
def test_push_is_that_of_the_areas_as_they_stand(heading: float, pushed: float) -> None:
    """½ρCAu² sin α of an area at α to the wind, as in (WC1); here α is 90° less the heading."""
    lift = blown(20.0).changed({"load.heading": f"{heading} deg"})
    assert lift.load is not None and isinstance(lift.wind, Wind)
    whole = 0.5 * 1.225 * 1.2 * 38.0 * 20.0**2
    found = lift.wind.push(lift.load.areas_in("wind"), lift.load.heading)
    assert found == pytest.approx(pushed * whole, abs=1e-9)
