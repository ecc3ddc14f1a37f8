"""Waves in lift files: what is refused and told, and forces between what a database knows."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import databases
import waves
from afloat import barge, lift_of, written
from floating import SEA
from gantline.assembly import assemble
from gantline.hydro.database import DatabaseError, HydrodynamicDatabase, read_database
from gantline.scenario import ScenarioError, load_scenario
from json_lift import plain_lift

SWELL = {"significant_height": "1 m", "peak_period": "8 s", "direction": "0 deg"}


def refused(folder: Path, train: dict[str, Any]) -> str:
    path = written(folder, lift_of(barge(), waves={"swell": train}))
    with pytest.raises(ScenarioError) as error:
        load_scenario(path)
    return str(error.value)


@pytest.mark.parametrize(
    ("train", "said"),
    [
        ({"direction": "0 deg"}, "waves.swell: needs 'significant_height: 1.5 m' and 'peak_period: 8 s'"),
        ({"direction": "0 deg", "height": "1 m"}, "'period' is missing beside 'height'"),
        ({**SWELL, "height": "1 m", "period": "8 s"}, "leave one pair out"),
        ({"direction": "0 deg", "height": "1 m", "period": "8 s", "seed": "2"}, "'seed' is for a sea"),
        (
            {"direction": "0 deg", "height": "6 m", "period": "5 s"},
            "6 m every 5 s, 39 m apart in deep water, break; less than 5.54 m stand",
        ),
        ({**SWELL, "components": "3"}, "components"),
        ({"significant_height": "1 m", "peak_period": "8 s"}, "'direction' is missing"),
    ],
)
def test_what_is_refused(tmp_path: Path, train: dict[str, Any], said: str) -> None:
    assert said in refused(tmp_path, train)


def warnings_of(folder: Path, train: dict[str, Any], **given: Any) -> str:
    path = waves.in_waves(folder, {"swell": train}, **given)
    return "\n".join(assemble(load_scenario(path)).warnings)


def test_what_is_told(tmp_path: Path) -> None:
    """Waves that do nothing, steep seas, water of another period, waves that the file does not know."""
    path = written(tmp_path, lift_of(barge(), waves={"swell": SWELL}))
    assert "the waves swell pass under barge without a trace" in assemble(load_scenario(path)).warnings[0]
    plain = plain_lift(
        tmp_path, {"weight": {"mass": "1 t", "joint": {"type": "point"}}}, waves={"swell": SWELL}
    )
    assert "the waves swell do nothing: there are no vessels" in assemble(load_scenario(plain)).warnings[0]
    assert warnings_of(tmp_path, SWELL) == ""
    steep = {**SWELL, "significant_height": "3 m", "peak_period": "5 s"}
    found = warnings_of(tmp_path, steep)
    assert "swell is steeper than seas are: 3 m at a peak of 5 s" in found
    # The file's water is that of 9 s, its shortest waves of 2.09 s.
    assert "added_mass of barge is that of motions of 9 s; the waves have 5 s" in found
    short = {**SWELL, "significant_height": "0.2 m", "peak_period": "4 s"}
    assert "of the energy of swell is in waves shorter than any there; they do nothing" in warnings_of(
        tmp_path, short
    )


def test_waves_that_the_file_does_not_know(tmp_path: Path) -> None:
    """A regular wave beyond its shortest, a sea that is mostly shorter, a direction that it has not."""
    for train, said in (
        (
            {"height": "2 cm", "period": "2 s", "direction": "0 deg"},
            "has no waves of 2 s; the shortest are of 2.09",
        ),
        (
            {"significant_height": "0.1 m", "peak_period": "2.5 s", "direction": "0 deg"},
            "of the energy of swell",
        ),
    ):
        with pytest.raises(ScenarioError, match=said) as error:
            assemble(load_scenario(waves.in_waves(tmp_path, {"swell": train})))
        assert "vessels.barge.wave_forces.database" in str(error.value)
    few = read_database(databases.capytaine(tmp_path / "few.nc"))
    with pytest.raises(DatabaseError, match="no waves that run 45 deg from its bow; it has 0, 90 deg"):
        few.excitation_at(np.array([0.5]), np.radians(45.0), 1000.0)


def test_forces_between_frequencies_directions_and_sides(tmp_path: Path) -> None:
    """Linear in both, the other side as in a mirror, by the water's density, zero beyond the shortest."""
    database = read_database(tmp_path / waves.database(tmp_path))
    assert isinstance(database, HydrodynamicDatabase)
    known = np.radians(30.0)
    at = np.array([0.7, 0.725, 0.75])
    ends, doubts = database.excitation_at(at, known, SEA)
    assert not doubts
    assert ends[1] == pytest.approx((ends[0] + ends[2]) / 2, rel=1e-12)
    assert ends[0] == pytest.approx(waves.force_per_metre(0.7, known), rel=1e-9)
    between, _ = database.excitation_at(at[:1], np.radians(45.0), SEA)
    beside = [waves.force_per_metre(0.7, np.radians(angle)) for angle in (30.0, 60.0)]
    assert between[0] == pytest.approx((beside[0] + beside[1]) / 2, rel=1e-9)
    other, doubts = database.excitation_at(at, -known, SEA)
    assert "its waves come from one side; from the other they are mirrored" in doubts[0]
    assert other == pytest.approx(ends * [1, -1, 1, -1, 1, -1], rel=1e-12)
    assert other[0] == pytest.approx(waves.force_per_metre(0.7, -known), rel=1e-9)
    fresh, _ = database.excitation_at(at, known, 1000.0)
    assert fresh == pytest.approx(ends / 1.025, rel=1e-12)
    short, _ = database.excitation_at(np.array([0.1, 3.2]), known, SEA)
    assert np.all(short[1] == 0.0) and short[0] == pytest.approx(waves.force_per_metre(0.2, known), rel=1e-9)
    without = databases.capytaine(tmp_path / "none.nc", without=("Froude_Krylov_force", "diffraction_force"))
    with pytest.raises(DatabaseError, match="has no wave forces"):
        read_database(without).excitation_at(at, known, 1000.0)


def test_the_phase_counts_from_the_origin_of_the_file(tmp_path: Path) -> None:
    """A barge κΔ = π/2 further down the waves, and a reference point Δ ahead of the file's origin, are the
    same turn of the phase, one later and one earlier.
    """
    wave = {"height": "2 cm", "period": f"{2 * np.pi / 0.7!r} s", "direction": "0 deg"}
    way = np.pi / 2 / (0.7**2 / 9.81)

    def phasors(**vessel: Any) -> Any:
        path = waves.in_waves(tmp_path, {"swell": wave}, vessel)
        force = next(f for f in assemble(load_scenario(path)).document["forces"] if f["type"] == "wave")
        both = np.array(force["phasors"])[0]
        return both[:, 0] + 1j * both[:, 1]

    here, there = phasors(), phasors(position=[f"{way} m", "0 m"])
    assert there == pytest.approx(here * 1j, rel=1e-9, abs=1e-6)
