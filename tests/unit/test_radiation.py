"""`radiation` in lift files: what is refused and told, and what the core gets."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import databases
import waves
from afloat import barge, lift_of, written
from gantline.assembly import assemble
from gantline.hydro.database import DatabaseError, HydrodynamicDatabase, read_database
from gantline.hydro.memory import fit_memory
from gantline.scenario import ScenarioError, load_scenario
from json_lift import plain_lift

ABOUT = ["50 m", "0 m", "4 m"]
RADIATION = {"database": "barge.nc", "at": ABOUT}


def refused(folder: Path, **vessel: Any) -> str:
    path = written(folder, lift_of(barge(**vessel)))
    with pytest.raises(ScenarioError) as error:
        assemble(load_scenario(path))
    said = str(error.value)
    assert len(said.splitlines()) == 1
    return said


@pytest.mark.parametrize(
    ("vessel", "said"),
    [
        ({"radiation": {"at": ABOUT}}, "barge.radiation: 'database' is missing"),
        ({"radiation": {"database": "barge.nc"}}, "barge.radiation: 'at' is missing"),
        ({"radiation": {**RADIATION, "period": "9 s"}}, "'period' is not a key of radiation"),
        (
            {"radiation": {**RADIATION, "database": "no.nc"}},
            "barge.radiation.database: no.nc: cannot be read",
        ),
        (
            {"radiation": RADIATION, "added_mass": {"heave": "100 t"}},
            "barge.added_mass: 'radiation' holds the added mass of all frequencies; leave one out",
        ),
        (
            {"radiation": RADIATION, "water_damping": {**RADIATION, "period": "9 s"}},
            "barge.water_damping: 'radiation' holds the damping of all frequencies; leave the 'database' out",
        ),
    ],
)
def test_what_is_refused(vessel: dict[str, Any], said: str, tmp_path: Path) -> None:
    """One sentence, at the path of what is wrong."""
    waves.database(tmp_path, waves.radiated)
    assert said in refused(tmp_path, **vessel)


def test_files_that_say_too_little(tmp_path: Path) -> None:
    """Four frequencies, and one alone, are refused with what would be right."""
    databases.capytaine(tmp_path / "barge.nc")
    said = refused(tmp_path, radiation=RADIATION)
    assert (
        "barge.radiation.database: barge.nc (Capytaine): has 4 frequencies, periods from 6.283 to 15.71 s"
        in said
    )
    assert "memory needs 8 periods below two minutes, the longest 4 times the shortest" in said
    assert "'added_mass' and 'water_damping' of one period do with less" in said
    whole = read_database(tmp_path / "barge.nc")
    one = HydrodynamicDatabase(
        whole.name, whole.source, whole.frequencies[:1], whole.added_mass[:1], whole.damping[:1], 1000.0
    )
    with pytest.raises(DatabaseError, match="has one frequency; memory needs 8"):
        fit_memory(one, 1000.0)


def made_up(added: Any, damping: Any) -> HydrodynamicDatabase:
    return HydrodynamicDatabase("barge", "made up", waves.FREQUENCIES, added, damping, 1025.0)


def test_files_that_contradict_themselves() -> None:
    """Damping without any change of added mass is no water, which is an error; a little of that is told."""
    added, damping = waves.radiated(waves.FREQUENCIES)
    with pytest.raises(DatabaseError, match=r"do not go together as those of one water.*of one period"):
        fit_memory(made_up(*waves.constant(waves.FREQUENCIES)), 1025.0)
    bent = damping.copy()
    bent[:, 2, 2] *= 1 + 0.35 * np.cos(40 * waves.FREQUENCIES)
    (doubt,) = fit_memory(made_up(added, bent), 1025.0).doubts
    assert doubt.startswith("made up: its damping and added mass do not go together")
    assert "most in heave at" in doubt


def test_a_motion_that_makes_no_waves_has_its_added_mass(tmp_path: Path) -> None:
    """Yaw of a body of revolution: no damping, no term, A(∞) the mean of the file."""
    added, damping = waves.radiated(waves.FREQUENCIES)
    added[:, 5, :] = added[:, :, 5] = damping[:, 5, :] = damping[:, :, 5] = 0.0
    added[:, 5, 5] = 3e6
    memory = fit_memory(made_up(added, damping), 1025.0)
    assert not memory.strengths[:, 5].any() and not memory.strengths[:, :, 5].any()
    assert memory.infinite_added_mass[5, 5] == pytest.approx(3e6, rel=1e-12)


def test_it_goes_with_the_density_of_the_water(tmp_path: Path) -> None:
    """In fresh water all of it is by 1000/1025 less."""
    added, damping = waves.radiated(waves.FREQUENCIES)
    sea, fresh = (fit_memory(made_up(added, damping), density) for density in (1025.0, 1000.0))
    frequency = np.array([0.5, 1.0])
    assert fresh.damping(frequency) == pytest.approx(sea.damping(frequency) / 1.025, rel=1e-6, abs=1.0)
    assert fresh.infinite_added_mass == pytest.approx(sea.infinite_added_mass / 1.025, rel=1e-6, abs=1.0)


def test_vessels_and_bodies_of_mechanics_have_it(tmp_path: Path) -> None:
    """Both come to an added mass and a memory about one point; other damping stays; nothing is doubtful."""
    swell = {"height": "1 m", "period": "5 s", "direction": "0 deg"}
    path = waves.radiating(tmp_path, {"swell": swell}, {"water_damping": {"roll": "1 MN m s"}})
    made = assemble(load_scenario(path))
    forces = {force["name"]: force for force in made.document["forces"]}
    assert forces["barge.radiation"]["at"] == forces["barge.added_mass"]["at"] == [50.0, 0.0, 4.0]
    assert len(forces["barge.radiation"]["terms"]) > 10
    assert forces["barge.water_damping"]["damping"][3][3] == 1e6
    assert made.warnings == ()
    joint = {"type": "slider", "axis": [0, 0, 1]}
    body = {"joint": joint, "mass": "10 t", "radiation": {"database": "barge.nc", "at": [0, 0, 0]}}
    document = assemble(load_scenario(plain_lift(tmp_path, {"float": body}))).document
    assert [force["type"] for force in document["forces"]] == ["added_mass", "memory"]
    assert json.dumps(document, allow_nan=False)


def test_shares_of_critical_damping_are_of_each_motion_at_its_own_frequency(tmp_path: Path) -> None:
    """5 % of roll beside the memory: φᵀ C φ = 2 ζ ω, φ and ω of K φ = ω² (M + A(ω)) φ."""
    path = waves.radiating(tmp_path, {}, {"water_damping": {"critical": {"roll": "5 %"}}})
    made = assemble(load_scenario(path))
    (drag,) = [force for force in made.document["forces"] if force["name"] == "barge.critical_damping"]
    memory = fit_memory(read_database(tmp_path / "barge.nc"), 1025.0)
    omega = 1.0
    for _ in range(100):
        added = memory.added_mass(np.array([omega]))[0]
        stiffness = waves.impedance(0.0, added).real
        inertia = (stiffness - waves.impedance(omega, added, 0 * added).real) / omega**2
        half = np.linalg.inv(np.linalg.cholesky(inertia))
        squares, scaled = np.linalg.eigh(half @ stiffness @ half.T)
        shapes = half.T @ scaled
        roll = int(np.argmax(np.abs(shapes[3]) * (squares > 1e-6)))
        omega = float(np.sqrt(squares[roll]))
    # From the middle of the waterline to the centre of gravity, 1 m above it.
    shape = shapes[:, roll].copy()
    shape[:3] += np.cross(shape[3:], [0.0, 0.0, 1.0])
    damped = float(shape @ np.array(drag["damping"]) @ shape)
    assert damped == pytest.approx(2 * 0.05 * omega, rel=1e-6)
