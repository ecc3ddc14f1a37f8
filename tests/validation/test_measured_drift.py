"""Forces of waves on a vessel against measurements: what shakes and pushes a ship's section in a flume.

The section of `tests/validation/test_measured_section.py`, held and with motions free (Sundsdal, Greco,
Hanssen and Lugni 2025): amplitudes of forces on the held one, and mean forces on all. Those simulated are of
potential flow, mean ones by the momentum of the waves that run off (`tools/section_drift.py`).
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from gantline.hydro import read_database
from section_drift import FORCES, MEASURED, Pushed, Shaken, drift, simulated
from ship_section import FILE
from shown import unsaid

PAGE = "docs/verification/measured_drift.md"
#: As far apart as means of records of the same waves on the held section are, of the force with which waves
#: push that are thrown back whole; more where the time between waves and their return is shorter than a slosh
#: of the flume, 8.8 s, which it is in waves longer than 1.05 s.
APART, SLOSHING, SHORT = 0.15, 0.20, 1.05
#: Periods of waves between which heave, and roll, are near those of their own, where what the section does is
#: decided by what potential flow does not have [s].
HEAVES, ROLLS = (1.1, 1.3), (1.17, 1.6)
#: Which of sway, heave and roll are free by what is held.
HEAVING, ROLLING = ("free", "roll held", "sway held"), ("free", "heave held", "sway held")
#: Of the amplitude of a force on the held section: a tenth, as of motions, or 50 N/m beside 1.8 kN/m at most.
TENTH, SMALL = 0.1, 50.0


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict[Pushed, float]:
    folder = tmp_path_factory.mktemp("section")
    return {one: simulated(folder, one.set_up, one.frequency, one.amplitude) / one.whole for one in MEASURED}


def resonant(one: Pushed) -> bool:
    """Whether a motion that is free is near its own period."""
    heaves = one.set_up in HEAVING and HEAVES[0] < one.period < HEAVES[1]
    return heaves or (one.set_up in ROLLING and ROLLS[0] < one.period < ROLLS[1])


@pytest.mark.parametrize(
    "measured", [one for one in FORCES if not one.breaks], ids=lambda one: f"{one.period:.3f} s"
)
def test_forces_on_the_held_section(measured: Shaken) -> None:
    """Amplitudes of sway and heave force, to a tenth or 50 N per metre of wave."""
    sway, heave = of_database(measured.frequency)
    assert sway == pytest.approx(measured.sway, rel=TENTH, abs=SMALL)
    assert heave == pytest.approx(measured.heave, rel=TENTH, abs=SMALL)


CALM = [one for one in MEASURED if not resonant(one) and not one.breaks]


@pytest.mark.parametrize("measured", CALM, ids=lambda one: one.name)
def test_mean_forces(measured: Pushed, found: dict[Pushed, float]) -> None:
    """Of springs in a simulation, to 0.15 of the force of waves thrown back whole, 0.2 of long waves."""
    off = APART if measured.period < SHORT else SLOSHING
    assert found[measured] == pytest.approx(measured.share, abs=off)


@pytest.mark.parametrize("measured", [one for one in MEASURED if resonant(one)], ids=lambda one: one.name)
def test_mean_forces_in_resonance_are_no_smaller(measured: Pushed, found: dict[Pushed, float]) -> None:
    """The section goes farther than measured, throws off more, and is pushed harder.

    By as much as records differ it may be pushed less: heave held at 1.21 s is, 0.06 for 0.22.
    """
    assert found[measured] > measured.share - SLOSHING


@pytest.mark.parametrize("measured", MEASURED, ids=lambda one: one.name)
def test_forces_of_first_order_have_no_mean(measured: Pushed, found: dict[Pushed, float]) -> None:
    """So the springs hold what the database has, to a tenth of what records of the same waves differ by.

    What is left is of second order, and largest where the section heaves and rolls most.
    """
    known = np.interp(measured.frequency, *drift(measured.set_up)) * measured.amplitude**2 / measured.whole
    assert found[measured] == pytest.approx(known, abs=APART / 10)


def test_the_page_has_them(found: dict[Pushed, float]) -> None:
    """Every row of the tables of docs/verification/measured_drift.md."""
    rows = [row_of_forces(one) for one in FORCES] + [row(one, found[one]) for one in MEASURED]
    assert unsaid(PAGE, *rows) == []


def of_database(frequency: float) -> tuple[float, float]:
    """Amplitudes of sway and heave force of waves of 1 m on the held section [N/m]."""
    database = read_database(FILE)
    assert database.excitation is not None
    towards = CubicSpline(database.frequencies, database.excitation[:, 0])(frequency)
    return abs(complex(towards[1])), abs(complex(towards[2]))


def row_of_forces(one: Shaken) -> str:
    """Of the page's first table."""
    sway, heave = of_database(one.frequency)
    waves = f"{one.period:.3f} s | {1e3 * one.amplitude:.0f} mm"
    return f"| {waves} | {one.sway:.0f} N/m | {sway:.0f} N/m | {one.heave:.0f} N/m | {heave:.0f} N/m |"


def row(one: Pushed, share: float) -> str:
    """Of the page's second table."""
    waves = f"{one.period:.3f} s | {1e3 * one.amplitude:.0f} mm"
    return f"| {one.set_up} | {waves} | {len(one.forces)} | {one.share:.2f} | {share:.2f} |"
