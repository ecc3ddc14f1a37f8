"""Hulls from CAD files, matrices and databases in lift files: the same motion as what they stand for."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import databases
import gantline
from gantline.assembly import assemble
from gantline.cad.mesh import TriangleMesh
from gantline.scenario import ScenarioError, load_scenario
from gantline.statics import Statics
from json_lift import plain_lift, vessel, write_obj
from solids import box

SEA = 1025.0
SIZE, DRAFT = (60.0, 16.0, 6.0), 2.5
MASS = SEA * SIZE[0] * SIZE[1] * DRAFT
HULL = box(SIZE, (30.0, 0.0, 3.0))


def afloat(folder: Path, hull: dict[str, Any], **given: Any) -> Path:
    return plain_lift(folder, vessels={"barge": vessel(MASS, (30.0, 0.0, 4.0), 2.2, hull=hull, **given)})


def forces(path: Path) -> dict[str, Any]:
    return {force["name"]: force for force in assemble(load_scenario(path)).document["forces"]}


@pytest.mark.parametrize("way", ["as_is", "scaled", "moved", "y_up", "half"])
def test_a_mesh_floats_like_the_box_that_it_is(way: str, tmp_path: Path) -> None:
    """A file with seams, one at model scale in centimetres, one with its origin elsewhere, one with y up, and
    one with the port side alone.
    """
    mesh = HULL
    hull: dict[str, Any] = {"mesh": "hull.obj"}
    if way == "scaled":
        mesh, hull = HULL.scaled(100 / 40), hull | {"units": "cm", "scale": 40}
    elif way == "moved":
        mesh = HULL.moved(np.eye(3), np.array([-30.0, 5.0, 1.0]))
        hull = hull | {"at": ["30 m", "-5 m", "-1 m"]}
    elif way == "y_up":
        mesh, hull = (
            HULL.moved(np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]), np.zeros(3)),
            hull | {"up": "y"},
        )
    elif way == "half":
        length, breadth, depth = SIZE
        side = (length, breadth / 2, depth)
        mesh, hull = box(side, (length / 2, breadth / 4, depth / 2)), hull | {"half": True}
    write_obj(tmp_path / "hull.obj", mesh)
    path = afloat(tmp_path, hull, trim="1 deg", heel="2 deg")
    rest = Statics(path).equilibrium()
    # Coordinates of the file have all digits; scaling and turning round them.
    assert rest.recording.dataset["body_position"].values[-1, 0, 2] == pytest.approx(4.0 - DRAFT, abs=1e-9)
    body = next(body for body in assemble(load_scenario(path)).scene["bodies"] if body["name"] == "barge")
    assert np.ptp(body["shape"]["vertices"], axis=0) == pytest.approx(SIZE, abs=1e-3)
    assert np.ptp(body["shape"]["hull"], axis=0) == pytest.approx(SIZE, abs=1e-3)


def test_a_mesh_on_a_plain_body(tmp_path: Path) -> None:
    """`mechanics` has hulls by the same words: half as deep at half the mass."""
    write_obj(tmp_path / "hull.obj", HULL)
    joint = {"type": "slider", "axis": [0, 0, 1], "position": "-1 m"}
    body = {"joint": joint, "mass": f"{MASS / 2} kg", "hull": {"mesh": "hull.obj"}}
    path = plain_lift(tmp_path, {"float": body})
    place = Statics(path).equilibrium().recording.dataset["body_position"].values[-1, 0, 2]
    assert place == pytest.approx(-DRAFT / 2, abs=1e-9)
    assert assemble(load_scenario(path)).scene["bodies"][0]["shape"]["type"] == "mesh"


def test_an_open_mesh_floats_with_a_warning(tmp_path: Path) -> None:
    """Without its deck a hull displaces the same; that it is open is said in the recording."""
    high = HULL.corners[:, :, 2].min(axis=1) == 6.0
    write_obj(tmp_path / "hull.obj", HULL.of(~high))
    path = afloat(tmp_path, {"mesh": "hull.obj"})
    rest = Statics(path).equilibrium()
    assert rest.recording.dataset["body_position"].values[-1, 0, 2] == pytest.approx(4.0 - DRAFT, abs=1e-9)
    (warning,) = assemble(load_scenario(path)).warnings
    assert warning.startswith(
        "the hull of barge, hull.obj: 4 edges are open, 152 m together, the lowest at z = 6"
    )


@pytest.mark.parametrize(
    ("hull", "content", "says"),
    [
        ({"mesh": "hull.obj"}, None, "vessels.barge.hull.mesh: hull.obj: cannot be read (no such file"),
        ({"mesh": "hull.obj"}, "v 0 0 0\nv 1 x 0\n", "vessels.barge.hull.mesh: hull.obj: it is no OBJ file"),
        (
            {"mesh": "hull.obj"},
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "hull.mesh: hull.obj: its triangles enclose no volume",
        ),
        (
            {"mesh": "hull.obj", "box": ["1 m", "1 m", "1 m"]},
            "",
            "a hull is a 'box' or comes from a 'mesh', not both",
        ),
        ({"units": "m"}, "", "a hull is 'box: [100 m, 30 m, 8 m]' or 'mesh: hull.obj'"),
        ({"box": ["60 m", "16 m", "6 m"], "scale": 2}, "", "'scale' is for a hull from a 'mesh'"),
        ({"box": ["60 m", "16 m", "6 m"], "half": True}, "", "'half' is for a hull from a 'mesh'"),
        (
            {"mesh": "hull.obj", "half": True},
            "v 0 -1 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n",
            "hull.mesh: hull.obj: it reaches from y = -1 to 1 m, to both sides of the centre plane y = 0",
        ),
        ({"mesh": "hull.obj", "keel": [0, 0, 0]}, "", "'keel' is for a hull that is a 'box'"),
        ({"mesh": "hull.obj", "scale": 0}, "", "'0' is out of range; from 0.001 to 1000 is right"),
        (
            {"mesh": "hull.obj", "units": "mm"},
            "box",
            "barge.draft: 2.2 m is not between the keel at 0 m",
        ),
    ],
)
def test_what_is_no_hull_is_refused(
    hull: dict[str, Any], content: str | None, says: str, tmp_path: Path
) -> None:
    """One sentence, at the path of what is wrong."""
    if content == "box":
        write_obj(tmp_path / "hull.obj", HULL)
    elif content is not None:
        (tmp_path / "hull.obj").write_text(content, encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        assemble(load_scenario(afloat(tmp_path, hull)))
    assert says in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def heaving(folder: Path, name: str, period: str, **given: Any) -> Path:
    """A barge with added mass and damping of a database made by the tests."""
    writers: dict[str, Callable[[Path], Path]] = {
        ".nc": databases.capytaine,
        ".h5": databases.bemio,
        ".dhyd": databases.dhyd,
        ".hyd": databases.text,
    }
    writers[Path(name).suffix](folder / name)
    source = {"database": name, "period": period, "at": ["30 m", "0 m", "2 m"]}
    return afloat(
        folder, {"box": [f"{size} m" for size in SIZE]}, added_mass=source, water_damping=source, **given
    )


@pytest.mark.parametrize("name", ["a.nc", "a.h5", "a.dhyd", "a.hyd"])
def test_a_database_gives_whole_matrices_about_its_point(name: str, tmp_path: Path) -> None:
    """At 0.5 rad/s, for sea water: 1.025 times the file's where it says that it is for fresh water."""
    found = forces(heaving(tmp_path, name, f"{2 * math.pi / 0.5!r} s"))
    factor, within = (1.0, 1e-4) if name == "a.hyd" else (1.025, 1e-9)
    wanted = {"added_mass": databases.ADDED[1], "water_damping": databases.DAMPING[1]}
    for key, matrix in wanted.items():
        force = found[f"barge.{key}"]
        assert force["at"] == [30.0, 0.0, 2.0]
        rows = force["matrix" if key == "added_mass" else "damping"]
        # What is zero in the file may be rounding of the mean of two sides.
        assert np.array(rows) == pytest.approx(factor * matrix, rel=within, abs=1e-3)


