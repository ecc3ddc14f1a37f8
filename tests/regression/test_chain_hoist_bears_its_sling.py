"""A chain hoist at the upper end of its sling bears what the sling weighs, all of it.

`chain_hoist_load_of_rated_capacity` took the recorded tension of the sling, which is that at its middle where
its weight is lumped: half of the sling was left out, while the shackle above and the factor on breaking force
had it: over a long heavy sling a hoist was shown with less than hangs from it.
"""

from __future__ import annotations

import pytest

from gantline import Recording, Statics, simulate
from gantline.checks.run import values_of
from gantline.scenario import Scenario, parse_scenario
from levelled import TWO, G

#: What the slings weigh per metre [kg/m], what the hoists may carry, and what each weighs itself [kg].
PER_METRE, RATED, OWN = 100.0, 40e3, 900.0
HANG = "  - {step: hang, hold: until_end}"


def lift(hoists: str) -> Scenario:
    """Two plumb slings, of which one holds a hoist."""
    text = TWO.text(HANG, duration=12.0, hoist=hoists).replace("mass: none", f"mass: {PER_METRE} kg/m")
    return parse_scenario(text)


def at_rest() -> Recording:
    rated = f", rated_capacity: {RATED} kg, mass: {OWN} kg"
    return Statics(lift(rated)).equilibrium().recording


def by_run() -> Recording:
    return simulate(lift(f", rated_capacity: {RATED} kg, mass: {OWN} kg"))


def by_hand() -> float:
    """Of the load by the levers of its lugs, and its own sling from end to end [N]; not itself."""
    [hoisted] = [leg for leg in TWO.legs.values() if leg.hoist]
    [other] = [leg for leg in TWO.legs.values() if not leg.hoist]
    share = (TWO.centre[0] - other.lug[0]) / (hoisted.lug[0] - other.lug[0])
    return (TWO.mass * share + PER_METRE * hoisted.length) * G


@pytest.mark.parametrize("found", [at_rest, by_run])
def test_a_hoist_bears_its_whole_sling(found) -> None:  # type: ignore[no-untyped-def]
    """By weights alone; slings stretch by some 1e-3, and tilt the load by as little."""
    [used] = values_of(found(), "chain_hoist_load_of_rated_capacity").values()
    assert used == pytest.approx(by_hand() / (RATED * G), rel=2e-3)
