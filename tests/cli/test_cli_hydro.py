"""`gantline hydro`, as people use it."""

from __future__ import annotations

import json
import math
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

import databases
import waves
from afloat import BREADTH, DRAFT, LENGTH
from floating import SEA
from program import called, program


def hydro(*arguments: object) -> subprocess.CompletedProcess[str]:
    return called("hydro", *arguments)


def test_table_and_picture_of_a_box(tmp_path: Path) -> None:
    picture = tmp_path / "box.png"
    result = program(
        "hydro",
        "box:100m,30m,8m",
        "--drafts",
        "2 m..6 m/3",
        "--kg",
        "5 m",
        "--heel",
        "0 deg, 10 deg",
        "-o",
        picture,
    )
    assert result.returncode == 0, result.stderr
    # BM = 30²/(12 · 4) and 100²/(12 · 4), KB = 2, GM = 20.75 − 5.
    assert re.search(
        r"4\.000 +12300\.0 +12000\.0 +50\.000 +2\.000 +18\.750 +20\.750 +208\.33 .* 15\.750", result.stdout
    )
    # Wall-sided formula at 4 m, the third of the columns' middle one: sin 10° (15.75 + 18.75/2 tan² 10°).
    arm = math.sin(math.radians(10)) * (15.75 + 9.375 * math.tan(math.radians(10)) ** 2)
    assert re.search(rf"10\.0 +\S+ +{arm:.3f}", result.stdout)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert "closed mesh of 12 triangles" in result.stdout


def test_json_holds_all_figures() -> None:
    result = hydro("box:100m,30m,8m", "--drafts", "4 m", "--trim", "1 deg", "--density", "1 t/m^3", "--json")
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    (figures,) = found["hydrostatics"]
    assert figures["volume"] == pytest.approx(12000.0)
    assert figures["displacement"] == pytest.approx(12e6)
    # By the stern: B moves aft by a L²/12T.
    assert figures["lcb"] == pytest.approx(50 - math.tan(math.radians(1)) * 100**2 / 48)
    assert found["closure"]["is_closed"] is True
    assert found["righting_arms"] == []


def test_drafts_are_chosen_where_none_are_given() -> None:
    result = hydro("box:100m,30m,8m")
    assert result.returncode == 0, result.stderr
    assert [line.split()[0] for line in result.stdout.splitlines()[6:]] == [
        f"{draft}.000" for draft in range(1, 8)
    ]


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["nowhere.stl"], "nowhere.stl: cannot be read (no such file"),
        (["box:100m,30m,8m", "--drafts", "9 m"], "is wholly under water; it reaches from 0 to 8 m"),
        (["box:100m,30m,8m", "--drafts", "-1 m"], "is out of the water"),
        (["box:100m,30m,8m", "--drafts", "4"], "--drafts: '4' has no unit"),
        (["box:100m,30m,8m", "--drafts", "1 m..2 m/x"], "'x' is no number of values"),
        (["box:100m,30m,8m", "--heel", "10 deg"], "righting arms need the centre of gravity"),
        (["box:100m,30m,8m", "--heel", "200 deg", "--kg", "5 m"], "up to 180 deg"),
        (["box:100m,30m,8m", "--trim", "60 deg"], "too steep"),
        (["box:100m,30m,8m", "--density", "0 t/m^3"], "not the density of water"),
        (["box:100m,30m,8m", "--unit", "yd"], "--unit: 'yd' is no unit of length"),
        (["box:100m,30m,8m", "--up", "x"], "--up: 'x' is no axis that a hull has upwards; 'y' or 'z' is"),
        (["box:100m,30m,8m", "-o", "picture.xyz"], "names end in .png, .svg, .pdf"),
    ],
)
def test_wrong_questions_end_with_two_and_one_message(arguments: list[str], problem: str) -> None:
    result = hydro(*arguments)
    assert result.returncode == 2, result.stdout + result.stderr
    assert problem in result.stderr
    assert "Traceback" not in result.stderr


def test_gaps_are_warned_of(tmp_path: Path) -> None:
    hull = tmp_path / "open.obj"
    corners = ["v 0 -1 0", "v 9 -1 0", "v 9 -1 3", "v 0 -1 3", "v 0 1 0", "v 9 1 0", "v 9 1 3", "v 0 1 3"]
    faces = ["f 1 2 3 4", "f 8 7 6 5", "f 1 5 6 2", "f 2 6 7 3", "f 1 4 8 5"]
    hull.write_text("\n".join([*corners, *faces]))
    result = hydro(hull, "--drafts", "1 m")
    assert result.returncode == 0, result.stderr
    assert "not closed mesh" in result.stdout
    assert "4 edges are open" in result.stderr
    # It floated no deeper than to two thirds of its depth: so much of it counted as all.
    deep = hydro(hull, "--drafts", "2.9 m")
    assert re.search(r"\n +2\.900 +53\.50 +52\.20 ", deep.stdout), deep.stdout + deep.stderr
    assert "is wholly under water" in hydro(hull, "--drafts", "3 m").stderr


