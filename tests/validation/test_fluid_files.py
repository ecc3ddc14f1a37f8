"""Hulls and hydrodynamic databases of others, in lift files: to the figures that are known of them."""

from __future__ import annotations

import math
import shutil
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.assembly import assemble
from gantline.hydro import Attitude, hydrostatics, read_database, read_hull
from gantline.scenario import load_scenario
from gantline.statics import Statics
from json_lift import plain_lift, vessel
from mechanics import period

DATA = Path(__file__).resolve().parents[2].parent / "shared" / "data"
SEA, FRESH, G = 1025.0, 1000.0, 9.81


def data(file: str) -> Path:
    path = DATA / file
    if not path.exists():
        pytest.skip(f"../shared/data/{file} is not beside this checkout")
    return path


def beside(folder: Path, file: str) -> str:
    """A file of the data beside a lift file; its name there."""
    return Path(shutil.copy(data(file), folder)).name


@pytest.mark.parametrize(
    ("file", "axis", "omega", "tonnes"),
    [
        ("hydrodynamics/barge_100x30x4.dhyd", 2, 0.5, 45050.6),
        ("hydrodynamics/barge_100x30x4.dhyd", 2, 0.8, 29252.7),
        ("hydrodynamics/barge_100x30x4.dhyd", 2, 1.0, 27954.5),
        ("crane_vessels/cheetah.dhyd", 2, 0.5, 151309.5),
        ("crane_vessels/cheetah.dhyd", 3, 0.5, 1.187e7),
        ("hydrodynamics/barge_100x30x4_ofx.hyd", 2, 1.0472, 29086.4),
    ],
)
def test_added_mass_of_the_table(file: str, axis: int, omega: float, tonnes: float) -> None:
    """Figures of the data's table, to half of their last digit."""
    found = read_database(data(file))
    (place,) = np.flatnonzero(np.isclose(found.frequencies, omega, rtol=1e-5))
    wanted = pytest.approx(tonnes, abs=0.05 if tonnes < 1e6 else 5e3)
    assert found.added_mass[place, axis, axis] / 1e3 == wanted


def test_waves_push_a_barge_with_its_waterplane_at_long_periods() -> None:
    """Heave force for ω to 0: ρgA = 29 430 kN/m; the file has 29 422 kN/m at 0.01 rad/s."""
    found = read_database(data("hydrodynamics/barge_100x30x4.dhyd"))
    assert found.excitation is not None
    assert np.abs(found.excitation[0, :, 2]) == pytest.approx(29422e3, abs=0.5e3)
    assert found.directions == pytest.approx(np.linspace(0, math.pi, 9))


def amplitudes(path: Path) -> np.ndarray:
    """Wave forces of a text database, in 24 directions all round; largest frequency last, as elsewhere.

    Shape (frequency, direction, 6) [N, N m].
    """
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("FAMP")]
    rows = [[float(line[10 * part : 10 * part + 10]) * 1e3 for part in range(1, 7)] for line in lines]
    return np.array(rows).reshape(-1, 24, 6)[::-1]


def water_of(omega: np.ndarray, forces: np.ndarray, damping: np.ndarray) -> np.ndarray:
    """Density of deep water with which wave forces X and damping B agree [kg/m^3].

    Haskind, in Newman's form: B = ω³/(4πρg³) ∫|X|² dβ over all directions β, which stand evenly all round.
    """
    round_about: np.ndarray = 2 * math.pi * (forces**2).mean(axis=1)
    density: np.ndarray = omega**3 / (4 * math.pi * G**3) * round_about / damping
    return density


def test_two_programs_agree_about_a_barge() -> None:
    """The same barge from two files. The text does not say for which water it is; its wave forces and damping
    say 1025 kg/m³ in all six motions, to 1.2 % up to 1.3 rad/s, beyond which frequencies are irregular. The
    other file is for 1000 and its own wave forces and damping differ from that by 3 to 6 % in heave and pitch
    and 7 to 11 % in roll: so coarse are its panels. In the same water heave, roll and pitch agree to 3.1 %.
    """
    text = data("hydrodynamics/barge_100x30x4_ofx.hyd")
    one, other = read_database(data("hydrodynamics/barge_100x30x4.dhyd")), read_database(text)
    assert other.density is None
    forces, long = amplitudes(text), other.frequencies < 1.3
    assert list(other.frequencies) == sorted(other.frequencies) and long.sum() == 13
    for axis in range(6):
        found = water_of(other.frequencies, forces[:, :, axis], other.damping[:, axis, axis])[long]
        assert found == pytest.approx(SEA, rel=0.015)
    for axis in (2, 3, 4):
        pair = [
            one.added_mass_at(2 * math.pi, SEA)[0][axis, axis],
            other.added_mass_at(2 * math.pi, SEA)[0][axis, axis],
        ]
        assert pair[0] == pytest.approx(pair[1], rel=0.031)


