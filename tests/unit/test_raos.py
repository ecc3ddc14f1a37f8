"""Tables of RAOs: what is read of them, and what is said of those that cannot be."""

from __future__ import annotations

import math
from pathlib import Path
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gantline.hydro import DatabaseError, read_raos, write_raos
from gantline.hydro.raos import DisplacementRaos
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation
from hooked_lift import TWO_HOOKS, TWO_HOOKS_LUGS, TWO_HOOKS_SLINGS, hooked_lift
from table_of_raos import ON_DECK, goes_with_the_water

AXES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
UNITS = ("m/m",) * 3 + ("deg/m",) * 3
COLUMNS = [f"{name} [{unit}]" for name, unit in zip(AXES, UNITS, strict=True)]
HEAD = ",".join(
    [
        "direction [deg]",
        "period [s]",
        *(f"{column},{name} phase [deg]" for column, name in zip(COLUMNS, AXES, strict=True)),
    ]
)
WAVE = "0.1,10,0.2,20,0.3,30,4,40,5,50,6,60"


def written(folder: Path, *lines: str) -> Path:
    path = folder / "vessel.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def test_what_a_table_says(tmp_path: Path) -> None:
    """cos(ωt − φ) = Re(e^{iφ} e^{−iωt}); frequencies rise, whatever the order of lines."""
    raos = read_raos(written(tmp_path, "# of nobody", HEAD, f"180,6,{WAVE}", "", f"180,12,{WAVE}"), "lag")
    assert raos.frequencies == pytest.approx([2 * math.pi / 12, 2 * math.pi / 6])
    assert raos.directions == pytest.approx([math.pi])
    size = np.array([0.1, 0.2, 0.3, *np.radians([4.0, 5.0, 6.0])])
    assert raos.motion[1, 0] == pytest.approx(size * np.exp(1j * np.radians([10, 20, 30, 40, 50, 60])))


def test_semicolons_and_decimal_commas(tmp_path: Path) -> None:
    lines = [HEAD, f"180,6.5,{WAVE}"]
    plain = read_raos(written(tmp_path, *lines), "lag")
    other = [line.replace(",", ";").replace(".", ",") for line in lines]
    assert (read_raos(written(tmp_path, *other), "lag").motion == plain.motion).all()


@given(
    st.lists(st.floats(2.0, 40.0), min_size=1, max_size=5, unique_by="{:.10g}".format),
    st.lists(st.integers(0, 359), min_size=1, max_size=5, unique=True),
    st.randoms(use_true_random=False),
)
def test_what_is_written_is_read(
    tmp_path_factory: pytest.TempPathFactory, periods: list[float], directions: list[int], lots: Random
) -> None:
    """Twelve digits of each number are written: periods that differ by less are one."""
    frequencies = 2 * math.pi / np.array(sorted(periods, reverse=True))
    shape = (len(periods), len(directions), 6)
    parts = np.array([lots.uniform(-2.0, 2.0) for _ in range(2 * math.prod(shape))]).reshape(2, *shape)
    raos = DisplacementRaos("any", frequencies, np.radians(sorted(directions)), parts[0] + 1j * parts[1])
    path = tmp_path_factory.mktemp("raos") / "any.csv"
    write_raos(raos, path)
    found = read_raos(path, "lag")
    assert found.frequencies == pytest.approx(raos.frequencies, rel=1e-11)
    assert found.directions == pytest.approx(raos.directions, rel=1e-11)
    assert np.abs(found.motion - raos.motion).max() < 1e-10


@given(
    st.binary(max_size=400)
    | st.text(max_size=400).map(lambda text: (HEAD + "\n" + text).encode("utf-8", "replace"))
)
def test_any_file_is_a_table_or_one_sentence(tmp_path_factory: pytest.TempPathFactory, given: bytes) -> None:
    path = tmp_path_factory.mktemp("raos") / "any.csv"
    path.write_bytes(given)
    try:
        read_raos(path, "lead")
    except DatabaseError as problem:
        assert str(problem).startswith(str(path)) and "\n" not in str(problem)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ([HEAD], "has no waves"),
        (
            [HEAD.replace("sway [m/m]", "sway"), f"0,6,{WAVE}"],
            "1: 'sway' has no unit of it; 'sway [m/m]' is right",
        ),
        ([HEAD.replace("sway [m/m]", "side [m/m]"), f"0,6,{WAVE}"], "1: 'side [m/m]' is no column of RAOs"),
        ([HEAD.replace("sway [m/m]", "surge [m/m]"), f"0,6,{WAVE}"], "1: there are two columns 'surge'"),
        ([HEAD.replace("yaw [deg/m],", ""), f"0,6,{WAVE}"], "1: there is no column 'yaw [deg/m]'"),
        ([HEAD, f"0,6,{WAVE}", f"0,7,{WAVE},1"], "3: 15 numbers; there are 14 columns"),
        ([HEAD, f"0,six,{WAVE}"], "2: 'six' is no number; it is the period"),
        ([HEAD, f"0,0,{WAVE}"], "2: a period of 0 s; one above 0 s is right"),
        ([HEAD, f"0,6,-{WAVE}"], "2: a surge below zero; its phase tells its direction"),
        ([HEAD, f"0,6,{WAVE}", f"360,6,{WAVE}"], "3: waves of 6 s in 0 deg stand in line 2 already"),
        (
            [HEAD, f"0,6,{WAVE}", f"30,7,{WAVE}"],
            "has no waves of 7 s in 0 deg; every direction needs all periods",
        ),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, lines: list[str], said: str) -> None:
    with pytest.raises(DatabaseError) as problem:
        read_raos(written(tmp_path, *lines), "lag")
    assert said in str(problem.value)


