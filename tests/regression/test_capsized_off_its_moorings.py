"""A vessel that capsized after its mooring line had been cut ended the program.

What parted before it capsized was looked up among ropes and contacts, where mooring lines are not: the run
panicked with "index out of bounds", or named whatever stood there, a contact that "was cut".
"""

from __future__ import annotations

import json

import pytest

from floating import SEA, box_hull, buoyancy
from gantline._core import Simulation
from mechanics import Json, body, contact, document, free

LENGTH, BREADTH, DEPTH, DRAFT = 20.0, 8.0, 4.0, 2.0
MASS = SEA * LENGTH * BREADTH * DRAFT
CUT = 0.5


def top_heavy(contacts: list[Json]) -> Json:
    """A box whose centre of gravity is at 5 m of 4 m, let go at 23 deg, with one line that is cut.

    KM = T/2 + B²/12T = 3.67 m is far below the centre of gravity.
    """
    points, triangles = box_hull((LENGTH, BREADTH, DEPTH))
    hull = [[x, y, z - 5.0] for x, y, z in points], triangles
    inertia = [MASS / 12 * (a * a + b * b) for a, b in ((BREADTH, DEPTH), (LENGTH, DEPTH), (LENGTH, BREADTH))]
    line: Json = {"type": "mooring", "name": "spring", "body": "barge", "at": [0, 4, 0], "to": [0, 60, -20]}
    line |= {"weight": 100.0, "axial_stiffness": 1e7, "length": 65.0, "cut_at": CUT}
    barge = body(
        "barge", free([0, 0, 3.0], orientation=[0.98, 0.198997487421324, 0, 0]), MASS, inertia=inertia
    )
    vessel: Json = {"name": "barge", "body": "barge", "level": 0.0, "capsized_beyond": 0.6}
    return document([barge], forces=[buoyancy("barge", hull), line], vessels=[vessel], contacts=contacts)


@pytest.mark.parametrize("integrator", [{"type": "adaptive"}, {"type": "del", "step": 1e-3}])
@pytest.mark.parametrize("touching", [0, 2])
def test_the_line_that_was_cut_is_named(integrator: Json, touching: int) -> None:
    feet = [
        contact(f"foot{k}", "barge", [0, 0, 0], stiffness=1e6, plane_point=[0, 0, -300])
        for k in range(touching)
    ]
    settings = {"integrator": integrator, "duration": 20.0, "sample_interval": 0.1}
    status = Simulation(json.dumps(top_heavy(feet)), json.dumps(settings)).run()
    assert (status["status"], status["element"]) == ("failed", "barge")
    assert status["cause"].startswith("it has capsized over its starboard side, more than 34° from upright")
    assert status["cause"].endswith(f"before that spring was cut at {CUT:.2f} s")