def test_modes_have_the_mass_of_the_database(tmp_path: Path) -> None:
    """Heave of a box: ω² = ρgA/(m + a₃₃), about any point of its centre plane."""
    path = heaving(tmp_path, "a.h5", f"{2 * math.pi / 0.5!r} s")
    question = Statics(path)
    question.equilibrium()
    stiffness = SEA * 9.81 * SIZE[0] * SIZE[1]
    square = stiffness / (MASS + 1.025 * databases.ADDED[1][2, 2])
    (mode,) = (mode for mode in question.modes() if mode.square == pytest.approx(square, rel=1e-6))
    damping = 1.025 * databases.DAMPING[1][2, 2]
    assert mode.damping_ratio == pytest.approx(damping * math.sqrt(square) / (2 * stiffness), rel=1e-6)


def rows(matrix: Any, units: tuple[str, str, str]) -> list[list[str]]:
    """A matrix in the words of a lift file."""
    return [[f"{float(matrix[i][j])!r} {units[(i > 2) + (j > 2)]}" for j in range(6)] for i in range(6)]


def test_matrices_written_by_hand(tmp_path: Path) -> None:
    """The numbers of the file, in SI units."""
    added = rows(databases.ADDED[0], ("kg", "kg m", "kg m^2"))
    damping = rows(databases.DAMPING[0], ("N s/m", "N s", "N m s"))
    given = {"added_mass": {"matrix": added, "at": [0, 0, "1 m"]}, "water_damping": {"matrix": damping}}
    found = forces(afloat(tmp_path, {"box": [f"{size} m" for size in SIZE]}, **given))
    assert found["barge.added_mass"]["matrix"] == databases.ADDED[0].tolist()
    assert found["barge.added_mass"]["at"] == [0, 0, 1.0]
    assert found["barge.water_damping"]["damping"] == databases.DAMPING[0].tolist()


