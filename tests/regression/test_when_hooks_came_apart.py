"""A hook 10 cm behind was told with the time of a ripple in its ropes, the first page without.

Two cranes hoist a house, one of them 10 cm ahead from 170 s on. Both then go up side by side for two minutes,
while the falls ring by tenths of a millimetre: `hook_level_difference` had 259.48 s, the highest of these
crests, in the step after the one that brought the hooks apart. The first page of the report had the value
and the limit alone, also of what a step requires at its end, whose name it left out.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks.measure import Found, extreme
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results import Recording
from sample_lift import ringing_lift, sample_recording, sample_rig


def verdict(recording: Recording) -> list[str]:
    """What the first page says of each failed check and warning."""
    found = FirstPage().content(Subject(recording))["verdict"]
    assert isinstance(found, dict)
    return [f"{one['about']}: {one['text']}" for one in [*found["failed"], *found["warned"]]]


@pytest.mark.parametrize(("alike", "when"), [(0.0, 7.0), (0.5e-3, 4.0)])
def test_a_series_that_stays_came_there_when_it_first_did(alike: float, when: float) -> None:
    """It comes to 0.1 m at 4 s; the highest crest, 0.2 mm more, is at 7 s, and is the value."""
    recording = sample_recording(np.arange(11.0), tension=np.full((11, 5), 600e3))
    apart = np.array([0.0, 0.0, 0.0, 0.05, 0.1, 0.1001, 0.0999, 0.1002, 0.1, 0.1001, 0.1])
    (found,) = extreme(recording, apart, np.ones(11, dtype=bool), "A to B", alike=alike)
    assert isinstance(found, Found)
    assert (found.value, found.time) == (0.1002, when)


def test_the_first_page_says_when_a_limit_was_passed() -> None:
    subject = Subject(ringing_lift(rig=sample_rig(sling_angle_from_vertical=1e-3)))
    (check,) = [one for one in subject.checks if one.name == "sling_angle_from_vertical"]
    assert check.time is not None
    (said,) = [one for one in verdict(subject.recording) if one.startswith("sling angle from vertical")]
    step = subject.step_at(check.time)
    assert said.endswith(f", at {check.time:.1f} s" + (f", “{step}”" if step else ""))


def test_the_first_page_says_which_step_asked_for_it() -> None:
    rig = sample_rig()
    rig["plan"] = [
        {"step": "hoist", "kind": "hoist", "require": {"sling_angle_from_vertical": {"below": 1e-3}}}
    ]
    (said,) = [one for one in verdict(ringing_lift(rig=rig)) if one.startswith("sling angle from vertical")]
    assert said.endswith(", at the end of “hoist”")
