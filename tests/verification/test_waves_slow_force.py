"""Added mass in waves: closed forms of its slow force in a sea of two waves, and against still water."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from afloat import BREADTH, DRAFT, KG, LENGTH, MASS
from floating import SEA
from gantline.assembly import assemble
from gantline.results.variable import FloatArray
from gantline.scenario import load_scenario
from mechanics import Run, adaptive

#: Frequencies of the two waves [rad/s], and their difference, with a period of 125.7 s.
OMEGA = np.array([0.7, 0.75])
SLOW = OMEGA[1] - OMEGA[0]
ROUND = 2 * math.pi / SLOW
TOWARDS, HEIGHT = math.radians(60.0), 0.25
NUMBERS = OMEGA[:, None] ** 2 / waves.G * np.array([math.cos(TOWARDS), math.sin(TOWARDS)])
#: About the centre of gravity, without couplings; of the barge, and of the water along.
ADDED, DAMPING = (np.diag(np.diag(matrix)) for matrix in (waves.ADDED, waves.DAMPING))
OWN = MASS * np.diag([1.0, 1.0, 1.0, *waves.RADII**2])
#: Cut-off of the filter behind the barge, and what it keeps of motion at each, exp(−iωt).
CUT_OFF = 0.2 * OMEGA.min()
KEPT = (1 - 5j * OMEGA / CUT_OFF) / (1 - 1j * OMEGA / CUT_OFF) ** 5


def document(folder: Path, given: dict[str, Any], damping: FloatArray = DAMPING) -> dict[str, Any]:
    """A free barge whose waters act at its centre of gravity, in waves."""

    def water(frequencies: Any) -> tuple[Any, Any]:
        alike = np.ones((len(frequencies), 1, 1))
        return alike * ADDED, alike * damping

    at = [f"{LENGTH / 2} m", "0 m", f"{KG} m"]
    by_file = {"database": "barge.nc", "period": "9 s", "at": at}
    forces = {"database": "barge.nc", "at": at}
    vessel = {"added_mass": by_file, "water_damping": by_file, "wave_forces": forces}
    path = waves.in_waves(folder, given, vessel)
    waves.database(folder, water)
    found: dict[str, Any] = assemble(load_scenario(path)).document
    return found


def along_hull(given: dict[str, Any]) -> dict[str, Any]:
    """With added mass along the axes of the hull: on a body that is fixed to it, which no waves push."""
    carrier = {
        "name": "water",
        "parent": "barge",
        "mass": 0.0,
        "centre_of_gravity": [0.0] * 3,
        "inertia": [0.0] * 6,
        "placement": {"position": [0.0] * 3, "orientation": [1.0, 0.0, 0.0, 0.0]},
        "joint": {"type": "fixed"},
    }
    moved = [
        force | {"body": "water"} if force["type"] == "added_mass" else force for force in given["forces"]
    ]
    return given | {"bodies": [*given["bodies"], carrier], "forces": moved}


def slow_velocity(given: dict[str, Any]) -> Any:
    """Velocity and angular velocity at the slow frequency (6,), of the last four of eight rounds."""
    run: Run = adaptive(
        given, 8 * ROUND, tension_tolerance=0.1, position_tolerance=1e-8, sample_interval=ROUND / 256
    )
    assert run.energy_remainder < 1e-8
    late = run.time > run.time[-1] - 4 * ROUND + 1e-9
    time = run.time[late]
    motion = np.hstack([run.body("barge")[late], run.body("barge", "body_angular_velocity")[late]])
    # Beside sums and differences of up to three waves.
    others = {float(n * OMEGA[0] + m * OMEGA[1]) for n in range(-2, 4) for m in range(-2, 4)}
    columns = [np.ones_like(time), time]
    for omega in (SLOW, *sorted(one for one in others if one > 1e-9 and abs(one - SLOW) > 1e-9)):
        columns += [np.cos(omega * time), np.sin(omega * time)]
    found = np.linalg.lstsq(np.stack(columns, axis=1), motion, rcond=None)[0]
    slow = found[2] + 1j * found[3]
    return np.concatenate([-1j * SLOW * slow[:3], slow[3:]])


def pushed(towards: float = TOWARDS) -> Any:
    """Forces of both waves on the barge where it starts (2, 6); phases count from its stern."""
    phase = np.exp(1j * NUMBERS[:, :1] * LENGTH / 2)
    each = [waves.force_per_metre(omega, towards) for omega in OMEGA.tolist()]
    return np.array(each) * phase * HEIGHT / 2


def first_order() -> Any:
    """Place and turn of the centre of gravity in both waves (2, 6), (−ω²(M + A) − iωB + C)⁻¹ F."""
    arms = DRAFT / 2 - KG + np.array([BREADTH, LENGTH]) ** 2 / (12 * DRAFT)
    area = SEA * waves.G * LENGTH * BREADTH
    stiffness = np.diag([0.0, 0.0, area, *(MASS * waves.G * arms), 0.0])
    answers = [-(omega**2) * (OWN + ADDED) - 1j * omega * DAMPING + stiffness for omega in OMEGA.tolist()]
    return np.linalg.solve(np.array(answers), pushed()[..., None])[..., 0]


def beat(one: Any, other: Any) -> Any:
    """Part at exp(−i(ω₂ − ω₁)t) of products of amplitudes in both waves (2, …)."""
    return 0.5 * (one[1] * np.conj(other[0]) + np.conj(one[0]) * other[1])


def crossed(one: Any, other: Any) -> Any:
    """The same of cross products of vectors (2, 3)."""
    return 0.5 * (np.cross(one[1], np.conj(other[0])) + np.cross(np.conj(one[0]), other[1]))


def turned(turn: Any, matrix: FloatArray, motion: Any) -> Any:
    """Slow part of R A Rᵀν − Aν for axes that turn by α: α × Aν − A (α × ν) (6,)."""
    parts = (slice(0, 3), slice(3, 6))
    carried = motion @ matrix
    across = np.concatenate([crossed(turn, motion[:, part]) for part in parts])
    return np.concatenate([crossed(turn, carried[:, part]) for part in parts]) - matrix @ across


def slow_forces() -> tuple[Any, Any, Any, Any]:
    """Slow forces of second order (6,).

    Of the inertia of the hull about its centre of gravity; of added mass along axes of the hull,
    −(α × Aν − A (α × ν))˙ and −v × p; of added mass in waves, by what the filter leaves of their motion; and
    what that does to the place and heading at which they meet the barge and to the axes of damping.
    """
    moves = first_order()
    rate = -1j * OMEGA[:, None] * moves
    momentum = rate @ ADDED
    inertia = OWN.copy()
    inertia[:3, :3] = 0.0
    own = 1j * SLOW * turned(moves[:, 3:], inertia, rate)
    hull = 1j * SLOW * turned(moves[:, 3:], ADDED, rate)
    hull[3:] -= crossed(rate[:, :3], momentum[:, :3])
    place, heading = KEPT[:, None] * moves[:, :2], KEPT * moves[:, 5]
    turn = heading[:, None] * np.array([0.0, 0.0, 1.0])
    force, small = pushed(), 1e-5
    slope = (pushed(TOWARDS + small) - pushed(TOWARDS - small)) / (2 * small)
    left = sum(beat(place[:, k, None], 1j * NUMBERS[:, k, None] * force) for k in range(2))
    left += np.concatenate([crossed(turn, force[:, :3]), crossed(turn, force[:, 3:])])
    left -= beat(heading[:, None], slope) + turned(turn, DAMPING, rate)
    slow = np.zeros_like(rate)
    slow[:, :2], slow[:, 5] = -1j * OMEGA[:, None] * place, -1j * OMEGA * heading
    held = slow @ ADDED
    level = 1j * SLOW * (turned(turn, ADDED, rate) + turned(moves[:, 3:] - turn, ADDED, slow))
    level[3:] -= crossed(rate[:, :3], held[:, :3]) + crossed(slow[:, :3], (momentum - held)[:, :3])
    return own, hull, level, left


def test_added_mass_stirs_no_slow_motion(tmp_path: Path) -> None:
    """A free barge in two waves of 0.25 m, 0.7 and 0.75 rad/s: slow surge, sway and yaw at the difference.

    Added mass along the axes of the hull pushes by rates of its momenta of second order, and by the moment of
    what the waves' velocity carries on,

        −(α × Aν − A (α × ν))˙,    −v × p,

    and would stir it by 1 mm/s. Along the axes of wave forces nothing of that is left: less than 1 % of it
    in surge and sway, since 0.7 % of motion at 0.7 rad/s are in the slow place. Yaw keeps what the inertia of
    the hull itself does, which turns with it. With what the filter leaves closed forms are off by 0.03 % of
    that in surge and sway and by 0.25 % in yaw, splines between directions 30 deg apart; along the hull,
    which drifts and turns by a tenth of a degree, by up to 0.8 %; without what the filter leaves by 2.5 %.
    """
    given = {
        f"wave{k}": {"height": f"{HEIGHT} m", "period": f"{2 * math.pi / omega!r} s", "direction": "60 deg"}
        for k, omega in enumerate(OMEGA.tolist())
    }
    whole = document(tmp_path, given)
    own, hull, level, left = slow_forces()
    answer = np.diag(-1j * SLOW * (OWN + ADDED) + DAMPING)
    plane = [0, 1, 5]
    stirred = np.abs(hull / answer)[plane]
    assert np.all(np.abs((level + left) / answer)[plane[:2]] < 0.01 * stirred[:2])
    found = slow_velocity(whole)
    assert np.all(np.abs(found[:2]) < 0.01 * stirred[:2])
    off = np.abs(found - (own + level + left) / answer)[plane] / stirred
    assert np.all(off < [1e-3, 1e-3, 5e-3])
    before = slow_velocity(along_hull(whole))
    off = np.abs(before - (own + hull + left) / answer)[plane] / np.abs((own + hull) / answer)[plane]
    assert np.all(off < 0.01)


@pytest.mark.parametrize("speed", [0.5, 1.0])
def test_a_vessel_sent_off_turns_as_in_still_water(tmp_path: Path, speed: float) -> None:
    """A barge that goes along itself turns away from its course as exp(σt), by the moment of Munk:

        (I + A₆₆) σ² = (A₂₂ − A₁₁) V² (M + A₁₁)/(M + A₂₂).

    So it does in waves of 9 s without any height, whose slow heading and place lag behind what gathers
    way by 5 (σ/ω_c)² of it, 1.6 and 6.3 % here: that lag counts only by its square times the turn, as of
    what is fast.
    """
    given = {"swell": {"height": "1 mm", "period": "9 s", "direction": "30 deg"}}
    whole = document(tmp_path, given, 0.0 * DAMPING)
    whole["bodies"][0]["joint"]["velocity"] = [speed, 1e-7 * speed, 0.0]
    (force,) = (one for one in whole["forces"] if one["type"] == "wave")
    force["phasors"] = np.zeros_like(force["phasors"]).tolist()
    surge, sway, yaw = (ADDED[k, k] for k in (0, 1, 5))
    munk = (sway - surge) * speed**2 * (MASS + surge) / (MASS + sway)
    sigma = math.sqrt(munk / (OWN[5, 5] + yaw))
    assert 5 * (sigma / (0.2 * 2 * math.pi / 9.0)) ** 2 > 0.015
    run: Run = adaptive(
        whole, 400.0 / speed, tension_tolerance=None, position_tolerance=1e-12, sample_interval=10.0
    )
    spin = run.body("barge", "body_angular_velocity")[:, 2]
    # What goes as exp(−σt) is by then 1e-5 of it.
    grown = math.log(spin[-1] / spin[-11]) / 100.0
    assert grown == pytest.approx(sigma, rel=1e-4)


def test_a_spinning_vessel_gains_no_energy(tmp_path: Path) -> None:
    """A barge that goes and spins in waves without height keeps its energy, as a body in an ideal fluid.

    It turns round in five minutes, and what its added mass makes of its way goes round twice as fast: the
    slow place has that 1.45 times, 27 deg late, (WV5) at 2Ω/ω_c = 0.3. That is a difference of two thirds,
    which counts by its square, as of what is fast: in 25 minutes the energy goes up and down by 3 %. If it
    counted for itself, as where all momentum has level axes, the barge would spin up to 4 deg/s in that time.
    """
    given = {"swell": {"height": "1 mm", "period": "9 s", "direction": "30 deg"}}
    whole = document(tmp_path, given, 0.0 * DAMPING)
    (force,) = (one for one in whole["forces"] if one["type"] == "wave")
    force["phasors"] = np.zeros_like(force["phasors"]).tolist()
    whole["bodies"][0]["joint"] |= {"velocity": [0.5, 0.05, 0.0], "angular_velocity": [0.0, 0.0, 0.02]}
    run: Run = adaptive(whole, 1500.0, tension_tolerance=None, position_tolerance=1e-8, sample_interval=5.0)
    kinetic = run.energy("kinetic")
    assert np.all(np.abs(kinetic / kinetic[0] - 1) < 0.05)
    assert run.energy_remainder < 1e-7
