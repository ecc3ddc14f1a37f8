"""Loads in hinges and grippers, docs/concepts/hinge.md: masts raised about their feet, pendulums aboard.

A load of the weight W whose centre of gravity is a from its hinge, on a line that stands θ over level, is
held by the tension T of a sling with the lever p about the axis: T p = W a cos θ. The hinge bears the rest.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from scipy.integrate import solve_ivp

from afloat import BREADTH, DRAFT, KG, LENGTH, MASS, barge, lift_of, written
from carried_barge import carried, table
from floating import SEA
from gantline.results.loads.hinges import axial_force, hinge_force, hinge_moment, radial_force
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from hinged_mast import ACROSS, FOOT, HEAD, MAST, PINS, RAISE, WEIGHT, mast
from mechanics import G

Floats = npt.NDArray[np.float64]


def places(recording: Recording, sample: int) -> tuple[Floats, Floats]:
    """Centre of gravity and lug from the foot pins [m]."""
    turned = axes(recording.column("body_orientation", "mast"))[sample]
    centre = turned @ np.array([FOOT, 0.0, 0.0])
    assert recording.column("body_position", "mast")[sample] == pytest.approx(
        centre + np.array(PINS), abs=1e-9
    )
    return centre, turned @ np.array([HEAD, 0.0, 0.0])


def test_hook_load_of_a_mast_that_is_raised() -> None:
    """T = W a cos θ/p at every angle, the foot bears W and T together; at rest at nine moments."""
    question = Statics(parse_scenario(mast(RAISE)))
    tilts = []
    for time in np.linspace(0.0, 470.0, 9):
        rest = question.equilibrium(float(time))
        recording = rest.recording
        centre, lug = places(recording, -1)
        hook = recording.column("body_position", "main")[-1] - PINS
        along = (hook - lug) / np.linalg.norm(hook - lug)
        lever = lug[2] * along[0] - lug[0] * along[2]  # of a pull along the sling, about y
        tension = -WEIGHT * centre[0] / lever
        assert rest.tension("sling.A") == pytest.approx(tension, rel=1e-9)
        across, axial, upright = recording.column("hinge_push", "foot")[-1]
        assert (across, upright) == pytest.approx(
            (tension * along[0], tension * along[2] - WEIGHT), abs=1e-6 * WEIGHT
        )
        assert abs(axial) < 1e-6 * WEIGHT and recording.column("hinge_moment", "foot")[-1] < 1e-5 * WEIGHT
        carried = recording.column("load_transferred", "mast")[-1]
        assert carried == pytest.approx(tension * along[2] / WEIGHT, abs=1e-9)
        tilts.append(math.degrees(recording.column("load_tilt", "mast")[-1]))
    assert tilts[0] < 1.0 and tilts[-1] > 80.0


def test_a_pull_along_the_axis() -> None:
    """A hook 6 m beside the mast: the hinge bears its pull along the axis, and the moment of that askew."""
    recording = Statics(parse_scenario(mast(RAISE, hook=(10.0, 6.0, 60.0)))).equilibrium(0.0).recording
    centre, lug = places(recording, -1)
    hook = recording.column("body_position", "main")[-1] - PINS
    along = (hook - lug) / np.linalg.norm(hook - lug)
    tension = -WEIGHT * centre[0] / (lug[2] * along[0] - lug[0] * along[2])
    push = tension * along - [0.0, 0.0, WEIGHT]
    moment = np.cross(lug, tension * along)
    (hinge,) = recording.rig.hinges
    assert recording.column("hinge_push", "foot")[-1] == pytest.approx(push, abs=1e-6 * WEIGHT)
    assert axial_force(recording, hinge)[-1] == pytest.approx(tension * along[1], rel=1e-7)
    assert radial_force(recording, hinge)[-1] == pytest.approx(math.hypot(push[0], push[2]), rel=1e-7)
    assert hinge_moment(recording, hinge)[-1] == pytest.approx(math.hypot(moment[0], moment[2]), rel=1e-6)
    assert tension * along[1] > 0.05 * WEIGHT


@pytest.mark.parametrize(("method", "exact"), [("adaptive", 1e-6), ("del", 2e-3)])
def test_a_mast_that_falls_about_its_foot(method: str, exact: float) -> None:
    """θ̈ = -(W a/I) cos θ from level, I of the foot; the foot bears m a θ̇² + W sin along and the rest across.

    Its sling is cut as the run begins. ½ I θ̇² is what it has fallen by, and the books close.
    """
    text = mast(
        "  - {step: fall, hold: until_end, cut: sling.A}\n",
        more=f"simulation: {{sample_interval: 0.02 s, integrator: {method}"
        + (", step: 0.2 ms}" if method == "del" else ", position_tolerance: 0.0001 mm}"),
    ).replace("duration: 900 s", "duration: 3 s")
    recording = simulate(parse_scenario(text))
    inertia = ACROSS + MAST * FOOT**2
    own = solve_ivp(
        lambda _, y: [y[1], -WEIGHT * FOOT * math.cos(y[0]) / inertia],
        (0.0, 3.0),
        [recording.column("joint_position", "foot")[0] * -1.0, 0.0],
        rtol=1e-10,
        atol=1e-12,
        t_eval=recording.time,
    )
    angle, rate = own.y
    # The hinge turns by the right hand about y, which is down.
    assert recording.column("joint_position", "foot") == pytest.approx(-angle, abs=exact)
    along, across = np.stack([np.cos(angle), np.sin(angle)]), np.stack([-np.sin(angle), np.cos(angle)])
    spin = -WEIGHT * FOOT * np.cos(angle) / inertia
    acceleration = FOOT * (spin * across - rate**2 * along)
    push = -MAST * (acceleration + np.array([[0.0], [G]]))
    found = recording.column("hinge_push", "foot")[1:]  # the sling is there at the first sample
    assert found[:, 0] == pytest.approx(push[0][1:], abs=exact * WEIGHT)
    assert found[:, 2] == pytest.approx(push[1][1:], abs=exact * WEIGHT)
    assert np.abs(found[:, 1]).max() < 1e-9 * WEIGHT
    fallen = -WEIGHT * FOOT * (np.sin(angle) - np.sin(angle[0]))
    assert 0.5 * inertia * rate**2 == pytest.approx(fallen, rel=1e-6, abs=1.0)
    # The books are closed at ends of steps, of which the end of the run is one.
    assert recording.column("energy", "kinetic")[-1] == pytest.approx(fallen[-1], rel=exact)
    remainder = np.abs(recording.column("energy", "remainder")).max()
    assert remainder < 1e-7 * fallen.max()


@pytest.mark.parametrize("way", ["hoist", "lower"])
def test_friction_of_the_pins(way: str) -> None:
    """T p = W a cos θ ± M of a mast on its way up or down, M the friction of its foot pins.

    It springs a little on its sling.
    """
    moment = 500e3
    plan = f"  - {{step: go, {way}: main, speed: 1 m/min, by: 5 m}}\n"
    hinge = f", friction: {moment / 1e3} kN m"
    text = mast(plan, hinge=hinge, more="simulation: {sample_interval: 1 s}")
    recording = simulate(parse_scenario(text.replace("duration: 900 s", "duration: 240 s")))
    for sample in (60, 100, 200):
        centre, lug = places(recording, sample)
        hook = recording.column("body_position", "main")[sample] - PINS
        along = (hook - lug) / np.linalg.norm(hook - lug)
        lever = lug[0] * along[2] - lug[2] * along[0]
        side = 1.0 if way == "hoist" else -1.0
        expected = (WEIGHT * centre[0] + side * moment) / lever
        assert recording.column("rope_tension", "sling.A")[sample] == pytest.approx(expected, rel=5e-4)


def test_an_open_hinge_is_no_hinge() -> None:
    """A load that a step lets go as the run begins swings, turns and rolls as one that was never held.

    Its hook hangs aside, so that all six ways come into it; positions to ten times the tolerance of steps.
    """
    plan = "  - {step: swing, hold: until_end, open_hinges: foot}\n"
    text = mast(plan, hook=(15.0, 8.0, 60.0), more="simulation: {sample_interval: 0.1 s}")
    text = text.replace("duration: 900 s", "duration: 12 s").replace("start: rest", "start: as_given")
    free = text.replace(", open_hinges: foot", "")
    free = "\n".join(line for line in free.split("\n") if not line.startswith("hinges:"))
    held, alone = (
        simulate(parse_scenario(one), position_tolerance=1e-7, tension_tolerance=1.0) for one in (text, free)
    )
    for column in ("body_position", "body_angular_velocity"):
        assert held.column(column, "mast") == pytest.approx(alone.column(column, "mast"), abs=2e-5)
    assert held.column("load_tilt", "mast").max() > math.radians(60.0)
    assert held.column("hinge_push", "foot")[1:].any() == np.False_
    assert [name for _, _, name in held.events("hinge_opened")] == ["foot"]
    assert not held.events("pin_pulled")


#: Mass of a load in a hinge aboard [kg], its inertias [kg m^2], and height of the hinge over the keel [m].
BOB, BOB_INERTIA, PIVOT = 400e3, (4e6, 5e6, 2e6), 20.0
#: From the hinge down to the centre of gravity [m].
DOWN = 7.0


def hung(at: float) -> dict[str, Any]:
    """A load that hangs aboard in a hinge about the long axis of the barge, `at` from her stern [m]."""
    axes_of = zip(("xx", "yy", "zz"), BOB_INERTIA, strict=True)
    gripper = {"at": ["0 m", "0 m", f"{5.0 + DOWN} m"], "axis": [1, 0, 0], "held_by": "barge"}
    return {
        "load": {
            "name": "bob",
            "shape": {"box": ["4 m", "4 m", "10 m"]},
            "position": [f"{at} m", "0 m", f"{PIVOT - DRAFT - DOWN - 5.0} m"],
            "weight": {"calculated": f"{BOB} kg"},
            "inertia": {key: f"{one} kg m^2" for key, one in axes_of},
            "centre_of_gravity": {"at": ["0 m", "0 m", "5 m"]},
        },
        "hinges": {"gripper": gripper},
        "simulation": {"sample_interval": "5 ms", "position_tolerance": "0.001 mm"},
    }


def pendulum(folder: Path, *, at: float = LENGTH / 2, vessel: dict[str, object] | None = None) -> Path:
    """A barge with a load that hangs in a hinge about her long axis, both at the draft of the barge alone."""
    hull = {"mass": f"{MASS - BOB} kg", "at": [f"{LENGTH / 2} m", "0 m", f"{KG} m"]}
    floating = barge(masses={"hull": hull}, **(vessel or {}))
    return written(folder, lift_of(floating, duration="12 s", start="as_given", **hung(at)))


def test_a_pendulum_on_a_barge(tmp_path: Path) -> None:
    """Roll, sway and swing about the equilibrium: det(K - ω²M) = 0 in sway of the barge, roll and swing.

    With h from the barge's centre of gravity up to the hinge and l down from there, the load sways by
    y - h φ + l θ. Water rights by ρ g L B³/12 + W (KB - KG), W all weights; the load on its hinge by -m g h,
    and itself by m g l.
    """
    text = pendulum(tmp_path).read_text(encoding="utf-8").replace('"as_given"', '"rest"')
    (tmp_path / "rest.yaml").write_text(text, encoding="utf-8")
    question = Statics(tmp_path / "rest.yaml")
    question.equilibrium()
    up, hull = PIVOT - KG, MASS - BOB
    ways = np.array([1.0, -up, DOWN])
    roll = hull * 11.0**2
    mass = BOB * np.outer(ways, ways) + np.diag([hull, roll, BOB_INERTIA[0]])
    righting = SEA * G * LENGTH * BREADTH**3 / 12.0 + MASS * G * (DRAFT / 2.0 - KG)
    stiffness = np.diag([0.0, righting - BOB * G * up, BOB * G * DOWN])
    wanted = np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real)
    found = [mode.square for mode in question.modes()]
    for square in wanted[1:]:
        assert min(abs(one - square) for one in found) < 1e-6 * square
    assert abs(wanted[0]) < 1e-12


def test_forces_aboard_a_barge_that_rolls_and_pitches(tmp_path: Path) -> None:
    """F = m (r̈ + g), M = d(Iω)/dt - (p - r) × F of the load alone, p the hinge: by differences of its motion.

    The barge begins heeled and trimmed, 30 m ahead of her middle, so that the hinge bears along its axis too
    and keeps the load from turning askew. Central differences over 5 ms leave 1e-5 of what swings in seconds.
    """
    run = simulate(pendulum(tmp_path, at=LENGTH / 2 + 30.0, vessel={"heel": "6 deg", "trim": "2 deg"}))
    (hinge,) = run.rig.hinges
    velocity, spin = run.column("body_velocity", "bob"), run.column("body_angular_velocity", "bob")
    turned = axes(run.column("body_orientation", "bob"))
    pull = BOB * (np.gradient(velocity, run.time, axis=0) + np.array([0.0, 0.0, G]))
    momentum = np.einsum("nij,j,nkj,nk->ni", turned, BOB_INERTIA, turned, spin)
    lever = turned @ np.array([0.0, 0.0, DOWN])
    moment = np.gradient(momentum, run.time, axis=0) - np.cross(lever, pull)
    # The hinge lies along the barge: across to starboard, along forward, upright with her mast.
    vessel = axes(run.column("body_orientation", "barge"))
    start = axes(run.column("body_orientation", "bob")[0])
    frame = vessel @ vessel[0].T @ start @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    inner = slice(2, -2)
    push = -np.einsum("nji,nj->ni", frame, pull)[inner]
    found = run.column("hinge_push", "gripper")[inner]
    largest = np.abs(push).max()
    assert np.abs(found - push).max() < 1e-4 * largest
    assert np.abs(push[:, 1]).max() > 0.02 * largest
    along = np.einsum("ni,ni->n", moment, frame[:, :, 1])
    askew = np.linalg.norm(moment - along[:, np.newaxis] * frame[:, :, 1], axis=1)[inner]
    assert np.abs(hinge_moment(run, hinge)[inner] - askew).max() < 1e-3 * askew.max()
    assert np.abs(along[inner]).max() < 1e-3 * askew.max()  # it turns freely there
    assert askew.max() > 1e5
    energy = np.abs(run.column("energy", "remainder")).max()
    assert energy < 1e-7 * np.abs(run.column("energy", "gravity")).max()
    assert hinge_force(run, hinge).max() > 0.95 * BOB * G


def test_forces_aboard_a_barge_that_waves_carry(tmp_path: Path) -> None:
    """F = m (r̈ + g) on a barge that moves by her RAOs, whatever hangs from her; by differences as above."""
    table(tmp_path)
    swell = {"swell": {"height": "1 m", "period": "8 s", "direction": "60 deg"}}
    run = simulate(carried(tmp_path, swell, duration="60 s", **hung(LENGTH / 2 + 30.0)))
    acceleration = np.gradient(run.column("body_velocity", "bob"), run.time, axis=0)
    pull = BOB * (acceleration + np.array([0.0, 0.0, G]))
    vessel = axes(run.column("body_orientation", "barge"))
    start = axes(run.column("body_orientation", "bob")[0])
    frame = vessel @ vessel[0].T @ start @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    push = -np.einsum("nji,nj->ni", frame, pull)[2:-2]
    found = run.column("hinge_push", "gripper")[2:-2]
    assert np.abs(found - push).max() < 1e-4 * np.abs(push).max()
    assert np.abs(push[:, 0]).max() > 0.1 * BOB * G and np.abs(push[:, 1]).max() > 0.02 * BOB * G
