"""Matrices of small motions about an equilibrium: closed forms, natural motions, differences."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh, expm, null_space

import gantline

G = 9.81


def _hanging(second: str) -> gantline.Scenario:
    """Two weights of 300 kg and 200 kg one below the other on sliders; `second` is the lower rope."""
    plumb = {"type": "slider", "axis": [0, 0, 1]}
    bodies = {
        "upper": {"at": [0, 0, "8 m"], "joint": plumb, "mass": "300 kg"},
        "lower": {"at": [0, 0, "4 m"], "joint": plumb | {"damping": "70 N s/m"}, "mass": "200 kg"},
    }
    ends: dict[str, list[tuple[str, list[Any]]]] = {
        "above": [("world", [0, 0, "10 m"]), ("upper", [0, 0, 0])],
        "below": [("upper", [0, 0, 0]), ("lower", [0, 0, 0])],
    }
    ropes = {
        name: {
            "rope": kind,
            "length": "as_routed",
            "route": [{"type": "end", "body": body, "at": at} for body, at in ends[name]],
        }
        for name, kind in (("above", "soft"), ("below", second))
    }
    return gantline.parse_scenario(
        {
            "format": 1,
            "lift": {"title": "Two weights"},
            "duration": "1 s",
            "ropes": {
                "soft": {"axial_stiffness": "1 MN", "damping_time": "20 ms"},
                "stiff": {"axial_stiffness": "8 MN", "damping_time": "5 ms"},
                "rigid": {"inextensible": True},
            },
            "mechanics": {"bodies": bodies, "ropes": ropes},
        }
    )


def test_two_weights_on_elastic_ropes() -> None:
    """Two weights on ropes k₁ = 0.5 MN/m, k₂ = 2 MN/m: M, D, K and what x and ẋ add to both tensions."""
    statics = gantline.Statics(_hanging("stiff"))
    model = statics.linear_model()
    assert (model.coordinates, model.ropes) == (("upper", "lower"), ("above", "below"))
    assert repr(model) == "<LinearModel: 2 coordinates, 2 ropes>"
    k, tau = np.array([1e6 / 2, 8e6 / 4]), np.array([0.02, 0.005])
    gradient = np.array([[-1.0, 0.0], [1.0, -1.0]])  # upwards a weight shortens the rope above it
    np.testing.assert_allclose(model.mass, np.diag([300.0, 200.0]), rtol=1e-12)
    np.testing.assert_allclose(model.stiffness, gradient.T @ np.diag(k) @ gradient, rtol=1e-12)
    joints = np.diag([0.0, 70.0])
    np.testing.assert_allclose(model.damping, gradient.T @ np.diag(k * tau) @ gradient + joints, rtol=1e-12)
    np.testing.assert_allclose(model.tension, np.diag(k) @ gradient, rtol=1e-12)
    np.testing.assert_allclose(model.tension_rate, np.diag(k * tau) @ gradient, rtol=1e-12)
    assert model.held.shape == (0, 2)
    place = model.bodies.index("lower")
    np.testing.assert_array_equal(model.body_motion[place], np.eye(6)[:, [2]] @ [[0.0, 1.0]])


def test_an_inextensible_rope_holds() -> None:
    """The lower rope inextensible: H = ±[1, −1], its row of P is not a number, ω² = k₁/(m₁ + m₂)."""
    statics = gantline.Statics(_hanging("rigid"))
    model = statics.linear_model()
    np.testing.assert_allclose(model.held, [[1.0, -1.0]], rtol=1e-12)
    assert np.isnan(model.tension[1]).all() and np.isnan(model.tension_rate[1]).all()
    free = null_space(model.held)
    squares = eigh(free.T @ model.stiffness @ free, free.T @ model.mass @ free, eigvals_only=True)
    assert squares == pytest.approx([1e6 / 2 / 500], rel=1e-9)
    assert "1 held" in repr(model)


def test_matrices_have_the_natural_motions() -> None:
    """Reference lift: scipy's eigenvalues of K, M are those of `modes`, xᵀ D x/2ω their damping ratios."""
    statics = gantline.Statics("equalizer")
    statics.equilibrium()
    modes, model = statics.modes(), statics.linear_model()
    assert len(set(model.coordinates)) == len(model.coordinates) == len(modes)
    squares, shapes = eigh(model.stiffness, model.mass)
    largest = abs(squares[-1])
    assert squares == pytest.approx([mode.square for mode in modes], abs=1e-13 * largest, rel=1e-9)
    for mode, square, shape in zip(modes, squares, shapes.T, strict=True):
        if mode.damping_ratio is None:
            continue
        # Neighbours with the same period may be any mixture of each other; ratios are then alike as well.
        ratio = shape @ model.damping @ shape / (2 * math.sqrt(square))
        assert ratio == pytest.approx(mode.damping_ratio, rel=1e-6, abs=1e-12)
        if np.sum(np.abs(squares - square) < 1e-3 * square) == 1:
            moved = model.body_motion @ shape
            sign = np.sign(np.sum(moved * mode.body_motion))
            assert moved * sign == pytest.approx(mode.body_motion, abs=1e-6 * np.abs(moved).max())
            assert mode.of_body("block") == pytest.approx(mode.body_motion[mode.bodies.index("block")])


