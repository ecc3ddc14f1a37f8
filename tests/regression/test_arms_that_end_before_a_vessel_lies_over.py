"""`--lost` of a crane barge is refused for an attitude at 23° of trim, far from where the loss took her.

Arms are followed to where they vanish, or to where the vessel lies over across them, found by halves.
Shortly before she lies over there may be no attitude in which she rests: "no attitude was found in which it
rests" is all that is printed then, of a barge of 8158 t that swings by 0.45° as she loses 120 t. Steps over
angles take such a place for the end of the arms; halves between two of them do not.
"""

from __future__ import annotations

import math
from typing import cast

import pytest

from gantline.hydro.floating import CannotFloatError
from gantline.hydro.righting import Heeled, Righting
from gantline.study.lost_load import _Curve

#: No attitude is found from the first angle on, and the vessel lies over from the second on [deg]; looks are
#: half a degree apart, so that both lie between two of them.
NONE_FROM, OVER_FROM = math.radians(23.2), math.radians(23.4)


class _Arms:
    """Arms of a vessel that rights herself with GM 2 m, as far as she does."""

    def at(self, heel: float) -> Heeled:
        if NONE_FROM <= heel < OVER_FROM:
            raise CannotFloatError("barge: no attitude was found in which it rests")
        across = 1.0 if heel < NONE_FROM else -1.0
        return Heeled(heel, 0.0, 0.0, 2.0 * math.sin(heel), 2.0 * (1.0 - math.cos(heel)), across)


def test_arms_end_where_no_attitude_is_found() -> None:
    looks = _Curve(cast(Righting, _Arms()), {}).looks(0.0)
    assert looks[-1].heel == pytest.approx(NONE_FROM, abs=1e-9)
    assert all(one.across > 0.0 for one in looks)
