"""A vessel in waves beside a rope over a light sheave that was just taut at the start ended the program.

Where rope over a light sheave is just taut and gets longer, the first step is cut down to 1e-123 s. The slow
place of the vessel was then taken on by a cubic over the cube of that, which is 0: its heading was no number,
and the forces of waves, looked for from that heading, panicked with "index out of bounds".
"""

from __future__ import annotations

import json

import numpy as np

from floating import box_hull, buoyancy
from gantline._core import Simulation
from mechanics import Json, body, document, end, flow, free, rope, sheave

LENGTH, BREADTH, DEPTH, DENSITY = 20.0, 8.0, 4.0, 1000.0
MASS = DENSITY * LENGTH * BREADTH * DEPTH / 2
#: Of a component in each direction: force and moment, real and imaginary part [N/m, N].
PHASOR = [[1e4, 0], [0, 0], [2e5, 1e4], [0, 0], [1e5, 0], [0, 0]]
NOTHING = [[0, 0]] * 6
DIRECTIONS = [-3.0, 0.0, 1.5]


def rig() -> Json:
    """A box afloat, and a body that swings about a point on a rope over a sheave without inertia."""
    points, triangles = box_hull((LENGTH, BREADTH, DEPTH))
    hull = [[x, y, z - DEPTH / 2] for x, y, z in points], triangles
    vessel = body("vessel", free([40, 0, 0]), MASS, inertia=[2.1e6, 11.1e6, 12.4e6])
    joint: Json = {"type": "ball", "orientation": [1, 0, 0, 0], "angular_velocity": [0.5, 0.5, 0]}
    inertia = [2e3, 2.4e3, 1.6e3]
    centre = [0.3, 0, -0.5]
    bob = body("bob", joint, 730.0, position=[1.2, 0.2, 1.8], centre_of_gravity=centre, inertia=inertia)
    over = sheave(None, [-0.8, 0, 9], [0, 1, 0], 0.47, flow="passing", ratio=1.1)
    route = [end(None, [-2.8, 0.1, 5]), over, end("bob", [0.5, 0, -0.3])]
    waves: Json = {"type": "wave", "name": "waves", "body": "vessel", "at": [0, 0, 0], "origin": [40, 0, 0]}
    waves |= {"directions": DIRECTIONS, "phasors": [[[PHASOR, NOTHING, NOTHING, NOTHING]] * len(DIRECTIONS)]}
    component = {"frequency": 0.9, "wave_number": [0.0827, 0.0], "amplitude": 0.5, "phase": 0.3}
    return document(
        [vessel, bob, flow("passing", 0.0)],
        ropes=[rope("fall", None, route, 2.4e6, 0.002)],
        forces=[buoyancy("vessel", hull, density=DENSITY), waves],
        sea={"components": [component], "rise_time": 2.0},
    )


def test_it_runs_to_its_end_in_numbers() -> None:
    settings = {"integrator": {"type": "adaptive"}, "duration": 0.5, "sample_interval": 0.05}
    run = Simulation(json.dumps(rig()), json.dumps(settings))
    assert run.run()["status"] == "done"
    assert all(np.isfinite(values).all() for values in run.columns().values())
