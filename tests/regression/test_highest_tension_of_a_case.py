"""The highest tension that `gantline cases` showed of a rope could be that of the lift file, before rest.

The recording of an equilibrium has a sample of where the lift starts before that at rest, and the largest of
both was taken. Of a barge whose breast line has a pretension of 40 kN and pulls with 28 kN at rest, cases
said 40 kN, and so of the line that a case cuts at 0 s; `gantline statics` had 28 kN and nothing.
"""

from __future__ import annotations

import pytest

from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study.state import rest_json

#: EA of the lines [N], and how far their ends are apart at the start [m].
EA, APART = 4e6, 100.0
OF = "rope: nylon, type: spring"
TEXT = f"""\
format: 1
lift: {{title: Two lines that do not balance}}
duration: 5 s
ropes:
  nylon: {{axial_stiffness: {EA} N, damping_time: 0.1 s, mass: none}}
mechanics:
  bodies:
    barge: {{at: [0 m, 0 m, 0 m], mass: 1000 t, joint: {{type: slider, axis: [1, 0, 0]}}}}
mooring_lines:
  fore: {{vessel: barge, fairlead: [0, 0, 0], to: [{APART} m, 0, 0], {OF}, pretension: 40 kN}}
  aft: {{vessel: barge, fairlead: [0, 0, 0], to: [-{APART} m, 0, 0], {OF}, pretension: 16 kN}}
plan: [{{step: hold, hold: until_end}}]
"""


def test_of_lines_at_rest_what_they_pull_there_counts() -> None:
    """The barge goes ahead by x = (P - P')/(k + k'), and both lines pull with P - k x."""
    rest = Statics(parse_scenario(TEXT)).equilibrium(5.0)
    fore, aft = (EA * (1.0 + pull / EA) / APART for pull in (40e3, 16e3))
    pull = 40e3 - fore * (40e3 - 16e3) / (fore + aft)
    assert rest.recording.column("rope_tension", "mooring.fore")[0] == pytest.approx(40e3), "where it starts"
    shown = rest_json(rest)["rope_tension"]
    for line in ("mooring.fore", "mooring.aft"):
        assert shown[line] == pytest.approx(pull, rel=1e-9)
        assert series.rope_peak(rest.recording, line) == (shown[line], 5.0)


def test_of_a_line_that_is_cut_nothing_counts() -> None:
    """At 0 s, as a case does that sets `cut_at`; one line alone takes the barge to where it is slack."""
    cut = TEXT.replace("pretension: 40 kN", "pretension: 40 kN, cut_at: 0 s")
    shown = rest_json(Statics(parse_scenario(cut)).equilibrium(5.0))["rope_tension"]
    assert shown == pytest.approx({"mooring.fore": 0.0, "mooring.aft": 0.0}, abs=1e-6)
