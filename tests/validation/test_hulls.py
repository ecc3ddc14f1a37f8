"""Known hulls: figures that others published or measured, to the accuracy that they are known to."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gantline.hydro import Attitude, Hydrostatics, hydrostatics, read_hull

DATA = Path(__file__).resolve().parents[2].parent / "shared" / "data"


def found(file: str, draft: float) -> Hydrostatics:
    """Hydrostatics of a file of the data beside the project, on even keel."""
    path = DATA / file
    if not path.exists():
        pytest.skip(f"the hull ../shared/data/{file} is not beside this checkout")
    hull = read_hull(path)
    low, high = hull.box
    return hydrostatics(hull, Attitude(draft, middle=float(low[0] + high[0]) / 2))


#: Figures of the data's own table: measured there by other code, to the digits that it gives.
TABLE: list[tuple[str, float, dict[str, tuple[float, float]]]] = [
    (
        "hulls/dtmb5415.stl",
        6.15,
        {
            "volume": (8386.5, 0.05),
            "lcb": (70.282, 5e-4),
            "kb": (3.663, 5e-4),
            "waterplane_area": (2092.6, 0.05),
            "bm_transverse": (5.822, 5e-4),
            "km_transverse": (9.485, 5e-4),
            "wetted_surface": (2985.4, 0.05),
            "waterline_breadth": (19.058, 5e-4),
        },
    ),
    (
        "crane_vessels/buoyancy_cheetah.obj",
        6.75,
        {
            "volume": (53278.1, 0.05),
            "lcb": (103.577, 5e-4),
            "kb": (3.578, 5e-4),
            "bm_transverse": (26.709, 5e-4),
            "km_transverse": (30.287, 5e-4),
            "bm_longitudinal": (526.14, 5e-3),
            "waterplane_area": (8821.4, 0.05),
            "lcf": (98.945, 5e-4),
        },
    ),
    ("crane_vessels/buoyancy_octopus.obj", 12.0, {"volume": (80706, 0.5), "km_transverse": (75.57, 5e-3)}),
    (
        "crane_vessels/buoyancy_octopus.obj",
        24.0,
        {"volume": (122662, 0.5), "km_transverse": (46.93, 5e-3), "tcb": (-0.07, 5e-3)},
    ),
    ("crane_vessels/buoyancy_turtle.obj", 8.0, {"volume": (24692, 0.5), "km_transverse": (38.02, 5e-3)}),
    ("crane_vessels/buoyancy_turtle.obj", 10.0, {"km_transverse": (10.80, 5e-3)}),
    (
        "crane_vessels/buoyancy_husky.obj",
        3.5,
        {
            "volume": (4565.98, 5e-3),
            "lcb": (40.474, 5e-4),
            "kb": (1.902, 5e-4),
            "bm_transverse": (16.589, 1e-3),  # 16.5885 here: one digit less or more by rounding
            "tcb": (0.0037, 5e-5),
        },
    ),
]


@pytest.mark.parametrize(("file", "draft", "figures"), TABLE, ids=[f"{row[0]}-{row[1]}" for row in TABLE])
def test_hulls_have_their_measured_figures(
    file: str, draft: float, figures: dict[str, tuple[float, float]]
) -> None:
    """Every figure to half of its last digit: crane vessels, a semi-submersible, one with its deck awash."""
    values: dict[str, Any] = found(file, draft).as_dict()
    for name, (wanted, within) in figures.items():
        assert values[name] == pytest.approx(wanted, abs=within), name


def test_a_hull_of_shells_with_z_up_against_its_standard() -> None:
    """19 269.7 m³ at 6 m by the data's own table, from 24 shells with gaps and a house above its deck."""
    path = DATA / "crane_vessels/koala_hull.glb"
    if not path.exists():
        pytest.skip(f"the hull ../shared/data/crane_vessels/{path.name} is not beside this checkout")
    pytest.importorskip("trimesh")
    hull = read_hull(path, up="z")
    low, high = hull.box
    found = hydrostatics(hull, Attitude(6.0, middle=float(low[0] + high[0]) / 2))
    assert found.volume == pytest.approx(19269.7, abs=0.05)


def test_cheetah_displaces_what_its_owner_says() -> None:
    """53 290.76 m³ at 6.75 m on even keel, from another mesh of the same hull: within 0.05 %."""
    assert found("crane_vessels/buoyancy_cheetah.obj", 6.75).volume == pytest.approx(53290.76, rel=5e-4)


def test_dtmb_5415_displaces_what_was_published() -> None:
    """SIMMAN 2008: 8424 m³ at 6.15 m, wetted 2972.6 m², GM 1.95 m with KG 7.555 m. The mesh has its facets
    inside the hull: volume and surface within 0.5 %, GM within 0.02 m.
    """
    ship = found("hulls/dtmb5415.stl", 6.15)
    assert ship.volume == pytest.approx(8424, rel=5e-3)
    assert ship.wetted_surface == pytest.approx(2972.6, rel=5e-3)
    assert ship.gm([0, 0, 7.555])[0] == pytest.approx(1.95, abs=0.021)


def test_duisburg_test_case_from_its_large_mesh() -> None:
    """14 000 TEU at 1:59.407, 116 062 triangles: el Moctar, Shigunov and Zorn (2012) give 173 467 m³ at a
    draft of 14.5 m for the bare hull, C_B 0.661 of L_pp 355 m and B 51 m: 0.8274 m³ at 0.2441 m; the mesh
    has it within 0.1 %.
    """
    ship = found("hulls/DTC-scaled.stl.gz", 14.5 / 59.407)
    assert ship.volume == pytest.approx(173467 / 59.407**3, rel=1e-3)
    assert ship.waterline_size[1] == pytest.approx(51.0 / 59.407, rel=2e-3)
    assert ship.unbalanced < 1e-6


def test_sphere_of_task_10_floats_half_way() -> None:
    """522.443 m³ inside; in its plane of symmetry half of it, 261.22, a section near π R², and BM =
    R⁴π/4/V.
    """
    path = DATA / "hydrodynamics/oes_task10_sphere.obj"
    if not path.exists():
        pytest.skip("../shared/data/hydrodynamics/oes_task10_sphere.obj is not beside this checkout")
    hull = read_hull(path)
    assert hull.closure.is_closed
    assert hull.closure.volume == pytest.approx(522.443, abs=1e-3)
    low, high = hull.box
    half = hydrostatics(hull, Attitude(float(low[2] + high[2]) / 2, middle=float(low[0] + high[0]) / 2))
    assert half.volume == pytest.approx(522.443 / 2, rel=1e-4)
    assert half.waterplane_area == pytest.approx(78.54, rel=3e-3)
    assert half.bm_transverse == pytest.approx(490.87 / 261.8, rel=1e-2)
