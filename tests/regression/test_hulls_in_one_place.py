"""Two vessels in the same place.

A cargo barge that was put 5 m into the bow of the crane barge lifted its module off without a word: loads,
frames and cranes were held against hulls, hulls not against each other, nor against what stands in the yard.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from module_lift import BARGE, module_lift

#: The barge of `module_lift` is 40 m long, 12 m wide and 4 m high; its keel is at 0 m of its axes.
SECOND = BARGE.removeprefix("vessels:\n").replace("  barge:", "  other:\n    position: [HERE m, 0 m]")


@pytest.mark.parametrize(
    ("x", "verdict"), [(40.5, None), (39.0, Verdict.WARNING), (36.0, Verdict.FAILED)], ids=str
)
def test_vessels(x: float, verdict: Verdict | None) -> None:
    """The stern of the second barge so far ahead of that of the first: half of its height are 2 m."""
    around = BARGE + SECOND.replace("HERE", str(x))
    lift = module_lift(0.5, place=(20.0, 12.0), speed=30.0, duration=2.0, around=around)
    checks = check_recording(gantline.simulate(parse_scenario(lift)))
    found = [one for one in checks if one.name == "no_overlap"]
    assert [one.verdict for one in found] == ([] if verdict is None else [verdict])
    assert [one.element for one in found] == ([] if verdict is None else ["barge to other"])


def test_a_jetty() -> None:
    """A hull that reaches 1 m into a box of the yard."""
    jetty = "structures: {jetty: {type: box, x: [39 m, 60 m], y: [-20 m, 20 m], z: [-10 m, 3 m]}}\n"
    lift = module_lift(0.5, place=(20.0, 12.0), speed=30.0, duration=2.0, around=BARGE + jetty)
    checks = check_recording(gantline.simulate(parse_scenario(lift)))
    assert [one.element for one in checks if one.name == "no_overlap"] == ["barge to jetty"]
