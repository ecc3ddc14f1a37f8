"""Waves in lift files: what is refused and told, and forces between what a database knows."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import databases
import waves
from afloat import DRAFT, LENGTH, barge, lift_of, written
from floating import SEA
from gantline.assembly import assemble
from gantline.hydro.database import DatabaseError, HydrodynamicDatabase, read_database
from gantline.results.rig import Rig
from gantline.scenario import ScenarioError, load_scenario
from json_lift import plain_lift

SWELL = {"significant_height": "1 m", "peak_period": "8 s", "direction": "0 deg"}

_LINE = {"vessel": "barge", "fairlead": ["0 m", "0 m", "6 m"], "to": ["-180 m", "20 m", "0 m"]}
_STAY = {"mass": "10 kg/m", "axial_stiffness": "80 MN", "minimum_breaking_force": "1 MN"}
#: The barge on a line aft.
MOORED: dict[str, Any] = {
    "ropes": {"stay": _STAY},
    "mooring_lines": {"aft": {**_LINE, "rope": "stay", "pretension": "100 kN"}},
}


def refused(folder: Path, train: dict[str, Any]) -> str:
    path = written(folder, lift_of(barge(), waves={"swell": train}))
    with pytest.raises(ScenarioError) as error:
        assemble(load_scenario(path))
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
            "6 m every 5 s break in deep water; less than 5.54 m stand",
        ),
        (
            {**SWELL, "phase": "90 deg"},
            "waves.swell.phase: 'phase' is for waves with 'height'; those of a sea are drawn by its 'seed'",
        ),
        ({"direction": "0 deg", "height": "1 m", "period": "8 s", "phase": "90"}, "waves.swell.phase: "),
        ({**SWELL, "components": "3"}, "components"),
        ({"significant_height": "1 m", "peak_period": "8 s"}, "'direction' is missing"),
    ],
)
def test_what_is_refused(tmp_path: Path, train: dict[str, Any], said: str) -> None:
    assert said in refused(tmp_path, train)


def test_a_phase_is_told_where_waves_are(tmp_path: Path) -> None:
    """In the head of tables and reports; of more than a turn in rad that degrees may be meant."""
    train = {"direction": "0 deg", "height": "1 m", "period": "8 s", "phase": "-90 deg"}
    path = waves.in_waves(tmp_path, {"swell": train})
    sea = Rig.from_json(assemble(load_scenario(path)).rig).sea
    assert sea is not None
    assert (
        sea.trains[0].in_words == "swell: 1.00 m height, 8.0 s period, running towards 0 deg, phase -90 deg"
    )
    said = warnings_of(tmp_path, {**train, "phase": "30 rad"})
    assert "30 rad are 4.77 turns; '30 deg' may be meant" in said


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
    assert "swell is steeper than seas are: 3 m at a peak of 5 s, more than 1/15 of its length" in found
    # 1/15 at 8 s and 1/25 at 15 s, linear between: 1/19.4 of 224.8 m, 11.56 m, at 12 s.
    long = {**SWELL, "significant_height": "11.7 m", "peak_period": "12 s"}
    assert "11.7 m at a peak of 12 s, more than 1/19.4 of its length" in warnings_of(tmp_path, long)
    assert "steeper" not in warnings_of(tmp_path, {**long, "significant_height": "11.4 m"})
    # The file's water is that of 9 s, its shortest waves of 2.09 s.
    assert "added_mass of barge is that of motions of 9 s; the waves have 5 s" in found
    short = {**SWELL, "significant_height": "0.2 m", "peak_period": "4 s"}
    assert "of the energy of swell is in waves shorter than any there; they do nothing" in warnings_of(
        tmp_path, short
    )


@pytest.mark.parametrize(("drifts", "moored"), [(True, False), (False, True), (True, True)])
def test_drift_forces_and_moorings_belong_together(tmp_path: Path, drifts: bool, moored: bool) -> None:
    """A vessel that nothing holds, and a mooring whose mean pull is not there; not where it is said."""
    path = waves.in_waves(tmp_path, {"swell": SWELL}, **(MOORED if moored else {}))
    size = (len(waves.FREQUENCIES), len(waves.DIRECTIONS), 3)
    waves.database(tmp_path, drift=np.ones(size) if drifts else None)
    (told,) = assemble(load_scenario(path)).warnings if drifts != moored else ("",)
    expected = {
        (True, False): "no mooring line holds barge against the drift forces of its waves",
        (False, True): "barge.nc has no drift forces: the pull of the mooring lines of barge is without them",
    }
    assert expected.get((drifts, moored), "") in told
    known = path.read_text().replace('"wave_forces": {', '"wave_forces": {"drift": false, ')
    path.write_text(known)
    assert assemble(load_scenario(path)).warnings == ()


@pytest.mark.parametrize("by", ["nothing", "matrix", "areas"])
def test_slow_motions_on_moorings_want_damping(tmp_path: Path, by: str) -> None:
    """A moored vessel with drift forces whose water takes nothing but what waves take is told."""
    area = {"area": "400 m^2", "coefficient": 1.0, "along": "y"}
    critical = {"sway": "5 %", "periods": {"sway": "60 s"}}
    given: dict[str, dict[str, Any]] = {
        "nothing": {},
        "matrix": {"water_damping": {"critical": critical}},
        "areas": {"current_areas": {"side": area}},
    }
    path = waves.radiating(tmp_path, {"swell": SWELL}, given[by], **MOORED)
    drift = np.ones((len(waves.FREQUENCIES), len(waves.DIRECTIONS), 3))
    waves.database(tmp_path, waves.radiated, drift=drift)
    told = " ".join(assemble(load_scenario(path)).warnings)
    assert ("nothing but waves takes of the slow motions of barge" in told) == (by == "nothing")


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
    """At its own as in the file; the other side as in a mirror; by density; zero beyond the shortest."""
    database = read_database(tmp_path / waves.database(tmp_path))
    assert isinstance(database, HydrodynamicDatabase)
    known = np.radians(30.0)
    at = np.array([0.7, 0.725, 0.75])
    ends, doubts = database.excitation_at(at, known, SEA)
    assert not doubts
    assert ends[0] == pytest.approx(waves.force_per_metre(0.7, known), rel=1e-9)
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


def test_the_phase_counts_from_amidships(tmp_path: Path) -> None:
    """The way of the middle of the vessel through the waves counts. A reference point there that is 3 m ahead
    of the file's origin has the phases of the file κ 3 m cos β earlier. Forces are those per metre, whatever
    the place of the barge.
    """
    wave = {"height": "2 cm", "period": f"{2 * np.pi / 0.7!r} s", "direction": "40 deg"}
    path = waves.in_waves(tmp_path, {"swell": wave}, {"position": ["70 m", "30 m"], "heading": "20 deg"})
    waves.database(tmp_path, reference=(3.0, 0.0, -1.0))
    force = next(f for f in assemble(load_scenario(path)).document["forces"] if f["type"] == "wave")
    assert force["at"] == [LENGTH / 2, 0.0, DRAFT]
    assert force["origin"] == [LENGTH / 2, 0.0, DRAFT]
    # All seven of the file, and five of them from the other side.
    assert np.degrees(force["directions"]) == pytest.approx(np.arange(0.0, 360.0, 30.0), abs=1e-9)
    both = np.array(force["phasors"])[0, :, 0]  # of cubics what they have at the directions themselves
    around = np.radians(30.0 * np.arange(12))
    turned = np.exp(-1j * 0.7**2 / waves.G * 3.0 * np.cos(around))
    expected = [waves.force_per_metre(0.7, b) * turn for b, turn in zip(around, turned, strict=True)]
    found = both[..., 0] + 1j * both[..., 1]
    assert found == pytest.approx(np.array(expected), rel=1e-9, abs=1e-6)


def test_the_shortest_wave_of_a_file_is_in_it(tmp_path: Path) -> None:
    """Its own frequency, 3 rad/s, as a period of ten digits: it was above the highest by its last digit, and
    refused with "1e+02 % of the energy of swell is in waves shorter than any there".
    """
    for period in ("2.0943951 s", "2.0943952 s", "2.094395102 s"):
        wave = {"height": "2 cm", "period": period, "direction": "0 deg"}
        assert "shorter" not in warnings_of(tmp_path, wave)


def test_waves_longer_than_the_file_knows(tmp_path: Path) -> None:
    """The longest there are of 2π/0.2 = 31.4 s; forces of longer ones are theirs, which was not said."""
    long = {"height": "1 m", "period": "40 s", "direction": "0 deg"}
    sentence = (
        "100 % of the energy is in waves longer than any there; they push as those of 31.42 s, the longest"
    )
    assert sentence in warnings_of(tmp_path, long)
    assert "longer" not in warnings_of(tmp_path, {**long, "period": "31 s"})


def test_waves_of_another_depth(tmp_path: Path) -> None:
    """The file is for deep water; 50 m are deep for 8 s, κd = 3.2, not for 12 s: κd = 1.53, κ 10 % more."""
    swell = {"height": "1 m", "period": "12 s", "direction": "0 deg"}
    water = {"density": "1025 kg/m^3", "depth": "50 m"}
    found = warnings_of(tmp_path, swell, water=water)
    assert "barge.nc (Capytaine) is for deep water, the lift is in water 50 m deep" in found
    assert "deep water" not in warnings_of(tmp_path, {**swell, "period": "8 s"}, water=water)
    assert "deep water" not in warnings_of(tmp_path, swell)


def test_waves_that_break_over_the_ground(tmp_path: Path) -> None:
    """0.142 λ tanh κd (Miche 1944): in 3 m of water λ = 53.16 m for 10 s, and 0.142 ω²λ²/2πg = 2.57 m."""
    wave = {"height": "4 m", "period": "10 s", "direction": "0 deg"}
    with pytest.raises(
        ScenarioError, match=r"4 m every 10 s break in a depth of 3 m; less than 2\.57 m stand"
    ):
        warnings_of(tmp_path, wave, water={"depth": "3 m"})
    assert "break" not in warnings_of(tmp_path, wave)


def test_vessels_in_waves_without_their_water(tmp_path: Path) -> None:
    """Wave forces alone, and added mass of infinite frequency, are no motion in waves."""
    name = waves.database(tmp_path)
    alone = barge(wave_forces={"database": name, "at": ["50 m", "0 m", "4 m"]})
    path = written(tmp_path, lift_of(alone, waves={"swell": SWELL}))
    found = assemble(load_scenario(path)).warnings
    for key in ("added_mass", "water_damping"):
        said = f"barge has 'wave_forces' and no '{key}': its motions in waves are not its own"
        assert len([one for one in found if said in one]) == 1


def test_a_file_too_coarse_for_its_waves(tmp_path: Path) -> None:
    """In a file of directions 30° apart the phase at a corner of the barge of 100 × 30 m, in waves to 45°,
    turns by κ 30°·(50 sin 60° + 15 cos 60°) m = 26.6 m κ at most: by 1.5 rad in waves of 8.45 s, κ = ω²/g. To
    30°, as in the file, forces need no others.
    """
    barely = {"height": "10 cm", "period": "8.4 s", "direction": "45 deg"}
    found = warnings_of(tmp_path, barely)
    assert "of barge.nc (Capytaine) are far apart for waves of 8.4 s and shorter, which are " in found
    assert "forces between them may be a tenth and more off" in found
    assert "far apart" not in warnings_of(tmp_path, {**barely, "period": "8.5 s"})
    assert "far apart" not in warnings_of(tmp_path, {**barely, "direction": "30 deg"})
    # In a sea of a peak of 8.5 s much of what moves the barge is shorter, in one of 20 s little.
    swell = {"significant_height": "0.3 m", "peak_period": "8.5 s", "direction": "45 deg"}
    assert "far apart" in warnings_of(tmp_path, swell)
    assert "far apart" not in warnings_of(tmp_path, {**swell, "peak_period": "20 s"})


def test_drift_forces_where_a_file_has_them(tmp_path: Path) -> None:
    """By default where the file has any, not with `drift: false`; asked of a file without any an error."""
    drift = np.ones((len(waves.FREQUENCIES), len(waves.DIRECTIONS), 3))

    @cache
    def forces(has: bool, **given: bool) -> dict[str, Any]:
        about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
        afloat = {"wave_forces": {"database": "barge.nc", "at": about, **given}}
        path = waves.in_waves(tmp_path, {"swell": SWELL}, afloat)
        if has:
            waves.database(tmp_path, drift=drift)
        return {force["type"]: force for force in assemble(load_scenario(path)).document["forces"]}

    def drifts(has: bool, **given: bool) -> Any:
        return forces(has, **given)["wave"]["drifts"]

    # All seven of the file, and five of them mirrored, of each of a hundred waves.
    assert np.shape(drifts(True)) == (100, 12, 4, 3)
    assert np.array(drifts(True))[:, :, 0, 0] == pytest.approx(1.0)
    assert np.array(drifts(True))[0, [1, 11], 0] == pytest.approx(np.array([[1, 1, 1], [1, -1, -1]]))
    assert drifts(True, drift=False) == drifts(False) == []
    with pytest.raises(ScenarioError, match=r"wave_forces\.database: barge\.nc.*: has no drift forces"):
        drifts(False, drift=True)
    damped = [forces(True), forces(True, drift_damping=False), forces(True, drift=False), forces(False)]
    assert ["mean_drift" in found for found in damped] == [True, True, False, False]
    assert np.any(np.array(damped[0]["mean_drift"]["around"])[..., :3])
    assert not np.any(np.array(damped[1]["mean_drift"]["around"])[..., :3])


@pytest.mark.parametrize(("lines", "start"), [(1, "rest"), (2, "rest"), (2, "as_given")])
def test_mean_drift_forces_from_the_start(tmp_path: Path, lines: int, start: str) -> None:
    """Where two lines hold a vessel that starts at rest; on one it would swing round first."""
    moored = {f"line{k}": MOORED["mooring_lines"]["aft"] for k in range(lines)}
    path = waves.in_waves(tmp_path, {"swell": SWELL}, **{**MOORED, "mooring_lines": moored}, start=start)
    waves.database(tmp_path, drift=np.ones((len(waves.FREQUENCIES), len(waves.DIRECTIONS), 3)))
    scenario = load_scenario(path)
    forces = {force["type"]: force for force in assemble(scenario).document["forces"]}
    is_there = lines > 1 and start == "rest"
    assert forces["mean_drift"]["settled"] is is_there
    assert ("with their mean drift forces" in scenario.left_out_at_rest[0]) is is_there


def test_mean_drift_forces_are_about_amidships(tmp_path: Path) -> None:
    """Forces of a file about a point 30 m aft of there and 4 m to port: its yaw, and x F_y − y F_x."""
    alike = np.ones((len(waves.FREQUENCIES), len(waves.DIRECTIONS), 3))

    def rates(at: list[str]) -> Any:
        forces = {"database": "barge.nc", "at": at}
        path = waves.in_waves(tmp_path, {"swell": SWELL}, {"wave_forces": forces})
        waves.database(tmp_path, drift=alike * [1.0, 0.0, 0.0])
        force = assemble(load_scenario(path)).document["forces"][-1]
        assert force["type"] == "mean_drift" and force["at"] == [LENGTH / 2, 0.0, DRAFT]
        return np.array(force["around"])[0, 0]

    about = rates([f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"])
    away = rates([f"{LENGTH / 2 - 30} m", "4 m", f"{DRAFT} m"])
    # Yaw about the middle of a surge of 1 through the point: −4.
    assert away[2] == pytest.approx(-4.0 * about[0], rel=1e-9, abs=1e-9)
    assert away[:2] == pytest.approx(about[:2])


def test_drift_forces_between_frequencies(tmp_path: Path) -> None:
    """They stay between those beside them, however they jump, and beyond the ends they are as at the ends."""
    drift = np.zeros((len(waves.FREQUENCIES), len(waves.DIRECTIONS), 3))
    drift[20:] = 5e5
    database = read_database(tmp_path / waves.database(tmp_path, drift=drift))
    known = waves.FREQUENCIES
    at = np.concatenate([[0.1], np.linspace(known[18], known[22], 101), [4.0]])
    around = database.drift_around(at, SEA)
    assert around is not None
    found = around.cubics[:, :, 0, 0].real
    assert found.min() >= 0.0 and found.max() <= 5e5 * (1 + 1e-12)
    assert np.all(np.diff(found, axis=0) >= 0.0)
    assert found[0] == pytest.approx(0.0) and found[-1] == pytest.approx(5e5)