def long_table(folder: Path, pitch: float = 1.0, heave: float = 1.0, unit: str = "deg/m") -> None:
    """A vessel that goes with the water, in waves of 60 s and shorter ones, from following to head seas."""
    write_raos(goes_with_the_water(pitch=pitch, heave=heave), folder / "vessel.csv")
    path = folder / "vessel.csv"
    path.write_text(
        path.read_text(encoding="utf-8").replace("pitch [deg/m]", f"pitch [{unit}]"), encoding="utf-8"
    )


LIFT = """format: 1
lift: {title: A vessel}
duration: 1 s
waves:
  swell: {height: 1 m, period: 8 s, direction: 150 deg}
vessels:
  vessel:
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {all: {mass: 12300 t, at: [50 m, 0 m, 5 m]}}
    radii_of_gyration: [11 m, 27 m, 27 m]
    wave_motion: {raos: vessel.csv, phases: lag, at: [50 m, 0 m, 4 m]}
"""


PUSHED = "wave_forces: {database: a.nc, at: [0 m, 0 m, 0 m]}"


def doubts(folder: Path, text: str = LIFT) -> list[str]:
    return list(Simulation(parse_scenario(text, str(folder / "lift.yaml"))).assembly.warnings)


def test_long_waves_tell_what_has_slipped(tmp_path: Path) -> None:
    long_table(tmp_path)
    assert doubts(tmp_path) == []
    assert "pitches against their slope" in doubts(tmp_path, LIFT.replace("lag", "lead"))[0]
    long_table(tmp_path, pitch=-1.0)
    assert "pitches against their slope" in doubts(tmp_path)[0]
    long_table(tmp_path, unit="rad/m")
    assert "pitches by 57 of their slope: see the unit of pitch" in doubts(tmp_path)[0]
    long_table(tmp_path, heave=-1.0)
    assert "heaves by -1 of the water" in doubts(tmp_path)[0]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("    wave_motion", f"    {PUSHED}\n    wave_motion", "leave 'wave_forces' or 'wave_motion' out"),
        ("phases: lag", "phases: late", "found 'late'; right is 'lag' or 'lead'"),
        ("vessel.csv", "none.csv", "none.csv: cannot be read (no such file or directory)"),
        (
            "period: 8 s",
            "period: 4 s",
            "100 % of the energy of swell is in waves shorter than any there; the",
        ),
    ],
)
def test_what_cannot_be_is_refused_at_its_line(tmp_path: Path, old: str, new: str, said: str) -> None:
    long_table(tmp_path)
    with pytest.raises(ScenarioError) as problem:
        doubts(tmp_path, LIFT.replace(old, new, 1))
    assert said in str(problem.value) and "lift.yaml:" in str(problem.value)


@pytest.mark.parametrize(("mass", "is_told"), [(369e3, True), (200e3, False)])
def test_a_heavy_load_is_told(tmp_path: Path, mass: float, is_told: bool) -> None:
    """3 % and 1.6 % of the 12 300 t that she displaces; the bound is 2 %."""
    long_table(tmp_path)
    vessel = LIFT[LIFT.index("waves:") :].replace("    draft", "    position: [200 m, 0 m]\n    draft")
    text = hooked_lift(
        TWO_HOOKS, TWO_HOOKS_LUGS, TWO_HOOKS_SLINGS, mass=mass, position=(0, 0, 6.9), more=vessel + ON_DECK
    )
    told = [one for one in doubts(tmp_path, text) if "of what vessel displaces" in one]
    assert bool(told) == is_told
    assert not told or told[0].startswith("the load weighs 3.0 %")
