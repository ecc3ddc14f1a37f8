"""Derivatives of the tension of a hoist rope that its drum has hauled in.

The row of a rope that is fed has a compliance that stays, L₀/EA; its force is the tension over √(L₀/L).
The derivatives of that force were handed on as those of the tension: of the hook below, 10 m up, 0.536 N/kg
in place of 0.613. And where sheaves have losses, so that each part of the rope has a tension of its own, they
were those of the first part, while tensions are the mean of all.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import null_space

from gantline import _core
from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Losses, Statics
from mechanics import G, body, document, drum, end, flow, rope, slider

SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
HOISTS = ["hoist.hook.1", "hoist.hook.2"]
#: Parts of line that bear the hook, of both ropes.
PARTS = 16
#: Pull in a part of line over that in the part before it, where sheaves slip.
EFFICIENCY = 0.98


def ten_metres_up() -> Scenario:
    """The reeved hoist, hanging 10 m up from where its ropes were as long as they were made."""
    lift = parse_scenario(SCENARIO.read_text(encoding="utf-8"))
    up = {"step": "up", "hoist": "hook", "speed": "5 m/min", "by": "10 m"}
    return lift.changed({"plan": [up, {"step": "hold", "hold": "until_end"}]})


def test_weight_on_parts_of_line() -> None:
    """Ideal sheaves: dT/dm = g/16 of each of two ropes in eight parts, however much of them is wound up."""
    statics = Statics(ten_metres_up())
    statics.equilibrium()
    (found,) = statics.sensitivities([("mass", "block")])
    # Falls hang plumb; what is left is λM dq/dp after three rounds.
    assert [found.of(name) for name in HOISTS] == pytest.approx([G / PARTS] * 2, rel=1e-9)


@pytest.mark.parametrize(("losses", "ratio"), [("forward", 1 / EFFICIENCY), ("backward", EFFICIENCY)])
def test_weight_on_parts_of_line_whose_sheaves_slip(losses: Losses, ratio: float) -> None:
    """Sheaves that slip: mean over nine parts in geometric order, of which eight bear half of the weight."""
    statics = Statics(ten_metres_up())
    statics.equilibrium(losses=losses)
    (found,) = statics.sensitivities([("mass", "block")])
    parts = ratio ** np.arange(9)
    wanted = G / 2 * parts.mean() / parts[:8].sum()
    # Losses are a share of T (1 + ε/2): two parts of 2 % at strains of 0.2 % differ by 2 %, eight times.
    assert [found.of(name) for name in HOISTS] == pytest.approx([wanted] * 2, rel=8 * 0.02 * 0.002)


def test_matrices_of_wound_ropes() -> None:
    """Linear model: K x = f of a kilogram on the load, drums held, gives P x = g/16 in both ropes."""
    statics = Statics(ten_metres_up())
    statics.equilibrium()
    model = statics.linear_model()
    weight = -G * model.body_motion[model.bodies.index("block"), 2]
    free = null_space(model.held)
    x = free @ np.linalg.lstsq(free.T @ model.stiffness @ free, free.T @ weight, rcond=None)[0]
    answer = (model.tension @ x)[[model.ropes.index(name) for name in HOISTS]]
    # Singular values of K span 2e9 to 2e5: rounding grows ten thousandfold.
    assert answer == pytest.approx([G / PARTS] * 2, rel=1e-9)


def test_stiffness_of_a_fall_that_has_become_short() -> None:
    """A load on one fall, hauled in from 110 m to 30 m: ∂T/∂z = −EA/L and ∂T/∂ż = −τ EA/L."""
    mass, stiffness, damping_time, depth, wound = 10e3, 1e8, 0.1, 110.0, 80.0
    strain = mass * G / stiffness
    ramps = [
        {"at": 0.0, "duration": 1.0, "velocity": -4.0, "shape": "smooth"},
        {"at": wound / 4, "duration": 1.0, "velocity": 0.0, "shape": "smooth"},
    ]
    fall = rope(
        "fall", depth / (1 + strain), [end("load"), drum(None, (0, 0, 0), "winch")], stiffness, damping_time
    )
    bodies = [body("load", slider(), mass, position=(0, 0, -depth)), flow("winch", 500.0, drive="winch")]
    system = document(bodies, ropes=[fall], drives=[{"name": "winch", "ramps": ramps}])
    statics = _core.Statics(json.dumps(system))
    statics.settle(40.0)
    # Stretch goes onto the drum with the rope, so that the load rises by what goes over the rim.
    expected = stiffness / ((depth - wound) / (1 + strain))
    found = statics.linear(None)
    assert found["rope_tension"].ravel() == pytest.approx([-expected], rel=1e-9)
    assert found["rope_tension_rate"].ravel() == pytest.approx([-damping_time * expected], rel=1e-9)
    assert found["stiffness"].ravel() == pytest.approx([expected], rel=1e-9)
