"""`gantline check` wrote tables of 142 columns into a terminal of 60, which broke each line in the middle."""

from __future__ import annotations

import pytest

from gantline.cli.table import table
from verbs import gantline

ROWS = [("fore", "one", "1.0 m"), ("aft", "another", "20.0 m")]


def test_columns_that_do_not_fit_stand_below() -> None:
    assert table(("Guide", "which", "up to"), ROWS, "llr", 19) == [
        "Guide   which",
        "  fore  one",
        "  aft   another",
        "Guide    up to",
        "  fore   1.0 m",
        "  aft   20.0 m",
    ]
    whole = table(("Guide", "which", "up to"), ROWS, "llr")
    assert table(("Guide", "which", "up to"), ROWS, "llr", 23) == whole


def test_no_column_is_lost_where_none_fits() -> None:
    lines = table(("Guide", "which", "up to"), ROWS, "llr", 5)
    assert [line for line in lines if line.startswith("Guide")] == ["Guide   which", "Guide    up to"]
    both = table(("Guide", "which", "up to"), ROWS, "llr", 5, keys=2)
    assert both == table(("Guide", "which", "up to"), ROWS, "llr")


@pytest.mark.parametrize("lift", ["heavy_lift_ship", "upending"])
def test_tables_of_a_lift_fit(lift: str) -> None:
    """But for the lines above, and the last, which are sentences."""
    lines = gantline("check", lift, columns=80).stdout.splitlines()[3:-1]
    assert lines
    assert max(map(len, lines)) <= 80
