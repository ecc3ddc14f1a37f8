"""Ropes that are cut and ropes that break against closed forms."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import (
    G,
    Json,
    Run,
    adaptive,
    body,
    document,
    end,
    flow,
    half_turn,
    point,
    rope,
    sheave,
    simulate,
    slider,
)

MASS, EA, LENGTH = 100.0, 1e6, 5.0
STIFFNESS = EA / LENGTH


def hanging(**parting: Any) -> Json:
    """A mass at rest on an elastic rope."""
    stretch = MASS * G / STIFFNESS
    route = [end(None, (0, 0, 10)), end("mass")]
    return document(
        [body("mass", slider(), MASS, position=(0, 0, 10 - LENGTH - stretch))],
        ropes=[{**rope("rope", LENGTH, route, EA), **parting}],
    )


def pulled(force: float, speed: float, damping_time: float = 0.0, **rest: Any) -> Json:
    """A rope between the world and a drive that pulls at constant speed from its unstretched length on."""
    drive = slider((1, 0, 0), drive="pull")
    return document(
        [body("puller", drive, 10.0, position=(LENGTH, 0, 0))],
        ropes=[
            {
                **rope("rope", LENGTH, [end(None), end("puller")], EA, damping_time),
                "breaking_force": force,
            }
        ],
        drives=[{"name": "pull", "ramps": [{"at": 0.0, "duration": 1e-9, "velocity": speed}]}],
        **rest,
    )


def the_event(run: Run, kind: str) -> float:
    [(time, name)] = run.events(kind)
    assert name == "rope"
    return time


@pytest.mark.parametrize("at", [0.0, 0.3, 0.3141592653589793])
def test_a_mass_whose_rope_is_cut_falls_freely(at: float) -> None:
    """x = −½ g (t − t_c)² from the cut on, to 1e-10 m; the rope's ½ (m g)²/k is booked as parting."""
    run = adaptive(hanging(cut_at=at), 1.0)
    assert the_event(run, "cut") == at
    falling = np.maximum(run.time - at, 0.0)
    assert np.abs(run.joint("mass") + 0.5 * G * falling**2).max() < 1e-10
    assert np.abs(run.tension("rope")[run.time > at]).max() == 0.0
    assert np.abs(run.tension("rope")[run.time < at] - MASS * G).max(initial=0.0) < 1e-6
    held = 0.5 * (MASS * G) ** 2 / STIFFNESS
    assert run.energy("parting")[-1] == pytest.approx(held, rel=1e-9)
    assert run.energy("elastic")[-1] == 0.0
    assert run.energy_remainder < 1e-12
    assert run.events("slack") == []


def test_a_cut_with_fixed_steps() -> None:
    """The same with `del`: free fall from the start of the step of the cut, 1 ms, x = −½ g t (t + h)."""
    step = 1e-3
    run = simulate(hanging(cut_at=0.3), 1.0, step=step)
    assert the_event(run, "cut") == 0.3
    falling = np.maximum(run.time - 0.3, 0.0)
    assert np.abs(run.joint("mass") + 0.5 * G * falling * (falling + step)).max() < G * step
    assert run.energy("parting")[-1] == pytest.approx(0.5 * (MASS * G) ** 2 / STIFFNESS, rel=1e-9)
    assert run.energy_remainder < 1e-9


def test_a_swinging_mass_goes_on_along_its_tangent() -> None:
    """A ball on an inextensible string, cut at t_c: from there r = r_c + v_c (t − t_c) − ½ g (t − t_c)² ẑ."""
    at, length = 0.7, 2.0
    route = [end(None, (0, 0, 0)), end("ball")]
    string = {**rope("rope", length, route, None), "cut_at": at}
    system = document([body("ball", point((length, 0, 0)), 3.0)], ropes=[string])
    run = adaptive(system, 1.5, sample_interval=0.05)
    cut = int(np.argmin(np.abs(run.time - at)))
    place, velocity = run.body("ball"), run.body("ball", "body_velocity")
    flying = (run.time[cut:] - run.time[cut])[:, None]
    free = place[cut] + velocity[cut] * flying - 0.5 * G * flying**2 * np.array([0, 0, 1])
    assert np.abs(place[cut:] - free).max() < 1e-7  # the velocity is that of the dense output
    assert run.energy("parting")[-1] == 0.0  # a rope that does not stretch holds nothing
    assert run.columns["residual_constraint"].max() < 1e-6  # and is not too long once it has parted
    assert run.energy_remainder < 1e-9


