"""Loads in water against closed forms, against what hulls and bodies in deep water have, and in energy."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gantline
from floating import added_mass, drag
from in_water import RHO, growth, lattice, number, sea, share, submerged
from mechanics import G, Json, adaptive, body, document, end, free, rope, simulate, slider

MASS, ADDED = 1000.0, 700.0
#: Far below the surface [m].
DEEP = -200.0


def falling(force: Json, start: Json, **rest: Any) -> Json:
    """One body on a vertical slider."""
    return document([body("load", slider(**start), MASS)], forces=[force], **rest)


def test_sinks_to_its_terminal_speed() -> None:
    """(m + a) v̇ = (m − ρV) g − c v² from rest: v = w tanh(t/T), z = w T ln cosh(t/T), with
    w² = (m − ρV) g/c and T = w (m + a)/((m − ρV) g).
    """
    volume, c = 0.4, 350.0
    force = submerged("load", lattice(volume=volume, added=(0, 0, ADDED), quadratic=(0, 0, c)))
    run = adaptive(falling(force, {"position": DEEP}), 10.0)
    weight = (MASS - RHO * volume) * G
    w = math.sqrt(weight / c)
    rise = w * (MASS + ADDED) / weight
    assert run.body("load", "body_velocity")[:, 2] == pytest.approx(-w * np.tanh(run.time / rise), abs=1e-6)
    way = w * rise * np.log(np.cosh(run.time / rise))
    assert run.body("load")[:, 2] == pytest.approx(DEEP - way, abs=1e-6)
    # What drag has taken is what weight in water gave and motion does not have.
    taken = weight * way[-1] - 0.5 * (MASS + ADDED) * run.body("load", "body_velocity")[-1, 2] ** 2
    assert run.energy("drag")[-1] == pytest.approx(taken, rel=1e-6)
    assert run.energy_remainder < 1e-8


def test_blow_on_the_way_in() -> None:
    """Without weight the momentum (m + s a) v stays as a body goes in (von Kármán 1929), and of its energy
    ½ m v² the share a/(m + a) is lost: half of the work of the blow is in the water that goes along, half in
    spray.
    """
    speed = 5.0
    start = {"position": 2.0, "velocity": -speed}
    system = falling(submerged("load", lattice(added=(0, 0, ADDED))), start) | {"gravity": [0, 0, -1e-9]}
    run = adaptive(system, 1.5, sample_interval=0.005)
    velocity, wet = run.body("load", "body_velocity")[:, 2], share(-run.body("load")[:, 2], 1.0)
    assert (wet[0], wet[-1]) == (0.0, 1.0)
    assert velocity == pytest.approx(-speed * MASS / (MASS + wet * ADDED), rel=1e-6)
    had = 0.5 * MASS * speed**2
    assert run.energy("drag")[-1] == pytest.approx(had * ADDED / (MASS + ADDED), rel=1e-6)
    assert run.energy("kinetic")[-1] == pytest.approx(had * MASS / (MASS + ADDED), rel=1e-6)


def test_no_blow_on_the_way_out() -> None:
    """What comes out of the water leaves behind what went along: it keeps its speed, and ½ a v² is lost."""
    speed = 2.0
    start = {"position": -2.0, "velocity": speed}
    system = falling(submerged("load", lattice(added=(0, 0, ADDED))), start) | {"gravity": [0, 0, -1e-9]}
    run = adaptive(system, 2.0)
    assert run.body("load", "body_velocity")[:, 2] == pytest.approx(speed, rel=1e-6)
    # Nothing makes steps short, and the books look at some points of each: the hat of s' bends between.
    assert run.energy("drag")[-1] == pytest.approx(0.5 * ADDED * speed**2, rel=1e-4)


@pytest.mark.parametrize("depth", [None, 18.0])
def test_hung_in_a_wave(depth: float | None) -> None:
    """A body on a rope, small beside the waves: (m + a) ẍ + k τ ẋ + k x = (ρV + a) u̇, with u̇ = a ω² S of
    Airy's wave (1845). Pull and motion go as e^{−iωt}.
    """
    omega, amplitude, at, phase = 1.1, 1e-3, -6.0, 0.7
    volume, length, ea, tau = 0.4, 20.0, 4e5, 0.1
    rise = 10.0
    hung = rope("fall", length, [end(None, (0, 0, at + length)), end("load")], ea, tau)
    force = submerged("load", lattice(volume=volume, added=(0, 0, ADDED)))
    waves = sea((omega, amplitude, 0.6, phase), rise_time=rise, depth=depth)
    k, weight = ea / length, (MASS - RHO * volume) * G
    system = falling(force, {"position": at - weight / k}, sea=waves, ropes=[hung])
    period = 2 * math.pi / omega
    # What the waves begin with dies as exp(-τ k t/2(m + a)), e^-35 after 60 s.
    run = adaptive(system, 60.0 + 3 * period, tension_tolerance=1e-5, position_tolerance=1e-10)
    kappa, height = number(omega, depth), at - weight / k
    decay = math.exp(kappa * height)
    if depth is not None:
        decay = math.sinh(kappa * (height + depth)) / math.sinh(kappa * depth)
    # η = Re a e^{i(phase - ωt)}, and the water above it goes up with u̇ = -ω² η.
    pull = -(RHO * volume + ADDED) * amplitude * omega**2 * decay * cmath.exp(1j * phase)
    moved = pull / (k * (1 - 1j * omega * tau) - (MASS + ADDED) * omega**2)
    late = run.time > 60.0
    expected = (moved * np.exp(-1j * omega * run.time[late])).real
    # The wave is another at the depth of the moment: κ x, 1e-4 of 1e-3 m.
    assert run.body("load")[late, 2] == pytest.approx(height + expected, abs=2e-4 * abs(moved))


def lattices() -> list[Json]:
    """Cells of no symmetry about a body."""
    draw = np.random.default_rng(5)
    return [
        lattice(
            draw.uniform(-1.0, 0.5, 3),
            half=draw.uniform(0.2, 1.2, 2),
            height=0.5,
            layers=layers,
            volume=0.12,
            added=draw.uniform(100, 600, 3),
            quadratic=draw.uniform(40, 300, 3),
        )
        for layers in (1, 3)
    ]


def tumbling(place: float, *forces: Json, **rest: Any) -> Json:
    """A free body that turns about all axes."""
    start = free([0, 0, place], velocity=[0.8, -0.5, 0.3], angular_velocity=[0.5, -0.7, 0.9])
    load = body("load", start, MASS, inertia=(400.0, 700.0, 900.0))
    return document([load], forces=list(forces), **rest)


@pytest.mark.parametrize("stream", [(0.0, 0.0, 0.0), (0.9, -0.4, 0.0)])
def test_deep_down_it_is_kirchhoffs_body(stream: tuple[float, ...]) -> None:
    """A body with cells at one place, wholly wet, moves as one with added mass and drag by matrices, which
    the core has of bodies afloat; in a current as that does if the world goes the other way.
    """
    added, quadratic = (300.0, 800.0, 1500.0), (40.0, 90.0, 200.0)
    run = adaptive(
        tumbling(DEEP, submerged("load", lattice(added=added, quadratic=quadratic), stream=stream)), 8.0
    )
    still = tumbling(
        DEEP,
        added_mass("load", (0, 0, 0), [*added, 0, 0, 0]),
        drag("load", (0, 0, 0), [0] * 6, [*quadratic, 0, 0, 0]),
    )
    joint = still["bodies"][0]["joint"]
    joint["velocity"] = [one - other for one, other in zip(joint["velocity"], stream, strict=True)]
    known = adaptive(still, 8.0)
    carried = np.outer(run.time, stream)
    # Both to the tolerance of their steps.
    assert run.body("load") == pytest.approx(known.body("load") + carried, abs=1e-6)
    assert run.body("load", "body_orientation") == pytest.approx(
        known.body("load", "body_orientation"), abs=1e-6
    )


WAVES = ((0.9, 0.5, 0.3, 0.2), (1.3, 0.3, 1.1, 1.9), (2.1, 0.1, -0.8, 4.0))


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_energy_in_waves_and_current(integrator: str) -> None:
    """A body that tumbles into waves and a current: all that it loses and gains is booked."""
    # Lighter than water, so that it goes in, out and in again.
    force = submerged("load", *lattices(), lattice(height=1.5, volume=1.4), stream=(0.5, 0.2, 0.0))
    system = tumbling(3.5, force, sea=sea(*WAVES, rise_time=5.0, depth=12.0))
    if integrator == "adaptive":
        run = adaptive(system, 12.0)
        # The hats of s' bend between the points of a step at which the books look: 1.8e-7.
        assert run.energy_remainder < 1e-6
    else:
        coarse, fine = (simulate(system, 12.0, step=step, sample_interval=0.1) for step in (2e-3, 5e-4))
        # del books by trapezoids and rates of the start of a step: first order.
        assert fine.energy_remainder < 0.35 * coarse.energy_remainder
        assert fine.energy_remainder < 2e-3
        run = fine
    displaced = run.columns["displaced_volume"][:, 0]
    assert displaced.min() == 0.0 and displaced.max() > 1.0
    for kind in ("fluid_work", "drag"):
        assert np.abs(run.energy(kind)).max() > 100.0


def test_order_of_its_steps_in_waves() -> None:
    """The error of the way of a body that is wholly wet falls with the fifth power of the number of steps."""
    system = tumbling(-9.0, submerged("load", *lattices()), sea=sea(*WAVES, rise_time=5.0))

    def motion(tolerance: float) -> tuple[int, Any]:
        run = adaptive(system, 8.0, position_tolerance=tolerance, sample_interval=1.0)
        return run.counters["steps"], np.hstack([run.body("load"), run.body("load", "body_orientation")])

    exact = motion(1e-11)[1]
    found = [motion(tolerance) for tolerance in 10.0 ** -np.arange(4, 9)]
    errors = [np.log(np.abs(way - exact).max()) for _, way in found]
    order = -np.polyfit(np.log([steps for steps, _ in found]), errors, 1)[0]
    assert order == pytest.approx(5.0, abs=0.8)


def test_through_the_splash_zone() -> None:
    """A column of cells on a rope whose upper end goes down, through a sea that grows: the pull by equations
    of its own, solved by scipy's LSODA, to the tension tolerance; 0.04 N of 9890 apart.
    """
    speed, length, ea, tau, rise = 0.4, 30.0, 6e6, 0.05, 6.0
    heights, thick = np.linspace(-1.75, 1.75, 8), 0.5
    volume, added, c = 0.4 / 8, 900.0 / 8, 500.0 / 8
    column = lattice(
        (0, 0, heights[0]),
        height=thick,
        layers=8,
        volume=8 * volume,
        added=(0, 0, 8 * added),
        quadratic=(0, 0, 8 * c),
    )
    start, begun = 4.0, 2.0
    waves = ((0.9, 0.6, 0.0, 0.4), (1.4, 0.25, 0.0, 2.0))

    def water(z: Any, time: float) -> tuple[Any, ...]:
        g = float(growth(time, rise))
        dg = float(growth(time + 1e-6, rise) - growth(time - 1e-6, rise)) / 2e-6
        eta = rate = np.zeros_like(z)
        along = u = pull = np.zeros_like(z)
        for omega, amplitude, _, phase in waves:
            angle, decay = phase - omega * time, np.exp(omega**2 / G * np.minimum(z, 0.0))
            eta = eta + amplitude * math.cos(angle)
            rate = rate + amplitude * omega * math.sin(angle)
            along = along + amplitude * omega * math.cos(angle) * decay
            u = u + amplitude * omega * math.sin(angle) * decay
            pull = pull - amplitude * omega**2 * math.cos(angle) * decay
        return g * eta, g * rate + dg * eta, g * along, g * u, g * pull + dg * u

    def tension(time: Any, z: Any, v: Any) -> Any:
        goes = np.minimum(time / begun, 1.0)
        way = np.where(time < begun, 0.5 * speed * begun * goes**2, speed * (time - 0.5 * begun))
        stretch = start - way - z
        return np.maximum(0.0, ea / length * (stretch + tau * (-speed * goes - v)))

    def motion(time: float, state: Any) -> list[float]:
        z, v = state
        place = z + heights
        eta, rate, along, u, pull = water(place, time)
        wet, slope = share(eta - place, thick), np.maximum(0.0, 1 - abs(eta - place) / thick) / thick
        w, pace = v - u, rate - v
        force = wet * (RHO * volume * (G + pull) + added * pull - c * np.hypot(along, w) * w)
        force = force - slope * np.maximum(pace, 0.0) * added * w
        pulled = float(tension(time, z, v))
        return [v, (pulled - MASS * G + force.sum()) / (MASS + added * wet.sum())]

    first = [start - MASS * G * length / ea, 0.0]
    known = solve_ivp(
        motion, (0, 25), first, "LSODA", rtol=1e-9, atol=1e-11, dense_output=True, max_step=0.02
    )
    upper = body(
        "hook", {"type": "slider", "axis": [0, 0, 1], "drive": "hoist"}, 1.0, position=(0, 0, start + length)
    )
    hung = rope("fall", length, [end("hook"), end("load")], ea, tau)
    load = body("load", slider(position=first[0]), MASS)
    system = document(
        [upper, load], ropes=[hung], forces=[submerged("load", column)], sea=sea(*waves, rise_time=rise)
    )
    ramp = {"at": 0.0, "duration": begun, "velocity": -speed, "shape": "linear"}
    system["drives"] = [{"name": "hoist", "ramps": [ramp]}]
    run = adaptive(system, 25.0, tension_tolerance=1.0)
    z, v = known.sol(run.time)
    assert run.tension("fall") == pytest.approx(tension(run.time, z, v), abs=1.0)


def test_a_crest_is_felt_though_nothing_moves() -> None:
    """A body at rest 1.55 m above still water, under crests of 1.5 m: no motion makes steps short, and what
    the crest wets is s(1.5 m − z) of it, at the height where it hangs then.
    """
    at, ea, length = 1.6, 6e6, 30.0
    hung = rope("fall", length, [end(None, (0, 0, at + length)), end("load")], ea, 0.05)
    start = {"position": at - MASS * G * length / ea}
    force = submerged("load", lattice(height=0.25, volume=0.4, added=(0, 0, ADDED)))
    system = falling(force, start, ropes=[hung], sea=sea((0.9, 1.5, 0.0, 0.3), rise_time=20.0))
    known, found = (
        adaptive(system, 60.0, tension_tolerance=tension, position_tolerance=position)
        for tension, position in ((0.1, 1e-8), (None, None))
    )
    crest = known.time > 20.0
    height = known.body("load")[:, 2]
    wet = 0.4 * share(1.5 * np.cos(0.3 - 0.9 * known.time) - height, 0.25)
    assert known.columns["displaced_volume"][crest, 0] == pytest.approx(wet[crest], abs=1e-9)
    # The tolerance of tension by default, a thousandth of the weight.
    assert found.tension("fall").min() == pytest.approx(known.tension("fall").min(), abs=1e-3 * MASS * G)
    assert known.tension("fall").min() < 0.95 * MASS * G


@pytest.mark.parametrize("under", [1.0, 2.0, 3.0, 9.0])
def test_weighs_less_by_what_it_displaces(under: float) -> None:
    """At rest in still water the hook holds what weighs, less ρ g of what of the box is below the water
    (Archimedes); layers side by side add up to that between the first and the last.
    """
    statics = gantline.Statics("splash_zone")
    # It begins 6 m above the water, goes after 40 s, 0.2 m/s fast after 2 s lost with the acceleration.
    found = statics.equilibrium(time=42.0 + (6.0 + under) / 0.2)
    recording = found.recording
    weight = (60e3 + 4 * 9 * 9.42 + 8 * 16) * G
    body = list(recording.coordinates["body"]).index("manifold")
    height = float(recording["body_position"].values[-1, body, 2])
    # Shackles and slings on the lugs at 4 m raise the centre of gravity.
    lumped = 4 * 16 + 4 * 4.5 * 9.424
    bottom = height - (60e3 * 1.8 + lumped * 4.0) / (60e3 + lumped)
    wet = min(1.0, -bottom / 4.0) * 7.6
    assert recording["displaced_volume"].values[-1, 0] == pytest.approx(wet, rel=1e-4)
    load = float(recording.column("hook_load", "crane")[-1])
    assert load == pytest.approx(weight - RHO * G * wet, rel=2e-5)
