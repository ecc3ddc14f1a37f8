"""Wave forces follow the slow heading and place of their vessel, and not its motion in single waves."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from afloat import DRAFT, LENGTH, MASS
from floating import SEA
from gantline.assembly import assemble
from gantline.hydro.database import read_database
from gantline.results.rotation import heading
from gantline.results.variable import FloatArray
from gantline.scenario import load_scenario
from gantline.simulation import Simulation
from mechanics import Run, adaptive

OMEGA = 0.7
PERIOD = 2 * math.pi / OMEGA
NUMBER = OMEGA**2 / waves.G
#: What the slow place keeps of motion at ω, exp(−iωt): (1 + 5p)/(1 + p)⁵ with p = −iω/0.2 ω.
KEPT = (1 - 25j) / (1 - 5j) ** 5


def moving(
    path: Path,
    duration: float,
    velocity: tuple[float, float] = (0.0, 0.0),
    turning: float = 0.0,
    **damping: Any,
) -> Run:
    """The barge of a lift file, whose middle starts with a velocity, as it turns; with other damping."""
    document: dict[str, Any] = assemble(load_scenario(path)).document
    joint = document["bodies"][0]["joint"]
    # Of the origin at the stern.
    joint["velocity"] = [velocity[0], velocity[1] - turning * LENGTH / 2, 0.0]
    joint["angular_velocity"] = [0.0, 0.0, turning]
    for force in document["forces"]:
        if force["type"] == "drag":
            force |= damping
    return adaptive(
        document, duration, tension_tolerance=0.1, position_tolerance=1e-8, sample_interval=PERIOD / 16
    )


def straight(run: Run, since: float) -> tuple[FloatArray, FloatArray]:
    """Where the barge would have been at t = 0, and its velocity, of the straight way that it goes."""
    late = run.time >= since
    time, place = run.time[late], run.body("barge")[late, :2]
    phase = OMEGA * time
    terms = np.stack([np.ones_like(time), time, np.cos(phase), np.sin(phase)], axis=1)
    found = np.linalg.lstsq(terms, place, rcond=None)[0]
    return found[0], found[1]


def slow_heading(run: Run) -> float:
    """Mean heading of the last ten periods [rad]."""
    late = run.time > run.time[-1] - 10 * PERIOD + 1e-9
    return float(np.unwrap(heading(run.body("barge", "body_orientation")[late])).mean())


@pytest.mark.parametrize("turn", [50.0, -160.0, 400.0])
def test_a_vessel_that_has_turned_answers_like_one_that_lies_there(tmp_path: Path, turn: float) -> None:
    """Six complex amplitudes of a barge that was sent turning, and has come to rest at some heading ψ at some
    place x: (−ω²(M + A) − iωB + C)⁻¹ X(β − ψ) e^{ik·x}, X linear between the directions of the file, mirrored
    on its other side; one turn more or less is none.

    It comes to rest by exp(−t/τ), τ = (I + A)/B of yaw, 87 s in this water, in 240 periods to 2e-11. Waves of
    2 mm as in the steady motion of a vessel that stays, with the same tolerance.
    """
    damping = waves.DAMPING.copy()
    damping[5, 5] /= 8.0

    def water(frequencies: Any) -> tuple[Any, Any]:
        added, _ = waves.constant(frequencies)
        return added, np.ones((len(frequencies), 1, 1)) * damping

    wave = {"height": "2 mm", "period": f"{PERIOD!r} s", "direction": "30 deg"}
    path = waves.in_waves(tmp_path, {"swell": wave})
    yaw = MASS * waves.RADII[2] ** 2 + waves.ADDED[5, 5]
    waves.database(tmp_path, water)
    run = moving(path, 250 * PERIOD, turning=math.radians(turn) * damping[5, 5] / yaw)
    lies, (place, velocity) = slow_heading(run), straight(run, 240 * PERIOD)
    unwrapped = np.unwrap(heading(run.body("barge", "body_orientation")))
    # It has turned about as far as it was sent; what is expected is at the heading `lies` that it has.
    assert math.degrees(unwrapped[-1]) == pytest.approx(turn, rel=0.05)
    towards = math.radians(30.0)
    ahead = np.array([math.cos(towards), math.sin(towards)])
    # What the waves do in the second order moves it by a micrometre in a second.
    met = OMEGA - NUMBER * float(velocity @ ahead)
    per_metre, _ = read_database(tmp_path / "barge.nc").excitation_at(np.array([OMEGA]), towards - lies, SEA)
    force = per_metre[0] * 1e-3 * np.exp(1j * NUMBER * (place @ ahead))
    expected = waves.response(met, force, damping=damping)
    orientation = run.body("barge", "body_orientation")
    found = waves.amplitudes(run.time, run.body("barge"), orientation, met, lies)
    scale = np.repeat([np.abs(expected[:3]).max(), np.abs(expected[3:]).max()], 3)
    assert np.abs(found - expected) / scale == pytest.approx(np.zeros(6), abs=1e-5)


def test_a_vessel_that_turns_past_180_deg_answers_as_past_any_heading(tmp_path: Path) -> None:
    """A barge that turns on by 40 deg in waves, past a heading of 180 deg, and the same with the whole lift
    turned by -70 deg about the origin, at its stern: what does not turn with it is the same all the way.

    Its slow heading goes on past 180 deg, where the angle of its axis comes back as -180 deg. That is told by
    the way, not by where it comes to rest: half a minute later no filter knows of it any more.
    """
    rate = math.radians(40.0) * waves.DAMPING[5, 5] / (MASS * waves.RADII[2] ** 2 + waves.ADDED[5, 5])
    runs = []
    for turned in (0.0, -70.0):
        folder = tmp_path / f"by{turned:g}"
        folder.mkdir()
        wave = {"height": "0.5 m", "period": f"{PERIOD!r} s", "direction": f"{60.0 + turned} deg"}
        path = waves.in_waves(folder, {"swell": wave}, {"heading": f"{160.0 + turned} deg"})
        # The stern starts at rest.
        runs.append(moving(path, 5 * PERIOD, (0.0, rate * LENGTH / 2), turning=rate))
    one, other = runs
    ways = [np.unwrap(heading(run.body("barge", "body_orientation"))) for run in runs]
    assert math.degrees(ways[0][0]) < 180.0 - 10.0
    assert math.degrees(ways[0].max()) > 180.0 + 10.0
    heights = [run.body("barge")[:, 2] for run in runs]
    assert np.abs(ways[0] - ways[1] - math.radians(70.0)).max() < 1e-6
    assert np.abs(heights[0] - heights[1]).max() < 1e-6 * np.ptp(heights[0])
    spins = [np.linalg.norm(run.body("barge", "body_angular_velocity"), axis=1) for run in (one, other)]
    assert np.abs(spins[0] - spins[1]).max() < 1e-6 * spins[0].max()


@pytest.mark.parametrize(("speed", "towards"), [(1.0, 0.0), (1.0, 180.0), (0.5, 60.0)])
def test_a_vessel_that_drifts_meets_waves_at_another_frequency(
    tmp_path: Path, speed: float, towards: float
) -> None:
    """A barge in a current U, in water without added mass, moves with the frequency of encounter ω − k·U:
    (−ω_e² M − iω_e B + C)⁻¹ X(ω) e^{ik·x₀}, x₀ where its way began; slow places lag behind no steady drift,
    so the phase is that of the waves. 1 m/s is 7 % of the speed of the waves.
    """

    def water(frequencies: Any) -> tuple[Any, Any]:
        added, damping = waves.constant(frequencies)
        return 0.0 * added, damping

    wave = {"height": "2 mm", "period": f"{PERIOD!r} s", "direction": f"{towards} deg"}
    path = waves.in_waves(tmp_path, {"swell": wave})
    waves.database(tmp_path, water)
    run = moving(path, 60 * PERIOD, (speed, 0.0), stream=[speed, 0.0, 0.0])
    place, velocity = straight(run, 50 * PERIOD)
    assert velocity == pytest.approx([speed, 0.0], abs=1e-5)
    by = math.radians(towards)
    ahead = np.array([math.cos(by), math.sin(by)])
    met = OMEGA - NUMBER * float(velocity @ ahead)
    force = waves.force_per_metre(OMEGA, by) * 1e-3 * np.exp(1j * NUMBER * (place @ ahead))
    expected = waves.response(met, force, 0.0 * waves.ADDED)
    orientation = run.body("barge", "body_orientation")
    found = waves.amplitudes(run.time, run.body("barge"), orientation, met, 0.0)
    scale = np.repeat([np.abs(expected[:3]).max(), np.abs(expected[3:]).max()], 3)
    assert np.abs(found - expected) / scale == pytest.approx(np.zeros(6), abs=1e-5)


def test_no_mean_force_by_the_motion_in_waves(tmp_path: Path) -> None:
    """A barge that surges alone, free, in waves of 2 m: what of its motion is left in its slow place pushes
    it by

        F = ½ k |ξ|² Re(i h̄ Z),    Z = −ω²(M + A) − iωB,    h what the filter keeps,

    so that it drifts with F/B. With the place of every moment h = 1 and F = ½ k |ξ|² ωB, the power that its
    waves carry off over their speed: a part of the drift force alone, without what is reflected. h keeps
    less than a fifth of that here, 0.1 mm/s. Left out are terms of the fourth order, (k ξ)² = 1e-4 of it;
    what it began with has gone in 80 periods, by exp(−t B/(M + A)) of 41 s.
    """

    def water(frequencies: Any) -> tuple[Any, Any]:
        return tuple(matrix * np.eye(6) for matrix in waves.constant(frequencies))

    wave = {"height": "2 m", "period": f"{PERIOD!r} s", "direction": "0 deg"}
    path = waves.in_waves(tmp_path, {"swell": wave})
    waves.database(tmp_path, water)
    document: dict[str, Any] = assemble(load_scenario(path)).document
    (force,) = (one for one in document["forces"] if one["type"] == "wave")
    surge = np.zeros_like(force["phasors"])
    surge[..., 0, :] = np.array(force["phasors"])[..., 0, :]
    force["phasors"] = surge.tolist()
    run = adaptive(
        document, 100 * PERIOD, tension_tolerance=0.1, position_tolerance=1e-8, sample_interval=PERIOD / 16
    )
    _, velocity = straight(run, 80 * PERIOD)
    damping, mass = waves.DAMPING[0, 0], MASS + waves.ADDED[0, 0]
    answer = -(OMEGA**2) * mass - 1j * OMEGA * damping
    surging = abs(waves.force_per_metre(OMEGA, 0.0)[0] / answer)
    left = 0.5 * NUMBER * surging**2 * float((1j * np.conj(KEPT) * answer).real)
    momentary = 0.5 * NUMBER * surging**2 * OMEGA * damping
    assert 0.0 < left < 0.2 * momentary
    assert velocity[0] * damping == pytest.approx(left, rel=1e-3)


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_a_saved_run_goes_on_with_the_same_bytes(tmp_path: Path, integrator: str) -> None:
    """A free barge in a sea, put aside after 40 s, where its slow place is on its way, and taken up by
    another run: every column to the last bit. The books of both methods close.
    """
    sea = {"significant_height": "1 m", "peak_period": "8 s", "direction": "70 deg"}
    path = waves.in_waves(tmp_path, {"sea": sea}, duration="60 s")
    given: dict[str, Any] = {"integrator": integrator}
    if integrator == "del":
        given["step"] = 0.02
    first, second = Simulation(path, **given), Simulation(path, **given)
    first.run(until=40.0)
    second.restore(first.save())
    one, other = first.run(), second.run()
    for name, variable in one.variables.items():
        assert np.array_equal(
            variable.values, other.variables[name].values, equal_nan=variable.values.dtype.kind == "f"
        )
    kinds = dict(zip(one.coordinates["energy_kind"], one.variables["energy"].values.T, strict=True))
    # del books buoyancy by trapezoids: 7.2e-5 here, 1.8e-5 with half the step.
    most = 1e-7 if integrator == "adaptive" else 1e-4
    assert abs(kinds["remainder"]).max() < most * abs(kinds["fluid_work"]).max()


#: Against drift, of a water that remembers and damps no steady way [N s/m].
STEADY = 1e6


@pytest.mark.parametrize("remembers", [False, True])
def test_no_mean_force_by_a_hull_that_turns(tmp_path: Path, remembers: bool) -> None:
    """A free barge that rolls, pitches and yaws in oblique waves: damping by a matrix and water that
    remembers push along the axes of wave forces, so that no

        F̄ = ½ Re(ᾱ × F),    F = iω B ξ + ω² (A − A(∞)) ξ,

    is left, as it would be along the axes of the hull, which turn by α. It would drift with F̄/B. Left are
    what its slow place keeps, as in the test before, and terms of the fourth order: 0.1 % of F̄.
    """
    about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
    wave = {"height": "1 m", "period": f"{PERIOD!r} s", "direction": "60 deg"}
    own = {"at": about, "surge": f"{STEADY} N s/m", "sway": f"{STEADY} N s/m", "yaw": "1e9 N m s"}
    if remembers:
        path = waves.radiating(tmp_path, {"swell": wave}, vessel={"water_damping": own})
        added, damping = (matrix[0] for matrix in waves.radiated(np.array([OMEGA])))
        steady = np.diag([STEADY, STEADY, 0.0, 0.0, 0.0, 1e9])
        resists = np.array([STEADY, STEADY])
    else:
        path = waves.in_waves(tmp_path, {"swell": wave})
        added, damping, steady = waves.ADDED, waves.DAMPING, np.zeros((6, 6))
        resists = np.diag(waves.DAMPING)[:2]
    run = moving(path, 120 * PERIOD)
    _, velocity = straight(run, 100 * PERIOD)
    force = waves.force_per_metre(OMEGA, math.pi / 3) * 0.5
    moves = waves.response(OMEGA, force, added, damping + steady)
    pushes = 1j * OMEGA * (damping + steady) @ moves + OMEGA**2 * (added - waves.ADDED) @ moves
    along_hull = 0.5 * np.cross(np.conj(moves[3:]), pushes[:3]).real[:2]
    assert np.linalg.norm(along_hull) > 1e3
    assert np.linalg.norm(velocity * resists) < 0.005 * np.linalg.norm(along_hull)
