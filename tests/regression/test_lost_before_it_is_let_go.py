"""A tag line that was lost by its `cut_at`, while a later step lets go of it, counted as let go.

Which of its times it was nobody asked: `let go` at 5 s, and no check failed by it, though the step that lets
go of it begins at 20 s.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.results.ropes.parting import partings
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from upending import between_trolleys

LINE = """\
tag_lines:
  west: {{at: [-10 m, 0 m, 0 m], to: [-40 m, 0 m, 0 m], rope: tag, pretension: 1 kN{cut}}}
"""
PLAN = "{step: wait, hold: 20 s}\n{step: loose, hold: 5 s, cut: tag.west}"


@pytest.mark.parametrize(
    ("cut", "kind", "time"), [("", "let go", 20.0), (", cut_at: 5 s", "cut", 5.0)], ids=["let go", "lost"]
)
def test_a_line_that_is_lost_has_not_been_let_go(cut: str, kind: str, time: float) -> None:
    """One that its step lets go of, as that begins, fails nothing; one lost before does."""
    text = between_trolleys(PLAN, duration=30.0)
    text = text.replace("plan:\n", LINE.format(cut=cut) + "plan:\n", 1)
    text = text.replace("ropes:\n", "ropes:\n  tag: {axial_stiffness: 150 kN, mass: none}\n", 1)
    recording = simulate(parse_scenario(text))
    assert [(one.rope, one.kind, one.time) for one in partings(recording)] == [("tag.west", kind, time)]
    failed = [one.name for one in check_recording(recording) if one.verdict is Verdict.FAILED]
    assert failed == (["rope_parted"] if cut else [])
