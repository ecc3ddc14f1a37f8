"""`59 % of gate hangs before the plan begins`, and its hooks had 16 % of it.

A dock gate stood on its sill, 12 m of it in water, which bore 42 %. `load_transferred` counts what supports
do not bear, so that steps `until: {load_transferred: 50 %}` moved nothing; the warning said that the hooks
had it."""

from __future__ import annotations

import gantline
from four_slings import LIFT
from gantline.checks import check_recording
from gantline.scenario import parse_scenario

#: Wholly wet: 20 m^3 of sea water are 20.5 t of 40 t and the rigging on it.
WET = LIFT.replace(
    "  stands_on: ground\n",
    "  stands_on: ground\n"
    "  in_water: {displaced_volume: 20 m^3, added_mass: [20 t, 20 t, 20 t], drag_coefficients: [1, 1, 1]}\n",
).replace("duration: 70 s\n", "duration: 5 s\nwater: {level: 10 m}\n")
FIRST = "plan:\n"
HALF = "  - {step: half, hoist: crane, speed: 1 m/min, until: {load_transferred: 50 %}}\n"


def test_what_water_bears_does_not_hang() -> None:
    checks = check_recording(gantline.simulate(parse_scenario(WET.replace(FIRST, FIRST + HALF))))
    [check] = [one for one in checks if one.name == "plan_moves"]
    assert check.remark == (
        "what it waits for held as it began, and nothing moved: half; 51 % of module is borne by the water "
        "and its slings before the plan begins"
    )
