"""A hook that goes a little out of its chart, and then farther.

The first sample outside was shown to a centimetre: "radius of 14.00 m is outside of the chart, 10.00 m to
14.00 m". How far the hook got was not said: a tail crane in the wake of a column had been at 15.5 m.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from rated_lift import recording


@pytest.mark.parametrize(
    ("radius", "said"),
    [
        ([17.0, 18.001, 19.5, 18.5], "radius of 18.001 m at 1.00 s (19.50 m at 2.00 s) is outside of"),
        ([17.0, 12.5, 11.999, 11.9995], "radius of 11.999 m at 2.00 s is outside of"),
    ],
)
def test_the_first_and_the_farthest_place_outside_are_told(radius: list[float], said: str) -> None:
    run = recording([[one] for one in radius], [[100.0]] * len(radius))
    (check,) = (one for one in check_recording(run) if one.name == "hoist_load_of_rating")
    assert check.verdict is Verdict.FAILED
    assert f"{said} the chart, 12.00 m to 18.00 m: no lift" in check.remark
