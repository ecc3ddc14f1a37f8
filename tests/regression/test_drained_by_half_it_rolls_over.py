"""Of a load that hung still with its tank half drained it was not known whether it stays upright.

Of what has run through holes no plan knows, and so equilibria were asked at the end of a run alone; of
every hold before that the check `hangs_stably` warned, "no equilibrium was found", of loads that hang
upright and of those that roll over. The run knows what was in the tank, and they are asked with that.

A load of 120 t hangs by two lugs in a line, 0.5 m above its centre of gravity, with a tank of 10 by 5.5 m
under its deck: with m in it at the height z its righting lever about that line is

120 t · 0.5 m + m (4 m - z) - rho L B^3/12 ,

the last, of 142 t m, while it has a surface. Full or empty it hangs upright; by half it does not.
"""

from __future__ import annotations

from typing import Any

import pytest

from gantline.checks import Verdict
from gantline.results import Recording
from gantline.simulation import Simulation
from of_recording import checks_of
from tanked_load import OWN, SEA, SIZE, hold, lift, tank

HOIST = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
LENGTH, DEPTH, BOTTOM, LUGS, HIGH = 10.0, 0.8, 3.0, 4.0, 3.5


def righting(breadth: float, share: float) -> float:
    """Moment by the tilt [kg m] with the tank full to a share."""
    mass = SEA * LENGTH * breadth * DEPTH * share
    surface = SEA * LENGTH * breadth**3 / 12 if 0.0 < share < 1.0 else 0.0
    return OWN * (LUGS - HIGH) + mass * (LUGS - BOTTOM - 0.5 * DEPTH * share) - surface


def drained_by_half(breadth: float) -> Recording:
    """It hangs full for 10 s, drains for a while, is held, and drains."""
    content = SEA * LENGTH * breadth * DEPTH / 1e3
    own = tank((0, 0, BOTTOM), content, (LENGTH, breadth, DEPTH))
    drain = {"at": ["0 m", "0 m", f"{BOTTOM} m"], "area": "0.4 m^2", "closed": True}
    plan: list[dict[str, Any]] = [
        hold("full", "10 s"),
        hold("drain", f"{2.2 * breadth} s") | {"open_holes": "drain"},
        hold("half", "20 s") | {"close_holes": "drain"},
        hold("empty", "until_end") | {"open_holes": "drain"},
    ]
    reach = SIZE[0] / 2 - 1.0
    sides = {"fore": reach, "aft": -reach}
    more: dict[str, Any] = {
        "load": {
            "centre_of_gravity": {"at": ["0 m", "0 m", f"{HIGH} m"]},
            "lugs": {name: {"at": [f"{x} m", "0 m", f"{LUGS} m"]} for name, x in sides.items()},
        },
        "cranes": {
            name: {"type": "fixed_hook", "at": [f"{x} m", "0 m", "30 m"], "hoist": HOIST}
            for name, x in sides.items()
        },
        "slings": {
            name: {"from": name, "to": f"module.{name}", "rope": "stiff", "length": "16 m"} for name in sides
        },
    }
    tanks = {"inside": own | {"holes": {"drain": drain}}}
    return Simulation(lift(tanks, plan, duration="120 s", **more)).run()


def share_at(run: Recording, time: float) -> float:
    """How full the tank is [1]."""
    content = run.column("tank_content", "module.inside")
    return float(content[run.time <= time][-1] / content[0])


@pytest.mark.parametrize(("breadth", "stays"), [(5.5, False), (3.0, True)])
def test_it_is_asked_with_what_was_in_its_tank(breadth: float, stays: bool) -> None:
    """By half, with a surface 5.5 m wide, a push rolls it over; with one of 3 m nothing is to be said."""
    run = drained_by_half(breadth)
    held = 10.0 + 2.2 * breadth + 10.0
    share = share_at(run, held)
    assert 0.2 < share < 0.8
    assert (righting(breadth, share) > 0.0) is stays
    assert righting(breadth, 1.0) > 0.0
    found = checks_of(run, "hangs_stably")
    if stays:
        assert not found
    else:
        (check,) = found
        assert check.verdict is Verdict.FAILED, check.remark
        assert check.time == pytest.approx(held + 10.0, abs=1.0)
