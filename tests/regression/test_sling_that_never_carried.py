"""One of four slings ten times too long, and GO without a warning.

86 m for 8.6 m: the load hung in two slings across, a third held its balance, and the fourth lay slack from
the first to the last. Its row of the table said 0.0 kN; no check did, since each sling's own load was within
its limits, and `skew_load_factor` without a limit is not held against anything.
"""

from __future__ import annotations

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario

STRONG = LIFT.replace("capacity: 13.2 t", "capacity: 40 t").replace(
    "rated_capacity: 46 t", "rated_capacity: 60 t"
)
SAFE = STRONG + "limits: {sling_factor_on_breaking_force: 3}\n"


def told(text: str) -> tuple[Check | None, str]:
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return next((one for one in checks if one.name == "slings_carry"), None), verdict_of(checks)


def test_a_sling_that_is_slack_all_the_time_is_told() -> None:
    found, verdict = told(SAFE.replace("module.A, length: 8.6 m", "module.A, length: 86 m"))
    assert found is not None and found.verdict is Verdict.WARNING
    # The one across from it was taut for a moment, as the load came off.
    beside = "slack while the load hangs clear, beside others that carry it: D"
    assert found.remark == f"slack over the whole lift: A; {beside}"
    assert verdict.startswith("GO WITH WARNINGS")


def test_four_that_carry_are_no_matter() -> None:
    found, verdict = told(SAFE)
    assert found is None
    assert verdict.startswith("GO;")


def test_a_load_that_never_hangs_is_not_judged() -> None:
    """All slings are slack while it stands: what is missing then is the lift."""
    assert told(SAFE.replace("speed: 1 m/min, until", "speed: 0.01 m/min, until"))[0] is None
