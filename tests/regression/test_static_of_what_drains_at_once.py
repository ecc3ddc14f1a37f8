"""A tank of 100 t that drained as soon as its load was up left no static force of it in any check.

The load hung still empty, and that was static: its shackles stood at 40 % of their working load limit and
`ok` with a skew load factor of the rule, where the full tank had them at 105 %, and the hook at 84 % of its
rated capacity in place of 109 % with a dynamic factor of 1.3. What a load bears for 5 s as full as in no hold
is static too, as what it bears turned is.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import check_recording
from gantline.checks.check import Check, Verdict
from gantline.results.recording import Recording
from gantline.simulation import simulate
from tanked_load import HOOK, OWN, SIZE, G, document, hold, lift, pump, tank

CONTINGENCY, RATE = 1.05, 0.5e3  # [1], 1800 t/h [kg/s]
CONTENT = 60e3  # [kg]
#: How long a pump takes to its rate, and loads hang still at least [s].
STARTS, STILL = 10.0, 5.0
#: Means of t^2 over that time about its middle and from its begin, by sin^2 as static values are [s^2].
ABOUT = (STILL / 2.0) ** 2 * (1.0 / 3.0 - 2.0 / math.pi**2)
FROM_BEGIN = (STILL / 2.0) ** 2 + ABOUT
#: What is left of the content in the first such time, of which a pump takes R t^2/2 t_s from rest [kg].
LEFT = CONTENT - RATE * FROM_BEGIN / (2.0 * STARTS)
WEIGHT = {"weight": {"calculated": f"{OWN} kg", "contingency": CONTINGENCY}}
#: Upright over length of a sling from one hook to a corner of the load.
UPRIGHT = (HOOK - SIZE[2]) / math.hypot(5.0, 2.5, HOOK - SIZE[2])
#: Two hooks over the lugs, and the tanks between them, along the load [m].
HOOKS, TANKS = {"fore": 5.0, "aft": -5.0}, {"fore": 4.0, "aft": -4.0}
UP_AND_DOWN = [
    {"step": "up", "hoist": "crane", "speed": "6 m/min", "by": "3 m"},
    {"step": "down", "lower": "crane", "speed": "6 m/min", "by": "3 m"},
]


def _drained(**changes: object) -> Recording:
    plan = [pump("drain", ("module.inside", "sea"), "1800 t/h", by="60 t"), hold("empty", "until_end")]
    inside = {"inside": tank((0, 0, 0.5), CONTENT / 1e3, box=(6.0, 5.0, 3.0))}
    return simulate(lift(inside, plan, load=WEIGHT, duration="200 s", **changes))


def _check(recording: Recording, key: str) -> Check:
    return next(check for check in check_recording(recording) if check.name == key)


def test_hook_load_of_a_full_tank_is_static() -> None:
    """(W + what is left in the mean over the first 5 s) g, and contingency on W alone."""
    found = _check(_drained(), "static_hook_load")
    assert found.value == pytest.approx((CONTINGENCY * OWN + LEFT) * G, rel=1e-3)


def test_shackle_bears_a_full_tank() -> None:
    """A quarter of it in each sling, over the cosine of its lean, all of it raised."""
    shackles = {"bow": {"working_load_limit": "60 t"}}
    slings = {name: {**one, "shackles": {"bottom": "bow"}} for name, one in document({})["slings"].items()}
    found = _check(_drained(shackles=shackles, slings=slings), "shackle_load_of_working_load_limit")
    tension = (OWN + LEFT) * G / 4.0 / UPRIGHT
    assert found.value == pytest.approx(CONTINGENCY * tension / (60e3 * G), rel=1e-3)


def test_what_is_pumped_to_one_end_and_back_is_static() -> None:
    """Of two hooks one bears half of the load, and of the liquid a share by levers, as the pump turns."""
    crane = document({})["cranes"]["crane"]
    cranes = {side: {**crane, "at": [f"{x} m", "0 m", f"{10 + HOOK} m"]} for side, x in HOOKS.items()}
    length = math.hypot(2.5, HOOK - SIZE[2])
    of = {"A": "fore", "B": "aft", "C": "aft", "D": "fore"}
    slings = {
        name: {"from": side, "to": f"module.{name}", "rope": "stiff", "length": f"{length!r} m"}
        for name, side in of.items()
    }
    tanks = {side: tank((x, 0, 0.5), 30.0, box=(4.0, 5.5, 3.4)) for side, x in TANKS.items()}
    there, back = ("module.aft", "module.fore"), ("module.fore", "module.aft")
    plan = [
        hold("even"),
        pump("there", there, "1800 t/h", by="30 t"),
        pump("back", back, "1800 t/h", by="30 t"),
    ]
    scenario = lift(
        tanks, [*plan, hold("end", "until_end")], load=WEIGHT, duration="250 s", cranes=cranes, slings=slings
    )
    found = _check(simulate(scenario), "static_hook_load")
    gone = RATE * ABOUT / (2.0 * STARTS)
    arm = (CONTENT - 2.0 * gone) / CONTENT * TANKS["fore"] / HOOKS["fore"]
    borne = OWN / 2.0 + CONTENT * (1.0 + arm) / 2.0
    assert found.element == "fore"
    assert found.value == pytest.approx(CONTINGENCY * borne * G, rel=5e-3)


def test_static_forces_of_a_load_under_water_say_what_they_are_of() -> None:
    """A load that only ever hung still under water has no static force of what it bore higher up."""
    plan = [hold("below"), *UP_AND_DOWN, hold("end", "until_end")]
    water = {
        "displaced_volume": "60 m^3",
        "added_mass": ["20 t", "20 t", "40 t"],
        "drag_coefficients": [1, 1, 1],
    }
    wet = {**WEIGHT, "in_water": water}
    scenario = lift(None, plan, load=wet, duration="120 s", water={"level": "14 m", "depth": "40 m"})
    found = _check(simulate(scenario), "static_hook_load")
    assert found.verdict is Verdict.WARNING
    assert "static force of a time with less to bear" in found.remark
