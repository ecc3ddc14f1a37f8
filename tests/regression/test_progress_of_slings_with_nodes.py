"""A run of a lift whose slings have nodes ended in `KeyError: 'sling.S1'` as soon as its progress was shown.

The core knows the pieces between nodes, `sling.S1/1` and so on, and no rope of that name. So `tension_spread`
of such slings was refused with "there is no rope `sling.S1`", too.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from lift_text import BASE, changed

LENGTH, MASS = 13.0, 20.0
#: Both slings of the base lift of 20 kg/m, with nodes.
HEAVY = changed(
    BASE,
    (
        "sling: {axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}",
        f"sling: {{axial_stiffness: 100 MN, mass: {MASS} kg/m}}",
    ),
    ("slings:\n", "sling_defaults: {rope_weight: distributed, rope_nodes: 3}\nslings:\n"),
    ("integrator: del, step: 1 ms, ", ""),
)


def test_the_sling_that_carries_most_is_told() -> None:
    most = Simulation(parse_scenario(HEAVY)).largest_sling_tension
    assert most is not None and most[0] in ("S1", "S2") and most[1] > 0.0


@pytest.mark.parametrize("until", ["{tension_spread: 5 %}", "{slings: slack}"])
def test_steps_wait_for_slings_with_nodes(until: str) -> None:
    """The core takes a condition on them that was refused, and the run goes on from its first moment."""
    run = Simulation(parse_scenario(changed(HEAVY, ("start_at: 0 s, brake_from: 10 s", f"until: {until}"))))
    run.advance_to(0.1)
    assert run.time == pytest.approx(0.1)


def test_a_sling_with_nodes_is_slack_where_its_own_weight_hangs() -> None:
    """13 m of 20 kg/m in each of two, 9.81 m/s^2."""
    text = changed(HEAVY, ("start_at: 0 s, brake_from: 10 s", "until: {slings: slack}"))
    until = assemble(parse_scenario(text)).document["plan"][0]["until"]
    assert until["bound"] == pytest.approx(2 * LENGTH * MASS * 9.81, rel=1e-9)
