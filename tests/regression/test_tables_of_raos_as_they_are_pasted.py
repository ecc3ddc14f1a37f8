"""Tables of RAOs as they come out of other programs, which were refused without a word on what is right.

A line of infinite period was "'inf' is no number", directions from 0 to 360 deg "stand in line 2 already" as
waves of 0 deg, and of waves of 45 deg between rows of 0 and 90 deg it was said that there are none. Heave of
1e200 m/m was a step that fell below 1e-10 s in the run, and percent in a table without long waves went
unnoticed.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.hydro import DatabaseError, read_raos, write_raos
from gantline.hydro.raos import DisplacementRaos
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from table_of_raos import goes_with_the_water

HEAD = (
    "direction [deg],period [s],surge [m/m],surge phase [deg],sway [m/m],sway phase [deg],heave [m/m],"
    "heave phase [deg],roll [deg/m],roll phase [deg],pitch [deg/m],pitch phase [deg],yaw [deg/m],"
    "yaw phase [deg]"
)
WAVE = "0.1,10,0.2,20,0.3,30,4,40,5,50,6,60"
TABS = str.maketrans(",.", "\t,")

LIFT = """format: 1
lift: {title: A vessel}
duration: 1 s
vessels:
  vessel:
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    wave_motion: {raos: vessel.csv, phases: lag, at: [50 m, 0 m, 4 m]}
"""


def written(folder: Path, *lines: str) -> Path:
    path = folder / "vessel.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (f"0,inf,{WAVE}", "2: 'inf' is no number; it is the period; leave waves of infinite period out"),
        (
            f"0,6,{WAVE}".replace("0.2", ""),
            "2: '' is no number; it is the sway; a motion that there is none of is 0",
        ),
        (f"0,6,{WAVE}".replace("0.3", "30%"), "2: '30%' is no number; it is the heave; 30 % is 0.3"),
        (
            f"0,6,{WAVE}".replace(",4,", ',"1,004",'),
            "2: '1,004' is no number; it is the roll; decimals take a point",
        ),
        (f"0,6,{WAVE}".replace("0.3", "1e200"), "2: a heave of 1e+200 m/m; see its number and its unit"),
        (
            f"0,6,{WAVE}\n180,6,{WAVE}\n360,6,{WAVE}",
            "4: waves of 6 s in 0 deg stand in line 2 already; 360 deg is that direction",
        ),
    ],
)
def test_what_is_right_is_said(tmp_path: Path, line: str, said: str) -> None:
    with pytest.raises(DatabaseError) as problem:
        read_raos(written(tmp_path, HEAD, line), "lag")
    assert said in str(problem.value)


def test_tabs(tmp_path: Path) -> None:
    """They part columns as commas do; a decimal comma between them is told."""
    plain = read_raos(written(tmp_path, HEAD, f"180,6.5,{WAVE}"), "lag")
    lines = [HEAD, f"180,6.5,{WAVE}"]
    tabs = read_raos(written(tmp_path, *(line.replace(",", "\t") for line in lines)), "lag")
    assert (tabs.motion == plain.motion).all()
    with pytest.raises(DatabaseError, match="decimals take a point, or a comma where semicolons part"):
        read_raos(written(tmp_path, *(line.translate(TABS) for line in lines)), "lag")


def test_rows_that_are_too_far_apart_are_told(tmp_path: Path) -> None:
    raos = read_raos(written(tmp_path, HEAD, *(f"{one},6,{WAVE}" for one in (0, 90, 180))), "lag")
    with pytest.raises(DatabaseError, match="at most 60 deg apart"):
        raos.at(np.array([1.0]), np.radians(45.0))


@pytest.mark.parametrize(
    ("axis", "size", "said"),
    [
        (2, 52.0, "vessel.csv: in its waves of 10 s heave is 52 m/m: see its unit"),
        (2, 4.9, None),
        (3, 3.0, "vessel.csv: in its waves of 10 s roll is 172 deg/m: see its unit"),
        (3, 0.9, None),
    ],
)
def test_units_that_slipped_are_told_without_long_waves(
    tmp_path: Path, axis: int, size: float, said: str | None
) -> None:
    """Waves of 10 s are 156 m long, κL = 4 of 100 m. Bounds are 5 m/m and 1 rad/m; 3 rad are 172 deg."""
    raos = goes_with_the_water()
    motion = raos.motion[2:].copy()
    motion[0, :, axis] = size
    write_raos(
        DisplacementRaos("any", raos.frequencies[2:], raos.directions, motion), tmp_path / "vessel.csv"
    )
    found = Simulation(parse_scenario(LIFT, str(tmp_path / "lift.yaml"))).assembly.warnings
    assert list(found) == ([f"wave motion of vessel: {said}"] if said else [])
