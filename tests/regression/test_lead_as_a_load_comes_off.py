"""A crawler crane on soft ground set a nacelle down, and its off-lead was 372 % of what its chart allows.

It had 2 % of its load in its hook then, and sprang back. The check fails by that as it stands, since charts
say no load from which on their lead counts, but it did not say how little the hook bore, nor what the lead
had come to while it bore more: nobody could tell a boom that is pulled aside from one that is let go.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks.check import Check, Verdict
from of_recording import check_of
from rated_lift import recording

#: In the hook, after 9 t of hook block and falls [t]; the chart of the recording allows 1 deg.
BORNE = np.array([[100.0], [60.0], [24.0], [2.0]])


def _check(*leads: float) -> Check:
    of = recording([[14.0]] * 4, (BORNE + 9.0).tolist(), lead=np.radians([[one] for one in leads]))
    return check_of(of, "attitude_of_rating")


def test_a_lead_under_little_load_is_told_beside_that_under_more() -> None:
    """24 t are less than a quarter of 100 t, 60 t are more."""
    found = _check(0.1, 0.8, 2.0, 3.7)
    assert (found.verdict, found.element) == (Verdict.FAILED, "off_lead H0")
    assert found.value == pytest.approx(3.7)
    assert found.remark == (
        "off_lead of 3.70 deg with 19.6 kN in H0, 2 % of its most; with a quarter of that and more 0.80 deg"
    )


@pytest.mark.parametrize("leads", [(0.1, 1.7, 1.2, 0.3), (0.1, 0.8, 0.9, 0.7)])
def test_one_under_load_or_within_its_limit_needs_no_word(leads: tuple[float, ...]) -> None:
    assert _check(*leads).remark == ""
