"""`start: rest`: friction holds where a lift stands, with no more than it has.

Between m₁ < m₂ over a sheave that slips at the ratio ρ nothing moves while m₂/m₁ <= ρ, and a load stands on a
slope while tan α <= μ: without losses neither comes to rest anywhere.
"""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import (
    G,
    Json,
    Run,
    body,
    contact,
    document,
    end,
    finished,
    flow,
    half_turn,
    point,
    rope,
    slider,
)

RATIO, EA, HEIGHT, RADIUS = 1.05, 1e7, 10.0, 0.5


def from_rest(system: Json, duration: float = 1.0) -> Run:
    """Runs from the equilibrium."""
    integrator = {"type": "adaptive", "tension_tolerance": 1e-3, "position_tolerance": 1e-7}
    settings = {"integrator": integrator, "duration": duration, "sample_interval": 0.1, "start": "rest"}
    run = Simulation(json.dumps(system), json.dumps(settings))
    status = run.run()
    assert status["status"] == "done", status
    return finished(run, status)


def two_weights(heavy: float, inertia: float) -> Json:
    """100 kg and `heavy` [kg] 5 m below a held sheave of I/r² = `inertia` [kg]."""
    bodies = [
        body("light", slider(), 100.0, position=(-RADIUS, 0, 5)),
        body("heavy", slider(), heavy, position=(RADIUS, 0, 5)),
        flow("sheave", inertia),
    ]
    over = half_turn(None, (0, 0, HEIGHT), RADIUS, over=True, flow="sheave", ratio=RATIO)
    return document(bodies, ropes=[rope("r", None, [end("light"), over, end("heavy")], EA, 0.01)])


@pytest.mark.parametrize("inertia", [0.0, 10.0])
@pytest.mark.parametrize("heavy", [100.0, 101.0, 104.9])
def test_a_lossy_sheave_holds_unequal_weights(heavy: float, inertia: float) -> None:
    """Each hangs by its own span, m g ℓ/EA lower than it was put; nothing has passed, and nothing moves."""
    run = from_rest(two_weights(heavy, inertia))
    span = HEIGHT - 5 + math.pi * RADIUS / 2
    for name, mass in (("light", 100.0), ("heavy", heavy)):
        height = run.body(name, "body_position")[:, 2]
        # Forces balance to 1e-9 of their size over a stiffness of 2 MN/m.
        assert height == pytest.approx(5 - mass * G * span / EA, abs=1e-9)
        assert np.abs(run.body(name, "body_velocity")).max() < 1e-9
    assert run.columns["segment_tension"][-1] == pytest.approx([100 * G, heavy * G], rel=1e-6)
    assert run.joint("sheave") == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("inertia", [0.0, 10.0])
@pytest.mark.parametrize("heavy", [105.1, 120.0])
def test_it_holds_no_more_than_its_ratio(heavy: float, inertia: float) -> None:
    """m₂/m₁ > ρ = 1.05: nothing stops the heavier one."""
    with pytest.raises(ValueError, match="it cannot start at rest"):
        from_rest(two_weights(heavy, inertia))


@pytest.mark.parametrize("inertia", [0.0, 10.0])
def test_sheaves_stay_apart_in_one_rope(inertia: float) -> None:
    """Two moving sheaves of 300 and 303 kg: the heavier one does not run down, as it would without losses.

    Each goes down, and both of its parts, 6.57 m and 5.79 m of rope, get longer by as much; tensions in that
    ratio are more than the sheave holds, so it slips, and the held sheave between them, at 1.01, does not.
    """
    bodies = [
        body("left", slider(), 300.0, position=(-1, 0, 5)),
        body("right", slider(), 303.0, position=(1, 0, 5)),
        *(flow(name, inertia) for name in ("l", "m", "r")),
    ]
    route = [
        end(None, (-1.5, 0, HEIGHT)),
        half_turn("left", (0, 0, 0), RADIUS, over=False, flow="l", ratio=RATIO),
        half_turn(None, (0, 0, HEIGHT), RADIUS, over=True, flow="m", ratio=RATIO),
        half_turn("right", (0, 0, 0), RADIUS, over=False, flow="r", ratio=RATIO),
        end(None, (1.5, 0, HEIGHT)),
    ]
    run = from_rest(document(bodies, ropes=[rope("r", None, route, EA, 0.01)]))
    low = np.array([300.0, 303.0]) * G / (1 + RATIO)
    expected = [low[0] * RATIO, low[0], low[1], low[1] * RATIO]
    # (F8): at a strain of 1.5e-4 the ratio is 7.6e-6 smaller.
    assert run.columns["segment_tension"][0] == pytest.approx(expected, rel=1e-5)
    assert run.joint("m") == pytest.approx(0.0, abs=1e-12)
    heights = [run.body(name, "body_position")[0, 2] for name in ("left", "right")]
    # Slip moves rope from part to part: together they are longer by what their tensions stretch them.
    outer, inner = HEIGHT - 5 + math.pi * RADIUS / 2, HEIGHT - 5 + math.pi * RADIUS
    down = low * (RATIO * outer + inner) / (2 * EA)
    assert heights == pytest.approx(5 - down, abs=1e-8)


@pytest.mark.parametrize("degrees", [0.0, 10.0, 16.6, 16.8])
def test_a_load_stands_on_a_slope_while_friction_holds(degrees: float) -> None:
    """To arctan 0.3 = 16.699 degrees, with m g sin α; beyond it slides without end."""
    slope = math.radians(degrees)
    ground = contact("ground", "load", (0, 0, 0), stiffness=1e8, friction=0.3)
    ground["plane_normal"] = [-math.sin(slope), 0, math.cos(slope)]
    system = document([body("load", point((0, 0, 0)), 1e3)], contacts=[ground])
    if math.tan(slope) > 0.3:
        with pytest.raises(ValueError, match="falls without end"):
            from_rest(system)
        return
    run = from_rest(system)
    assert np.abs(run.body("load", "body_velocity")).max() < 1e-9
    assert np.linalg.norm(run.body("load", "body_position")[-1]) == pytest.approx(1e3 * G / 1e8, rel=1e-6)
