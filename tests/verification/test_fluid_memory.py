"""Water that remembers the motion of a body, against matrix exponentials and passivity."""

from __future__ import annotations

import itertools
import json
import math
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from floating import SEA, box_hull, buoyancy
from gantline._core import Simulation, Statics
from mechanics import Floats, G, Json, Run, adaptive, body, document, free, simulate, slider
from saved_states import content

#: A box that floats half in water, on a vertical guide: M z¨ + K ∗ ż + ρgA z = 0 to the last digit.
LENGTH, BREADTH, DEPTH = 20.0, 10.0, 8.0
MASS = SEA * LENGTH * BREADTH * DEPTH / 2
STIFFNESS = SEA * G * LENGTH * BREADTH
ADDED = 0.8 * MASS
#: Terms of K(t) = Re Σ R exp(pt): one that decays, one that swings and makes b s/(s² + 2ζωs + ω²).
DECAYS = (complex(-0.6, 0.0), complex(0.9 * STIFFNESS, 0.0))
_B, _W, _Z = 0.8 * STIFFNESS, 0.9, 0.4
_P = _W * complex(-_Z, math.sqrt(1 - _Z**2))
SWINGS = (_P, _B * complex(1.0, -_P.real / _P.imag))


def term(pole: complex, residue: Any, axis: int = 2) -> Json:
    """A term of K along one motion, or with a whole matrix."""
    matrix = np.zeros((6, 6), dtype=complex)
    if np.ndim(residue) == 2:
        matrix[:] = residue
    else:
        matrix[axis, axis] = residue
    return {
        "pole": [pole.real, pole.imag],
        "real": matrix.real.tolist(),
        "imaginary": matrix.imag.tolist(),
    }


def remembered(*terms: Json, at: tuple[float, float, float] = (0, 0, 0)) -> Json:
    return {"type": "memory", "name": "past", "body": "box", "at": list(at), "terms": list(terms)}


def guided(*terms: tuple[complex, complex], height: float = 0.5, speed: float = 0.0) -> Json:
    """The box on its guide, `height` above where it floats."""
    hull = box_hull([LENGTH, BREADTH, DEPTH])
    joint = slider(position=height - DEPTH / 2, velocity=speed)
    added = np.zeros((6, 6))
    added[2, 2] = ADDED
    moving = {"type": "added_mass", "name": "added", "body": "box", "at": [0, 0, 0], "matrix": added.tolist()}
    forces = [buoyancy("box", hull), moving, remembered(*(term(*one) for one in terms))]
    return document([body("box", joint, MASS)], forces=forces)


def exact(time: Floats, terms: list[tuple[complex, complex]], height: float, speed: float = 0.0) -> Floats:
    """z and ż of the guided box, by the exponential of the matrix of (z, ż, z₁, …), shape (time, 2)."""
    size = 2 + len(terms)
    # ż_k = p z_k + ż is complex; with its conjugate the force −Re Σ R z_k is linear in both.
    matrix = np.zeros((2 + 2 * len(terms), 2 + 2 * len(terms)), dtype=complex)
    matrix[0, 1] = 1.0
    inertia = MASS + ADDED
    matrix[1, 0] = -STIFFNESS / inertia
    for index, (pole, residue) in enumerate(terms):
        for place, p, r in ((2 + index, pole, residue), (size + index, np.conj(pole), np.conj(residue))):
            matrix[place, place], matrix[place, 1] = p, 1.0
            matrix[1, place] = -0.5 * r / inertia
    start = np.zeros(len(matrix), dtype=complex)
    start[:2] = height, speed
    return np.array([(expm(matrix * t) @ start)[:2].real for t in time])


@pytest.mark.parametrize("terms", [[DECAYS], [SWINGS], [DECAYS, SWINGS]])
def test_adaptive_follows_the_matrix_exponential(terms: list[tuple[complex, complex]]) -> None:
    """(m + a) z¨ + Re Σ R z_k + ρgA z = 0, ż_k = p z_k + ż: to 1e-7 of the amplitude."""
    run = adaptive(guided(*terms), 30.0, position_tolerance=1e-9, tension_tolerance=1e-3, sample_interval=0.5)
    found = run.joint("box") + DEPTH / 2
    wanted = exact(run.time, terms, 0.5)[:, 0]
    assert np.abs(found - wanted).max() < 1e-7 * 0.5
    assert run.energy_remainder < 1e-9


def test_order_of_adaptive() -> None:
    """Errors fall with the fifth power of the mean step at least, from 1e-5 m to 1e-9 m of tolerance."""
    terms, found = [DECAYS, SWINGS], []
    for tolerance in (1e-5, 1e-7, 1e-9):
        run = adaptive(
            guided(*terms), 30.0, position_tolerance=tolerance, tension_tolerance=1e-3, sample_interval=0.5
        )
        error = np.abs(run.joint("box") + DEPTH / 2 - exact(run.time, terms, 0.5)[:, 0]).max()
        found.append((run.counters["steps"], error))
    for (few, large), (many, small) in itertools.pairwise(found):
        assert math.log(large / small) / math.log(many / few) > 5.0


