"""Hydrodynamic databases of another hull, and reference points put elsewhere aboard: taken without a word.

The file of a barge of 90 × 30 × 3 m served a crane vessel of 105.6 × 46 × 4.2 m, which felt half of the
forces of its waves. With `at` at the stern, where the file has its point amidships, waves lifted the barge
of `crane_barge_in_swell` by its stern: GO, with a dynamic factor of 1.025 in place of 1.044. The longest
waves of a file say whose it is: they lift a hull with ρ g A − ω² (ρ V + A₃₃) per metre, in the middle of
its waterplane.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from afloat import BREADTH, DEPTH, DRAFT, LENGTH, MASS, barge, lift_of, written
from floating import SEA
from gantline.assembly import assemble
from gantline.hydro import HydrodynamicDatabase, read_database, write_database
from gantline.scenario import load_scenario

G = 9.81
#: Added mass in heave [kg]: a plate as broad.
ADDED = SEA * math.pi * (BREADTH / 2) ** 2 * LENGTH
AMIDSHIPS = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
SCENARIOS = Path(__file__).parents[2] / "scenarios"


def database(longest: float = 25.0, **changes: Any) -> HydrodynamicDatabase:
    """Long waves about the middle of the barge's waterplane: from abeam, and by their slope from ahead."""
    omega = 2 * math.pi / np.array([longest, 0.4 * longest])
    forces = np.zeros((2, 2, 6), dtype=complex)
    heave = SEA * G * LENGTH * BREADTH - omega**2 * (MASS + ADDED)
    forces[:, :, 2] = heave[:, np.newaxis]
    slope = omega**2 / G
    forces[:, 0, 4] = -1j * slope * SEA * G * BREADTH * LENGTH**3 / 12
    added = np.zeros((2, 6, 6))
    added[:] = np.diag([1e6, 1e6, ADDED, 1e9, 1e10, 1e10])
    return replace(
        HydrodynamicDatabase(
            name="barge",
            source="by formulas",
            frequencies=omega,
            added_mass=added,
            damping=0.1 * added,
            density=SEA,
            reference=np.zeros(3),
            water_depth=np.inf,
            directions=np.radians([0.0, 90.0]),
            excitation=forces,
        ),
        **changes,
    )


def doubts(folder: Path, made: HydrodynamicDatabase, at: list[str] | None = None, **vessel: Any) -> list[str]:
    """Warnings of the barge with its added mass of 12 s from that file."""
    write_database(made, folder / "barge.nc")
    source = {"database": "barge.nc", "period": "12 s", "at": at or AMIDSHIPS}
    assembly = assemble(load_scenario(written(folder, lift_of(barge(added_mass=source, **vessel)))))
    return [one.replace(" (Capytaine)", "") for one in assembly.warnings if "hull" in one]


def test_its_own_hull(tmp_path: Path) -> None:
    """No word, also of one that displaces 20 % more."""
    assert doubts(tmp_path, database()) == []
    assert doubts(tmp_path, database(displacement=1.2 * MASS / SEA)) == []


def test_another_hull(tmp_path: Path) -> None:
    """Twice as broad a box: half of its force per metre; and what the file says that it displaces."""
    broad: dict[str, Any] = {
        "hull": {"box": [f"{LENGTH} m", f"{2 * BREADTH} m", f"{DEPTH} m"]},
        "draft": f"{DRAFT / 2} m",
    }
    omega = 2 * math.pi / 25.0
    stiffness = SEA * G * LENGTH * BREADTH
    own, theirs = (one * stiffness - omega**2 * (MASS + ADDED) for one in (2, 1))
    assert doubts(tmp_path, database(), **broad) == [
        "added_mass of barge: barge.nc is of another hull, draft or scale: waves of 25 s lift it with "
        f"{theirs / 1e6:.3g} MN per metre, the vessel's hull at its draft {own / 1e6:.3g} MN"
    ]
    assert doubts(tmp_path, database(displacement=8100.0)) == [
        "added_mass of barge: barge.nc is of a hull that displaces 8100 m^3, the vessel's displaces "
        "1.2e+04 m^3 at its draft of the lift file"
    ]


@pytest.mark.parametrize(("at", "place"), [((0, 0), "(0.0, 0.0)"), ((50, 4), "(50.0, 4.0)")])
def test_another_place_aboard(tmp_path: Path, at: tuple[float, float], place: str) -> None:
    """The stern in place of the middle, and beside the centre plane."""
    assert doubts(tmp_path, database(), [f"{at[0]} m", f"{at[1]} m", "4 m"]) == [
        "added_mass of barge: with its reference point 'at' barge.nc has the middle of the waterplane at "
        f"{place} m of the vessel, its hull at (50.0, 0.0) m"
    ]


def test_waves_that_are_not_long_say_nothing(tmp_path: Path) -> None:
    """Waves of 18 s are five lengths long, κL = 1.24: whose hull it is remains open."""
    assert doubts(tmp_path, database(longest=18.0), ["0 m", "0 m", "4 m"]) == []


def test_the_scenario_in_swell_and_with_its_point_astern() -> None:
    """Its file, by Capytaine, is of its hull: the force from abeam agrees to 0.05 %."""
    lift = load_scenario(SCENARIOS / "crane_barge_in_swell")
    assert not assemble(lift).warnings
    known = read_database(SCENARIOS / "crane_barge_in_swell" / "crane_barge.nc")
    assert known.excitation is not None
    expected = SEA * G * 90 * 30 - known.frequencies[0] ** 2 * (SEA * 90 * 30 * 3 + known.added_mass[0, 2, 2])
    assert np.abs(known.excitation[0, :, 2]).max() == pytest.approx(expected, rel=6e-4)
    astern = {f"vessels.barge.{key}.at": ["0 m", "0 m", "3 m"] for key in ("wave_forces", "radiation")}
    told = assemble(lift.changed(astern)).warnings
    assert len(told) == 1, told
    assert told[0].endswith("at (0.0, 0.0) m of the vessel, its hull at (45.0, 0.0) m")
