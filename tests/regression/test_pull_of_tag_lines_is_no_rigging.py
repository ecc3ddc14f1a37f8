"""Rigging of 1.99 t below the hook of `off_a_barge`, said its first page; slings and shackles weigh 1.1 t.

The rest is what two tag lines pull down with, which the static hook load holds as well. The row says so now.
"""

from __future__ import annotations

import gantline
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

#: Each pulls straight down with 9.81 kN, the weight of 1 t.
TAG_LINES = """\
tag_lines:
  fore: {at: [ 5 m, 0 m, 0 m], to: [ 5 m, 0 m, -20 m], rope: kind, pull: 9.81 kN}
  aft:  {at: [-5 m, 0 m, 0 m], to: [-5 m, 0 m, -20 m], rope: kind, pull: 9.81 kN}
"""


def weights(more: str) -> dict[str, str]:
    """Rows of the weights of a load of 200 t on one sling without mass, by their names."""
    hung = {"S1": ("A", "1", 10.0)}
    text = hooked_lift({"A": (0.0, 0.0, 20.0)}, {"1": (0.0, 0.0, 4.0)}, hung, position=(0, 0, 6), more=more)
    text = text.replace("start: as_given", "start: rest")
    return dict(FirstPage().content(Subject(gantline.simulate(parse_scenario(text))))["weights"])


def test_rigging_with_what_tag_lines_pull_is_called_that() -> None:
    rows = weights(TAG_LINES)
    assert rows["+ rigging and tag lines"] == "2.00 t"
    assert rows["= static hook load"] == "202.0 t"


def test_without_tag_lines_nothing_pulls() -> None:
    assert not any("tag lines" in row for row in weights(""))
