"""A hinge that the first step opens: it let 528 kN go, and the checks said that it bore nothing, as is right.

The first sample of a run is of what comes after the opening, so that `hinge_opens_unloaded` was `ok`, with
"it bore 0.0 kN, 0 % of what mast weighs". Such a plan of a lift that starts at rest is refused now; where a
step before waits for something that is so already, or nothing is at rest, what the hinge bore is told to be
unknown, a warning.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict
from gantline.results.loads.hinge_peaks import in_words
from gantline.results.loads.hinges import is_shut
from gantline.results.loads.lift_off import lift_off_in_words
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from hinged_mast import mast
from of_recording import checks_of

GO = "  - {step: go, hold: 5 s, open_hinges: foot}\n"
BESIDE = (
    "  - {step: up, hoist: main, speed: 1 m/min, by: 1 m}\n"
    "  - {step: go, hoist: main, starts: with_previous, speed: 1 m/min, by: 1 m, open_hinges: foot}\n"
)
LATER = "  - {step: go, hoist: main, start_at: 1 s, speed: 1 m/min, by: 0.1 m, open_hinges: foot}\n"
AT_ONCE = "  - {step: wait, hold: until_met, until: {slings: taut}}\n" + GO


def lift(plan: str) -> str:
    return mast(plan, hook=(19.0, 0.0, 60.0), more="simulation: {sample_interval: 0.1 s}").replace(
        "900 s", "8 s"
    )


@pytest.mark.parametrize(("plan", "place"), [(GO, 1), (BESIDE, 2)])
def test_it_is_refused(plan: str, place: int) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(lift(plan))
    message = (
        "'foot' opens as the lift begins, so nothing tells what it lets go; a 'hold' step before it does"
    )
    assert f"plan[{place}].open_hinges: {message}" in str(caught.value)


def test_one_that_begins_later_is_not() -> None:
    """W (1 - 18/39) = 528.2 kN, of a mast that has not moved yet."""
    recording = simulate(parse_scenario(lift(LATER)))
    (check,) = checks_of(recording, "hinge_opens_unloaded")
    assert check.verdict is Verdict.FAILED and check.remark.startswith("it bore 528.2 kN")


@pytest.mark.parametrize(("plan", "start"), [(AT_ONCE, "rest"), (GO, "as_given")])
def test_what_it_bore_is_not_known(plan: str, start: str) -> None:
    """The slings carry from the start, so that the step which opens the hinge begins at once."""
    recording = simulate(parse_scenario(lift(plan).replace("start: rest", f"start: {start}")))
    (hinge,) = recording.rig.hinges
    assert [time for time, _, _ in recording.events("hinge_opened")] == [0.0]
    (check,) = checks_of(recording, "hinge_opens_unloaded")
    assert check.verdict is Verdict.WARNING
    assert check.remark == (
        "it opens as the lift begins, so what it bore is not known; a 'hold' before it tells"
    )
    assert not is_shut(recording, hinge).any()
    assert "opened" not in dict(in_words(recording, hinge))
    assert lift_off_in_words(recording, 2) == "clear from the start"
