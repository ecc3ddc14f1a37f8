"""Bars of travel in reports whose colour was not that of the check, and "1 times" beside a stop.

From 90 % of a stroke on they warned, whatever the limit of the lift: with a limit of 80 % a sheave at 85 %
was a warning among the checks, "stop if a sheave is over 80 %" on the first page, and a green bar below. A
stop that was met once was met "1 times".
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.report.tables import Equalizers
from gantline.results.recording import Recording
from of_recording import checks_of
from sample_lift import sample_recording, sample_rig

TONES = {Verdict.OK: "good", Verdict.WARNING: "warn", Verdict.FAILED: "bad"}


def recording(used: float, **given: float) -> Recording:
    """The load hangs all along, its second moving sheave this share of its stroke down; one met its stop."""
    rig = sample_rig(**given)
    travel = np.zeros((3, 5))
    travel[:, 1] = used * rig["equalizers"][0]["travel_down"]
    events = [(0.5, "stop_hit", "e1.2")] if used > 1.0 else []
    return sample_recording(
        np.arange(3.0),
        tension=np.full((3, 5), 6e5),
        contact=np.zeros((3, 4)),
        travel=travel,
        rig=rig,
        events=events,
    )


@pytest.mark.parametrize("used", [0.75, 0.85, 0.92, 1.05])
@pytest.mark.parametrize("limit", [0.8, 0.9, 0.95])
def test_a_bar_warns_where_its_check_does(used: float, limit: float) -> None:
    lift = recording(used, equalizer_travel_used=limit)
    (check,) = checks_of(lift, "equalizer_travel_used")
    content = Equalizers().content(Subject(lift))
    assert content is not None
    bar = content["equalizers"][0]["sheaves"][1]["down_used"]
    assert bar["text"] == f"{100 * used:.0f} %" and bar["tone"] == TONES[check.verdict]
    assert f"a sheave is over {100 * limit:.0f} % of its stroke" in stop_if(Subject(lift))


def test_without_a_limit_it_warns_from_the_usual_one_on() -> None:
    tones = []
    for used in (0.85, 0.92):
        content = Equalizers().content(Subject(recording(used)))
        assert content is not None
        tones.append(content["equalizers"][0]["sheaves"][1]["down_used"]["tone"])
    assert tones == ["good", "warn"]


def test_a_stop_met_once_is_met() -> None:
    content = Equalizers().content(Subject(recording(1.05)))
    assert content is not None
    assert ("stop met", "e1.2 at 0.50 s") in content["equalizers"][0]["facts"]
