"""An emergency stop in a step that lowers hooks was told to be soft of trolleys, which stood still then.

`doubtful_stops` took all that the plan moves anywhere. Only what may move as the stop comes is told of now:
steps beside the one that is named, and those after it that may have begun by then.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


def told(stop: dict[str, str]) -> list[str]:
    """What is said of an emergency stop of `goliath`, whose trolleys traverse in 'to the dock' alone."""
    found = assemble(load_scenario("goliath").changed({"emergency_stop": stop})).warnings
    return [one for one in found if "as soft as any stop" in one]


@pytest.mark.parametrize("step", ["take up slack", "hoist", "lower"])
def test_trolleys_that_stand_still(step: str) -> None:
    assert told({"in_step": step, "after": "1 s"}) == []


def test_trolleys_that_traverse_or_may() -> None:
    """The hoist of 20 m at 5 m/min may be over in 240 s, and the traverse comes after it."""
    assert told({"in_step": "to the dock", "after": "30 s"})
    assert told({"in_step": "hoist", "after": "500 s"})
    assert told({"at": "900 s"})
    assert told({"at": "1 s"}) == []
