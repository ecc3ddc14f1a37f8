"""A draft of 0.424 m for 4.24 m, a trim by the bow for one by the stern, and no word of it.

`start: rest` takes a vessel to where it floats. A barge that rose or sank by 3.8 m took its hooks along, so
that slings began metres slack or taut; a run warned only of ways in plan. One of which the sign of its trim
had slipped came to rest the other way, with a boom head 1.6 m lower and more than half of the load in its
slings before the first step; said was only that steps moved nothing.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import DRAFT, barge, lift_of, written
from gantline import simulate


def warnings(folder: Path, draft: float) -> list[str]:
    run = simulate(written(folder, lift_of(barge(draft=f"{draft} m"), duration="0.1 s")))
    return [one for one in run.attributes["warnings"] if "by the draft of the lift file" in one]


@pytest.mark.parametrize(("off", "words"), [(-1.5, "1.5 m deeper"), (1.5, "1.5 m higher")])
def test_a_vessel_that_floats_elsewhere_than_its_draft_is_told(
    tmp_path: Path, off: float, words: str
) -> None:
    """It weighs what a draft of `DRAFT` displaces; said is that and `off`."""
    (found,) = warnings(tmp_path, DRAFT + off)
    assert found.startswith(f"barge starts {words} than by the draft of the lift file")


@pytest.mark.parametrize("off", [-0.9, 0.0, 0.9])
def test_a_draft_is_where_the_search_begins(tmp_path: Path, off: float) -> None:
    """Half a metre or so is what a draft is guessed to."""
    assert warnings(tmp_path, DRAFT + off) == []


@pytest.mark.parametrize(
    ("heel", "trim", "is_told"), [(0.4, 0.0, False), (0.8, 0.0, True), (0.0, -0.8, True)]
)
def test_a_heel_or_trim_that_does_not_come_out_is_told(
    tmp_path: Path, heel: float, trim: float, is_told: bool
) -> None:
    """All that it weighs is in the middle, so that it floats upright."""
    given = barge(heel=f"{heel} deg", trim=f"{trim} deg")
    run = simulate(written(tmp_path, lift_of(given, duration="0.1 s")))
    found = [one for one in run.attributes["warnings"] if "from heel and trim of the lift file" in one]
    assert bool(found) is is_told
    assert all(one.startswith("barge starts 0.8 deg from heel and") for one in found)
