"""A draft of 0.424 m for 4.24 m, and no word of it.

`start: rest` takes a vessel to where it floats. A barge that rose or sank by 3.8 m took its hooks along, so
that slings began metres slack or taut; a run warned only of ways in plan.
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