@pytest.mark.parametrize("terms", [[DECAYS], [DECAYS, SWINGS]])
def test_order_of_del(terms: list[tuple[complex, complex]]) -> None:
    """Errors of `del` fall with the square of the step; its velocities are those of half a step before,
    so it starts where nothing accelerates: afloat, moving.
    """
    errors = []
    for step in (0.1, 0.05, 0.025):
        run = simulate(guided(*terms, height=0.0, speed=0.5), 30.0, step=step, sample_interval=0.5)
        wanted = exact(run.time, terms, 0.0, 0.5)[:, 0]
        errors.append(np.abs(run.joint("box") + DEPTH / 2 - wanted).max())
    for large, small in itertools.pairwise(errors):
        assert 1.7 < math.log2(large / small) < 2.3
    assert errors[-1] < 2e-4 * 0.5


def whole(seed: int = 3) -> list[Json]:
    """Three oscillators that couple all six motions, of the size of the box's own inertia and stiffness."""
    draw = np.random.default_rng(seed)
    size = np.sqrt(np.array([1, 1, 1, 15, 40, 40]) * 0.3 * STIFFNESS)
    terms = []
    for omega, ratio in ((0.5, 0.5), (0.9, 0.3), (1.6, 0.6)):
        root: Floats = draw.normal(size=(6, 6)) * size[:, None] / 3
        pole = omega * complex(-ratio, math.sqrt(1 - ratio**2))
        strength = root @ root.T * complex(1.0, -pole.real / pole.imag)
        terms.append(term(pole, strength))
    return terms


def tumbling() -> Json:
    """The box afloat, free, heeled by 30 deg, turning about all axes and under way."""
    hull = box_hull([LENGTH, BREADTH, DEPTH])
    added = np.diag([0.2, 0.5, 0.8, 5.0, 15.0, 15.0]) * MASS
    start = free(
        [0, 0, 0.6 - DEPTH / 2],
        orientation=[math.cos(math.pi / 12), math.sin(math.pi / 12), 0, 0],
        velocity=[1.0, -0.5, 0.3],
        angular_velocity=[0.2, 0.1, 0.4],
    )
    inertia = [MASS * square for square in (14.0, 40.0, 42.0)]
    box = body("box", start, MASS, centre_of_gravity=(0, 0, 3.0), inertia=inertia)
    moving = {"type": "added_mass", "name": "added", "body": "box", "at": [1, 0, 3], "matrix": added.tolist()}
    forces = [buoyancy("box", hull), moving, remembered(*whole(), at=(1.0, 0.5, 3.0))]
    return document([box], forces=forces)


def place(run: Run) -> Floats:
    return np.hstack([run.body("box"), 10 * run.body("box", "body_orientation")])


def test_a_tumbling_box_and_both_methods() -> None:
    """Six coupled motions at large angles: `adaptive` comes to one course with the fifth power of the step,
    as its tangents are right; `del` comes to the same with its step. The books close to 1e-7.
    """
    runs = [
        adaptive(tumbling(), 12.0, position_tolerance=tolerance, tension_tolerance=1e-3, sample_interval=0.5)
        for tolerance in (1e-4, 1e-6, 1e-8, 1e-10)
    ]
    exactly = place(runs[-1])
    errors = [np.abs(place(run) - exactly).max() for run in runs[:-1]]
    steps = [run.counters["steps"] for run in runs[:-1]]
    for k in range(2):
        assert math.log(errors[k] / errors[k + 1]) / math.log(steps[k + 1] / steps[k]) > 4.5
    assert all(run.energy_remainder < 1e-7 for run in runs)
    by_steps = [
        np.abs(place(simulate(tumbling(), 12.0, step=step, sample_interval=0.5)) - exactly).max()
        for step in (0.01, 0.005)
    ]
    assert by_steps[1] < 0.6 * by_steps[0] < 0.06


def test_at_rest_nothing_is_remembered() -> None:
    """Statics of the box are those without memory: draft and stiffness, to the last bit."""
    found = []
    for terms in ([], [DECAYS, SWINGS]):
        question = Statics(json.dumps(guided(*terms)))
        question.settle()
        found.append(question.columns()["body_position"][-1])
    assert np.array_equal(*found)
    assert found[0][0, 2] == pytest.approx(-DEPTH / 2, abs=1e-9)


