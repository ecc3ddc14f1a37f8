"""A crane that bore a column alone was 100 % of its chart by the factor for several cranes, without a word.

The tailing crane had let go: its slings were slack to the end. The rule keeps capacity back of cranes that
share a load; whether it still does where one has it all, no rule known here says. The factor stays, and the
check says so, with what the crane uses without it and what it used while both bore.
"""

from __future__ import annotations

from typing import Any

import pytest

from gantline.checks.check import Check, Verdict
from of_recording import check_of
from rated_lift import recording

FACTORS = {"several_cranes_factor": {"value": 1.25, "source": "our rule"}}
TWO = ("c1", "c2")


def of(last: list[float], **given: Any) -> Check:
    """Hoist loads of two cranes at 16 m, 231 t rated: 120 and 100 t, then others."""
    settings: dict[str, Any] = {"cranes": TWO, "factors": FACTORS, **given}
    return check_of(recording([[16.0] * 2] * 2, [[120.0, 100.0], last], **settings), "hoist_load_of_rating")


def test_what_one_uses_alone_is_told_without_the_factor() -> None:
    """200 x 1.25 of 231 t alone, 120 x 1.25 while both bear."""
    found = of([200.0, 0.0])
    assert (found.verdict, found.element) == (Verdict.FAILED, "crane c1")
    assert found.value == pytest.approx(200 * 1.25 / 231)
    assert found.remark == (
        "the factor of 1.25 is for cranes that share a load, and no rule known here says that it ends where "
        f"one bears it alone, as c1 does for a while; crane c1 uses {100 * 200 / 231:.1f} % there without "
        f"it, and with it at most {100 * 120 * 1.25 / 231:.1f} % while others bear too"
    )


def test_nothing_is_said_within_the_limit_nor_while_both_bear() -> None:
    assert not of([150.0, 0.0]).remark
    assert not of([200.0, 5.0]).remark
    assert "c1 does for a while" in of([150.0, 0.0], limits={"hoist_load_of_rating": 0.8}).remark
