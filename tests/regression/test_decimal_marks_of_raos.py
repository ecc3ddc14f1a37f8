"""Tables of RAOs parted by semicolons that have both decimal commas and decimal points.

`1,004` beside `0.97` was read as 1.004 without a word, though commas that part thousands look alike. A
number with both marks was refused in words that were not in the table: '1.004.5' for '1.004,5'.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.hydro import DatabaseError, read_raos

AXES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
HEAD = "direction [deg];period [s]" + "".join(
    f";{name} [{'m/m' if place < 3 else 'deg/m'}];{name} phase [deg]" for place, name in enumerate(AXES)
)


def table(folder: Path, *heaves: str) -> Path:
    """One wave of each heave, of which nothing else has a decimal mark."""
    rows = [f"180;{5 + place};0;0;0;0;{heave};0;0;0;0;0;0;0" for place, heave in enumerate(heaves)]
    path = folder / "vessel.csv"
    path.write_text("\n".join(["# of 2,5 m of draft", HEAD, *rows]) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize("heaves", [("1,004", "0.97"), ("0.97", "1", "1,004")])
def test_both_marks_in_one_table_are_refused(tmp_path: Path, heaves: tuple[str, ...]) -> None:
    lines = {heave: 3 + place for place, heave in enumerate(heaves)}
    with pytest.raises(DatabaseError) as problem:
        read_raos(table(tmp_path, *heaves), "lag")
    both = f"'1,004' in line {lines['1,004']} has a comma, '0.97' in line {lines['0.97']} a point"
    at = f"vessel.csv:{max(lines.values())}: {both}; decimals take one of them throughout, thousands no mark"
    assert str(problem.value).endswith(at)


@pytest.mark.parametrize("heaves", [("1,004", "0,97"), ("1.004", "0.97")])
def test_one_mark_is_that_of_decimals(tmp_path: Path, heaves: tuple[str, ...]) -> None:
    motion = read_raos(table(tmp_path, *heaves), "lag").motion[:, 0, 2]
    assert list(motion.real) == [0.97, 1.004]  # by rising frequency, of 6 s and 5 s


def test_a_number_is_shown_as_it_stands(tmp_path: Path) -> None:
    with pytest.raises(DatabaseError, match=r"vessel.csv:3: '1\.004,5' is no number; it is the heave"):
        read_raos(table(tmp_path, "1.004,5"), "lag")