def test_modes_of_water_that_remembers() -> None:
    """ω² (m + A(ω)) = ρgA and ζ = B(ω)/2ω(m + A(ω)), A and B of the oscillator b s/(s² + 2ζs + ω²) at s = iω
    by iteration.
    """
    question = Statics(json.dumps(guided(SWINGS)))
    question.settle()
    found = question.modes()
    omega = 1.0
    for _ in range(200):
        answer = _B * 1j * omega / (_W**2 - omega**2 + 2j * _Z * _W * omega)
        inertia = MASS + ADDED + answer.imag / omega
        omega = math.sqrt(STIFFNESS / inertia)
    assert found["square"][0] == pytest.approx(omega**2, rel=1e-8)
    assert found["damping_ratio"][0] == pytest.approx(answer.real / (2 * omega * inertia), rel=1e-8)


@pytest.mark.parametrize("method", [{"type": "adaptive"}, {"type": "del", "step": 0.02}])
def test_a_run_goes_on_from_what_was_saved(method: Json) -> None:
    """Saved half-way and restored, a run ends with the same bytes: the state holds what water remembers."""
    settings = json.dumps({"integrator": method, "duration": 12.0, "sample_interval": 0.1})

    def fresh() -> Simulation:
        return Simulation(json.dumps(tumbling()), settings)

    straight, first, second = fresh(), fresh(), fresh()
    straight.run()
    first.run(until=6.0)
    saved = first.save()
    assert len(content(saved)["state"]["past"]) == 12 * 3
    second.restore(saved)
    second.run()
    if method["type"] == "del":
        assert second.save() == straight.save()
    first.run()
    assert second.save() == first.save()


def test_a_run_without_memory_saves_nothing_of_it() -> None:
    """The state of a lift without it does not know the word."""
    bare = document([body("box", slider(), MASS)], forces=[])
    settings = {"integrator": {"type": "adaptive"}, "duration": 0.1, "sample_interval": 0.1}
    run = Simulation(json.dumps(bare), json.dumps(settings))
    run.run()
    assert "past" not in content(run.save())["state"]


@pytest.mark.parametrize("step", [None, 0.05, 0.2])
def test_it_never_gives_energy_in_the_whole(step: float | None) -> None:
    """The tumbling box for 200 s, by either method: the work that water takes is never below zero, and
    all energy of motion goes, surge, sway and yaw apart, which nothing restores.
    """
    if step is None:
        run = adaptive(tumbling(), 200.0, position_tolerance=1e-5, sample_interval=0.5)
    else:
        run = simulate(tumbling(), 200.0, step=step, sample_interval=0.5)
    held = run.energy("kinetic") + run.energy("gravity") + run.energy("fluid")
    assert run.energy("drag").min() >= 0.0
    assert held.max() <= held[0] * (1 + 1e-9) + (0.0 if step is None else 0.02 * np.ptp(held))
    late = run.time > 150.0
    assert np.ptp(run.body("box")[late, 2]) < 1e-2


def carried(*terms: tuple[complex, complex]) -> Json:
    """The box on a guide that a drive moves upwards, within 2 s at 0.5 m/s."""
    hull = box_hull([LENGTH, BREADTH, DEPTH])
    lifted = body("guide", slider(position=0.0, drive="lift"), 1000.0)
    box = body("box", slider(position=-DEPTH / 2), MASS, parent="guide")
    added = np.zeros((6, 6))
    added[2, 2] = ADDED
    moving = {"type": "added_mass", "name": "added", "body": "box", "at": [0, 0, 0], "matrix": added.tolist()}
    ramp = {"at": 0.0, "duration": 2.0, "velocity": 0.5, "shape": "linear"}
    return document(
        [lifted, box],
        forces=[buoyancy("box", hull), moving, remembered(*(term(*one) for one in terms))],
        drives=[{"name": "lift", "ramps": [ramp]}],
    )


def test_a_body_on_what_a_drive_moves() -> None:
    """What water remembers is the whole motion of the box, the drive's share of it too: the guide has no hold
    on the box, which stays where it floats, to 1e-7 m.
    """
    run = adaptive(carried(DECAYS, SWINGS), 8.0, position_tolerance=1e-9, sample_interval=0.5)
    assert np.abs(run.body("box")[:, 2] + DEPTH / 2).max() < 1e-7
    by_steps = simulate(carried(DECAYS, SWINGS), 8.0, step=0.01, sample_interval=0.5)
    assert np.abs(by_steps.body("box")[:, 2] + DEPTH / 2).max() < 1e-3


def test_statics_of_a_saved_run_are_at_rest() -> None:
    """As if everything stopped there: waves that were made are gone, and the box comes to where it floats."""
    settings = {"integrator": {"type": "adaptive"}, "duration": 3.0, "sample_interval": 1.0}
    run = Simulation(json.dumps(guided(DECAYS, SWINGS)), json.dumps(settings))
    run.run()
    question = Statics(json.dumps(guided(DECAYS, SWINGS)))
    question.settle_saved(run.save(), "none")
    assert question.columns()["body_position"][-1, 0, 2] == pytest.approx(-DEPTH / 2, abs=1e-9)
