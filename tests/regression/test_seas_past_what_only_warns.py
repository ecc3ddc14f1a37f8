"""Seas past a limit that only warns were shown as if they kept every limit.

`gantline seas` said of a lift off a barge "0.8 m  107 %", "allowed 0.8 m", and nothing more: who reads
that does not know whether 107 % of a limit is allowed, nor of which. A mooring line had gone past the
factor of 2.3 that warns where nobody sets one. The picture had it in the shade of what "keeps its
limits".
"""

from __future__ import annotations

import re

import pytest

from column_in_waves import ALIKE, FACTOR, STRENGTH, column
from gantline.cli.seas_table import seas_table
from gantline.plot.seas import seas_picture
from gantline.results.file.saved_seas import SavedSeas
from gantline.scenario import parse_scenario
from gantline.study import run_seas
from lift_text import changed

#: The sling carries some 780 kN; 1.7 MN are 2.2 times that, less than the 2.3 below which ropes warn.
WEAK = changed(column(ALIKE, duration="20 s"), (STRENGTH, ", minimum_breaking_force: 1.7 MN"), (FACTOR, ""))


@pytest.fixture(scope="module")
def saved() -> SavedSeas:
    return SavedSeas.from_json(run_seas(parse_scenario(WEAK), heights=[0.5], periods=[8.0]).to_json())


def test_the_table_says_so(saved: SavedSeas) -> None:
    (sea,) = saved.seas
    assert sea.is_allowed and sea.used is not None and sea.used > 1.0
    lines = seas_table(saved, 100)
    assert any(re.fullmatch(r"  0\.5 m +10\d % warns", line) for line in lines), lines
    assert (
        "warns: past a limit that only warns, so the sea is allowed: rope_factor_on_breaking_force sling.S1"
        in " ".join(" ".join(lines).split())
    )


def test_so_does_the_picture(saved: SavedSeas) -> None:
    figure = seas_picture(saved)
    (legend,) = figure.legends
    assert "is past one that only warns" in [text.get_text() for text in legend.get_texts()]
