"""Ship structure from five CAD systems: masses from geometry against the weights that each file declares.

The files lie beside the project. Every part declares what the CAD system that wrote it computed for it.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from gantline.cad import CadModel, PartKind, read

FILES = Path(__file__).resolve().parents[3] / "shared" / "data" / "ship_blocks"
pytestmark = pytest.mark.skipif(
    not FILES.exists(), reason="the files lie in ../shared/data/ship_blocks beside the project"
)

#: Declared sums [kg] by kind, as their README lists them, and how far the sum from geometry may be off.
DECLARED: dict[str, tuple[dict[str, float], float]] = {
    "aveva_m1_plate": ({"plate": 7850.0}, 1e-6),
    "napa_m1_plate": ({"plate": 7850.0}, 1e-6),
    # One of seven bars is a rolled section whose fillets no dimension tells: 10.2 kg of 9235.5.
    "napa_m3_panel": ({"plate": 7065.0, "stiffener": 2170.5}, 2e-3),
    # A hole of 1.5 x 1.0 m with 0.5 m corners: exact against 145 chords.
    "napa_m6_plate_with_hole": ({"plate": 389.9, "edge reinforcement": 65.0}, 1e-3),
    "napa_m8_unit": (
        {
            "plate": 11563.4,
            "stiffener": 3536.1,
            "bracket": 814.8,
            "edge reinforcement": 676.7,
            "pillar": 91.4,
        },
        2e-4,
    ),
    "napa_bulker_deck_innerbottom": ({"plate": 152042.6, "stiffener": 42359.3}, 3e-4),
    "tc10_napa": ({"plate": 6691.6, "stiffener": 298.3}, 2e-4),
    "tc11_napa": ({"plate": 17270.0, "stiffener": 715.2}, 1e-4),
    "tc11_aveva": ({"plate": 17270.0, "stiffener": 676.0}, 1e-4),
    # Its plates declare 7860.0 kg for 20 m² x 50 mm x 7850 kg/m³ = 7850 kg.
    "tc11_cadmatic": ({"plate": 17290.0, "stiffener": 676.0}, 1.2e-3),
    "tc11_3dx": ({"plate": 17270.0, "stiffener": 675.9}, 1e-4),
    "tc11_prostep": ({"plate": 17191.5, "stiffener": 635.6}, 1e-4),
}


@cache
def model(name: str) -> CadModel:
    return read(FILES / f"{name}.3docx", keep=False)


@pytest.mark.parametrize("name", DECLARED)
def test_masses_agree_with_the_declared_ones(name: str) -> None:
    """Sum of masses from geometry within 1 % of the declared sum; each file has its own, closer bound."""
    kinds, within = DECLARED[name]
    found = model(name)
    assert {kind.value for kind, _ in found.kinds} == set(kinds)
    for kind, parts in found.kinds:
        both = found.compared(kind)
        assert both.declared == pytest.approx(kinds[kind.value], abs=0.06)
        assert all(part.properties is not None and part.declared is not None for part in parts)
    whole = found.compared()
    worst = whole.worst
    assert worst is not None and worst.properties is not None and worst.declared is not None
    assert whole.computed == pytest.approx(whole.declared, rel=within), (
        f"worst: {worst.name}, {worst.properties.mass:.2f} kg, declared {worst.declared.mass:.2f} kg"
    )


@pytest.mark.parametrize("name", [name for name in DECLARED if name != "napa_m3_panel"])
def test_every_part_agrees_with_its_declared_weight(name: str) -> None:
    """Part by part within half a percent: bulb flats and tubes are approximated by the exporters."""
    for part in model(name).parts:
        assert part.properties is not None and part.declared is not None
        assert part.properties.mass == pytest.approx(part.declared.mass, rel=5e-3), part.name


def test_sections_of_the_panel_agree_bar_by_bar() -> None:
    """Flat, bulb, L, T, HEA, tube, rectangular tube: all but the HEA, which lacks its fillets, to 0.3 %."""
    off = {
        part.size: part.properties.mass / part.declared.mass - 1
        for part in model("napa_m3_panel").of_kind(PartKind.STIFFENER)
        if part.properties is not None and part.declared is not None
    }
    assert len(off) == 7
    assert off.pop("HEA200") == pytest.approx(400.743 / 410.947 - 1, abs=1e-4)  # 2·b·f + (h − 2f)·t, sharp
    assert max(map(abs, off.values())) < 3e-3


@pytest.mark.parametrize("name", ["napa_m8_unit", "napa_bulker_deck_innerbottom", "tc10_napa"])
def test_plates_have_their_declared_centres_of_gravity(name: str) -> None:
    """Contour, openings and curved surfaces: within a millimetre, the digits that are printed."""
    for part in model(name).of_kind(PartKind.PLATE):
        assert part.properties is not None and part.declared is not None and part.declared.centre is not None
        assert part.properties.centre == pytest.approx(part.declared.centre, abs=1e-3), part.name


def test_the_whole_unit_hangs_where_it_is_declared() -> None:
    """Centre of gravity of 236 parts, declared weights against geometry: within a millimetre."""
    found = model("napa_m8_unit")
    declared = [part.declared for part in found.parts]
    masses = np.array([each.mass for each in declared if each is not None])
    centres = np.array([each.centre for each in declared if each is not None])
    assert found.properties.mass == pytest.approx(16682.4, rel=2e-4)
    assert found.properties.centre == pytest.approx(masses @ centres / masses.sum(), abs=1e-3)


def test_five_cad_systems_give_one_structure() -> None:
    """The same model from NAPA, AVEVA, CADMATIC, 3DEXPERIENCE and PROSTEP: within 1.5 % of mass."""
    names = [f"tc11_{system}" for system in ("napa", "aveva", "cadmatic", "3dx", "prostep")]
    masses = [model(name).properties.mass for name in names]
    assert max(masses) / min(masses) - 1 < 0.015
    assert {model(name).unit for name in names} == {"m, as the file says", "mm, as the file says"}
    for name in names:
        # x from 40 to 60, y from -1 to 1, z from 0 to 1 m, and half a thickness of 50 mm, and a bar's height.
        assert model(name).box == pytest.approx(np.array([[40, -1, 0], [60, 1, 1]]), abs=0.13)


def test_all_schemas_and_encodings_are_among_them() -> None:
    """Schema 2.8.5 with a child for each coordinate, 3.0 and 3.1 with lists, metres and millimetres."""
    forms = {model(name).form.split(",")[0] for name in DECLARED}
    assert forms == {"OCX 2.8.5", "OCX 3.0.0", "OCX 3.1.0"}


@pytest.mark.parametrize("name", DECLARED)
def test_triangles_hold_what_the_parts_weigh(name: str) -> None:
    """Flat plates and bars are drawn as closed bodies, to a millimetre: volumes to 2 %, or 1 kg."""
    for part in model(name).parts:
        assert part.properties is not None
        if not part.mesh.is_closed or "SRF" in part.name:
            continue  # curved plates are drawn as their middle surface
        assert part.mesh.is_consistent, part.name
        assert 7850.0 * part.mesh.volume == pytest.approx(part.properties.mass, rel=2e-2, abs=1.0), part.name


def test_doubts_of_the_real_files_are_told() -> None:
    """A thickness that contradicts weight and area, a bulb without width, a part without material."""
    said = {name: {doubt for part in model(name).parts for doubt in part.doubts} for name in DECLARED}
    assert "its thickness of 200 mm is no plate's" in said["napa_m1_plate"].pop()
    assert "width of the bulb taken from EN 10067" in said["tc11_aveva"].pop()
    assert "it names no material" in said["aveva_m1_plate"].pop()
    assert {name for name, doubts in said.items() if doubts} == set()
