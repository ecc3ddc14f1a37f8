"""Loads that go through decks were told of hulls that are boxes alone: of one from a file nothing was said.

The same barge of 4 m that draws 2 m as a file, with a forecastle of 3 m more on its forward 10 m: through her
deck, and through the top of the forecastle 3 m sooner.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.hydro import box_hull
from gantline.scenario import load_scenario
from lift_text import changed
from module_lift import BARGE, module_lift

#: Underside of the module, deck and top of the forecastle over the water [m].
UNDERSIDE, DECK, FORECASTLE = 12.0, 2.0, 5.0
#: Sizes of hull and forecastle, and the middles of their bottoms [m].
PARTS = [((40.0, 12.0, 4.0), (20.0, 0.0, 0.0)), ((10.0, 12.0, 3.0), (35.0, 0.0, 4.0))]


def _told(folder: Path, by: float, x: float) -> list[str]:
    """What is said of a way down by a length over a place along her [m]."""
    lines, count = [], 1
    for size, bottom in PARTS:
        vertices, triangles = box_hull(size).mesh
        middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2 * [1, 1, 0]
        lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in (vertices - middle + bottom).tolist()]
        lines += ["f " + " ".join(str(corner + count) for corner in one) for one in triangles.tolist()]
        count += len(vertices)
    (folder / "hull.obj").write_text("\n".join(lines) + "\n", encoding="utf-8")
    around = changed(BARGE, ("{box: [40 m, 12 m, 4 m]}", "{mesh: hull.obj}"))
    text = module_lift(by, place=(x, UNDERSIDE), speed=30.0, duration=45.0, around=around)
    (folder / "scenario.yaml").write_text(text, encoding="utf-8")
    doubts = assemble(load_scenario(folder / "scenario.yaml")).doubts
    return [one.sentence for one in doubts if "lets them touch" in one.sentence]


@pytest.mark.parametrize(("x", "top"), [(20.0, DECK), (35.0, FORECASTLE)])
def test_a_way_down_through_what_is_highest_there(tmp_path: Path, x: float, top: float) -> None:
    """By what it goes down more than to the deck there."""
    [told] = _told(tmp_path, 11.0, x)
    deep = f"{11.0 - (UNDERSIDE - top):.2f} m"
    assert told.startswith(f"step 'lower' lets module down over barge, to {deep} below her deck or deeper")


@pytest.mark.parametrize(("x", "by"), [(20.0, 9.0), (35.0, 6.5), (45.0, 12.0)])
def test_above_it_or_beside_her_nothing_is_said(tmp_path: Path, x: float, by: float) -> None:
    assert _told(tmp_path, by, x) == []