def test_a_small_motion_goes_by_the_matrices() -> None:
    """Two weights let go 1 mm from rest: the run goes by exp(A t) with A of M, D and K."""
    lift = _hanging("stiff")
    statics = gantline.Statics(lift)
    rest = statics.equilibrium().recording
    model = statics.linear_model()
    at_rest = np.array([rest.column("joint_position", name)[-1] for name in model.coordinates])
    off = np.array([1e-3, -0.5e-3])
    start = {
        f"mechanics.bodies.{name}.joint.position": f"{float(value)!r} m"
        for name, value in zip(model.coordinates, at_rest + off, strict=True)
    }
    # `as_routed` is of the place where the file has a weight: lengths are told.
    lengths = {"mechanics.ropes.above.length": "2 m", "mechanics.ropes.below.length": "4 m"}
    run = gantline.simulate(
        lift.changed(start | lengths | {"start": "as_given"}),
        tension_tolerance=1e-3,
        position_tolerance=1e-8,
        sample_interval=0.01,
    )
    inverse = np.linalg.inv(model.mass)
    n = len(off)
    step = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ model.stiffness, -inverse @ model.damping]])
    x = np.array([run.column("joint_position", name) for name in model.coordinates]).T - at_rest
    wanted = np.array([(expm(step * t) @ np.concatenate([off, np.zeros(n)]))[:n] for t in run.time])
    # Plumb ropes on sliders are linear: what is left is the method's, 1e-8 m in a step.
    assert np.abs(x - wanted).max() < 2e-8


CATENARIES = """
format: 1
lift: {title: A barge on chains}
duration: 10 s
ropes:
  chain: {axial_stiffness: 90 MN, mass: 40 kg/m, damping_time: 50 ms}
vessels:
  barge:
    draft: 3 m
    hull: {box: [60 m, 20 m, 6 m]}
    masses: {all: {mass: 3690 t, at: [30 m, 0 m, 3 m]}}
    radii_of_gyration: [6 m, 17 m, 18 m]
mooring_lines:
  one: {vessel: barge, fairlead: [60 m, 8 m, 6 m], to: [260 m, 90 m, -25 m], length: 222 m, rope: chain,
        sea_bed: -25 m}
  two: {vessel: barge, fairlead: [60 m, -8 m, 6 m], to: [230 m, -120 m, -25 m], length: 209 m, rope: chain,
        sea_bed: -25 m}
  aft: {vessel: barge, fairlead: [0 m, 0 m, 6 m], to: [-180 m, 20 m, -25 m], length: 187 m, rope: chain,
        sea_bed: -25 m}
"""


LINES = ("mooring.one", "mooring.two", "mooring.aft")


def test_mooring_lines_answer_too() -> None:
    """Tensions of catenary lines over a barge's mass and centre of gravity, against differences."""
    statics = gantline.Statics(gantline.parse_scenario(CATENARIES))
    statics.equilibrium()
    model = statics.linear_model()
    found = statics.sensitivities([("mass", "barge"), ("centre_x", "barge")])
    assert found[0].ropes == model.ropes == LINES

    def tensions(mass: float, centre: float) -> list[float]:
        values = {"mass": f"{mass!r} kg", "at.x": f"{centre!r} m"}
        paths = {f"vessels.barge.masses.all.{key}": value for key, value in values.items()}
        rest = gantline.Statics(gantline.parse_scenario(CATENARIES).changed(paths)).equilibrium()
        return [rest.tension(line) for line in LINES]

    for one, step in zip(found, ([500.0, 0.0], [0.0, 2e-3]), strict=True):
        above, below = (
            np.array(tensions(3690e3 + sign * step[0], 30.0 + sign * step[1])) for sign in (1.0, -1.0)
        )
        wanted = (above - below) / (2 * sum(step))
        # Differences have an error of the step squared, and searches end at 1e-9 of what a step changes.
        np.testing.assert_allclose([one.of(line) for line in LINES], wanted, rtol=1e-7)
        # The barge lies level: its turn about the world's axes is that about its own, and P x is dT.
        x = np.linalg.lstsq(model.body_motion[0], one.of_body("barge"), rcond=None)[0]
        np.testing.assert_allclose(model.tension @ x, one.tension, rtol=1e-10)
    assert "3 ropes; most in mooring." in repr(found[0])


def test_water_that_remembers_has_the_matrices_of_a_frequency() -> None:
    """Crane barge: M(ω), D(ω) at the frequency of a motion have that motion and its damping ratio."""
    statics = gantline.Statics("crane_barge_in_swell")
    statics.equilibrium()
    mode = next(
        mode for mode in statics.modes() if mode.damping_ratio is not None and mode.damping_ratio > 0.1
    )
    omega = math.sqrt(mode.square)
    model = statics.linear_model(omega)
    squares, shapes = eigh(model.stiffness, model.mass)
    place = int(np.argmin(np.abs(squares - mode.square)))
    assert squares[place] == pytest.approx(mode.square, rel=1e-8)
    shape = shapes[:, place]
    assert shape @ model.damping @ shape / (2 * omega) == pytest.approx(mode.damping_ratio, rel=1e-6)
    # Without a frequency the water has none of it: ropes alone damp.
    still = statics.linear_model().damping
    assert shape @ still @ shape < 0.01 * (shape @ model.damping @ shape)


def test_a_frequency_is_above_zero() -> None:
    """What is no frequency is refused by name."""
    statics = gantline.Statics(_hanging("stiff"))
    for wrong in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match=r"frequency: .* is no frequency above zero"):
            statics.linear_model(wrong)
