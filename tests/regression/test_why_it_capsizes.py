"""Why a vessel capsizes on its way to rest.

A centre of gravity at 22 m of a cargo barge, a digit too many, was answered with "it capsizes before it comes
to rest" and no number. Its own masses and tanks say what GM they leave it, and of one that sinks what it
weighs and what its hull displaces.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import BREADTH, DRAFT, LENGTH, barge, lift_of, written
from floating import SEA
from gantline.statics import NoEquilibriumError, Statics


def test_what_capsizes_says_its_gm(tmp_path: Path) -> None:
    """12 300 t with the centre at 22 m and 820 t in a full tank at 4 m: KG of both is 20.875 m.

    KM = T/2 + B^2/12T of a box, 20.75 m: GM = -0.125 m.
    """
    tank = {"box": ["20 m", "5 m", "8 m"], "bottom": ["50 m", "0 m", "0 m"], "content": "820 t"}
    masses = {"hull": {"mass": f"{SEA * LENGTH * BREADTH * DRAFT} kg", "at": ["50 m", "0 m", "22 m"]}}
    question = Statics(written(tmp_path, lift_of(barge(masses=masses, heel="2 deg", tanks={"full": tank}))))
    with pytest.raises(NoEquilibriumError) as caught:
        question.equilibrium()
    centre = (12300 * 22 + 820 * 4) / 13120
    assert DRAFT / 2 + BREADTH**2 / (12 * DRAFT) - centre == -0.125  # of which halves go away from zero
    assert caught.value.cause == (
        "it capsizes before it comes to rest; its masses and tanks alone are 13120 t, their centre "
        f"{centre:.2f} m above the keel, which gives it a GM of -0.13 m at its draft"
    )
