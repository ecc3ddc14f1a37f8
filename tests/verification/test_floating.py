"""Bodies afloat against closed forms: where they rest, how they swing, and what becomes of their energy."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from floating import SEA, added_mass, box_hull, buoyancy, drag, pitch_and_roll, sphere_hull
from gantline._core import Simulation, Statics
from mechanics import G, Json, adaptive, body, document, elliptic_k, free, period, simulate

LENGTH, BREADTH, DEPTH, DRAFT = 100.0, 30.0, 8.0, 4.0
KG = 5.0
MASS = SEA * LENGTH * BREADTH * DRAFT
ROLL, PITCH = MASS * 11.0**2, MASS * 27.0**2


def barge(draft: float = DRAFT, kg: float = KG, **start: Any) -> Json:
    return body(
        "barge",
        free([0, 0, -draft], **start),
        MASS,
        centre_of_gravity=(0, 0, kg),
        inertia=(ROLL, PITCH, PITCH),
    )


def afloat(bodies: list[Json], *forces: Json) -> Json:
    return document(bodies, forces=[buoyancy("barge", box_hull((LENGTH, BREADTH, DEPTH))), *forces])


def test_barge_with_a_load_ahead_of_its_bow() -> None:
    """12 300 t with 1000 t at 65 m ahead of the middle and 60 m up: T = ∇/LB = 4.325 m, GM_L = T/2 + L²/12T
    − KG = 185.70 m, and with it 1.508°. Exactly: B stands below G, t (GM + BM t²/2) = x_G with t = tan θ;
    no deck is wet.
    """
    load = body("load", {"type": "fixed"}, 1e6, parent="barge", position=(65, 0, 60))
    question = Statics(json.dumps(afloat([barge(), load])))
    found = question.settle()
    assert found["unstable"] == 0
    assert found["neutral"] == 3, "nothing holds surge, sway and yaw"
    total = MASS + 1e6
    draft = total / (SEA * LENGTH * BREADTH)
    kg, lever = (MASS * KG + 1e6 * 60) / total, 1e6 * 65 / total
    bm = LENGTH**2 / (12 * draft)
    gm = draft / 2 + bm - kg
    assert (draft, gm) == pytest.approx((4.325, 185.70), abs=0.005)
    assert math.degrees(lever / gm) == pytest.approx(1.508, abs=0.0005)
    (tangent,) = (root.real for root in np.roots([bm / 2, 0, gm, -lever]) if abs(root.imag) < 1e-9)
    columns, names = question.columns(), question.names()
    place = names["body"].index("barge")
    bow, side = pitch_and_roll(columns["body_orientation"][0, place])
    # The equilibrium is found to 1e-9 of the forces, and GM is a twentieth of a hull's size: 1e-9 of the
    # angle.
    assert math.tan(-bow) == pytest.approx(tangent, rel=2e-9)
    assert side == pytest.approx(0, abs=1e-12)
    # The middle of the keel is T cos θ below the water: its column of water is T along the hull.
    assert columns["body_position"][0, place, 2] == pytest.approx((KG - draft) * math.cos(bow), rel=1e-9)


def test_natural_motions_of_a_barge() -> None:
    """Heave ω² = ρgA/(m + a₃₃), roll and pitch about G ω² = m g GM/(I + a), with GM = T/2 + I_w/∇ − KG."""
    heavy = added_mass("barge", (0, 0, KG), [1e6, 4e6, 1.5e7, 6e8, 9e9, 4e9])
    resists = drag("barge", (0, 0, KG), [0, 0, 4e6, 1e8, 2e9, 0], [9, 9, 9, 9, 9, 9])
    question = Statics(json.dumps(afloat([barge()], heavy, resists)))
    question.settle()
    modes = question.modes()
    squares, ratios = np.sort(modes["square"]), modes["damping_ratio"][np.argsort(modes["square"])]
    gm = [DRAFT / 2 + side**2 / (12 * DRAFT) - KG for side in (BREADTH, LENGTH)]
    wanted = {
        "heave": (SEA * G * LENGTH * BREADTH / (MASS + 1.5e7), 4e6 / (MASS + 1.5e7)),
        "roll": (MASS * G * gm[0] / (ROLL + 6e8), 1e8 / (ROLL + 6e8)),
        "pitch": (MASS * G * gm[1] / (PITCH + 9e9), 2e9 / (PITCH + 9e9)),
    }
    order = sorted(wanted.values())
    assert np.abs(squares[:3]).max() < 1e-6
    # 1e-9: modes come from a dense eigenvalue problem of condition about 1e4.
    assert squares[3:] == pytest.approx([square for square, _ in order], rel=1e-9)
    assert ratios[3:] == pytest.approx([rate / 2 / math.sqrt(square) for square, rate in order], rel=1e-9)


def test_top_heavy_barge_lolls_or_capsizes() -> None:
    """With GM < 0 a box lolls to tan² φ = −2 GM/BM (wall-sided formula) as long as its deck is dry; upright
    is unstable.
    """
    bm = BREADTH**2 / (12 * DRAFT)
    kg = DRAFT / 2 + bm * (1 + 0.5 * math.tan(math.radians(7)) ** 2)
    upright = Statics(json.dumps(afloat([barge(kg=kg)])))
    upright.settle()
    assert upright.modes()["square"].min() < -1e-3
    leaning = [math.cos(0.01), math.sin(0.01), 0, 0]
    question = Statics(json.dumps(afloat([barge(kg=kg, orientation=leaning)])))
    found = question.settle()
    assert found["unstable"] == 0
    _, side = pitch_and_roll(question.columns()["body_orientation"][0, 0])
    assert math.degrees(side) == pytest.approx(7.0, rel=1e-6)


RADIUS = 5.0
FRESH = 1000.0
HALF = FRESH * 2 / 3 * math.pi * RADIUS**3


def bobbing(amplitude: float, added: float) -> tuple[Json, float]:
    """A sphere half as heavy as water, `amplitude` [m] above its rest; ω of small motion [1/s]."""
    ball = body(
        "sphere", free([0, 0, amplitude]), HALF, centre_of_gravity=(0, 0, -2), inertia=[HALF * 10] * 3
    )
    hull = buoyancy("sphere", sphere_hull(RADIUS, 60), density=FRESH)
    water = added_mass("sphere", (0, 0, 0), [0.5 * HALF, 0.5 * HALF, added, 0, 0, 0])
    omega = math.sqrt(FRESH * G * math.pi * RADIUS**2 / (HALF + added))
    return document([ball], forces=[hull, water]), omega


@pytest.mark.parametrize("amplitude", [0.05, 1.0, 3.0, 5.0])
def test_floating_sphere_bobs(amplitude: float) -> None:
    """z̈ = −ω² (z − z³/3R²), ω² = ρgπR²/(m + a): T = 4K(k)/(ω √(1 − s)), s = A²/6R², k² = s/(1 − s). From 5
    m, where it just leaves the water, it takes 16 % longer than a small motion does.
    """
    system, omega = bobbing(amplitude, 0.5 * HALF)
    run = adaptive(system, 40.0, sample_interval=0.02)
    s = amplitude**2 / (6 * RADIUS**2)
    wanted = 4 * elliptic_k(math.sqrt(s / (1 - s))) / (omega * math.sqrt(1 - s))
    height = run.body("sphere")[:, 2] + 2
    # The mesh has 14 280 panels and the volume of the sphere: its section is 0.02 % off.
    assert period(run.time, height) == pytest.approx(wanted, rel=1e-3)
    # The first term of the series of K, to show that it is one.
    assert wanted * omega / (2 * math.pi) == pytest.approx(1 + 0.75 * s, abs=1.5 * s * s)
    assert height.min() == pytest.approx(-amplitude, rel=1e-3)
    assert run.energy_remainder < 1e-6


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_energy_of_a_barge_thrown_about_balances(method: str) -> None:
    """Kinetic energy with that of the water, gravity, displaced water and drag: what the books say is what
    is there. The barge heels until its deck is under, trims and yaws at once.
    """
    start: dict[str, Any] = {"velocity": [2.0, 1.0, 0.0], "angular_velocity": [0.35, 0.05, 0.05]}
    heavy = added_mass("barge", (1, 0.5, 2), [1e6, 4e6, 1.5e7, 6e8, 3e9, 4e9])
    resists = drag("barge", (0, 0, 2), [0, 1e4, 1e5, 1e7, 1e8, 1e8], [2e4, 2e5, 1e6, 1e9, 0, 1e9])
    system = afloat([barge(draft=3.0, **start)], heavy, resists)
    runs = {
        "adaptive": lambda: adaptive(system, 60.0, sample_interval=0.1, tension_tolerance=None),
        "del": lambda: simulate(system, 60.0, step=0.01, sample_interval=0.1),
    }
    run = runs[method]()
    _, side = pitch_and_roll(run.body("barge", "body_orientation"))
    freeboard = math.atan2(DEPTH - DRAFT, BREADTH / 2)
    assert np.abs(side).max() > freeboard, "the deck must go under"
    stored = run.energy("kinetic") + run.energy("gravity") + run.energy("fluid")
    lost = stored[0] - stored
    assert lost[-1] == pytest.approx(run.energy("drag")[-1] + run.energy("method")[-1], rel=1e-3)
    assert run.energy("drag")[-1] > 0.2 * run.energy("kinetic")[0]
    # adaptive integrates along its course; del takes energies by the trapezoidal rule over its steps.
    assert run.energy_remainder < {"adaptive": 1e-5, "del": 1e-3}[method]


def test_a_wave_of_the_hand_moves_nothing_sideways() -> None:
    """Water at rest gives no force along the surface: a heaving, rolling barge without drag keeps its
    horizontal momentum, that of the water along with it, and its centre of gravity on a line.
    """
    start: dict[str, Any] = {
        "angular_velocity": [0.1, 0.01, 0],
        "velocity": [-0.01 * KG, 0.1 * KG, 0],
    }  # about G
    run = adaptive(afloat([barge(draft=3.0, **start)]), 30.0, sample_interval=0.1)
    assert np.ptp(run.body("barge")[:, :2], axis=0).max() < 1e-6
    assert np.ptp(run.body("barge")[:, 2]) > 1


def test_kirchhoff_turns_a_slender_body_broadside() -> None:
    """Added mass in the body's axes moves as Kirchhoff's equations say: a body without weight in deep water
    keeps momentum and energy, and one that glides along its axis yaws by the Munk moment (a₂₂ − a₁₁) u v.
    With a disturbance ψ̈ (I + a₆₆) = u² (m + a₁₁)(a₂₂ − a₁₁)/(m + a₂₂) ψ it grows like cosh: momentum along
    the path is kept.
    """
    mass, along, across, turn = 1000.0, 100.0, 900.0, 500.0
    hull = body(
        "fish", free([0, 0, 0], velocity=[2, 0, 0], angular_velocity=[0, 0, 1e-4]), mass, inertia=[turn] * 3
    )
    system = document([hull], forces=[added_mass("fish", (0, 0, 0), [along, across, across, 0, 0, 50.0])])
    system["gravity"] = [0, 0, 0]
    run = adaptive(system, 4.0, sample_interval=0.05)
    w, _, _, z = run.body("fish", "body_orientation").T
    yaw = 2 * np.arctan2(z, w)
    rate = 2 * math.sqrt((mass + along) * (across - along) / ((mass + across) * (turn + 50.0)))
    growing = run.time < 2.0
    assert yaw[growing] == pytest.approx(1e-4 / rate * np.sinh(rate * run.time[growing]), rel=1e-4, abs=1e-9)
    assert np.ptp(run.energy("kinetic")) < 1e-6 * run.energy("kinetic")[0]


@pytest.mark.parametrize(
    ("force", "problem"),
    [
        ({**buoyancy("ship", box_hull((1, 1, 1)))}, "there is no body `ship`"),
        ({**buoyancy("barge", box_hull((1, 1, 1))), "density": -1.0}, "density"),
        (
            {
                **buoyancy(
                    "barge", (box_hull((1, 1, 1))[0], [[c, b, a] for a, b, c in box_hull((1, 1, 1))[1]])
                )
            },
            "counter-clockwise",
        ),
        ({**buoyancy("barge", (box_hull((1, 1, 1))[0], [[0, 1, 9]]))}, "has no point 9, only 8"),
        ({**added_mass("barge", (0, 0, 0), [1, 1, -1, 1, 1, 1])}, "negative eigenvalues"),
        ({**drag("barge", (0, 0, 0), [0] * 6, [0, 0, -1, 0, 0, 0])}, "zero or more"),
    ],
)
def test_wrong_water_is_refused(force: Json, problem: str) -> None:
    """One clear sentence for each mistake."""
    with pytest.raises(ValueError, match=problem):
        Statics(json.dumps(document([barge()], forces=[force])))


def test_explicit_knows_no_water() -> None:
    """It says so, and what to use."""
    settings = {"integrator": {"type": "explicit", "step": 1e-3}, "duration": 1.0, "sample_interval": 0.1}
    with pytest.raises(ValueError, match="knows no water"):
        Simulation(json.dumps(afloat([barge()])), json.dumps(settings))


def test_a_barge_too_heavy_for_its_hull_sinks() -> None:
    """24 600 t of water are all that 24 000 m³ displace: with 25 000 t there is no equilibrium, and that is
    said.
    """
    heavy = {**barge(), "mass": 25e6}
    with pytest.raises(RuntimeError) as raised:
        Statics(json.dumps(afloat([heavy]))).settle()
    assert raised.value.args == ("barge", "it sinks: no hull bears that weight")