@pytest.mark.parametrize("damping_time", [0.0, 0.01])
def test_a_rope_pulled_at_constant_speed_breaks_at_its_breaking_force(damping_time: float) -> None:
    """F = k (v t + τ v), so t_b = F_b L/(EA v) − τ, to 1e-8; released energy ½ k (v t_b)²."""
    force, speed = 5e3, 0.02
    run = adaptive(pulled(force, speed, damping_time), 2.0)
    time = force * LENGTH / (EA * speed) - damping_time
    assert the_event(run, "broken") == pytest.approx(time, abs=1e-8)
    assert run.peak("rope") == pytest.approx(force, rel=1e-9)
    assert run.tension("rope")[run.time > time].max() == 0.0
    held = 0.5 * STIFFNESS * (speed * time) ** 2
    assert run.energy("parting")[-1] == pytest.approx(held, rel=1e-8)
    if damping_time == 0.0:
        assert held == pytest.approx(0.5 * force**2 * LENGTH / EA, rel=1e-12)
        moving = 0.5 * 10.0 * speed**2
        assert run.energy("drive_work")[-1] == pytest.approx(held + moving, rel=1e-8)


def test_breaking_with_fixed_steps() -> None:
    """`del` ends a rope at the end of the step in which it reaches F_b: late by a step at most."""
    force, speed, step = 5e3, 0.02, 1e-3
    run = simulate(pulled(force, speed), 2.0, step=step)
    time = force * LENGTH / (EA * speed)
    assert 0.0 <= the_event(run, "broken") - time <= step * (1 + 1e-6)
    assert run.tension("rope")[-1] == 0.0
    assert run.energy_remainder < 1e-9


def test_a_rope_that_bears_its_peak_holds() -> None:
    """A mass let go on an unstretched rope swings up to 2 m g: it breaks just below that and not just above.

    It breaks where k x = F_b, x = (m g/k)(1 − cos ω t).
    """
    static = MASS * G
    omega = math.sqrt(STIFFNESS / MASS)
    route = [end(None, (0, 0, LENGTH)), end("mass")]
    mass = [body("mass", slider(), MASS)]

    def let_go(force: float) -> Run:
        return adaptive(
            document(mass, ropes=[{**rope("rope", LENGTH, route, EA), "breaking_force": force}]), 1.0
        )

    assert let_go(2.0 * static * (1 + 1e-5)).events("broken") == []
    for share in (0.5, 1.0, 1.9, 2.0 * (1 - 1e-5)):
        time = math.acos(1 - share) / omega
        assert the_event(let_go(share * static), "broken") == pytest.approx(time, abs=2e-5)


def test_a_string_breaks_as_the_ball_swings_down() -> None:
    """T = 3 m g sin φ of a ball let go level with its string: it breaks at sin φ = F_b/(3 m g)."""
    mass, length = 3.0, 2.0
    route = [end(None, (0, 0, 0)), end("ball")]
    string = {**rope("rope", length, route, None), "breaking_force": 1.5 * mass * G}
    run = adaptive(document([body("ball", point((length, 0, 0)), mass)], ropes=[string]), 1.5)
    time = the_event(run, "broken")
    sample = np.searchsorted(run.time, time)
    angle = np.arctan2(-run.body("ball")[:sample, 2], run.body("ball")[:sample, 0])
    tension = run.tension("rope")[:sample]
    assert np.abs(tension - 3 * mass * G * np.sin(angle)).max() < 1e-3
    assert run.peak("rope") == pytest.approx(1.5 * mass * G, rel=1e-7)
    assert run.tension("rope")[sample:].max() == 0.0


def test_one_rope_after_another() -> None:
    """Two equal ropes share m g. One is cut: the other swings up to 3/2 m g and breaks at 1.2 m g on its way.

    With both, k₂ = 2 k and x₀ = m g/2k; with one, k x = m g − ½ m g cos ω t, so cos ω t_b = −0.4.
    """
    routes = [[end(None, (y, 0, LENGTH)), end("mass", (y, 0, 0))] for y in (-1.0, 1.0)]
    ropes = [rope(name, LENGTH, route, EA) for name, route in zip(("one", "other"), routes, strict=True)]
    ropes[0]["cut_at"] = 0.25
    ropes[1]["breaking_force"] = 1.2 * MASS * G
    start = -MASS * G / (2 * STIFFNESS)
    run = adaptive(document([body("mass", slider(), MASS, position=(0, 0, start))], ropes=ropes), 1.0)
    assert run.events("cut") == [(0.25, "one")]
    [(time, name)] = run.events("broken")
    assert name == "other"
    assert time == pytest.approx(0.25 + math.acos(-0.4) * math.sqrt(MASS / STIFFNESS), abs=1e-6)
    assert run.energy_remainder < 1e-8