CROOKED, DRIVEN = databases.ADDED[0].copy(), databases.ADDED[0].copy()
CROOKED[0, 4] *= 1.01
DRIVEN[0, 4] = DRIVEN[4, 0] = 1e6


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"matrix": rows(CROOKED, ("kg", "kg m", "kg m^2"))}, "row 5, item 1 and row 1, item 5 differ"),
        ({"matrix": rows(DRIVEN, ("kg", "kg m", "kg m^2"))}, "some motion would gain energy from this water"),
        ({"matrix": rows(databases.ADDED[0], ("kg", "kg", "kg m^2"))}, "row 1, item 4: "),
        ({"matrix": [["1 t"] * 6] * 5}, "a matrix is a list of six rows"),
        ({"matrix": [["1 t"] * 5] * 6}, "row 1: found a list; a row is a list of six"),
        ({"matrix": 5, "database": "a.h5"}, "it is a 'matrix' or comes from a 'database', not both"),
        ({"matrix": 5, "heave": "5 t"}, "'heave' is part of the 'matrix'; leave one of them out"),
        ({"database": "a.h5", "period": "9 s"}, "'at' is missing: where the database's reference point is"),
        ({"database": "a.h5", "at": [0, 0, 0]}, "'period' is missing; it is written like '9 s'"),
        ({"period": "9 s"}, "'period' is for a 'database'"),
        ({"database": "b.h5", "at": [0, 0, 0], "period": "9 s"}, "added_mass.database: b.h5: cannot be read"),
        (
            {"database": "a.h5", "at": [0, 0, 0], "period": "99 s"},
            "a period of 99 s is not in it; its periods go",
        ),
        ({"database": "a.h5", "at": [0, 0, 0], "period": "9"}, "or 'infinite_frequency'"),
        (
            {"database": "a.h5", "at": [0, 0, 0], "period": "9 s", "body": "ship"},
            "has no body 'ship'; it has box1",
        ),
    ],
)
def test_what_is_no_added_mass_is_refused(given: dict[str, Any], says: str, tmp_path: Path) -> None:
    """One sentence, at the path of what is wrong."""
    databases.bemio(tmp_path / "a.h5")
    path = afloat(tmp_path, {"box": [f"{size} m" for size in SIZE]}, added_mass=given)
    with pytest.raises(ScenarioError) as caught:
        assemble(load_scenario(path))
    assert says in str(caught.value), str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_nothing_damps_at_infinite_frequency(tmp_path: Path) -> None:
    """B(∞) = 0: no waves are made."""
    given = {"database": "a.h5", "at": [0, 0, 0], "period": "infinite_frequency"}
    path = afloat(tmp_path, {"box": [f"{size} m" for size in SIZE]}, water_damping=given)
    with pytest.raises(ScenarioError, match="at infinite frequency no waves are made and nothing damps"):
        load_scenario(path)