def test_one_side_of_a_hull_and_an_axis_that_points_up(tmp_path: Path) -> None:
    """A wedge of 9 × 3 × 1 m, lying: its side up to y = 0 is mirrored, its y points up."""
    hull = tmp_path / "side.obj"
    # x along, y of the file up, -z of it to port
    hull.write_text(
        "v 0 0 0\nv 9 0 0\nv 0 3 0\nv 9 3 0\nv 0 3 -1\nv 9 3 -1\nf 2 1 5 6\nf 1 3 5\nf 2 6 4\nf 3 4 6 5\n"
    )
    result = hydro(hull, "--up", "y", "--half", "--drafts", "1.5 m", "--json")
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    (figures,) = found["hydrostatics"]
    assert found["box"] == [[0.0, -1.0, 0.0], [9.0, 1.0, 3.0]]
    assert found["closure"]["is_closed"] is True
    # Half as deep, half as wide.
    assert figures["volume"] == pytest.approx(9.0 * 1.5 * 1.0 / 2)
    assert figures["waterplane_area"] == pytest.approx(9.0 * 1.0)


def test_a_database_is_shown_as_a_table_and_as_json(tmp_path: Path) -> None:
    path = databases.bemio(tmp_path / "box.h5")
    result = hydro(path)
    assert result.returncode == 0, result.stderr
    assert "box1, from box.h5 (BEMIO); for water of 1 t/m³; about (1, 0, -2) m of the file" in result.stdout
    assert "displaces 77 m³; water 50 m deep; wave forces in 2 directions" in result.stdout
    assert (
        "for 'radiation', with memory: box.h5 (BEMIO): has 4 frequencies, periods from 6.283" in result.stdout
    )
    # At infinity, then from short periods to long ones: heave 90 (2 − ω) t and 27 ω kN s/m.
    assert re.search(r"\n +0 +infinite +45 +200 +4500 *\n", result.stdout)
    assert re.search(r"\n +12\.566 +0\.5000 +135 +13\.5 +600 +60 +13500 +1350\n", result.stdout)
    as_json = hydro(path, "--json")
    found = json.loads(as_json.stdout)
    assert found["added_mass"][1][2][2] == pytest.approx(135e3)
    assert found["damping"][1][2][4] == 0.0
    assert found["excitation_real"][0][1][2] == pytest.approx(1.2e6)
    assert found["density"] == 1000.0


def test_forces_of_waves_by_their_direction(tmp_path: Path) -> None:
    """Those of the file's formula in one of its directions, between two the spline's; drift forces beside."""
    runs = waves.DIRECTIONS
    drift = np.zeros((len(waves.FREQUENCIES), len(runs), 3))
    drift[:] = 1e3 * np.stack([np.cos(runs), 2 * np.sin(runs), 0 * runs], 1)
    path = tmp_path / waves.database(tmp_path, drift=drift)
    result = hydro(path, "--waves", "90 deg, 45 deg", "--json")
    assert result.returncode == 0, result.stderr
    beam, between = json.loads(result.stdout)["waves"]
    real, imaginary = (np.array(beam[f"excitation_{part}"]) for part in ("real", "imaginary"))
    expected = np.array([waves.force_per_metre(omega, math.pi / 2) for omega in waves.FREQUENCIES])
    assert real + 1j * imaginary == pytest.approx(expected, abs=1e-9 * abs(expected).max())
    assert np.array(beam["drift"])[7] == pytest.approx([0.0, 2e3, 0.0], abs=1e-9)
    # Directions of the file are 30 deg apart: a spline of cos and sin is off by 5/384 of that to the fourth.
    assert between["direction"] == pytest.approx(math.pi / 4)
    assert np.array(between["drift"])[7] / 1e3 == pytest.approx([0.5**0.5, 2**0.5, 0.0], rel=2e-3)

    shown = hydro(path, "--waves", "90 deg").stdout
    assert "Waves that run 90 deg from its bow: sizes of forces per metre of amplitude, drift forces" in shown
    slowest = shown.splitlines()[-1].split()
    assert slowest[0] == "31.416" and slowest[1] == "0" and slowest[7:] == ["0", "2", "0"]
    # In long waves heave is what lifts the waterline, ρ G L B, to 1 − κT.
    kappa = 0.2**2 / waves.G
    lift = SEA * waves.G * LENGTH * BREADTH * math.exp(-kappa * DRAFT) / 1e3
    assert float(slowest[3]) == pytest.approx(lift, rel=2e-3)


def test_how_well_a_database_serves_as_radiation(tmp_path: Path) -> None:
    """What the fit leaves of damping and added mass, and where most."""
    waves.database(tmp_path, waves.radiated)
    result = hydro(tmp_path / "barge.nc")
    assert result.returncode == 0, result.stderr
    said = r"for 'radiation', with memory: the fit misses 0\.0\d+ % of the largest damping and 0\.0"
    assert re.search(said, result.stdout), result.stdout


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["nowhere.dhyd"], "nowhere.dhyd: cannot be read (no such file"),
        (["two.h5"], "has several bodies, box1, box2; name one of them"),
        (["two.h5", "--body", "box3"], "has no body 'box3'; it has box1, box2"),
        (["two.h5", "--drafts", "4 m"], "--drafts: is for a hull; two.h5 is a hydrodynamic database"),
        (["box:100m,30m,8m", "--body", "box1"], "--body: is for a hydrodynamic database; this is a hull"),
        (["box:100m,30m,8m", "--waves", "0 deg"], "--waves: is for a hydrodynamic database; this is a hull"),
        (["two.h5", "--body", "box1", "--waves", "45 deg"], "no waves that run 45 deg from its bow; it has"),
        (["two.h5", "--body", "box1", "--waves", "90 m"], "--waves: '90 m' is a length"),
    ],
)
def test_wrong_questions_about_databases(
    arguments: list[str], problem: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    databases.bemio(tmp_path / "two.h5", bodies=2)
    result = hydro(*arguments)
    assert result.returncode == 2, result.stdout + result.stderr
    assert problem in result.stderr
    assert result.stderr.count("\n") == 1
