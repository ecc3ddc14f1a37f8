"""Two variants of a case read alike in the tables of `gantline cases --variants`.

In a terminal of 80 columns `hook_levels (cranes.A.at.z -1 mm)` and `(… +1 mm)` were both cut to
`hook_levels (cranes.A.at.z…`, and of a lift with losses six lines had one name. They have numbers now,
and the names stand in full below.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from plumb_lift import plumb_lift
from verbs import gantline

CASES = "hook_levels: {vary: {cranes.A.at.z: [-1 mm, 1 mm]}}"


def cases(lift: Path, columns: int) -> list[str]:
    result = gantline("cases", str(lift), "--variants", columns=columns)
    assert result.exit_code == 0, result.stderr
    return result.stdout.splitlines()


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "lift.yaml"
    path.write_text(plumb_lift(CASES), encoding="utf-8")
    return path


def test_names_that_are_cut_alike_have_numbers(lift: Path) -> None:
    lines = cases(lift, 80)
    assert max(map(len, lines)) <= 80
    table = lines[lines.index("") : lines.index("", lines.index("") + 1)]
    rows = [line for line in table if re.match(r"  #\d ", line)]
    assert [row[:20] for row in rows] == [
        "  #1 as given       ",
        "  #2 hook_levels (cr",
        "  #3 hook_levels (cr",
    ]
    for name in ("#2 hook_levels (cranes.A.at.z −1 mm)", "#3 hook_levels (cranes.A.at.z +1 mm)"):
        assert f"  {name}" in lines


def test_names_that_have_room_have_none(lift: Path) -> None:
    lines = cases(lift, 160)
    assert not any("#" in line for line in lines)
    assert sum("hook_levels (cranes.A.at.z −1 mm) " in line for line in lines) >= 1


def test_the_worst_case_of_each_element(lift: Path) -> None:
    """In its last column variants were cut alike too, with nothing below that told them apart."""
    assert cases(lift, 80)[-1].startswith("1 case, 3 equilibria")
    lines = gantline("cases", str(lift), columns=60).stdout.splitlines()
    start = next(place for place, line in enumerate(lines) if line.startswith("Worst case"))
    rows, below = lines[start:-1], lines[lines.index("", start) + 1 : -2]
    assert any(line.endswith("#1 hook_levels …") for line in rows)
    assert any(line.endswith("#2 hook_levels …") for line in rows)
    assert sorted(line[5:] for line in below) == [
        "hook_levels (cranes.A.at.z +1 mm)",
        "hook_levels (cranes.A.at.z −1 mm)",
    ]
    # With lines for variants the first numbers are those of their own.
    lines = cases(lift, 60)
    start = next(place for place, line in enumerate(lines) if line.startswith("Worst case"))
    assert {found[0] for line in lines[start:] if (found := re.search(r"#\d", line))} == {"#4", "#5"}
