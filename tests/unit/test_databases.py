"""Hydrodynamic databases: every format gives the same numbers in SI units; what is broken is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import xarray as xr

import databases
from databases import ADDED, DAMPING, DENSITY, DRIFT, EXCITATION, INFINITE, OMEGA
from gantline.hydro import DatabaseError, HydrodynamicDatabase, read_database, write_database

WRITERS: dict[str, Callable[[Path], Path]] = {
    "a.nc": databases.drifting,
    "a.h5": databases.bemio,
    "scaled.hdf5": lambda path: databases.bemio(path, scaled=True),
    "a.dhyd": databases.dhyd,
    "A.HYD": databases.text,
}


@pytest.mark.parametrize("name", WRITERS)
def test_every_format_gives_the_same(name: str, tmp_path: Path) -> None:
    """Text has five digits, so its matrices are as good as that; all others are exact to rounding."""
    found = read_database(WRITERS[name](tmp_path / name))
    within = 1e-4 if name == "A.HYD" else 1e-12
    assert found.frequencies == pytest.approx(OMEGA)
    assert found.added_mass == pytest.approx(ADDED, rel=within, abs=1e-6)
    assert found.damping == pytest.approx(DAMPING, rel=within, abs=1e-6)
    assert found.periods == pytest.approx(2 * np.pi / OMEGA)
    if name != "A.HYD":
        assert found.density == DENSITY
        assert found.excitation == pytest.approx(EXCITATION, rel=1e-12)
        assert found.directions == pytest.approx([0, np.pi / 2])
    else:
        assert found.density is None and found.excitation is None
    if name.startswith(("a.nc", "a.h5", "scaled")):
        assert found.infinite_added_mass == pytest.approx(INFINITE, rel=1e-12)
        assert found.displacement == 77.0
        assert found.drift == pytest.approx(DRIFT, rel=1e-12)
    else:
        assert found.drift is None
    if name != "a.dhyd":
        assert found.reference == pytest.approx([1.0, 0.0, -2.0])


@pytest.mark.parametrize("name", WRITERS)
def test_what_is_written_is_read_again(name: str, tmp_path: Path) -> None:
    """Of every format, with and without waves, an infinite frequency, a density."""
    known = read_database(WRITERS[name](tmp_path / name))
    path = write_database(known, tmp_path / "own.nc")
    read = read_database(path)
    assert read.source == "own.nc (Capytaine)"
    for field in ("name", "density", "displacement", "water_depth"):
        assert getattr(read, field) == getattr(known, field), field
    for field in ("frequencies", "added_mass", "damping", "directions"):
        np.testing.assert_array_equal(getattr(read, field), getattr(known, field), err_msg=field)
    for field in ("infinite_added_mass", "reference", "excitation", "drift"):
        one, other = getattr(read, field), getattr(known, field)
        assert (one is None) == (other is None), field
        if one is not None:
            np.testing.assert_array_equal(one, other, err_msg=field)
    with pytest.raises(DatabaseError, match=r"own\.h5: has to end in '\.nc'"):
        write_database(known, tmp_path / "own.h5")


def test_a_database_says_in_a_line_what_it_has(tmp_path: Path) -> None:
    database = read_database(databases.capytaine(tmp_path / "box.nc"))
    assert repr(database) == (
        "<HydrodynamicDatabase 'box', box.nc (Capytaine): 4 periods from 6.283 s to 15.71 s, "
        "wave forces in 2 directions>"
    )


def test_a_matrix_at_a_period_in_another_water(tmp_path: Path) -> None:
    """Linear in frequency between its neighbours, in proportion to the density."""
    found = read_database(databases.capytaine(tmp_path / "a.nc"))
    matrix, doubts = found.added_mass_at(2 * np.pi / 0.6, 1025.0)
    assert matrix == pytest.approx(1.025 * (ADDED[1] * 2 + ADDED[2]) / 3, rel=1e-12) and doubts == []
    matrix, _ = found.damping_at(2 * np.pi / 0.8, 1000.0)
    assert matrix == pytest.approx(DAMPING[2], rel=1e-12, abs=1e-6)
    assert found.added_mass_at(None, 500.0)[0] == pytest.approx(0.5 * INFINITE, rel=1e-12)
    with pytest.raises(
        DatabaseError, match=r"a period of 20 s is not in it; its periods go from 6\.283 to 15\.71 s"
    ):
        found.added_mass_at(20.0, 1000.0)


def test_a_file_without_density_or_infinity_says_so(tmp_path: Path) -> None:
    found = read_database(databases.text(tmp_path / "a.hyd"))
    matrix, (doubt,) = found.added_mass_at(2 * np.pi / 0.5, 1025.0)
    assert "does not say for which water" in doubt
    assert matrix == pytest.approx(ADDED[1], rel=1e-4, abs=1.0)
    with pytest.raises(DatabaseError, match="has no infinite frequency; its periods go"):
        found.added_mass_at(None, 1025.0)


PACKED = {"added_mass": {"dtype": "int32", "scale_factor": 500.0, "add_offset": 3e4, "_FillValue": -9999}}


@pytest.mark.parametrize("engine", ["h5netcdf", "scipy"])
@pytest.mark.parametrize("encoding", [{}, PACKED], ids=["plain", "packed"])
def test_every_netcdf_file_gives_the_same(engine: Any, encoding: dict[str, Any], tmp_path: Path) -> None:
    """Of the fourth version or an older one, with other orders of dimensions, and with packed numbers: all
    of ADDED are whole numbers of 500 above 3e4, so those are exact but for rounding of the largest."""
    known = databases.drifting(tmp_path / "known.nc")
    with xr.open_dataset(known, engine="h5netcdf") as tables:
        other = tables.transpose("influenced_dof", "omega", ...)
        other.to_netcdf(tmp_path / "other.nc", engine=engine, encoding=encoding)
    found, same = read_database(tmp_path / "other.nc"), read_database(known)
    largest = float(np.abs(ADDED).max())
    assert found.added_mass == pytest.approx(ADDED, rel=1e-12, abs=1e-12 * largest)
    for field in ("frequencies", "damping", "excitation", "directions", "drift"):
        np.testing.assert_array_equal(getattr(found, field), getattr(same, field), err_msg=field)


def test_a_gap_of_a_file_is_no_number(tmp_path: Path) -> None:
    """What the file has marked as missing is refused as a number that is none."""
    with xr.open_dataset(databases.capytaine(tmp_path / "whole.nc"), engine="h5netcdf") as tables:
        holed = tables.load()
    holed["added_mass"][0, 0, 0] = np.nan
    encoding: Any = {"added_mass": {"_FillValue": -1e30}}
    holed.to_netcdf(tmp_path / "holed.nc", engine="h5netcdf", encoding=encoding)
    with pytest.raises(DatabaseError, match="its added mass has numbers that are not finite"):
        read_database(tmp_path / "holed.nc")


def made(added: np.ndarray, damping: np.ndarray) -> HydrodynamicDatabase:
    return HydrodynamicDatabase("box", "made", np.array([0.5]), added[None], damping[None], DENSITY)


def test_what_is_nearly_symmetric_is_mended_and_said() -> None:
    crooked = ADDED[1].copy()
    crooked[0, 1] = 0.1 * crooked[1, 1]
    matrix, (doubt,) = made(crooked, DAMPING[1]).added_mass_at(2 * np.pi / 0.5, DENSITY)
    assert matrix == pytest.approx((crooked + crooked.T) / 2)
    assert "surge by sway and of sway by surge" in doubt and "their mean is taken" in doubt
    crooked[0, 2] = 3 * crooked[2, 2]
    with pytest.raises(DatabaseError, match="differ by 300 % of the diagonal; another period may be better"):
        made(crooked, DAMPING[1]).added_mass_at(2 * np.pi / 0.5, DENSITY)


def test_a_little_negative_damping_is_set_to_zero_and_said() -> None:
    """Heave takes −0.5 % of the largest: what is left of it is zero, the others stay."""
    driven = np.diag([1.0, 1.0, -0.005, 1.0, 1.0, 1.0])
    matrix, (doubt,) = made(ADDED[1], driven).damping_at(2 * np.pi / 0.5, DENSITY)
    assert matrix == pytest.approx(np.diag([1, 1, 0, 1, 1, 1]), abs=1e-12)
    assert "a motion whose damping is below zero, by 0.5 % of the largest, is set to zero" in doubt
    driven[2, 2] = -0.3
    with pytest.raises(DatabaseError, match="gains energy from the water, 30 % of the largest"):
        made(ADDED[1], driven).damping_at(2 * np.pi / 0.5, DENSITY)


def test_one_of_several_bodies(tmp_path: Path) -> None:
    path = databases.bemio(tmp_path / "two.h5", bodies=2)
    assert read_database(path, "box2").added_mass == pytest.approx(ADDED, rel=1e-12)
    with pytest.raises(DatabaseError, match="has several bodies, box1, box2; name one of them"):
        read_database(path)
    with pytest.raises(DatabaseError, match="has no body 'box3'; it has box1, box2"):
        read_database(path, "box3")
    found = read_database(databases.capytaine(tmp_path / "a.nc", prefix="crane__"))
    assert found.name == "crane" and found.added_mass == pytest.approx(ADDED, rel=1e-12)


def spoiled(tmp_path: Path, name: str) -> Path:
    """A database that is broken in the way its name says."""
    path = tmp_path / name
    writers: dict[str, Callable[[Path], Path]] = {
        ".nc": databases.capytaine,
        ".h5": databases.bemio,
        ".hyd": databases.text,
        ".dhyd": databases.dhyd,
    }
    if path.suffix in writers:
        writers[path.suffix](path)
    whole = path.read_bytes() if path.exists() else b""
    if name.startswith("cut"):
        path.write_bytes(whole[: len(whole) // 2])
    elif name.startswith("noise"):
        path.write_bytes(bytes(range(256)) * 40)
    elif name.startswith("empty"):
        path.write_bytes(b"")
    elif name.startswith("link"):
        with h5py.File(path, "a") as file:
            file["elsewhere"] = h5py.ExternalLink("/etc/passwd", "/x")
    elif name.startswith("outside"):
        with h5py.File(path, "a") as file:
            file.create_dataset("raw", (4,), "f8", external=[(tmp_path / "raw.bin", 0, 32)])
    elif name.startswith("bomb"):
        with h5py.File(path, "a") as file:
            file.create_dataset("huge", (10**6, 10**6), "f8", chunks=(1000, 1000), compression="gzip")
    elif name.startswith("other"):
        with h5py.File(path, "w") as file:
            file["x"] = 1.0
    elif name.startswith("still"):
        with h5py.File(path, "a") as file:
            del file["mass/omega"]
    elif name.startswith("alone"):
        with h5py.File(path, "a") as file:
            del file["Heave/wave_direction"]
    elif name.startswith("nan"):
        with h5py.File(path, "a") as file:
            file["body1/hydro_coeffs/added_mass/all"][2, 2, 0] = np.nan
    elif name.startswith("short"):
        with h5py.File(path, "a") as file:
            del file["simulation_parameters/w"]
            file["simulation_parameters/w"] = OMEGA[:2]
    elif name.startswith("word"):
        path.write_text(whole.decode().replace("ADMAS     ", "ADMAS     x", 1), encoding="utf-8")
    elif name.startswith("rows"):
        path.write_text(whole.decode().replace("BDAMP", "REM", 1), encoding="utf-8")
    elif name.startswith("early"):
        path.write_text(whole.decode().replace("OMEGA", "REM  ", 1), encoding="utf-8")
    elif name.startswith("motions"):
        databases.capytaine(path, coordinates={"influenced_dof": [f"mode {k}" for k in range(6)]})
    elif name.startswith("adrift"):
        with h5py.File(path, "a") as file:
            del file["added_mass"].attrs["DIMENSION_LIST"]
    elif name.startswith("bare"):
        databases.capytaine(path, without=["added_mass"])
    elif name.startswith("reverse"):
        databases.capytaine(path, coordinates={"rho": -3.0})
    elif name.startswith("drift"):
        drift = np.full((5, 2), np.nan if "nan" in name else 1.0)
        over = ["omega", "body_name"] if "over" in name else ["omega", "wave_direction"]
        tables = {f"drift_force_{axis}": (over, drift) for axis in ("surge", "sway", "yaw")}
        coordinates = {"body_name": ["box", "other"]} if "over" in name else {}
        databases.capytaine(path, tables=tables, coordinates=coordinates)
    return path


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("nowhere.xyz", "is no hydrodynamic database that can be read; these can: .nc, .h5"),
        ("empty.nc", "the file is empty"),
        ("cut.nc", "it is no hydrodynamic database, or a broken one"),
        ("cut.h5", "it is no hydrodynamic database, or a broken one"),
        ("cut.hyd", "is cut off: 4 frequencies are announced, 2 are there"),
        ("noise.dhyd", "it is no hydrodynamic database, or a broken one"),
        ("noise.hyd", "there is no line 'OMEGA' in it"),
        ("link.h5", "'elsewhere' is a link"),
        ("link.nc", "'elsewhere' is a link"),
        ("outside.h5", "the numbers of 'raw' are in another file"),
        ("bomb.dhyd", "'huge' has 1000000000000 numbers, so it is not read"),
        ("other.h5", "has no 'body1/hydro_coeffs'"),
        ("other.dhyd", "has no 'mass/added_mass'"),
        ("still.dhyd", "has no 'mass/omega'"),
        ("alone.dhyd", "has no 'Heave/wave_direction'"),
        ("other.nc", "has no 'added_mass' and 'radiation_damping'"),
        ("bare.nc", "has no 'added_mass' and 'radiation_damping'"),
        ("nan.h5", "its added mass has numbers that are not finite"),
        ("short.h5", "a table is 6 × 6 × 4; 6 × 6 × 2 are needed"),
        ("word.hyd", "has a column that is no number"),
        ("rows.hyd", "at 0.4 rad/s 'BDAMP' has 5 rows; six are needed"),
        ("early.hyd", "'ADMAS' stands before the first 'OMEGA'"),
        ("motions.nc", "no body has the six motions surge to yaw; it has mode 0, mode 1"),
        ("reverse.nc", "-3 kg/m^3 is not the density of water"),
        ("drift_nan.nc", "its drift forces have numbers that are not finite"),
        ("adrift.nc", "its 'added_mass' does not run over 'omega'"),
        ("drift_over.nc", "its 'drift_force_surge' runs over omega, body_name"),
    ],
)
def test_broken_files_say_what_is_wrong(name: str, says: str, tmp_path: Path) -> None:
    path = spoiled(tmp_path, name)
    with pytest.raises(DatabaseError) as caught:
        read_database(path)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(DatabaseError, match=r"cannot be read \(no such file"):
        read_database(tmp_path / "a.h5")
