"""Supports at 97 % of the simulated weight were a GO though the design weight is 5 % more: 101.8 % of them.

Hooks, slings and lugs are held against the design weight; supports were held against the simulated one alone.
"""

import pytest

from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from hooked_lift import hooked_lift
from mechanics import G
from of_recording import checks_of

LUGS = {"1": (3.0, 0.0, 4.0), "2": (-3.0, 0.0, 4.0)}
MASS, SHARE = 200e3, 0.97
#: Four supports share the load.
CAPACITY = MASS * G / 4 / SHARE


def lift(weight: str) -> str:
    """200 t on four supports below its corners, that a hook lifts off."""
    slings = {f"S{lug}": ("hook", lug, 10.0) for lug in LUGS}
    text = hooked_lift({"hook": (0.0, 0.0, 13.4)}, LUGS, slings, centre=(0.0, 0.0, 2.0), mass=MASS)
    supports = (
        "supports: {stools: {under: load, grid: {x: [-4 m, 4 m], y: [-2 m, 2 m]}, height: 1 m, "
        f"stiffness: 200 MN/m, damping: 2 MN s/m, capacity: {MASS / 4 / SHARE / 1e3!r} t}}}}"
    )
    text = text.replace("start: as_given", f"ground: {{level: -1 m}}\n{supports}")
    text = text.replace("weight: {calculated: 200.0 t}", f"weight: {weight}")
    return f"{text}plan:\n  - {{step: up, hoist: hook, speed: 0.1 m/s, by: 0.5 m}}\n"


@pytest.mark.parametrize(
    ("weight", "used", "verdict"),
    [
        ("{calculated: 200 t}", SHARE, Verdict.OK),
        ("{calculated: 200 t, contingency: 1.05, simulate: calculated}", 1.05 * SHARE, Verdict.FAILED),
        ("{calculated: 200 t, contingency: 1.05, simulate: design}", 1.05 * SHARE, Verdict.FAILED),
    ],
)
def test_supports_bear_the_design_weight(weight: str, used: float, verdict: Verdict) -> None:
    """m g/4 on each, over its capacity."""
    rest = Statics(parse_scenario(lift(weight))).equilibrium(0.0)
    (check,) = checks_of(rest.recording, "support_force_of_capacity")
    assert check.value == pytest.approx(used, rel=1e-6)
    assert check.verdict is verdict
    assert check.formula == (
        "(490.5 kN x 1.05 to the design weight) / 505.7 kN" if "simulate: calculated" in weight
        else f"{used * CAPACITY / 1e3:.1f} kN / 505.7 kN"
    )  # fmt: skip
