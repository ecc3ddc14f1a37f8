"""A case that cut a sling and left its girder with one end on the ground was `ok`.

Such a case is solved for just after its time, so it was never compared with the lift as it is given at that
time: of a girder of 160 t between two cranes, of which 44 % hung in what was left, nothing was said, and
`gantline cases` ended with 0. Nor was a cut with a time of its own compared.

Once it was told that it stands, the sling that is left still "swings to" T0 + 2 (T - T0), which is of a load
that hangs on: 2434 kN for one that comes down on its corner on the way.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import parse_scenario
from gantline.study import CasesResult, run_cases
from plumb_lift import WEIGHT, plumb_lift
from program import called

LUGS = {"A": (2.5, 0.0), "B": (-2.5, 0.0)}
#: Of the load, whose corner at the other side comes down on the ground [m].
HALF = 5.0
GROUND = """
ground: {level: -0.3 m, friction: 0.4}
plan:
  - {step: wait, hold: 4 s}
  - {step: hang, hold: until_end}
"""


def _cases(cases: str) -> CasesResult:
    return run_cases(parse_scenario(plumb_lift(cases, lugs=LUGS, more=GROUND)))


@pytest.mark.parametrize("when", ["", ", at: 5 s", ", at_step: hang, after: 1 s"])
def test_a_load_that_stands_by_a_cut_is_no_sound_case(when: str) -> None:
    """It hangs by one lug and stands on the far corner: moments about that leave the sling 2 W/3."""
    (state,) = _cases(f"gone: {{cut: SB{when}}}").of("gone")
    assert state.rest is not None
    arm = HALF + LUGS["A"][0]
    assert state.rest.tension("sling.SA") == pytest.approx(WEIGHT * HALF / arm, rel=0.02)
    assert state.stands == ("girder",)
    assert not state.is_sound


def test_nothing_is_told_of_how_far_the_others_swing(tmp_path: Path) -> None:
    """A load that comes down goes by no law of one on springs; that is said in place of a force."""
    text = plumb_lift("gone: {cut: SB}", lugs=LUGS, more=GROUND)
    (state,) = run_cases(parse_scenario(text)).of("gone")
    assert state.stands and not state.swings_to
    path = tmp_path / "lift.yaml"
    path.write_text(text, encoding="utf-8")
    said = " ".join(called("cases", path).stdout.split())
    assert "gone is at rest: what slings bear as girder comes down is not in it; a run with" in said
    assert "swings to" not in said


def test_a_load_that_still_hangs_by_the_others_does_not_stand() -> None:
    """Three slings of four hold it up."""
    found = run_cases(parse_scenario(plumb_lift("gone: {cut: SB}", more=GROUND)))
    assert found.of("gone")[0].stands == ()