def test_sphere_of_task_10_has_the_added_mass_of_a_hemisphere() -> None:
    """A₃₃(∞)/ρV = 0.50006 with the file's own volume; at KR = 0.999 Hulme's 0.4287 and 0.2487 to 0.001."""
    found = read_database(data("hydrodynamics/sphere.h5"))
    assert found.infinite_added_mass is not None and found.displacement is not None
    assert found.infinite_added_mass[2, 2] / (FRESH * found.displacement) == pytest.approx(0.50006, abs=5e-6)
    assert found.reference == pytest.approx([0, 0, -2])
    # Surge and pitch about z = −2: pressure on a sphere has no moment about its centre, 2 m above.
    infinite = found.infinite_added_mass
    assert infinite[0, 4] == pytest.approx(2 * infinite[0, 0], rel=1e-4)
    place = int(np.argmin(np.abs(found.frequencies**2 * 5 / G - 0.999)))
    whole = FRESH * 2 / 3 * math.pi * 125
    assert found.added_mass[place, 2, 2] / whole == pytest.approx(0.4287, abs=1e-3)
    damping = found.damping[place, 2, 2] / (whole * found.frequencies[place])
    assert damping == pytest.approx(0.2487, abs=1e-3)
    # Long waves lift it with its section: 770 389 N/m.
    assert found.excitation is not None
    assert abs(found.excitation[0, 0, 2]) == pytest.approx(770389, rel=3e-3)


@pytest.mark.parametrize("amplitude", [0.05, 5.0])
def test_sphere_of_task_10_bobs_in_a_lift_file(amplitude: float, tmp_path: Path) -> None:
    """261.8 t on the mesh's own buoyancy with A₃₃(∞) of the database: against a quadrature of the oscillator
    (m + a) z̈ = ρg (V(z) − V₀), V by hydrostatics of the mesh at 241 drafts: within 0.1 %.
    """
    hull, database = (
        beside(tmp_path, f"hydrodynamics/{name}") for name in ("oes_task10_sphere.obj", "sphere.h5")
    )
    mass, mesh = 261.8e3, read_hull(data("hydrodynamics/oes_task10_sphere.obj"))
    low, high = mesh.box[:, 2]
    drafts = np.linspace(low + 1e-6, high - 1e-6, 241)
    volumes = np.array([hydrostatics(mesh, Attitude(float(draft)), FRESH).volume for draft in drafts])
    rest = float(np.interp(mass / FRESH, volumes, drafts))
    # From 5 m it dips under by a few millimetres, where it displaces all of its volume.
    below = np.linspace(high + 0.05, high + 1.0, 20)
    drafts = np.concatenate([drafts, below])
    volumes = np.concatenate([volumes, np.full(len(below), mesh.closure.volume)])
    # Released `amplitude` above rest: draft d = rest − z.
    top = min(amplitude, rest - drafts[0])
    added = read_database(tmp_path / database).added_mass_at(None, FRESH)[0][2, 2]
    wanted = _period(drafts, volumes, rest, top, mass, mass + added)
    body = {
        "joint": {"type": "slider", "axis": [0, 0, 1], "position": f"{top - rest!r} m"},
        "mass": f"{mass} kg",
        "hull": {"mesh": hull},
        "added_mass": {"database": database, "period": "infinite_frequency", "at": ["0 m", "0 m", "-2 m"]},
    }
    lift = plain_lift(tmp_path, {"sphere": body}, water={"density": "1 t/m^3"}, duration="30 s")
    recording = gantline.simulate(lift)
    height = recording.dataset["body_position"].values[:, 0, 2] + rest
    assert period(recording.dataset["time"].values, height) == pytest.approx(wanted, rel=1e-3)
    if amplitude < 1:
        area = hydrostatics(mesh, Attitude(rest), FRESH).waterplane_area
        small = 2 * math.pi * math.sqrt((mass + added) / (FRESH * G * area))
        assert wanted == pytest.approx(small, rel=1e-3)