def test_a_rope_that_is_weaker_than_the_tolerance() -> None:
    """It goes taut and breaks within the switching tolerance, five times 100 N: the mass falls on freely."""
    route = [end(None, (0, 0, LENGTH)), end("mass")]
    weak = {**rope("rope", LENGTH, route, EA), "breaking_force": 200.0}
    system = document([body("mass", slider(), MASS, position=(0, 0, 0.5))], ropes=[weak])
    run = adaptive(system, 1.0, tension_tolerance=100.0)
    assert the_event(run, "broken") == pytest.approx(math.sqrt(2 * 0.5 / G), abs=2e-3)
    assert run.joint("mass")[-1] == pytest.approx(-0.5 * G, abs=1e-2)
    assert run.counters["steps"] < 100


def test_every_span_of_a_rope_parts() -> None:
    """A rope over a sheave with losses is cut: both sides fall freely, and both sides' energy is booked."""
    spans = [("left", 40.0), ("right", 60.0)]
    route = [
        end("left"),
        half_turn(None, (0, 0, 5), 0.5, over=True, flow="groove", ratio=1.1),
        end("right"),
    ]
    bodies = [
        body(name, slider(), mass, position=(x, 0, 0))
        for (name, mass), x in zip(spans, (-0.5, 0.5), strict=True)
    ]
    cut = {**rope("rope", None, route, EA), "cut_at": 0.5}
    run = adaptive(document([*bodies, flow("groove", 2.0)], ropes=[cut]), 1.0)
    at, last = int(np.argmin(np.abs(run.time - 0.5))), len(run.time) - 1
    for name, _ in spans:
        place, velocity = run.body(name)[:, 2], run.body(name, "body_velocity")[:, 2]
        assert place[last] == pytest.approx(place[at] + 0.5 * velocity[at] - G / 8, abs=1e-6)
    assert run.energy("parting")[-1] == pytest.approx(run.energy("elastic")[at], rel=1e-6)
    assert run.columns["segment_tension"][at + 1 :].max() == 0.0
    assert run.energy_remainder < 1e-8


def test_a_cut_as_a_step_begins() -> None:
    """The plan waits 0.25 s and cuts as its second step begins; what is not named stays whole."""
    system = hanging()
    spare = rope("spare", LENGTH + 2.0, [end(None, (0, 0, 10)), end("mass")], EA)
    system["ropes"].append(spare)
    system["plan"] = [
        {"name": "wait", "until": {"type": "duration", "duration": 0.25}},
        {"name": "cut", "until": {"type": "end_of_run"}, "cuts": ["rope"]},
    ]
    run = adaptive(system, 2.0)
    assert run.events("cut") == [(0.25, "rope")]
    fall = 2.0 - MASS * G / STIFFNESS
    time, name = run.events("taut")[0]
    assert name == "spare"
    assert time == pytest.approx(0.25 + math.sqrt(2 * fall / G), abs=1e-4)
    assert simulate(system, 0.5).events("cut") == [(0.25, "rope")]


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_saved_run_goes_on_with_the_same_bytes(method: str) -> None:
    """Saved after the cut and before the break: the same rest of the run."""
    routes = [[end(None, (y, 0, LENGTH)), end("mass", (y, 0, 0))] for y in (-1.0, 1.0)]
    ropes = [rope(name, LENGTH, route, EA) for name, route in zip(("one", "other"), routes, strict=True)]
    ropes[0]["cut_at"], ropes[1]["breaking_force"] = 0.25, 1.2 * MASS * G
    start = -MASS * G / (2 * STIFFNESS)
    system = document([body("mass", slider(), MASS, position=(0, 0, start))], ropes=ropes)
    integrator = {"type": method} | ({"step": 1e-3} if method == "del" else {})
    settings = {"integrator": integrator, "duration": 0.5, "sample_interval": 0.01}

    def new() -> Simulation:
        return Simulation(json.dumps(system), json.dumps(settings))

    whole, first, second = new(), new(), new()
    whole.run()
    first.run(None, 0.26)
    second.restore(first.save())
    second.run()
    assert second.save() == whole.save()
    assert [kind for kind in whole.names()["event_kind"]][:2] == ["cut", "broken"]


@pytest.mark.parametrize("run", [adaptive, simulate])
def test_what_a_rope_held_may_go_where_no_rope_could(run: Callable[..., Run]) -> None:
    """Cut, a load flies through its sheave: a rope would have no tangent there, and nobody asks any more."""
    route = [end(None, (-1, 0, -3)), sheave(None, (0, 0, 0), (0, 1, 0), 0.5), end("load")]
    cut = {**rope("rope", None, route, EA, 0.01), "cut_at": 0.05}
    load = body("load", point((0.3, 0, -2), (0, 0, 12.0)), MASS)
    done = run(document([load], ropes=[cut]), 1.0)
    place = done.body("load")
    assert (np.hypot(place[:, 0], place[:, 2]) < 0.5).any()
    assert all(np.isfinite(column).all() for column in done.columns.values())
    assert run is simulate or done.energy_remainder < 1e-6
