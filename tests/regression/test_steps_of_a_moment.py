"""Of a moment pictures and the first page named the step that had begun last, whatever was under way then.

Under two steps that go side by side, one hook up and the other down, a picture of 12 s said the second
alone; so did the first page of the tightest clearance. Between a step that had ended at 20 s and one with a
`start_at` of 30 s both named the one that was over. The player has all that go, and none in between.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from gantline import Recording
from gantline.export.video import write_still
from gantline.report.subject import Subject
from sample_lift import sample_recording

TIME = np.linspace(0.0, 40.0, 41)
BESIDE = [
    (10.0, "step_begin", "up"),
    (10.0, "step_begin", "down"),
    (15.0, "step_end", "down"),
    (20.0, "step_end", "up"),
    (30.0, "step_begin", "next"),
]


def lift(events: list[tuple[float, str, str]]) -> Recording:
    return sample_recording(TIME, tension=np.full((41, 5), 1e5), events=events)


@pytest.mark.parametrize(
    ("time", "names"),
    [(5.0, ""), (10.0, "up + down"), (12.0, "up + down"), (17.0, "up"), (25.0, ""), (40.0, "next")],
)
def test_what_goes_at_a_moment(time: float, names: str, tmp_path: Path) -> None:
    """A picture says it as one of a lift in which one step of these names goes all the time."""
    recording = lift(BESIDE)
    assert Subject(recording).step_at(time) == names
    alone = lift([(0.0, "step_begin", names)] if names else [])
    for name, one in (("given", recording), ("alone", alone)):
        write_still(one, tmp_path / f"{name}.png", time)
    given, other = (np.asarray(Image.open(tmp_path / f"{name}.png")) for name in ("given", "alone"))
    assert (given == other).all()
