"""A blade of 60 m lay with its root in the tower that it was meant for, and nothing said so before the run.

`gantline check` found the lift in order. The run pushed the blade out and off its frames as it settled,
pulled it back into the tower with 22,764 % of what its shackles bear, and told of twelve failures, of which
the first was that it never hung still.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.assembly.doubts.inside import depth_within
from gantline.scenario import parse_scenario
from lift_text import BASE

LOAD = "block"
#: Its corners: 8 m along x, 6 m along y, 3 m high, its middle over the origin, on the ground.
BOX = np.array([[x, y, z] for x in (-4.0, 4.0) for y in (-3.0, 3.0) for z in (0.0, 3.0)])


def warnings_of(structure: str) -> list[str]:
    found = assemble(parse_scenario(f"{BASE}structures:\n  hall: {{{structure}}}\n")).warnings
    return [one for one in found if " begins " in one]


@pytest.mark.parametrize(
    ("structure", "deep"),
    [
        # Of a tower of 2 m from x = 3 m on, 1 m is in the box.
        ("type: cylinder, at: [4 m, 0 m], diameter: 2 m, z: [0 m, 80 m]", 1.0),
        # Its corner points at the load, half of a diagonal of 2 m sqrt 2 from x = 5 m.
        (
            "type: box, x: [4 m, 6 m], y: [-1 m, 1 m], z: [0 m, 80 m], heading: 45 deg",
            math.sqrt(2.0) - 1.0,
        ),
        # A roof 0.2 m below the top of the load.
        ("type: box, x: [-20 m, 20 m], y: [-20 m, 20 m], z: [2.8 m, 3.5 m]", 0.2),
    ],
)
def test_it_is_told_how_deep(structure: str, deep: float) -> None:
    (said,) = warnings_of(structure)
    assert said == (
        f"{LOAD} begins {deep:.2f} m deep in hall, which pushes it out: see its 'position', how large it is, "
        "and where that stands"
    )


@pytest.mark.parametrize(
    "structure",
    [
        "type: cylinder, at: [5.1 m, 0 m], diameter: 2 m, z: [0 m, 80 m]",
        # Beside the corner of the load, 0.7162 m sqrt 2 = 1.013 m from its middle.
        "type: cylinder, at: [4.7162 m, 3.7162 m], diameter: 2 m, z: [0 m, 80 m]",
        "type: box, x: [-20 m, 20 m], y: [-20 m, 20 m], z: [-1 m, 0 m]",  # it stands on it
        "type: box, x: [4 m, 6 m], y: [-3 m, 3 m], z: [0 m, 3 m]",  # it stands against it
        "type: dock, x: [-20 m, 20 m], y: [-20 m, 20 m], floor: -3 m",
    ],
)
def test_what_is_beside_it_or_below_is_not(structure: str) -> None:
    assert warnings_of(structure) == []


@pytest.mark.parametrize("shift", [-0.1, 0.1])
def test_edges_that_cross_part_what_no_face_does(shift: float) -> None:
    """The load lies in x + z <= 7 m, with its edge at x = 4 m, z = 3 m on that plane.

    A bar with an edge along (1, 0, -1), of which all else is beyond that plane, crosses it there. Across both
    edges is (1, 0, 1) / sqrt 2, which stands on no face of load or bar: shifted out along it by d the two are
    d apart, shifted in they are d deep.
    """
    along, out, y = np.array([1.0, 0.0, -1.0]), np.array([1.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0])
    along, out = along / math.sqrt(2.0), out / math.sqrt(2.0)
    section = [0.0 * out, out + 0.5 * y, 1.5 * out - 0.5 * y]
    edge = np.array([4.0, 0.0, 3.0]) + shift * out
    bar = np.array([edge + one * along + corner for one in (-2.0, 2.0) for corner in section])
    assert depth_within(BOX, bar) == pytest.approx(-shift, abs=1e-12)