def _period(
    drafts: np.ndarray,
    volumes: np.ndarray,
    rest: float,
    top: float,
    mass: float,
    whole: float,
) -> float:
    """Twice the time from the highest to the lowest place, of equal energy, by z = middle + half cos φ."""
    from scipy.interpolate import CubicSpline
    from scipy.optimize import brentq

    energy = CubicSpline(drafts, FRESH * G * volumes - mass * G).antiderivative()
    start = rest - top
    end = float(brentq(lambda draft: float(energy(draft) - energy(start)), rest + 0.3 * top, drafts[-1]))
    angle = (np.arange(2000) + 0.5) / 2000 * math.pi
    middle, half = (start + end) / 2, (end - start) / 2
    gap = energy(start) - energy(middle - half * np.cos(angle))
    speed = np.sqrt(2 * np.maximum(gap, 1e-300) / whole)
    return float(2 * np.sum(half * np.sin(angle) / speed) * math.pi / 2000)


@pytest.mark.parametrize(
    ("file", "draft", "volume", "within", "centre"),
    [
        # Another mesh of the same hull displaces 0.02 % more: 53 290.76 m³ within 0.05 %.
        ("crane_vessels/buoyancy_cheetah.obj", 6.75, 53290.76, 5e-4, 103.577),
        # SIMMAN 2008: 8424 m³; facets inside the hull take 0.45 %.
        ("hulls/dtmb5415.stl", 6.15, 8424.0, 5e-3, 70.282),
    ],
)
def test_known_hulls_float_at_their_drafts_in_lift_files(
    file: str, draft: float, volume: float, within: float, centre: float, tmp_path: Path
) -> None:
    """A vessel of ρ times the published volume, over its centre of buoyancy: at rest on even keel at that
    draft, to what the volume's tolerance is of the water plane.
    """
    name = beside(tmp_path, file)
    known = hydrostatics(read_hull(data(file)), Attitude(draft, middle=centre), SEA)
    given = vessel(
        SEA * volume,
        (centre, float(known.centre_of_buoyancy[1]), draft),
        draft - 0.3,
        hull={"mesh": name},
        trim="0.2 deg",
    )
    lift = plain_lift(tmp_path, vessels={"ship": given})
    rest = Statics(lift).equilibrium()
    height = rest.recording.dataset["body_position"].values[-1, 0, 2]
    # The centre of gravity was put where the water is at that draft.
    assert height == pytest.approx(0.0, abs=within * volume / known.waterplane_area)


def test_a_crane_vessel_with_its_database(tmp_path: Path) -> None:
    """Cheetah at 12.566 s: heave added mass 151 309.5 t of fresh water, 1.025 of it in the sea, about
    (100, 0, 6.75) of the hull.
    """
    hull, database = (
        beside(tmp_path, f"crane_vessels/{name}") for name in ("buoyancy_cheetah.obj", "cheetah.dhyd")
    )
    source = {"database": database, "period": f"{4 * math.pi!r} s", "at": ["100 m", "0 m", "6.75 m"]}
    given = vessel(
        SEA * 53278.1,
        (103.577, 0.0, 12.0),
        6.75,
        hull={"mesh": hull},
        added_mass=source,
        water_damping=source,
    )
    lift = plain_lift(tmp_path, vessels={"cheetah": given})
    forces = {force["type"]: force for force in assemble(load_scenario(lift)).document["forces"]}
    assert forces["added_mass"]["matrix"][2][2] == pytest.approx(1.025 * 151309.5e3, rel=1e-6)
    question = Statics(lift)
    assert question.equilibrium().unstable == 0
    # Heave of 8821.4 m² by itself; pitch, which is coupled with it, moves it by a few per cent.
    periods = sorted(mode.period for mode in question.modes() if mode.period is not None)
    alone = 2 * math.pi * math.sqrt((53278.1 * SEA + 1.025 * 151309.5e3) / (SEA * G * 8821.4))
    assert any(one == pytest.approx(alone, rel=0.05) for one in periods)
