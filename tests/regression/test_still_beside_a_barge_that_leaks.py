"""A load that hung still for 40 s beside a barge with a leak, and was told that it never had.

What runs through holes of tanks was booked as work of drives, and a load hangs still while drives do none.
So with a leaking barge anywhere in the lift there were no static forces: 100 t with a contingency of 1.1,
lifted by a hook for 105 t and set down again, was GO WITH WARNINGS at 98 %, by the peak of its simulated
weight alone, with "hold the load still for 5 s". It is 105.3 % and NO-GO, with or without the barge.

It is the fluid's work now. A load that drains itself does not hang still, as before.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from ballasted import ADDED, DAMPED, barge
from ballasted import tank as tank_afloat
from gantline.checks import Verdict
from gantline.results import Recording, series
from gantline.simulation import Simulation
from of_recording import checks_of
from tanked_load import OWN, G, hold, lift, tank

#: A hole in the bottom of its tank.
LEAK = {"at": ["80 m", "0 m", "1 m"], "area": "0.05 m^2"}


def leaking() -> dict[str, Any]:
    """A barge that floods for more than 10 minutes."""
    fore = {**tank_afloat((80.0, 0.0, 1.0), 200.0), "holes": {"leak": LEAK}}
    return barge({"fore": fore}, added_mass=ADDED, water_damping=DAMPED)


def set_down(vessels: dict[str, Any] | None) -> Recording:
    """A load that is hoisted off its supports, hangs for 20 s and is set down again."""
    supports = {"under": "module", "grid": {"x": ["-5 m", "5 m"], "y": ["-2 m", "2 m"]}, "foot": "9 m"}
    supports |= {"height": "1 m", "stiffness": "100 MN/m", "damping": "1 MN s/m", "friction": "0.4"}
    plan: list[dict[str, Any]] = [
        {"step": "off", "hoist": "crane", "speed": "2 m/min", "until": {"supports": "clear"}},
        {"step": "up", "hoist": "crane", "speed": "3 m/min", "by": "0.5 m"},
        hold("look", "20 s"),
        {"step": "down", "lower": "crane", "speed": "3 m/min", "until": {"supports": "touched"}},
        {"step": "slack", "lower": "crane", "speed": "3 m/min", "by": "0.3 m"},
        hold("rest", "until_end"),
    ]
    given: dict[str, Any] = {"supports": {"stools": supports}, "duration": "80 s", "water": {"level": "0 m"}}
    given["load"] = {"weight": {"calculated": f"{OWN} kg", "contingency": 1.1}}
    if vessels is not None:
        vessels["barge"]["position"] = ["0 m", "50 m"]
        given["vessels"] = vessels
    crane = {"type": "fixed_hook", "at": ["0 m", "0 m", "29.9 m"], "rated_capacity": "125 t"}
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    given["cranes"] = {"crane": crane | {"hoist": hoist}}
    return Simulation(lift(None, plan, **given)).run()


def test_a_leak_beside_it_leaves_a_load_still() -> None:
    """132 t of 125 t, as without the barge, by means over the hold: 120 t · g, but for its bounce."""
    run, alone = set_down({"barge": leaking()}), set_down(None)
    assert np.ptp(run.column("tank_content", "barge.fore")) > 10e3
    for one in (run, alone):
        static, _ = series.greatest_static(one, one.column("hook_load", "crane"))
        assert static == pytest.approx(OWN * G, rel=1e-4)
        (check,) = checks_of(one, "hoist_load_of_rated_capacity")
        assert check.verdict is Verdict.FAILED
        assert check.value == pytest.approx(1.1 * OWN / 125e3, rel=1e-4)
        assert not checks_of(one, "hangs_still")


def test_a_leak_is_the_work_of_no_drive() -> None:
    """Drives of hooks that stand and of a barge that nobody pumps do none; jets lose what is the water's."""
    run = set_down({"barge": leaking()})
    at_rest = run.time > 70.0
    assert np.ptp(run.column("energy", "drive_work")[at_rest]) == 0.0
    assert np.all(np.diff(run.column("energy", "fluid_work")[at_rest]) < 0.0)
    assert abs(run.column("energy", "remainder")).max() < 1e-5 * abs(run.column("energy", "gravity")).max()


def test_a_load_that_drains_does_not_hang_still() -> None:
    """Through a hole in its bottom; once it is empty it does."""
    holes = {"valve": {"at": ["0 m", "0 m", "0.5 m"], "area": "0.4 m^2"}}
    run = Simulation(lift({"inside": tank((0, 0, 0.5), 24.0, holes=holes)}, duration="120 s")).run()
    content = run.column("tank_content", "module.inside")
    (still,) = series.quiet_windows(run)
    assert np.ptp(content[still]) == 0.0
    assert content[0] - content[still][0] > 20e3
