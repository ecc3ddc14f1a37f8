"""A mast with its hinge along it, let go as it lies: the run ended at `foot/about_upright`, in no lift file.

Its axis is level at the start, and plumb as the mast hangs in its sling: there two joints of the open hinge
turn about the same axis, and "the step fell below 0.0000000001 s" was all that was said. The page of hinges
had it that no load on slings comes to that.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.scenario.loads.hinge import failed_at
from gantline.simulation import SimulationError, simulate
from hinged_mast import mast

PLAN = "  - {step: hold, hold: 1 s}\n  - {step: go, hold: until_end, open_hinges: foot}\n"
ENDS = (
    "an open hinge goes not along with its load to where an 'axis' that was level is upright, or one that "
    "was upright level: choose the 'axis' across the load, about which it is raised, or open it once that "
    "is done"
)


def lift(axis: str, plan: str = PLAN) -> str:
    text = mast(plan, hook=(19.0, 0.0, 60.0)).replace("900 s", "8 s")
    return text.replace("axis: [0, 1, 0]", f"axis: {axis}")


def test_it_is_told_at_the_hinge() -> None:
    with pytest.raises(SimulationError) as caught:
        simulate(parse_scenario(lift("[1, 0, 0]")))
    assert caught.value.element == "foot"
    assert caught.value.cause.endswith(ENDS)
    assert caught.value.recording.events("hinge_opened")


def test_across_the_load_it_goes_on() -> None:
    assert simulate(parse_scenario(lift("[0, 1, 0]"))).time[-1] == pytest.approx(8.0)


def test_what_fails_elsewhere_stays_as_it_is() -> None:
    """So does the cause at a hinge that nothing opens."""
    scenario = parse_scenario(lift("[1, 0, 0]"))
    assert failed_at(scenario, "sling.A", "it tears") == ("sling.A", "it tears")
    shut = parse_scenario(lift("[1, 0, 0]", "  - {step: hold, hold: until_end}\n"))
    assert failed_at(shut, "foot/along", "it sticks") == ("foot", "it sticks")
