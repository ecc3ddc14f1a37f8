"""The first page of a lift that fails named three failed checks, the first of the list, and hid the others.

In `equalizer_sling_cut` 13 checks fail. The page told of hook, hoist load and equalizer travel, no numbers,
and neither that a sling had been cut nor that the others were past their breaking force.
"""

from __future__ import annotations

import numpy as np

from gantline.report.carried import sling_rows
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results import Recording
from sample_lift import ringing_lift, sample_recording, sample_rig


def verdict(recording: Recording) -> dict[str, object]:
    found = FirstPage().content(Subject(recording))["verdict"]
    assert isinstance(found, dict)
    return found


def test_every_failure_is_named_the_worst_with_its_numbers() -> None:
    rig = sample_rig(
        equalizer_travel_used=1e-6,
        sling_factor_on_breaking_force=1e3,
        sling_angle_from_vertical=1e-3,
        hook_dynamic_factor=1.0,
        tension_spread_when_clear=1e-9,
    )
    subject = Subject(ringing_lift(rig=rig))
    failed = {check.name.replace("_", " ") for check in subject.checks if check.verdict.value == "failed"}
    assert len(failed) >= 4
    found = verdict(subject.recording)
    shown = found["failed"]
    assert isinstance(shown, list) and len(shown) == 3
    assert all("at most" in one["text"] or "at least" in one["text"] for one in shown)
    every = " ".join([*(one["about"] for one in shown), str(found["failed_too"])])
    assert all(name in every for name in failed)
    assert found["nearest"] == []


def test_a_sling_that_parted_says_so() -> None:
    """Also where there is room for four slings only, as of lifts afloat: parted ones come first."""
    time = np.arange(11.0)
    tension = np.full((11, 5), 600e3)
    tension[:, 4] = 1.0
    tension[time > 5.0, 4] = 0.0
    recording = sample_recording(time, tension=tension, events=[(5.0, "cut", "sling.S5")])
    rows = sling_rows(Subject(recording), 1)[0]
    assert [(row["name"], row["gone"], row["is_parted"]) for row in rows] == [("S5", "cut 5.0 s", True)]
    assert all(row["gone"] == "" for row in sling_rows(Subject(recording), 5)[0][:4])
