"""A crane barge with a slack tank and a module in its tackle, in oblique waves and water that remembers.

Small motions x about rest: shift and turn of the barge about the middle of its waterline, shift of the
module. With the masses m at r of barge, frozen liquid and, in C, of the module at the boom head,

    M ẍ + ∫ K(s) ẋ(t − s) ds + D ẋ + C x = Re F e^(−iωt) g(t)
    M:  Σ m J(r)ᵀ J(r) + own inertias + A(∞), J(r) = [1, −[r]×], and the module's own mass
    C:  ρ g A_w of heave; of roll and pitch ρ g I_w − ρ g V T/2 − Σ m g z − ρ_t g i
    rope: of the module against the head, B = [−J(head), 1], m g/ℓ aside and EA/ℓ₀ along, its damper τ EA/ℓ₀
    F:  a X(ω, β − ψ) e^(ik·s)

K is the kernel of the three oscillators that the file is made of, whose states are integrated along: so
neither the fit of the program nor its steps have a part in it. The system is carried on by the exponential of
its matrix, forces by three points of Gauss, over the growth of the waves too.

The program is not linear. What is of second order in the height of the waves, 1e-3 of the surge of a barge
that nothing holds in waves of 0.2 mm, is taken out by the heights H and 2H: 2 x(H)/H − x(2H)/2H.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
from scipy.linalg import expm

import gantline
from gantline.hydro import HydrodynamicDatabase, write_database
from rigid import across

G, SEA = 9.81, 1025.0
LENGTH, BREADTH, DEPTH, DRAFT = 80.0, 24.0, 7.0, 3.2
#: Middle of the waterline, centre of the liquid, head of the boom, from stern and keel [m].
MIDDLE = np.array([LENGTH / 2, 0.0, DRAFT])
TANK, BOTTOM, CONTENT, LIQUID = np.array([16.0, 10.0, 4.0]), np.array([30.0, 3.0, 0.5]), 320e3, 1000.0
FILL = CONTENT / LIQUID / 160.0
HEAD, MODULE, EA, FALL, TAU = np.array([86.0, -6.0, 28.0]), 90e3, 60e6, 18.0, 0.02
DISPLACED = SEA * LENGTH * BREADTH * DRAFT
OWN = DISPLACED - MODULE - CONTENT
LYING = BOTTOM + np.array([0.0, 0.0, FILL / 2])
#: So that all of it is plumb over the middle.
CENTRE = (DISPLACED * MIDDLE - MODULE * HEAD - CONTENT * LYING) / OWN
CENTRE[2] = 4.1
RADII = np.array([8.0, 22.0, 23.0])
HEADING, TOWARDS, PERIOD = math.radians(40.0), math.radians(135.0), 8.0
OMEGA = 2 * math.pi / PERIOD
STERN = np.array([10.0, -5.0, -DRAFT])
#: Added mass of fast motion, and what the oscillators damp at most; ω_j, ζ_j and shares of these.
SIZES = DISPLACED * np.array([1.0, 1.0, 1.0, 60.0, 450.0, 450.0])
ADDED = np.diag(SIZES * [0.05, 0.3, 0.8, 0.25, 0.7, 0.3])
ADDED[0, 4] = ADDED[4, 0] = -0.2 * DISPLACED
ADDED[1, 3] = ADDED[3, 1] = 0.4 * DISPLACED
MOST = 0.35 * np.diag(SIZES * [0.04, 0.25, 0.7, 0.1, 0.6, 0.25])
MOST[0, 4] = MOST[4, 0] = -0.2 * math.sqrt(MOST[0, 0] * MOST[4, 4])
MOST[1, 3] = MOST[3, 1] = 0.3 * math.sqrt(MOST[1, 1] * MOST[3, 3])
OSCILLATORS = ((0.55, 0.4, 1.0), (0.9, 0.3, 0.7), (1.6, 0.5, 0.4))
VISCOUS = SIZES * [0.01, 0.03, 0.05, 0.04, 0.05, 0.1]
MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
DURATION, SAMPLE = 60.0, 0.1


def force_per_metre(omega: float, towards: float) -> Any:
    """Some forces that fall off with the depth of the barge, out of phase with each other (6,)."""
    k, area = omega**2 / G, SEA * G * LENGTH * BREADTH
    cos, sin = math.cos(towards), math.sin(towards)
    of = [-0.8j * k * cos * DRAFT, -0.9j * k * sin * DRAFT, 0.9, 0.06j * k * sin * BREADTH**2]
    of += [-0.07j * k * cos * LENGTH**2, 0.05 * k * 2 * sin * cos * LENGTH * BREADTH / 10]
    return area * np.exp(-k * DRAFT + 0.2j * omega) * np.array(of)


def write_water(folder: Path) -> None:
    """The file of that water, with the frequency of the waves among its own."""
    frequencies = np.sort(np.append(np.linspace(0.15, 3.2, 70), OMEGA))
    directions = np.radians([0.0, 45.0, 90.0, 135.0, 180.0])
    s = 1j * frequencies
    answer = sum(share * 2 * z * w * s / (w * w + 2 * z * w * s + s * s) for w, z, share in OSCILLATORS)
    assert isinstance(answer, np.ndarray)
    database = HydrodynamicDatabase(
        name="barge",
        source="own",
        frequencies=frequencies,
        added_mass=ADDED + (answer.imag / frequencies)[:, None, None] * MOST,
        damping=answer.real[:, None, None] * MOST,
        density=SEA,
        infinite_added_mass=ADDED,
        reference=np.zeros(3),
        water_depth=np.inf,
        directions=directions,
        excitation=np.array([[force_per_metre(w, b) for b in directions] for w in frequencies]),
    )
    write_database(database, folder / "barge.nc")


def lift(height: float) -> dict[str, Any]:
    """The lift file in waves of that height."""

    def place(at: Any) -> list[str]:
        return [f"{float(part)!r} m" for part in at]

    turned = np.array(
        [[math.cos(HEADING), -math.sin(HEADING), 0], [math.sin(HEADING), math.cos(HEADING), 0], [0, 0, 1]]
    )
    span = FALL * (1 + MODULE * G / EA)
    water = {"database": "barge.nc", "at": place(MIDDLE)}
    units = dict(zip(MOTIONS, ["N s/m"] * 3 + ["N m s"] * 3, strict=True))
    viscous = {
        name: f"{value!r} {units[name]}" for name, value in zip(MOTIONS, VISCOUS.tolist(), strict=True)
    }
    barge = {
        "position": place(STERN[:2]),
        "heading": f"{HEADING!r} rad",
        "draft": f"{DRAFT} m",
        "hull": {"box": place([LENGTH, BREADTH, DEPTH])},
        "masses": {"own": {"mass": f"{OWN!r} kg", "at": place(CENTRE)}},
        "radii_of_gyration": place(RADII),
        "tanks": {
            "slack": {
                "box": place(TANK),
                "bottom": place(BOTTOM),
                "content": f"{CONTENT} kg",
                "density": "1 t/m^3",
            }
        },
        "radiation": water,
        "wave_forces": water,
        "water_damping": {"at": place(MIDDLE), **viscous},
    }
    at = STERN + turned @ HEAD - [0.0, 0.0, span]
    ends = [{"type": "end", "body": "barge", "at": place(HEAD)}, {"type": "end", "body": "module"}]
    wave = {"height": f"{height!r} m", "period": f"{PERIOD!r} s", "direction": f"{TOWARDS + HEADING!r} rad"}
    return {
        "format": 1,
        "lift": {"title": "A module in its tackle"},
        "duration": f"{DURATION} s",
        "start": "rest",
        "water": {"density": f"{SEA} kg/m^3", "level": "0 m"},
        "waves": {"swell": wave},
        "ropes": {"fall": {"axial_stiffness": f"{EA} N", "damping_time": f"{TAU} s", "mass": "none"}},
        "vessels": {"barge": barge},
        "mechanics": {
            "bodies": {"module": {"at": place(at), "joint": {"type": "point"}, "mass": f"{MODULE} kg"}},
            "ropes": {"fall": {"rope": "fall", "length": f"{FALL} m", "stretched": True, "route": ends}},
        },
        "simulation": {
            "sample_interval": f"{SAMPLE} s",
            "tension_tolerance": "0.001 N",
            "position_tolerance": "1e-9 m",
        },
    }


def motion_of(point: Any) -> Any:
    """Shift of a point of the barge by shift and turn of the middle (3, 6)."""
    return np.hstack([np.eye(3), -across(point - MIDDLE)])


def linear() -> tuple[Any, Any, Any, Any]:
    """M with A(∞), D, C (9, 9), and what x adds to the length of the tackle (9,)."""
    mass = np.diag([0.0] * 6 + [MODULE] * 3)
    for own, at in ((OWN, CENTRE), (CONTENT, LYING)):
        mass[:6, :6] += own * motion_of(at).T @ motion_of(at)
    mass[:6, :6] += ADDED
    box = np.array([TANK[0], TANK[1], FILL]) ** 2
    mass[3:6, 3:6] += OWN * np.diag(RADII**2) + CONTENT / 12 * np.diag(box.sum() - box)
    weights = (
        sum(m * at[2] for m, at in ((OWN, CENTRE), (CONTENT, LYING), (MODULE, HEAD))) - DISPLACED * DRAFT
    )
    surface = LIQUID * TANK[0] * TANK[1] / 12 * TANK[[1, 0]] ** 2
    plane = SEA * LENGTH * BREADTH / 12 * np.array([BREADTH, LENGTH]) ** 2
    stiffness = np.zeros((9, 9))
    stiffness[2, 2] = SEA * G * LENGTH * BREADTH
    stiffness[[3, 4], [3, 4]] = G * (plane - SEA * LENGTH * BREADTH * DRAFT**2 / 2 - weights - surface)
    apart = np.hstack([-motion_of(HEAD), np.eye(3)])
    aside, along = MODULE * G / (FALL * (1 + MODULE * G / EA)), EA / FALL
    stiffness += apart.T @ np.diag([aside, aside, along]) @ apart
    damping = np.diag(np.append(VISCOUS, np.zeros(3))) + TAU * along * np.outer(apart[2], apart[2])
    return mass, damping, stiffness, -apart[2]


def own_motion() -> Any:
    """x and what is added to the tension, per metre of wave height (samples, 10)."""
    mass, damping, stiffness, longer = linear()
    inverse = np.linalg.inv(mass)
    count = 12 * len(OSCILLATORS)
    matrix = np.zeros((18 + count, 18 + count))
    matrix[:9, 9:18] = np.eye(9)
    matrix[9:18, :9], matrix[9:18, 9:18] = -inverse @ stiffness, -inverse @ damping
    for place, (w, z, share) in enumerate(OSCILLATORS):
        # Of C s/(s² + 2ζωs + ω²): r̈ + 2ζωṙ + ω²r = ẋ, force −C ṙ.
        at = 18 + 12 * place
        matrix[at : at + 6, at + 6 : at + 12] = np.eye(6)
        matrix[at + 6 : at + 12, at : at + 6] = -w * w * np.eye(6)
        matrix[at + 6 : at + 12, at + 6 : at + 12] = -2 * z * w * np.eye(6)
        matrix[at + 6 : at + 12, 9:15] = np.eye(6)
        matrix[9:18, at + 6 : at + 12] -= inverse[:, :6] @ (share * 2 * z * w * MOST)
    number, towards = OMEGA**2 / G, TOWARDS + HEADING
    middle = STERN[:2] + MIDDLE[0] * np.array([math.cos(HEADING), math.sin(HEADING)])
    phase = number * (middle @ [math.cos(towards), math.sin(towards)])
    force = np.zeros(9, dtype=complex)
    force[:6] = 0.5 * force_per_metre(OMEGA, TOWARDS) * np.exp(1j * phase)

    def pushed(time: float) -> Any:
        share = min(time / (3 * PERIOD), 1.0)
        growth = share**3 * (10 - share * (15 - 6 * share))
        return growth * (inverse @ (force * np.exp(-1j * OMEGA * time)).real)

    step = SAMPLE / 5
    points = 0.5 + np.array([-0.5, 0.0, 0.5]) * math.sqrt(0.6)
    on = expm(matrix * step)
    by = [
        weight * step * expm(matrix * step * (1 - point))[:, 9:18]
        for point, weight in zip(points, (5 / 18, 8 / 18, 5 / 18), strict=True)
    ]
    state = np.zeros(len(matrix))
    found = []
    for k in range(round(DURATION / step) + 1):
        if k % 5 == 0:
            stretch = longer @ state[:9] + TAU * (longer @ state[9:18])
            found.append([*state[:9], EA / FALL * stretch])
        state = on @ state + sum(b @ pushed((k + point) * step) for b, point in zip(by, points, strict=True))
    return np.array(found)


def moved(folder: Path, height: float) -> Any:
    """The same of a run, in the axes of the heading (samples, 10)."""
    run = gantline.simulate(gantline.parse_scenario(lift(height), str(folder / "scenario.yaml")))
    shift, module = (run.column("body_position", name) for name in ("barge", "module"))
    turn = run.column("body_orientation", "barge")
    upright = np.array([math.cos(HEADING / 2), 0.0, 0.0, -math.sin(HEADING / 2)])
    scalar = upright[0] * turn[:, 0] - turn[:, 1:] @ upright[1:]
    vector = upright[0] * turn[:, 1:] + turn[:, :1] * upright[1:] + np.cross(upright[1:], turn[:, 1:])
    angle = 2 * vector * np.sign(scalar)[:, None]
    cos, sin = math.cos(HEADING), math.sin(HEADING)
    level = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    lies = (OWN * CENTRE + CONTENT * LYING) / (OWN + CONTENT)
    barge = (shift - shift[0]) @ level - np.cross(angle, lies - MIDDLE)
    tension = run.column("rope_tension", "fall")
    found = np.column_stack([barge, angle, (module - module[0]) @ level, tension - tension[0]])
    return found / height


def test_a_module_in_its_tackle_on_a_barge_in_waves(tmp_path: Path) -> None:
    """Six motions of the barge, three of the module and the tension of its tackle, from rest over the growth
    of the waves to a minute, in shares of the largest of each: 1e-4. The fit of the water, to 1e-4 of its
    damping, and tolerances of 1 nm of 0.05 mm leave 2e-5.
    """
    write_water(tmp_path)
    low, high = moved(tmp_path, 2e-4), moved(tmp_path, 4e-4)
    wanted = own_motion()
    apart = np.abs(2 * low - high - wanted).max(axis=0) / np.abs(wanted).max(axis=0)
    assert apart.max() < 1e-4
