"""What keeps lengths of slings from being found is told with the slings that are slack.

Of four slings under one hook one is 0.2 m too long, and that across from it hangs slack. The search stopped where
it goes taut and said `no change betters it any more; 0.0068 is left of the slope along y [rad]`: not what is
slack, which one has to know to take it in first. The page on wanted attitudes says that this is named.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.study import CannotBeError, adjust_lengths
from hooked_lift import TWO_HOOKS_LUGS, hooked_lift


def test_what_is_slack_is_named() -> None:
    """S4 is too long, so the diagonal from it to S1 bears little; the centre of gravity is nearer to S4."""
    lengths = zip(TWO_HOOKS_LUGS, (12.7, 12.7, 12.7, 12.9), strict=True)
    text = hooked_lift(
        {"hook": (0.0, 0.0, 22.0)}, TWO_HOOKS_LUGS,
        {f"S{lug}": ("hook", lug, length) for lug, length in lengths},
        centre=(0.3, 0.0, 2.0), position=(0.0, 0.0, 6.4),
    )  # fmt: skip
    with pytest.raises(CannotBeError, match=r"is left of the slope along y \[rad\]; slack: S1$"):
        adjust_lengths(parse_scenario(text), slopes=(0.0, 0.0))