def sphere_period(mass: float, area: float, radius: float, amplitude: float) -> float:
    """Of m z̈ = −ρgπ (R² z − z³/3) by quadrature over z = A sin φ, π R² scaled to the section `area` [s]."""
    angle = (np.arange(400) + 0.5) / 400 * math.pi / 2
    z = amplitude * np.sin(angle)
    factor = 1000.0 * 9.81 * area / radius**2
    gap = factor * (radius**2 * (amplitude**2 - z**2) / 2 - (amplitude**4 - z**4) / 12)
    return float(4 * np.sum(amplitude * np.cos(angle) / np.sqrt(2 * gap / mass)) * math.pi / 800)


@pytest.mark.parametrize("amplitude", [0.05, 2.5, 5.0])
def test_a_sphere_bobs_as_quadrature_says(amplitude: float, tmp_path: Path) -> None:
    """Half under water, with half of its displacement as added mass, from 0.05 m to 5 m, where it is just out
    of the water and swings 15 % longer. Section and mass are the mesh's own; what facets of 3° leave of the
    shape of the curve is below 0.1 % of the period.
    """
    from gantline.hydro import Attitude, Hull, hydrostatics
    from mechanics import period
    from solids import sphere

    ball = sphere(5.0, 24)
    write_obj(tmp_path / "ball.obj", ball)
    half = hydrostatics(Hull("ball", ball.vertices, ball.triangles), Attitude(-1e-9), 1000.0)
    added = np.zeros((6, 6))
    added[2, 2] = 0.5 * half.mass
    body = {
        "joint": {"type": "slider", "axis": [0, 0, 1], "position": f"{amplitude} m"},
        "mass": f"{half.mass!r} kg",
        "hull": {"mesh": "ball.obj"},
        "added_mass": {"matrix": rows(added, ("kg", "kg m", "kg m^2"))},
    }
    path = plain_lift(tmp_path, {"ball": body}, water={"density": "1 t/m^3"}, duration="15 s")
    recording = gantline.simulate(path)
    time, height = recording.dataset["time"].values, recording.dataset["body_position"].values[:, 0, 2]
    wanted = sphere_period(1.5 * half.mass, half.waterplane_area, 5.0, amplitude)
    assert period(time, height) == pytest.approx(wanted, rel=1e-3)


def test_the_quadrature_of_the_sphere() -> None:
    """z̈ = −ω² (z − z³/3R²) is Duffing's equation: with μ = A²/6R², T = 4 K(k)/(ω √(1 − μ)), k² = μ/(1 − μ),
    2π/ω (1 + A²/8R² + 19 A⁴/768 R⁴ + …). The integrand is even and smooth in φ, for which the rule
    converges faster than any power: what is left is the rounding of the gap near A, 1e-16 A²/(A² − z²) at
    the last of 400 points, 1e-11.
    """
    from scipy.special import ellipk

    small = 2 * math.pi * math.sqrt(4e5 / (1000 * 9.81 * math.pi * 25))
    for amplitude in (1e-4, 0.5, 5.0):
        bend = amplitude**2 / (6 * 5.0**2)
        wanted = small * 2 / math.pi * float(ellipk(bend / (1 - bend))) / math.sqrt(1 - bend)
        assert sphere_period(4e5, math.pi * 25, 5.0, amplitude) == pytest.approx(wanted, rel=1e-10)


def test_touching_hulls_use_a_convex_body(tmp_path: Path) -> None:
    """The corners of a mesh's convex hull bear contacts; the mesh is for water and pictures."""
    write_obj(tmp_path / "hull.obj", TriangleMesh.combined([HULL]))
    parts = {
        "block": {"joint": {"type": "fixed"}, "at": ["0 m", "0 m", "20 m"], "shape": {"box": ["1 m"] * 3}}
    }
    contact = {"between": ["barge", "block"], "stiffness": "10 MN/m"}
    path = plain_lift(
        tmp_path,
        parts,
        mechanics={"body_contacts": {"hit": contact}},
        vessels={"barge": vessel(MASS, (30.0, 0.0, 4.0), 2.2, hull={"mesh": "hull.obj"})},
    )
    shapes = {shape["name"]: shape for shape in assemble(load_scenario(path)).document["shapes"]}
    (part,) = shapes["barge"]["parts"]
    assert part["type"] == "convex" and len(part["vertices"]) == 8
