"""A round load on the ground, or supports, under `integrator: explicit` were refused without line and path.

The core refuses what it finds in a system, and knows no lift file.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from guided_lift import guided_lift

_EXPLICIT = "simulation: {integrator: explicit, step: 1 ms}\n"
_SUPPORTS = (
    "supports: {stools: {under: module, grid: {x: [-2 m, 2 m], y: [-1 m, 1 m]}, height: 0.3 m, "
    "top: [0.3 m, 0.3 m], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.4}}\n"
)


def refused(lift: str) -> str:
    """The message, and the line that it names."""
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(lift + _EXPLICIT)
    [problem] = caught.value.problems
    assert problem.line == lift.count("\n") + 1
    assert problem.path == "simulation.integrator"
    return str(caught.value)


def test_a_round_load() -> None:
    lift = guided_lift("").replace("guides:\n\n", "")
    lift = lift.replace("{box: [6 m, 3 m, 2 m]}", "{cylinder: {diameter: 2 m, length: 6 m}}")
    assert "'explicit' knows no round loads on the ground; 'adaptive' or 'del' is right" in refused(lift)


def test_supports() -> None:
    lift = guided_lift("", more=_SUPPORTS).replace("guides:\n\n", "")
    assert "'explicit' knows no supports; 'adaptive' or 'del'" in refused(lift)
