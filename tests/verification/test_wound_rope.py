"""Drums that remember the strain of what they wound, and their layers, by docs/concepts/winch.md."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import G, Json, Run, adaptive, body, document, drum, end, flow, rope, simulate, slider

MASS, EA = 10e3, 1e8
WEIGHT = MASS * G
#: Strain of the rope under the load, 1e-3.
STRAIN = WEIGHT / EA
#: Damping time of the rope [s]: it rings at 10 rad/s and is at rest after some seconds.
TAU = 0.1


def hoist(
    ramps: list[tuple[float, float, float]],
    *,
    laid_under: float | None = None,
    depth: float = 110.0,
    **end_of: Json,
) -> Json:
    """A load at rest on one fall under a drum; `ramps` are (start [s], duration [s], velocity [m/s])."""
    end_of_rope = drum(None, (0, 0, 0), "winch")
    end_of_rope["drum"] |= {"laid_under": laid_under, **end_of}
    bodies = [body("load", slider(), MASS, position=(0, 0, -depth)), flow("winch", 500.0, drive="winch")]
    given = [{"at": at, "duration": lasts, "velocity": v, "shape": "smooth"} for at, lasts, v in ramps]
    fall = rope("fall", depth / (1 + STRAIN), [end("load"), end_of_rope], EA, TAU)
    return document(bodies, ropes=[fall], drives=[{"name": "winch", "ramps": given}])


UP_AND_DOWN = [(0.0, 1.0, -2.0), (20.0, 1.0, 0.0), (25.0, 1.0, 2.0), (45.0, 1.0, 0.0)]


def test_a_load_rises_as_fast_as_the_rim_and_comes_back_to_where_it_was() -> None:
    """Under a steady tension the stretch goes onto the drum: the load goes v, not (1 + ε) v, and back again.

    100 m up at ε = 1e-3 would otherwise be 100.1 m. Starting and stopping changes the tension by 3 %, with
    which some decimetres are wound; they come off as they went on.
    """
    run = adaptive(hoist(UP_AND_DOWN), 60.0, sample_interval=0.1)
    height, way = run.body("load")[:, 2], run.joint("winch")
    steady = (run.time > 12.0) & (run.time < 19.0)
    speed = run.body("load", "body_velocity")[steady, 2]
    assert speed == pytest.approx(np.full(speed.shape, 2.0), abs=2e-5)
    at_rest = (run.time > 24.5) & (run.time < 25.0)
    # Hauling with the acceleration a winds ∫ (ε − ε₀) of the way more stretch: ε a/g over 1 m, 2e-4 m at
    # most.
    assert height[at_rest] + 110.0 == pytest.approx(-way[at_rest], abs=3e-4)
    assert height[-1] == pytest.approx(-110.0, abs=1e-5)
    assert way[-1] == pytest.approx(0.0, abs=1e-9)
    assert run.energy_remainder < 1e-10


def test_rope_wound_under_little_comes_off_and_stretches() -> None:
    """L̇ = v/(1 + ε_d): the load sinks with v (1 + ε)/(1 + ε_d), the rim holds T, and friction takes the rest.

    Rope wound under half of the weight has half of its stretch. It slips on the drum until it has the whole:
    EA (ε − ε_d)²/2 of its unstretched length.
    """
    laid = 0.5 * WEIGHT
    run = adaptive(hoist([(0.0, 1.0, 2.0)], laid_under=laid, depth=10.0), 30.0, sample_interval=0.1)
    steady = run.time > 15.0
    speed = -run.body("load", "body_velocity")[steady, 2]
    expected = 2.0 * (1 + STRAIN) / (1 + 0.5 * STRAIN)
    assert speed == pytest.approx(np.full(speed.shape, expected), rel=1e-6)
    way = np.ptp(run.joint("winch")[steady])
    # The damper answers to g, whose rate is ε L̇/2 where rope of a steady strain comes in: it has τ L̇/2L
    # of the tension.
    length = -run.body("load")[:, 2]
    strain = STRAIN * (1 - TAU * 2.0 / (2 * length[steady]))
    lost = EA * (strain - 0.5 * STRAIN) ** 2 / 2 * 2.0 / (1 + 0.5 * STRAIN)
    # To first order in strain, 1e-3, and in τ L̇/L, 5e-3 at most.
    slipped = np.trapezoid(lost, run.time[steady])
    assert np.ptp(run.energy("friction")[steady]) == pytest.approx(slipped, rel=1e-4)
    work = np.ptp(run.energy("drive_work")[steady])
    assert work == pytest.approx(WEIGHT * way, rel=1e-6)
    assert run.energy_remainder < 1e-10


def test_work_of_hoisting_is_weight_times_way_at_the_rim() -> None:
    """The rim holds T, not T (1 + ε/2): half a per mille of the work here, which the wound rope keeps."""
    run = adaptive(hoist([(0.0, 1.0, -2.0)]), 40.0, sample_interval=0.1)
    steady = run.time > 15.0
    way = -np.ptp(run.joint("winch")[steady])
    work = np.ptp(run.energy("drive_work")[steady])
    assert work == pytest.approx(-WEIGHT * way, rel=1e-6)
    # What the drum holds grows by EA ε²/2 of its unstretched length, and the fall gets that much shorter:
    # of 5.5 kJ together only what the damper holds changes, 2 τ v/2L of the fall's, L from 80 to 30 m.
    assert np.ptp(run.energy("elastic")[steady]) < 2 * TAU * 2.0 / (2 * 30.0) * EA * STRAIN**2 / 2 * 80.0
    assert abs(run.energy("friction")[-1]) < 1e-6


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_both_methods_wind_alike(method: str) -> None:
    """Where the load is after 20 m up and 10 m down, with a load that rings: to 0.1 mm."""
    system = hoist([(0.0, 0.5, -2.0), (10.0, 0.5, 2.0), (15.0, 0.5, 0.0)], depth=60.0)
    fine = adaptive(system, 20.0, sample_interval=0.1)
    run = fine if method == "adaptive" else simulate(system, 20.0, sample_interval=0.1)
    assert run.body("load")[-1, 2] == pytest.approx(fine.body("load")[-1, 2], abs=1e-4)
    assert run.energy_remainder < (1e-10 if method == "adaptive" else 1e-4)


def test_a_checkpoint_carries_what_was_wound() -> None:
    """A run that is saved on the way up and taken up again pays out what it wound, to the last bit."""
    text = json.dumps(hoist(UP_AND_DOWN, depth=60.0))
    settings = json.dumps(
        {"integrator": {"type": "adaptive"}, "duration": 30.0, "sample_interval": 0.1},
    )
    whole, parts = Simulation(text, settings), Simulation(text, settings)
    assert whole.run()["status"] == "done"
    parts.run(None, 12.3)
    again = Simulation(text, settings)
    again.restore(parts.save())
    assert again.run()["status"] == "done"
    one, other = whole.columns(), again.columns()
    late = one["time"] > 15.0
    # The pause ends a step, so steps differ; what is wound does not.
    assert np.abs(one["body_position"][late] - other["body_position"][late]).max() < 1e-6


LAYERS = {"radius": 0.5, "step": 0.04, "turns": 20.0, "start": 5.0}
#: Rope of a turn in the first layer [m].
TURN = 2 * math.pi * 0.5


def layered(turns: float, speed: float, **motor: float) -> Run:
    """Winds up `turns` turns on a drum with 5 turns on it; the rope hardly stretches."""
    ramps = [
        {"at": 0.0, "duration": 1.0, "velocity": -speed, "shape": "smooth"},
        {"at": turns * TURN / speed, "duration": 1.0, "velocity": 0.0, "shape": "smooth"},
    ]
    top = drum(None, (0, 0, 0), "winch")
    top["drum"] |= {"layers": LAYERS}
    bodies = [
        body("load", slider(), MASS, position=(0, 0, -300)),
        flow("winch", 500.0, drive="winch", **motor),
    ]
    fall = rope("fall", 300.0, [end("load"), top], 1e11, 0.01)
    system = document(bodies, ropes=[fall], drives=[{"name": "winch", "ramps": ramps}])
    return adaptive(system, turns * TURN / speed + 5.0, sample_interval=0.1, tension_tolerance=1.0)


def test_length_on_each_layer() -> None:
    """Rope of n turns in layer k is n π (D + 2 (k − 1) δ): 15 turns of the first, 20 of the second, 5 more.

    Ends stand well inside a layer, so that the climb from one to the next counts half on either side.
    """
    run = layered(40.0, 4.0)
    wound = sum(
        2 * math.pi * (0.5 + 0.04 * layer) * turns for layer, turns in ((0, 15.0), (1, 20.0), (2, 5.0))
    )
    assert run.joint("winch")[-1] == pytest.approx(-40 * TURN, abs=1e-9)
    # Under 98 kN of 1e11 N the rope has 1e-6 of stretch; the load starts that of 300 m lower, from rope
    # without.
    assert run.body("load")[-1, 2] + 300.0 == pytest.approx(wound, abs=1e-3)
    assert run.energy_remainder < 1e-8


def test_speed_of_the_rope_grows_with_the_layers() -> None:
    """At a constant speed of the drum the rope goes with D₁ + 2 (k − 1) δ over D₁."""
    run = layered(40.0, 4.0)
    speed = run.body("load", "body_velocity")[:, 2]
    turns = 5.0 - run.joint("winch") / TURN
    for layer, (start, stop) in enumerate(((12.0, 19.0), (24.0, 39.0), (43.0, 44.2))):
        within = (turns > start) & (turns < stop)
        assert within.any()
        assert speed[within].mean() == pytest.approx(4.0 * (0.5 + 0.04 * layer) / 0.5, rel=1e-4)


def test_pull_at_constant_torque_falls_with_the_layers() -> None:
    """A motor of the torque M hauls T = M/r_k: 1.12 m g on the first layer are too little for the third.

    δ/r = 0.08: the radii are as 1, 1.08, 1.16, and within half a turn about turn 40 it goes from 1.08 to
    1.16. From 1.12 on, at turn 40, the load brakes the drum:
    ½ m (ρ v)² + ½ I v² = m g ∫ (ρ − 1.12) dx, ρ = r/r₁, v = 1 m/s.
    """
    slope = 0.08 / (0.5 * TURN)
    run = layered(40.0, 1.0, capacity=1.12 * WEIGHT)
    # The climb itself speeds the rope up by v² dρ/dx, so that the motor is at its limit a little before
    # turn 40.
    limit = 1.12 / (1 + slope / G)
    energy = 0.5 * MASS * limit**2 + 0.5 * 500.0
    climbed = (0.04**2 - (1.12 - limit) ** 2) / (2 * slope)
    beyond = (energy / WEIGHT - climbed) / 0.04 + 0.04 / slope
    turns = 5.0 - run.joint("winch") / TURN
    # A sample is at most 0.05 s from the turning point, where a = 0.04 g.
    assert turns.max() == pytest.approx(40.0 + beyond / TURN, abs=1e-3)
    assert run.energy_remainder < 1e-8
