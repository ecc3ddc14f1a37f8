"""Slings that cut through the corner of their load, and no line on distances.

The trunnions of a column stood too near to its head, and its slings ran 0.15 m inside the edge. With
slings and column under `watch` the lift failed; without a `watch` the check was left out of the table
altogether, as for a lift that has nothing of the kind. Every load has slings that may run through it.
"""

from __future__ import annotations

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

#: A lug at the bottom: its sling runs up inside the load.
THROUGH = LIFT.replace("A: {at: [-2.5 m,  1.5 m, 3 m]", "A: {at: [-2.5 m,  1.5 m, 1 m]").replace(
    "to: module.A, length: 8.6 m", "to: module.A, length: 10.42 m"
)
WATCH = "watch: [{between: [slings, module], smallest: 0.1 m}]\n"


def clearance(text: str) -> Check:
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return next(one for one in checks if one.name == "clearance_margin")


def test_what_nobody_watches_is_not_checked_and_says_so() -> None:
    found = clearance(THROUGH)
    assert found.verdict is Verdict.NOT_CHECKED
    assert found.remark == "no pair under 'watch', not even slings and load: module"


def test_what_is_watched_is_checked() -> None:
    """A metre from the lug is left out; the next is inside the box, which the sling leaves at its top."""
    assert clearance(THROUGH + WATCH).verdict is Verdict.FAILED
    assert clearance(LIFT + WATCH).verdict is Verdict.OK
