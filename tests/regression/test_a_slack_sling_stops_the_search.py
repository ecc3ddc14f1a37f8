"""What keeps lengths of slings from being found is told with the slings that are slack.

Of four slings under one hook one is 0.2 m too long, and it or that across from it hangs slack. The search for
a level load stopped where it goes taut and said `no change betters it any more; 0.0068 is left of the slope
along y [rad]`: not what is slack, though the page on wanted attitudes says that this is named. Whoever wanted
a share for it too was told that `lengths of slings do not act on what is wanted`: its own does, once taut.
Level alone can be had as well, by lengths with which all four bear.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.results import series
from gantline.scenario import Scenario, parse_scenario
from gantline.study import CannotBeError, LengthAnswer, adjust_lengths
from hooked_lift import TWO_HOOKS_LUGS, hooked_lift
from mechanics import G

CENTRES = [(0.3, 0.0), (0.0, 0.4), (0.0, 0.2)]


def four_slings(centre: tuple[float, float]) -> Scenario:
    """S4 is too long, so the diagonal from it to S1 bears little."""
    lengths = zip(TWO_HOOKS_LUGS, (12.7, 12.7, 12.7, 12.9), strict=True)
    return parse_scenario(
        hooked_lift(
            {"hook": (0.0, 0.0, 22.0)}, TWO_HOOKS_LUGS,
            {f"S{lug}": ("hook", lug, length) for lug, length in lengths},
            centre=(*centre, 2.0), position=(0.0, 0.0, 6.4),
        )
    )  # fmt: skip


def test_what_is_slack_is_named() -> None:
    """The centre of gravity is nearer to S4, so that S1 is slack; S2 and S3 alone cannot do it."""
    with pytest.raises(CannotBeError, match=r"; slack: S1$"):
        adjust_lengths(four_slings(CENTRES[0]), slopes=(0.0, 0.0), slings=["S2"])


@pytest.mark.parametrize("centre", CENTRES)
def test_level_alone_is_had_with_shares_that_are_even(centre: tuple[float, float]) -> None:
    """Σ V = W and Σ V (x, y) = W c, lugs at ±a, ±b: Σ V² is least by V = W/4 (1 + x c_x/a² + y c_y/b²)."""
    answer = adjust_lengths(four_slings(centre), slopes=(0.0, 0.0))
    assert answer.slack_by_least_change
    expected = [
        0.25 * (1.0 + x * centre[0] / 4.0**2 + y * centre[1] / 2.0**2) for x, y, _ in TWO_HOOKS_LUGS.values()
    ]
    assert upright(answer) == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize("centre", CENTRES)
@pytest.mark.parametrize("share", [0.1, 0.2])
def test_a_sling_that_is_slack_takes_the_share_that_is_wanted(
    centre: tuple[float, float], share: float
) -> None:
    """Level lugs at x = ±4 m, y = ±2 m: forces meet in the hook, so Σ V = W and Σ V (x, y) = W c."""
    answer = adjust_lengths(four_slings(centre), slopes=(0.0, 0.0), shares={"S4": share})
    assert min(answer.before.tension(f"sling.S{lug}") for lug in TWO_HOOKS_LUGS) == 0.0
    aft, ahead = (0.5 * (1.0 - centre[1] / 2.0), 0.5 * (1.0 + centre[0] / 4.0))
    expected = [1.0 + share - aft - ahead, aft - share, ahead - share, share]
    assert upright(answer) == pytest.approx(expected, abs=1e-7)


def upright(answer: LengthAnswer) -> list[float]:
    """Vertical forces of the slings over the weight [1]."""
    shares = []
    for lug in TWO_HOOKS_LUGS:
        top, bottom = (one[-1] for one in series.rope_ends(answer.after.recording, f"sling.S{lug}"))
        along = (top - bottom) / np.linalg.norm(top - bottom)
        shares.append(float(answer.after.tension(f"sling.S{lug}") * along[2] / (200e3 * G)))
    return shares
