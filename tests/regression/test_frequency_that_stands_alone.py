"""A database with added mass of nonsense at its lowest frequency was shown, and taken, without a word.

Panel programs fail where waves are too long for them: one had 85,967 t of added mass in heave at 628 s beside
25,375 t at 314 s and 25,576 t at 157 s, 18 times as much in roll. Added mass goes smoothly to its limits.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.hydro import HydrodynamicDatabase, fit_memory, read_database, write_database
from gantline.hydro.database.outlying import outliers
from verbs import gantline

BARGE = Path(__file__).resolve().parents[2] / "scenarios" / "crane_barge_in_swell" / "crane_barge.nc"


@pytest.fixture(scope="module")
def barge() -> HydrodynamicDatabase:
    return read_database(BARGE)


def with_factor(database: HydrodynamicDatabase, place: int, axis: int, factor: float) -> HydrodynamicDatabase:
    added = database.added_mass.copy()
    added[place, axis, axis] *= factor
    return HydrodynamicDatabase(
        "barge", "changed.nc", database.frequencies, added, database.damping, database.density
    )


def test_a_database_as_it_is_says_nothing(barge: HydrodynamicDatabase) -> None:
    assert list(outliers(barge.added_mass)) == []
    assert barge.outlying(None) == []


@pytest.mark.parametrize(("place", "axis"), [(0, 2), (0, 4), (9, 2), (-1, 3)])
@pytest.mark.parametrize("factor", [3.4, 0.3])
def test_one_that_stands_alone_is_named(
    barge: HydrodynamicDatabase, place: int, axis: int, factor: float
) -> None:
    changed = with_factor(barge, place, axis, factor)
    [found] = outliers(changed.added_mass)
    assert found.place == place % len(barge.frequencies)
    assert list(found.axes) == [axis]
    # What stands beside it goes on smoothly: it was within some per cent of that.
    assert found.times == pytest.approx(factor, rel=0.15)


def test_it_counts_where_its_values_are_taken(barge: HydrodynamicDatabase) -> None:
    changed = with_factor(barge, 9, 2, 3.0)
    own, far = float(barge.periods[9]), float(barge.periods[2])
    assert any("its added mass of heave" in one for one in changed.added_mass_at(own, 1025.0)[1])
    assert not any("stands" in one or "times that" in one for one in changed.added_mass_at(far, 1025.0)[1])


def test_memory_of_it_is_told(barge: HydrodynamicDatabase) -> None:
    assert not any("periods beside it" in one for one in fit_memory(barge, 1025.0).doubts)


def test_the_command_warns(barge: HydrodynamicDatabase, tmp_path: Path) -> None:
    file = tmp_path / "changed.nc"
    write_database(with_factor(barge, 0, 2, 3.4), file)
    found = gantline("hydro", str(file))
    assert found.exit_code == 0
    times = 3.4 * barge.added_mass[0, 2, 2] / barge.added_mass[1, 2, 2]
    assert f"heave at {barge.periods[0]:.4g} s is {times:.3g} times that at the periods" in found.stderr
