"""A vessel that capsizes by a weight put aside was told of its GM alone: 23.43 m, and "it capsizes".

The hull's 3200 t of a barge at y = 30 m in place of 3 m: what it weighs lay 12 m to port of what it
displaces, of which the message said nothing. Nor did it say where to look where its own weights lie well,
as of one that lines or towers pull over.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import BREADTH, DRAFT, KG, LENGTH, MASS, barge, lift_of, written
from gantline.statics import NoEquilibriumError, Statics

#: KM = T/2 + B^2/12T of a box, less KG [m].
GM = DRAFT / 2 + BREADTH**2 / (12 * DRAFT) - KG
SAID = (
    "it capsizes before it comes to rest; its masses and tanks alone are 12300 t, their centre 5.00 m above "
    f"the keel, which gives it a GM of {GM:.2f} m at its draft"
)


def cause(folder: Path, x: float, y: float) -> str:
    masses = {"hull": {"mass": f"{MASS} kg", "at": [f"{x} m", f"{y} m", f"{KG} m"]}}
    with pytest.raises(NoEquilibriumError) as caught:
        Statics(written(folder, lift_of(barge(masses=masses)))).equilibrium()
    return caught.value.cause


@pytest.mark.parametrize(
    ("x", "y", "beside"),
    [
        (LENGTH / 2, 14.0, "14.00 m to port"),
        (LENGTH / 2 + 4.0, -14.0, "4.00 m ahead and 14.00 m to starboard"),
        (10 * LENGTH / 2, 0.0, "450.00 m ahead"),
    ],
)
def test_what_lies_aside_is_told(tmp_path: Path, x: float, y: float, beside: str) -> None:
    aside = f"but that centre is {beside} of the one of its hull below the water"
    assert cause(tmp_path, x, y) == f"{SAID}; {aside}"


def test_what_else_is_on_it_is_told(tmp_path: Path) -> None:
    """A tower of 6000 t, 60 m above the keel, which is a body of its own."""
    tower = {"parent": "barge", "at": ["50 m", "1 m", "60 m"], "joint": {"type": "fixed"}, "mass": "6000 t"}
    inertia = {"xx": "1e6 t m^2", "yy": "1e6 t m^2", "zz": "1e6 t m^2"}
    given = lift_of(barge(), mechanics={"bodies": {"tower": tower | {"inertia": inertia}}})
    with pytest.raises(NoEquilibriumError) as caught:
        Statics(written(tmp_path, given)).equilibrium()
    other = "what else is on it or pulls it turns it over: cranes, loads, mooring lines, fenders"
    assert caught.value.cause == f"{SAID}; {other}"
