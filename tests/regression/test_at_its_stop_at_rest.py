"""A sheave that stands at its stop "would have met its stop, which is not simulated".

An equilibrium has no event of a stop that is met. So the check of travel took a lift with `stops: true` for
one without: a sheave 2 mm into its stop was told as one whose stop nobody simulates, which reads as if its
tensions were those of a sheave that runs on.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict
from of_recording import check_of


@pytest.mark.parametrize(
    ("stops", "told"),
    [
        (True, "it stands at its stop, which gives"),
        (False, "it would have met its stop, which is not simulated"),
    ],
)
def test_what_is_said_of_a_sheave_past_its_stroke_at_rest(stops: bool, told: str) -> None:
    """Sheaves of the reference lift go up by 1.2 m (EZ3) at rest, beyond 0.8 m, with a stop or without."""
    changes = {"equalizers.e1.travel.stops": stops, "equalizers.e1.travel.up": "0.8 m"}
    rest = gantline.Statics(gantline.load_scenario("equalizer").changed(changes)).equilibrium()
    check = check_of(rest.recording, "equalizer_travel_used")
    assert check.verdict is Verdict.FAILED
    assert check.value is not None and check.value > 1.0
    assert check.remark.endswith(told)
