"""Locking pins of moving sheaves, in and pulled, against closed forms."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import G, Json, Run, body, document, end, finished, half_turn, hinge, rope, slider

RADIUS = 0.2
#: A sheave [kg], the load [kg], EA of the slings [N]; the equalizing rope is a thousand times as stiff.
SHEAVE, LOAD, EA = 200.0, 60e3, 1e8
LENGTHS = (10.0, 10.01, 9.995)
#: When the pins are pulled [s].
PULLED = 4.0
METHODS: dict[str, Json] = {
    "adaptive": {"type": "adaptive", "tension_tolerance": 1.0, "position_tolerance": 1e-7},
    "del": {"type": "del", "step": 1e-3},
}


def pinned_depth() -> float:
    """Depth z of the load below the sheaves where Σ kᵢ (z − Lᵢ) = W [m]."""
    stiffness = [EA / length for length in LENGTHS]
    return (LOAD * G + EA * len(LENGTHS)) / sum(stiffness)


def equalizer(plan: list[Json], *, pin: bool = True, damped: bool = True) -> Json:
    """A level load on three slings under an equalizer, let go above where it hangs; there if not damped."""
    route = [end(None, (-RADIUS, 0, 0))]
    guide, hoist, stretching = (2e4, 2e5, 0.02) if damped else (0.0, 0.0, 0.0)
    depth = 10.0 if damped else pinned_depth()
    bodies, slings = [], []
    for i, length in enumerate(LENGTHS):
        x = 4 * RADIUS * i
        bodies.append(body(f"m{i}", slider((0, 0, -1), damping=guide, pin=pin), SHEAVE, position=(x, 0, -5)))
        slings.append(rope(f"s{i}", length, [end(f"m{i}"), end("load", (x, 0, 0))], EA, stretching))
        route.append(half_turn(f"m{i}", (0, 0, 0), RADIUS, False))
        if i < 2:
            route.append(half_turn(None, (x + 2 * RADIUS, 0, 0), RADIUS, True))
    route.append(end(None, (9 * RADIUS, 0, 0)))
    bodies.append(body("load", slider((0, 0, -1), damping=hoist), LOAD, position=(0, 0, -5 - depth)))
    ropes = [rope("equalizing", None, route, 1e3 * EA, stretching), *slings]
    return document(bodies, ropes=ropes, plan=plan)


def steps(*names: str, duration: float = PULLED, **done: list[str]) -> list[Json]:
    """Two steps that hold; the second, from `duration` on, does what `done` says."""
    hold = {"type": "duration", "duration": duration}
    return [
        {"name": names[0], "until": hold},
        {"name": names[1], "until": {"type": "end_of_run"}, **done},
    ]


def run(system: Json, method: str, duration: float, interrupted_at: float | None = None) -> Run:
    settings = {"integrator": METHODS[method], "duration": duration, "sample_interval": 0.05}
    texts = json.dumps(system), json.dumps(settings)
    simulation = Simulation(*texts)
    if interrupted_at is not None:
        simulation.run(None, interrupted_at)
        saved = simulation.save()
        simulation = Simulation(*texts)
        simulation.restore(saved)
    status = simulation.run()
    assert status["status"] == "done", status
    return finished(simulation, status)


def pin_force(result: Run, name: str) -> Any:
    return result.columns["pin_force"][:, result.names["pin"].index(name)]


def at(result: Run, time: float) -> int:
    return int(np.searchsorted(result.time, time - 1e-9))


@pytest.mark.parametrize("method", METHODS)
def test_pinned_slings_share_as_on_a_beam_and_equalise_when_the_pins_are_pulled(method: str) -> None:
    """In: each sling carries kᵢ (z − Lᵢ) with Σ = W, kᵢ = EA/Lᵢ, and its pin that and the sheave's weight.

    The equalizing rope carries nothing, since nothing has pulled it. Pulled: W/3 in each sling, (W/3 + w)/2
    in the equalizing rope, whose stretch is Σ 2 xᵢ, and rᵢ = xᵢ + Lᵢ + W/(3 kᵢ) the same for all sheaves,
    as the load is level.
    """
    names = [f"m{i}" for i in range(3)]
    result = run(equalizer(steps("pinned", "free", pulls=names)), method, 24.0)
    weight = LOAD * G
    stiffness = np.array([EA / length for length in LENGTHS])
    lengths = np.array(LENGTHS)
    pinned = stiffness * (pinned_depth() - lengths)
    assert (pinned > 0).all() and np.ptp(pinned) > 0.5 * weight / 3  # they do not carry alike
    before = at(result, PULLED)
    tension = [float(result.tension(f"s{i}")[before]) for i in range(3)]
    assert tension == pytest.approx(pinned, rel=1e-6)
    held = [float(pin_force(result, name)[before - 1]) for name in names]
    assert held == pytest.approx(pinned + SHEAVE * G, rel=1e-6)
    for name in names:
        assert np.abs(result.joint(name)[: before + 1]).max() < 1e-12
        assert np.abs(pin_force(result, name)[before + 1 :]).max() == 0.0
    equal = weight / 3
    tension = [float(result.tension(f"s{i}")[-1]) for i in range(3)]
    assert tension == pytest.approx([equal] * 3, rel=1e-6)
    travel = np.array([result.joint(name)[-1] for name in names])
    # T = (f + w)/2 in a rope of six parts and five arcs, about 30 m + 3 m: its stretch goes to all sheaves.
    length = 6 * 5.0 + 5 * math.pi * RADIUS
    stretch = 0.5 * (equal + SHEAVE * G) * length / (1e3 * EA)
    reach = lengths + equal / stiffness
    assert travel == pytest.approx(reach.mean() - reach + stretch / 6, abs=2e-7)
    assert result.events("pin_pulled") == [(PULLED, name) for name in names]
    assert result.energy_remainder < (1e-8 if method == "adaptive" else 1e-6)


def test_a_pin_that_is_pulled_takes_no_energy_with_it() -> None:
    """Without any damping, from rest on pinned sheaves: what is stored stays, through the pulling too.

    The sheaves set off with what the pins held over their mass, less 2T, which is the same for all of them.
    """
    names = [f"m{i}" for i in range(3)]
    plan = steps("pinned", "free", duration=0.5, pulls=names)
    system = equalizer(plan, damped=False)
    settings = {"integrator": METHODS["adaptive"], "duration": 1.0, "sample_interval": 1e-4}
    simulation = Simulation(json.dumps(system), json.dumps(settings))
    result = finished(simulation, simulation.run())
    kinetic, gravity, elastic = (result.energy(kind) for kind in ("kinetic", "gravity", "elastic"))
    before = at(result, 0.5)
    assert kinetic[: before + 1].max() < 1e-9 * elastic[0]
    assert kinetic.max() > 1e-2 * elastic[0]
    assert np.abs(kinetic + gravity + elastic - elastic[0]).max() < 1e-6 * elastic[0]
    for kind in ("impact", "parting", "friction"):
        assert result.energy(kind)[-1] == 0.0
    assert result.energy_remainder < 1e-8
    # ω² = EA/(L m) of a sheave on its sling changes the force by ω² t²/6 = 1e-4 of its change in the time t.
    speed = np.array([-result.body(name, "body_velocity")[before + 1, 2] for name in names])
    held = np.array([pin_force(result, name)[before - 1] for name in names])
    assert np.diff(speed) == pytest.approx(1e-4 * np.diff(held) / SHEAVE, rel=1e-3)


@pytest.mark.parametrize("method", METHODS)
def test_a_run_goes_on_from_a_checkpoint_on_either_side_of_the_pulling(method: str) -> None:
    """The same bytes as without a break, from a state with the pins in and from one with the pins out."""
    system = equalizer(steps("pinned", "free", duration=1.0, pulls=["m0", "m2"]))
    whole = run(system, method, 2.5)
    for interrupted_at in (0.7, 1.6):
        parts = run(system, method, 2.5, interrupted_at)
        assert parts.names == whole.names
        for name, values in whole.columns.items():
            assert np.array_equal(parts.columns[name], values), name


@pytest.mark.parametrize("method", METHODS)
def test_a_pin_that_is_put_in_again(method: str) -> None:
    """At rest: it holds where the sheave then is, and what comes on afterwards is shared as on a beam.

    After equalising at W/3 the load is pulled down by a further rope: the slings share its tension as their
    stiffness, EA/Lᵢ, and the sheaves do not move.
    """
    names = [f"m{i}" for i in range(3)]
    plan: list[Json] = [
        {"name": "free", "until": {"type": "duration", "duration": 2.0}},
        {"name": "pinned", "until": {"type": "duration", "duration": 1.0}, "pins": names},
        {
            "name": "more",
            "until": {"type": "duration", "duration": 12.0},
            "moves": [{"drive": "winch", "velocity": 0.01, "acceleration": 1.0}],
        },
        {"name": "rest", "until": {"type": "end_of_run"}},
    ]
    system = equalizer(plan, pin=False)
    # A winch below that tightens a rope which starts slack.
    system["bodies"].append(body("winch", slider((0, 0, -1), drive="winch"), 1.0, position=(0, 0, -25)))
    system["ropes"].append(rope("more", 10.001, [end("load"), end("winch")], EA / 10, 0.02))
    system["drives"] = [{"name": "winch", "ramps": []}]
    result = run(system, method, 24.0)
    pinned, last = at(result, 2.5), -1
    for name in names:
        moved = np.abs(result.joint(name)[pinned:] - result.joint(name)[pinned])
        assert moved.max() < 1e-12
    slings = [result.tension(f"s{i}") for i in range(3)]
    assert [float(sling[pinned]) for sling in slings] == pytest.approx([LOAD * G / 3] * 3, rel=1e-5)
    added = np.array([sling[last] - sling[pinned] for sling in slings])
    stiffness = np.array([EA / length for length in LENGTHS])
    more = float(result.tension("more")[last])
    assert more > 1e4
    assert added == pytest.approx(more * stiffness / stiffness.sum(), rel=1e-4)
    assert result.events("pin_put_in") == [(2.0, name) for name in names]
    assert abs(result.energy("impact")[last]) < 1e-3  # J, of sheaves slower than 1 mm/s
    assert result.energy_remainder < 1e-5


@pytest.mark.parametrize("method", METHODS)
def test_no_pin_goes_into_a_sheave_that_moves(method: str) -> None:
    """The run ends with the sheave's name and its speed; the state is the last good one."""
    plan = steps("free", "pinned", duration=0.01, pins=["m2"])
    settings = {"integrator": METHODS[method], "duration": 1.0, "sample_interval": 0.05}
    simulation = Simulation(json.dumps(equalizer(plan, pin=False)), json.dumps(settings))
    status = simulation.run()
    assert status["status"] == "failed"
    assert status["time"] == pytest.approx(0.01, abs=1e-3)
    assert status["element"] == "m2"
    assert "cannot be put in while it moves by 0." in status["cause"]


