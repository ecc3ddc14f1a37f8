"""A winch of constant tension under `mechanics` kept a load from ever hanging still.

Its motor asks for hauling in all the time and slips, so its drive works in every sample; only tuggers of
tag lines were excepted. Static values were then means over all of the lift since the load came clear. Two
slings that carry 196.2 kN until a third takes most of it had 158.5 kN, that third 75 kN of 262 kN, and a
lug that is used by 105 % with the design weight was ok at 94 %: GO WITH WARNINGS, where the same lift
without the winch is a NO-GO.
"""

from __future__ import annotations

import pytest

import gantline
from beside_a_winch import LIFT
from gantline.checks import Verdict
from gantline.results import series
from of_recording import check_of

WEIGHT = 40e3 * 9.81


@pytest.fixture(scope="module")
def recording() -> gantline.Recording:
    return gantline.simulate(gantline.parse_scenario(LIFT))


def test_static_forces_are_those_of_both_holds(recording: gantline.Recording) -> None:
    """W/2 at S1 and S2 before the third takes over; that third holds W less what both have left then."""
    metrics = recording.metrics()
    late = float(
        recording.column("rope_tension", "sling.S1")[-1] + recording.column("rope_tension", "sling.S2")[-1]
    )
    # The winch pulls down and aside with 1 kN over 38.5 m, by 30 mm of every metre at most: below 0.1 kN.
    for sling in ("S1", "S2"):
        assert metrics[f"static_sling_tension.sling.{sling}"] == pytest.approx(WEIGHT / 2, abs=100.0)
    assert metrics["static_sling_tension.sling.S3"] == pytest.approx(WEIGHT - late, abs=200.0)


def test_a_lug_past_its_capacity_at_a_hold_fails(recording: gantline.Recording) -> None:
    """196.2 kN x 1.1 of contingency x 1.1 of the rule over 23 t x 9.81 are 105 %."""
    lug = check_of(recording, "lug_load_of_capacity")
    assert lug.verdict is Verdict.FAILED
    assert lug.value == pytest.approx(WEIGHT / 2 * 1.1 * 1.1 / (23e3 * 9.81), rel=1e-3)


def test_hoisting_beside_the_winch_is_not_hanging_still(recording: gantline.Recording) -> None:
    """No window that lasts from before to after a hoist but the last one, of a run that moves to its end."""
    *still, _ = series.quiet_windows(recording)
    times = [(recording.time[one][0], recording.time[one][-1]) for one in still]
    ends = {step: time for time, _, step in recording.events("step_end")}
    begins = {step: time for time, _, step in recording.events("step_begin")}
    assert [begin >= ends["up"] and end <= begins["take over"] for begin, end in times] == [True, False]
    assert times[1][0] >= ends["take over"]
