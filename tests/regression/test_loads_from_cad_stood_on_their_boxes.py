"""Loads from CAD that stood on supports by the box around them.

What lay on supports were the sides of the box, of a load from CAD too. A tapered module stood on thin air at
the corners of its box, and nothing told: the four supports there bore an eighth of its weight each, as much
as the four under it, a GO at 62.5 % of their capacity where these bear a quarter, 125 %. A support under the
air beside a bow, one that stood within the load, and one under a hollow that the hull closes passed
`gantline check` without a word.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cad_loads import LEVEL, assembled, cad_lift, convex
from gantline.cad.mesh import TriangleMesh
from gantline.scenario import ScenarioError
from hull_lift import G, simulated
from solids import box

#: 16 m by 12 m above, 12 m by 6 m below: the long sides rise by 53°, the ends by 63°.
TAPERED = convex(
    [(x, y, 0.0) for x in (-6.0, 6.0) for y in (-3.0, 3.0)]
    + [(x, y, 4.0) for x in (-8.0, 8.0) for y in (-6.0, 6.0)]
)
#: A point ahead, at x = 8 m.
BOW = convex([(x, y, z) for x, y in ((-8.0, -5.0), (-8.0, 5.0), (8.0, 0.0)) for z in (0.0, 4.0)])
#: Four legs under a deck, 3 m high.
TABLE = TriangleMesh.combined(
    [
        box((16.0, 10.0, 1.0), (0.0, 0.0, 3.5)),
        *(box((1.0, 1.0, 3.0), (x, y, 1.5)) for x in (-7.5, 7.5) for y in (-4.5, 4.5)),
    ]
)


def places(**at: tuple[float, float]) -> dict[str, Any]:
    return {"places": {name: {"at": [f"{x} m", f"{y} m"]} for name, (x, y) in at.items()}}


def corners(x: float, y: float) -> dict[str, tuple[float, float]]:
    return {name: (i * x, j * y) for name, i, j in (("a", -1, -1), ("b", -1, 1), ("c", 1, -1), ("d", 1, 1))}


def refused(folder: Path, given: dict[str, Any]) -> str:
    with pytest.raises(ScenarioError) as problem:
        assembled(folder, given)
    return str(problem.value)


def test_a_tapered_module_stands_on_its_underside(tmp_path: Path) -> None:
    """The four below it bear a quarter each; those at the corners of its box nothing, and that is told."""
    outer = {f"far_{name}": (x, 0.8 * y) for name, (x, y) in corners(5.0, 5.5).items()}
    given = cad_lift(tmp_path, TAPERED, {**places(**corners(5.0, 2.0), **outer), "height": "1.5 m"})
    recording = simulated(tmp_path, {**given, "duration": "0.2 s"})
    found = [recording.column("contact_force", one.name)[0] for one in recording.rig.supports]
    assert found == pytest.approx([20e3 * G / 4] * 4 + [0.0] * 4, rel=1e-6)
    doubts = assembled(tmp_path, given).warnings
    # The low rim, at y = 4.1 m, is where a side at 53° comes down: 1.1 m · 4/3 above the underside.
    told = [one for one in doubts if "4 of 8 supports of keel_blocks bear nothing" in one]
    assert told and "'keel_blocks.far_a' 1.47 m" in told[0]


def test_a_support_beside_a_bow_is_refused_by_name_and_place(tmp_path: Path) -> None:
    given = cad_lift(tmp_path, BOW, {**places(**corners(6.0, 4.0)), "height": "1.5 m"})
    message = refused(tmp_path, given)
    assert "supports.keel_blocks: 'keel_blocks.c': nothing of the load" in message
    assert "top of 0.6 m by 0.6 m at (-29.00, -4.00) m" in message and "'keel_blocks.a'" not in message


def test_a_load_is_put_onto_the_nearest_of_its_supports(tmp_path: Path) -> None:
    """Under the sides that rise by 53°, at y = 5 − 0.3 m: 1.7 m · 4/3 = 2.267 m above the underside."""
    given = cad_lift(tmp_path, TAPERED, {**places(**corners(4.0, 5.0)), "height": "3 m"})
    message = refused(tmp_path, given)
    assert "0.7667 m above 'keel_blocks.a', the nearest of them; right is z = 0.733333 m" in message
    assembled(tmp_path, {**given, "load": {**given["load"], "position": ["-35 m", "0 m", "0.733333 m"]}})


def test_a_support_within_a_load_from_cad_is_refused(tmp_path: Path) -> None:
    given = cad_lift(tmp_path, TAPERED, {**places(**corners(5.0, 2.0)), "height": "1.5 m"})
    inside = {"under": "hull", "height": "2.5 m", **places(pillar=(0.0, 0.0))}
    given["supports"]["inside"] = inside
    message = refused(tmp_path, given)
    assert "'inside.pillar' stands inside the load at the start: its top is at 2.5 m" in message
    assert f"underside of the load there at {LEVEL} m; move it" in message


def test_hollows_that_the_hull_closes_are_told(tmp_path: Path) -> None:
    """Between the legs of a table, 3 m above its feet, hull and supports meet in the air."""
    at = {**corners(7.5, 4.5), "middle": (0.0, 0.0)}
    found = assembled(tmp_path, cad_lift(tmp_path, TABLE, {**places(**at), "height": "1.5 m"})).warnings
    told = [one for one in found if "closes a hollow" in one]
    assert told and told[0].endswith("begins: 'keel_blocks.middle' 3.00 m")
    given = cad_lift(tmp_path, TABLE, {**places(**corners(7.5, 4.5)), "height": "1.5 m"})
    given["supports"]["pillars"] = {"under": "hull", "height": "4 m", **places(one=(0.0, 0.0))}
    assert "that of its convex hull, which closes a hollow" in refused(tmp_path, given)


def test_corners_on_the_ground_that_are_in_the_air_are_told(tmp_path: Path) -> None:
    """The box of the tapered module has its lower corners √(2² + 3²) = 3.61 m off those of the module."""
    given = cad_lift(tmp_path, TAPERED, {}, stands_on="ground", position=["0 m", "0 m", "0 m"])
    found = assembled(tmp_path, {key: value for key, value in given.items() if key != "supports"}).warnings
    told = [one for one in found if one.startswith("on the ground the load stands on the corners of its box")]
    assert told and "of which 4 are up to 3.61 m off any corner of its shape" in told[0]
    flat = cad_lift(tmp_path, box((16.0, 10.0, 4.0), (0.0, 0.0, 2.0)), {}, stands_on="ground")
    flat["load"]["position"] = ["0 m", "0 m", "0 m"]
    found = assembled(tmp_path, {key: value for key, value in flat.items() if key != "supports"}).warnings
    assert not [one for one in found if "corners of its box" in one]


def test_the_underside_of_a_box_is_where_it_was(tmp_path: Path) -> None:
    """A box from CAD: the corners of each side as of a box in the lift file, from the centre of gravity."""
    mesh = box((16.0, 10.0, 4.0), (0.0, 0.0, 2.0))
    given = cad_lift(tmp_path, mesh, {**places(**corners(6.0, 4.0)), "height": "1.5 m"})
    sides = [np.array(side) for side in assembled(tmp_path, given).document["supports"][0]["sides"]]
    assert sorted(len(side) for side in sides) == [4] * 6
    assert sorted(np.round(side.mean(axis=0), 9).tolist() for side in sides) == sorted(
        [
            [0.0, 0.0, -2.0],
            [0.0, 0.0, 2.0],
            [8.0, 0.0, 0.0],
            [-8.0, 0.0, 0.0],
            [0.0, 5.0, 0.0],
            [0.0, -5.0, 0.0],
        ]
    )
