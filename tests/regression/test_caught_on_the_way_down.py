"""A load that was lowered onto the edge of a bulkhead, hung there, slid off and went on down: GO.

An engine of 420 t still swung by 0.2 m as it came to the hatch, with 0.25 m of room to either side. It stood
on the bulkhead's upper edge for 5 s, tilted to 1.9 deg, a sling lost 30 % of its force, and slid off. What is
lowered is set down, so `stays_clear` looked away; without a watched pair of the two nothing else tells.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from held_aside import held_aside
from of_recording import checks_of

#: Room between load and ledge as it hangs plumb; it swings to 13.2 kN / (588.6 kN / 13.5 m) = 0.3 m [m].
GAP = 0.2

_AROUND = """\
ground: {{level: 0 m, friction: 0.1}}
structures:
  ledge: {{type: box, x: [{ledge} m, 8 m], y: [-5 m, 5 m], z: [0 m, 4 m]}}
"""
#: Let go of 6 s before, it comes to the ledge at its farthest, after three and a half swings of 7.5 s.
DOWN = """\
  - {step: let go, hold: 6 s, cut: tag.back}
  - {step: in, lower: hook, speed: 6 m/min, by: 5.6 m}"""


def simulated(plan: str = DOWN, gap: float = GAP, pull: float = 13.2) -> Recording:
    text = held_aside(plan, duration=75.0, pull=pull, more=_AROUND.format(ledge=4.0 + gap))
    return simulate(parse_scenario(text))


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "stays_clear")


@pytest.mark.parametrize("held", ["6 s", "4 s"], ids=["edge", "side"])
def test_a_load_that_an_edge_catches_or_that_swings_against_a_side(held: str) -> None:
    """2 s earlier, more than a quarter of a swing, it comes down past the edge and then meets the side."""
    recording = simulated(DOWN.replace("6 s", held))
    met = [time for time, kind, _ in recording.events() if kind == "set_down"]
    (found,) = told(recording)
    assert (found.verdict, found.element, found.time) == (Verdict.WARNING, "box", met[0])
    assert "meets what is in its way in 'in' and goes on down past it" in found.remark


def test_a_load_that_goes_past_it() -> None:
    recording = simulated(gap=0.5)
    assert [kind for _, kind, _ in recording.events() if kind == "set_down"] == []
    assert told(recording) == []


@pytest.mark.parametrize("gap", [-0.1, -3.0], ids=["by its edge", "well on"])
def test_a_load_that_is_set_down_and_hoisted_again(gap: float) -> None:
    """2 m down to the ledge, and up again by 1 m; it swings next to nothing."""
    down = "  - {step: down, lower: hook, speed: 6 m/min, by: 2.01 m}\n"
    plan = f"{down}  - {{step: up, hoist: hook, speed: 3 m/min, by: 1 m}}"
    recording = simulated(plan, gap, pull=0.01)
    assert {kind for _, kind, _ in recording.events()} >= {"set_down", "lift_off"}
    assert told(recording) == []
