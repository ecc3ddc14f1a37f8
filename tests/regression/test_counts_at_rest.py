"""`gantline statics` counted checks of which its table had no line.

Quantities without a limit were left out of the table and stood in the sentence below it: of `equalizer`
"5 not checked, 5 without a limit" below three lines that were not checked. Now one line names them.
"""

from __future__ import annotations

import re

import pytest

from gantline.checks import check_recording
from gantline.cli.rest_table import checks_at_rest
from gantline.scenario import load_scenario
from gantline.statics import Statics


@pytest.mark.parametrize("name", ["equalizer", "spreader_bar", "goliath"])
def test_the_lines_are_as_many_as_the_sentence_says(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines that begin with `not checked` and names that are not checked either; names without a limit."""
    monkeypatch.setenv("COLUMNS", "100")
    rest = Statics(load_scenario(f"scenarios/{name}")).equilibrium()
    checks = check_recording(rest.recording)
    # Colours are codes in front of each line.
    lines = [re.sub(r"\x1b\[\d*m", "", line) for line in checks_at_rest(rest, checks)]
    text = " ".join(line.strip() for line in lines)
    counted = re.search(r"(\d+) not checked, (\d+) without a limit$", text)
    told = re.search(r"no limit +((?:\w+, )*\w+); not checked either: ((?:\w+, )*\w+) ", text)
    assert counted is not None and told is not None
    without, neither = (names.split(", ") for names in told.groups())
    rows = sum(line.startswith("not checked ") for line in lines)
    assert (rows + len(neither), len(without)) == (int(counted[1]), int(counted[2]))
    assert {one.name for one in checks if one.has_no_limit} == set(without)