@pytest.mark.parametrize("method", METHODS)
def test_a_pinned_hinge_is_a_fixed_joint(method: str) -> None:
    """A crooked double pendulum in space, its knee pinned at 0.7 rad, moves like one without a joint there.

    Rounding apart, so do its joint forces and what the energy balance leaves over.
    """
    angle = 0.7

    def pendulum(joint: Json, turned: float) -> Json:
        upper = body(
            "upper", hinge((0, 1, 0), position=0.9), 20.0, centre_of_gravity=(0, 0.1, -0.5), inertia=(2, 2, 1)
        )
        lower = body(
            "lower",
            joint,
            30.0,
            parent="upper",
            position=(0, 0, -1),
            centre_of_gravity=(0.2, 0, -0.6),
            inertia=(3, 2, 1),
        )
        lower["placement"]["orientation"] = [math.cos(turned / 2), math.sin(turned / 2), 0, 0]
        return document([upper, lower])

    pinned = run(pendulum(hinge((1, 0, 0), position=angle, pin=True), 0.0), method, 4.0)
    fixed = run(pendulum({"type": "fixed"}, angle), method, 4.0)
    for column in ("body_position", "body_orientation", "body_velocity", "joint_force"):
        largest = np.abs(fixed.columns[column]).max()
        assert np.abs(pinned.columns[column] - fixed.columns[column]).max() < 1e-6 * largest
    assert np.abs(pinned.joint("lower") - angle).max() < 1e-12
    assert np.abs(pin_force(pinned, "lower")).max() > 10.0
    assert pinned.energy_remainder == pytest.approx(fixed.energy_remainder, rel=1e-3, abs=1e-9)


def test_what_is_refused() -> None:
    """Pins of joints that have none, twice in one step, on driven joints, and with `explicit`."""
    method = {"integrator": METHODS["del"], "duration": 1.0, "sample_interval": 0.1}
    explicit = {**method, "integrator": {"type": "explicit", "step": 1e-4}}
    pinned, driven, rough = equalizer([]), equalizer([]), equalizer([])
    rough["bodies"][0]["joint"]["friction"] = 10.0
    driven["bodies"][0]["joint"]["drive"] = "d"
    driven["drives"] = [{"name": "d", "ramps": []}]
    cases = (
        (equalizer(steps("a", "b", pulls=["load"])), method, "there is no pin of `load`"),
        (equalizer(steps("a", "b", pulls=["m0"], pins=["m0"])), method, "moves the pin of `m0` twice"),
        (driven, method, "what is driven has no pin"),
        (rough, method, "has friction and a pin, which hold the same"),
        (pinned, explicit, "the integrator explicit knows no pins, such as that of m0"),
    )
    for system, settings, says in cases:
        with pytest.raises(ValueError, match=says):
            Simulation(json.dumps(system), json.dumps(settings))
