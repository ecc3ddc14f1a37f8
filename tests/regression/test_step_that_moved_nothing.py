"""Steps that were over as they began, and a hold point at half of the load with five sixths of it.

A module was to come off a barge: slack up, half of it over, hold and look. Afloat the two vessels lay a
little otherwise than the lift file had them, and 83 % of the module hung in its slings at 0 s. The steps that
were to take up slack and half of the load found their conditions met and ended at once; no line said so.
"""

from __future__ import annotations

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario

FIRST = "plan:\n"
LAST = "  - {step: hold point, hold: 20 s}\n"
AGAIN = "  - {step: again, hoist: crane, speed: 1 m/min, until: {load_transferred: 50 %}}\n"
#: The hook a metre higher; slings of 8.6 m then hold the lugs 8.1 m below it, the load 0.9 m above ground.
HANGING = LIFT.replace("  stands_on: ground\n", "  position: [0 m, 0 m, 0.95 m]\n").replace("11 m]", "12 m]")


def told(text: str) -> tuple[Check | None, str]:
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return next((one for one in checks if one.name == "plan_moves"), None), verdict_of(checks)


def test_a_step_whose_condition_holds_already_is_told() -> None:
    """The load is clear: that half of it is over needs no hoisting."""
    assert told(LIFT)[0] is None
    found, _ = told(LIFT.replace(LAST, AGAIN + LAST))
    assert found is not None and found.verdict is Verdict.WARNING
    assert found.remark == "what it waits for held as it began, and nothing moved: again"


def test_a_load_that_hangs_before_its_plan_begins_is_told() -> None:
    """Nothing stands under it: all of it hangs at 0 s."""
    text = HANGING.replace(FIRST, FIRST + AGAIN).replace("capacity: 13.2 t", "capacity: 40 t")
    found, verdict = told(text.replace("rated_capacity: 46 t", "rated_capacity: 60 t"))
    assert found is not None
    assert found.remark.endswith(": again, lift off; 100 % of module hangs before the plan begins")
    assert verdict.startswith("GO WITH WARNINGS")
