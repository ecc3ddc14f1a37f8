"""Used 0.0 % of a clearance with 4 mm left.

A margin must not be below 0; its share of that limit was worked out as 0 over the margin, 0.0 % whether 20 m
were left or 4 mm, in the column in which 0 % means that nothing is used.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict, governing, verdict_of


def margin(value: float, verdict: Verdict = Verdict.OK) -> Check:
    return Check("clearance_margin", verdict, "", value=value, limit=0.0, at_least=True, unit="m")


@pytest.mark.parametrize("left", [0.004, 20.0])
def test_a_margin_has_no_share(left: float) -> None:
    check = margin(left)
    assert check.utilisation is None
    assert "nearest" not in verdict_of([check])


def test_what_is_beyond_its_margin_governs_still() -> None:
    used = Check("load_tilt", Verdict.FAILED, "", value=2.0, limit=1.0)
    gone = margin(-0.004, Verdict.FAILED)
    assert governing([used, gone]) is gone
    # A bound that is not 0 has a share as before: 0.5 m asked for, 2 m there.
    assert Check("freeboard", Verdict.OK, "", value=2.0, limit=0.5, at_least=True).utilisation == 0.25
