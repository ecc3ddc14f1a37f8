"""A load cell was to read -128.2 t when a quarter of a jacket leg had come over.

In waves readings follow from what hangs clear of all supports, less what these bear. A load that turns in a
hinge is clear of supports, and half of it is in its hinge: of a leg of 900 t, 547 t in its hook,
547 t - 0.75 * 900 t = -128 t stood on the first page, and 547 t at 100 %.
"""

from __future__ import annotations

import gantline
from gantline.report.carried import hook_row
from gantline.report.subject import ABSENT, Subject
from hinged_mast import MAST, mast
from lift_text import changed

PLAN = """\
  - {step: up, hoist: main, speed: 0.05 m/min, until: {supports: clear}}
  - {step: raise, hoist: main, speed: 6 m/min, by: 2 m}
  - {step: hold, hold: until_end}
"""
SEA = """\
ground: {level: 10 m, friction: 0.3}
water: {level: -20 m}
waves: {sea: {significant_height: 1 m, peak_period: 5 s, direction: 0 deg}}
"""


def _readings(more: str) -> list[str]:
    """Readings at 25, 50, 75 and 100 % of a mast whose head comes off the ground, its foot in a hinge."""
    text = mast(PLAN, hook=(19.0, 0.0, 60.0), more=more)
    text = changed(
        text, ("  weight:", "  stands_on: ground\n  weight:"), ("length: 49.0 m", "length: 49.01 m")
    )
    recording = gantline.simulate(gantline.parse_scenario(changed(text, ("900 s", "150 s"))))
    subject = Subject(recording)
    (hook,) = recording.rig.hooks
    return list(hook_row(subject, hook)["readings"])


def test_nothing_is_said_in_waves() -> None:
    """How hook and hinge share a load that has come over in part waves do not let tell."""
    assert _readings(SEA) == [ABSENT] * 4


def test_without_waves_they_are_read() -> None:
    """The hook lifts at 39 m from the pins what weighs 18 m from them, 46.2 t of 100 t, and no more."""
    still = _readings(SEA.partition("waves")[0])
    assert still[2:] == [ABSENT, ABSENT]
    assert abs(float(still[0]) - 0.25 * MAST / 1e3) < 0.1
