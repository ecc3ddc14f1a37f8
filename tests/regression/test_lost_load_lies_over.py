"""A vessel that swung far over its stern lay over sideways, and where that was followed rounding.

As the stern of the floating crane goes under, the water's section that holds it about its length shrinks:
near 9.84 deg it begins to lean, and near 10.16 deg it turns over. Each search for that lean began at its
nearest neighbour, also at one beyond which had turned over already, so that the end was found where rounding
had it: 10.08, 10.09 or 10.12 deg on three kinds of processor, A2/A1 from 28.71 to 28.84.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from gantline.hydro import Hull, Righting
from gantline.statics import Statics
from gantline.study import lose_load, lost_load
from gantline.study.lost_load import Swing

SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "floating_crane"
#: Angles are found to this [rad].
FOUND = 1e-10


@cache
def asked() -> tuple[Any, ...]:
    """What the swing of the crane without its load is measured of: the lift is brought to rest once."""
    every: list[tuple[Any, ...]] = []
    measured = lost_load._swing

    def noted(*given: Any) -> Swing | None:
        every.append(given)
        return measured(*given)

    question = Statics(SCENARIO)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lost_load, "_swing", noted)
        lose_load(question, question.equilibrium(), "load")
    (one,) = every
    return one


def swing_of(share: float) -> tuple[Swing, Righting]:
    """The crane without its load, with this share of its weight."""
    kept = []

    def weighed(hull: Hull, mass: float, centre: npt.ArrayLike, *, density: float) -> Righting:
        kept.append(Righting(hull, mass * share, centre, density=density))
        return kept[0]

    given = asked()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lost_load, "Righting", weighed)
        swing = lost_load._swing(*given)
    assert swing is not None
    return swing, kept[0]


def test_the_end_is_where_nothing_holds_it_across() -> None:
    """At a fold the metacentric height across goes to zero as the root of the angle that is left.

    It is 0.0416 m at 10.161 deg, 4.2e-6 rad before, so 0.0416 sqrt(1e-10/4.2e-6) = 2e-4 m there.
    """
    swing, righting = swing_of(1.0)
    assert swing.vanishing is not None
    last = righting.at(swing.vanishing)
    assert 0.0 < last.across < 1e-3
    assert abs(last.trim) < np.radians(30.0)  # it leans, and has not turned over
    beyond = righting.at(swing.vanishing + 2.0 * FOUND)
    assert beyond.arm < 0.0 or beyond.across <= 0.0


def test_rounding_does_not_move_it() -> None:
    (swing, _), (other, _) = swing_of(1.0), swing_of(1.0 - 1e-12)
    assert other.vanishing == pytest.approx(swing.vanishing, abs=2.0 * FOUND)
    # The work over the weight changes by the arm there, less than 20 m, times the angle.
    assert other.taken == pytest.approx(swing.taken, abs=20.0 * 2.0 * FOUND)
