"""Columns that went through keel blocks beside their way, and through their foundation, with GO.

Supports carry by their tops, their sides hold nothing: so it says in docs/concepts/supports.md. A column that
trolleys took along through a pillar went through that, and nothing was said: GO, 0 warnings. Nor did supports
carry any side but the underside of a load as it stands level: the column of `upending`, put down on four
supports by its end, went on down to the ground as if they were not there; that it stands on them now is seen
in tests/validation/test_upending.py and tests/verification/test_supports_turned.py.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of
from upending import between_trolleys

#: Where the underside of the column hangs at the start [m]; see `upending`.
UNDERSIDE = 28.5
#: Middle of the support along the girder; the column reaches to 10 m there and goes on by 8 m [m].
AT, BY = 14.0, 8.0


def away(by: float) -> str:
    return (
        f"{{step: go, traverse: [gol.one, gol.two], speed: 10 m/min, acceleration: 0.005 m/s^2, by: {by} m}}"
    )


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "no_overlap")


def beside(
    top: float,
    heading: float = 0.0,
    plan: str = away(BY),
    at: tuple[float, float] = (AT, 0.0),
    more: str = "",
) -> Recording:
    """The column hangs under two trolleys; a support as high as `top` [m] stands at `at` [m]."""
    support = (
        f"supports:\n  pillar: {{under: column, measured_from: world, heading: {heading} deg,"
        f" places: {{a: {{at: [{at[0]} m, {at[1]} m]}}}}, height: {top} m, stiffness: 20 MN/m{more}}}\n"
    )
    lift = between_trolleys(plan, duration=100.0)
    return simulate(parse_scenario(lift.replace("plan:\n", support + "plan:\n", 1)))


@pytest.mark.parametrize(
    ("over", "by", "verdict", "deep"),
    [
        (-0.2, BY, None, None),
        # 3.9 m of way: the end of the column is 0.2 m past the near side of the top, 0.6 m by 0.6 m.
        (1.0, 3.9, Verdict.WARNING, 0.2),
        # Farther, the shortest way out is from end to end, 0.6 m, until the column goes on over it all: then
        # it is up, by as much as the top is above the underside.
        (1.0, BY, Verdict.FAILED, 1.0),
    ],
    ids=str,
)
def test_a_load_that_is_taken_through_a_support(
    over: float, by: float, verdict: Verdict | None, deep: float | None
) -> None:
    """Taken along at 0.005 m/s^2 it swings by twice 0.005 m/s^2 / (9.81 m/s^2 / 50 m), 0.05 m, at most."""
    found = told(beside(UNDERSIDE + over, plan=away(by)))
    assert [one.verdict for one in found] == ([] if verdict is None else [verdict])
    for one in found:
        assert one.element == "column to pillar.a"
        assert "pillar.a carries nothing then: supports carry by their tops what comes down" in one.remark
        assert float(one.remark.split(" m deep")[0].split(", ")[-1]) == pytest.approx(deep, abs=0.06)


def test_a_support_that_stands_turned() -> None:
    """About the world's origin by 90 deg from (0, -14): the same place as without, and the same depth."""
    straight, turned = beside(UNDERSIDE + 1.0), beside(UNDERSIDE + 1.0, heading=90.0, at=(0.0, -AT))
    assert [one.remark for one in told(turned)] == [one.remark for one in told(straight)] != []


def test_a_support_that_is_taken_away_first_is_in_nobodys_way() -> None:
    """The column is at it after 4 m, at 0.005 m/s^2 no earlier than 40 s."""
    assert told(beside(UNDERSIDE + 1.0, more=", removed_at: 10 s")) == []


def test_a_load_sinks_into_the_support_that_carries_it() -> None:
    """100 t sink 49 mm into 20 MN/m at rest, and farther as they come down."""
    down = "{step: down, lower: [gol.A, gol.B], speed: 1 m/min, by: 0.5 m}"
    recording = beside(UNDERSIDE - 0.2, plan=down, at=(0.0, 0.0), more=", damping: 2 MN s/m")
    force = recording.column("contact_force", "support.pillar.a")
    assert force.max() > 300e3
    assert told(recording) == []
