"""The heaving sphere of OES Task 10 with the added mass that a wave program gives it."""

from __future__ import annotations

import json
import math
from pathlib import Path

import h5py
import numpy as np
import pytest

from floating import buoyancy
from gantline._core import Statics
from gantline.hydro import Attitude, float_free, hydrostatics, read_hull
from mechanics import G, Json, adaptive, body, document, free, period

DATA = Path(__file__).resolve().parents[2].parent / "shared" / "data" / "hydrodynamics"
FRESH, MASS = 1000.0, 261.8e3


@pytest.mark.parametrize("amplitude", [0.1, 1.0])
def test_sphere_of_task_10_bobs_with_its_added_mass(amplitude: float) -> None:
    """T = 2π √((m + a)/ρgA) with m = 261.8 t, a = A₃₃(∞) of sphere.h5 (0.5 ρV) and the mesh's own section
    A; from 1 m on it takes 3/4 · A²/6R² longer. Within 0.1 %.
    """
    if not (DATA / "sphere.h5").exists():
        pytest.skip("../shared/data/hydrodynamics/sphere.h5 is not beside this checkout")
    with h5py.File(DATA / "sphere.h5") as file:
        added = float(np.asarray(file["body1/hydro_coeffs/added_mass/inf_freq"])[2, 2]) * FRESH
    hull = read_hull(DATA / "oes_task10_sphere.obj")
    rest = float_free(hull, MASS, [0, 0, -2.0], density=FRESH)
    area = rest.hydrostatics.waterplane_area
    assert added == pytest.approx(0.5 * MASS, rel=2e-3)
    # The file's own waterplane stiffness, 770 389 N/m, is of another mesh: facets take 0.3 % at most.
    assert FRESH * G * area == pytest.approx(770389, rel=3e-3)

    matrix = np.zeros((6, 6))
    matrix[2, 2] = added
    vertices, triangles = hull.mesh
    water = buoyancy("sphere", (vertices.tolist(), triangles.tolist()), density=FRESH)
    moving = {"type": "added_mass", "name": "added", "body": "sphere", "at": [0, 0, 0]}
    moving["matrix"] = matrix.tolist()
    low = -rest.attitude.height

    def ball(height: float) -> Json:
        place = free([0, 0, height - low])
        inertia = [MASS * 10] * 3
        sphere = body("sphere", place, MASS, centre_of_gravity=(0, 0, -2), inertia=inertia)
        return document([sphere], forces=[water, moving])

    omega = math.sqrt(FRESH * G * area / (MASS + added))
    question = Statics(json.dumps(ball(0.0)))
    question.settle()
    assert math.sqrt(question.modes()["square"].max()) == pytest.approx(omega, rel=1e-3)
    run = adaptive(ball(amplitude), 30.0, sample_interval=0.02)
    height = run.body("sphere")[:, 2] + 2 + low
    wanted = 2 * math.pi / omega * (1 + 0.75 * amplitude**2 / 150)
    assert period(run.time, height) == pytest.approx(wanted, rel=1e-3)


def test_stiffness_of_its_mesh_is_that_of_a_sphere() -> None:
    """Heave ρgA of the mesh of 8064 triangles against πR²ρg = 770 476 N/m."""
    path = DATA / "oes_task10_sphere.obj"
    if not path.exists():
        pytest.skip("../shared/data/hydrodynamics/oes_task10_sphere.obj is not beside this checkout")
    hull = read_hull(path)
    middle = float(hull.box[:, 2].mean())
    found = hydrostatics(hull, Attitude(middle - 1e-6), FRESH)
    assert found.per_metre * G == pytest.approx(770476, rel=3e-3)
