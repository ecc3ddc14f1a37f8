"""Natural motions about an equilibrium: closed forms."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest

from gantline import _core
from gantline.plot.pictures import PICTURES
from gantline.results.series import sling_direction
from gantline.statics import Statics
from mechanics import body, document, end, free, hinge, point, rope, slider
from resting import CORNERS, G, at_rest, one_equalizer

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
from benchmarks.lifts import equalizer_lift, gantline_document  # noqa: E402

SCENARIOS = ROOT / "scenarios"
LOAD = "block"  # as the lift file calls it


@pytest.mark.parametrize("axial_stiffness", [None, 1e13])
def test_double_pendulum(axial_stiffness: float | None) -> None:
    """Double pendulum 30 t / 300 t on 30 m / 20 m: 14.026 s and 2.119 s."""
    # Hook block 30 t on 30 m, load 300 t on 20 m: det(K − ω²M) = 0 with M = [[m₁+m₂, m₂], [m₂, m₂]] in
    # lengths times angles, K = diag((m₁+m₂) g/l₁, m₂ g/l₂) likewise: 14.026 s and 2.119 s, twice each.
    upper, lower, top, bottom = 30e3, 300e3, 30.0, 20.0
    mass = np.array([[upper + lower, lower], [lower, lower]])
    stiffness = np.diag([(upper + lower) * G / top, lower * G / bottom])
    wanted = 2 * math.pi / np.sqrt(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real)
    assert sorted(wanted) == pytest.approx([2.119, 14.026], abs=5e-4)
    rest = at_rest(
        document(
            [body("hook", point((0, 0, -top)), upper), body("load", point((0, 0, -top - bottom)), lower)],
            ropes=[
                rope("upper", top, [end(None), end("hook")], axial_stiffness),
                rope("lower", bottom, [end("hook"), end("load")], axial_stiffness),
            ],
        )
    )
    # An elastic rope of 1e13 N stretches by 3e-7 of its length.
    exact = 1e-9 if axial_stiffness is None else 1e-6
    assert rest.periods[:4] == pytest.approx([max(wanted)] * 2 + [min(wanted)] * 2, rel=exact)


def test_load_on_an_elastic_sling() -> None:
    """Load on an elastic sling: ω² = EA/(m L), ζ = τω/2."""
    mass, length, stiffness, damping_time = 2e4, 12.0, 5e6, 0.01
    rest = at_rest(
        document(
            [body("load", slider(), mass)],
            ropes=[rope("r", length, [end(None, (0, 0, length)), end("load")], stiffness, damping_time)],
        )
    )
    modes = rest.core.modes()
    omega = math.sqrt(stiffness / (mass * length))
    assert modes["square"] == pytest.approx([omega**2], rel=1e-12)
    assert modes["damping_ratio"] == pytest.approx([0.5 * damping_time * omega], rel=1e-12)
    # xᵀ M x = 1
    assert abs(modes["shape"][0, 0]) == pytest.approx(1 / math.sqrt(mass), rel=1e-12)


@pytest.mark.parametrize("cords", [2, 4])
def test_torsion_of_plumb_cords(cords: int) -> None:
    """Bifilar and quadrifilar torsion: ω² = m g r²/(I L)."""
    # ω² = m g r²/(I L), r the distance of the cords from the axis; bifilar and quadrifilar.
    places = [(1.5, 0.0), (-1.5, 0.0)] if cords == 2 else [(1.2 * x, 0.9 * y) for x, y in CORNERS]
    mass, inertia, length = 500.0, 300.0, 6.0
    ropes = [
        rope(f"c{i}", length, [end(None, (x, y, length)), end("load", (x, y, 0))], None)
        for i, (x, y) in enumerate(places)
    ]
    joint = {"type": "free", **{**free((0, 0, 0))}}
    load = body("load", joint, mass, centre_of_gravity=(0, 0, -0.4), inertia=(100, 100, inertia))
    if cords == 4:
        # Four rigid cords repeat one another: elastic ones of 1e10 N, which stretch by 1.2e-7.
        for one in ropes:
            one["material"] = {"type": "elastic", "axial_stiffness": 1e10, "damping_time": 0.0}
    rest = at_rest(document([load], ropes=ropes))
    wanted = mass * G * 1.5**2 / (inertia * length)
    assert np.min(np.abs(rest.squares / wanted - 1)) < (1e-8 if cords == 2 else 1e-6)


def test_three_legged_bridle() -> None:
    """Three legs to one hook: load and legs swing as one body, T = 2π √((I + m H²)/(m g H)), both ways."""
    # Legs that do not stretch hold the load to the hook like a rigid frame; its plumb turn nothing holds.
    lugs = np.array([(3.0, 0.0, 0.0), (-2.0, 2.5, 0.0), (-2.0, -2.5, 0.0)])
    mass, below, height, inertia = 50e3, 1.0, 9.0, (2e5, 3e5, 4e5)
    hook = (0.0, 0.0, height)
    centre = (0.0, 0.0, -below)
    load = body("load", free((0, 0, 0)), mass, centre_of_gravity=centre, inertia=inertia)
    legs = [
        rope(f"s{i}", float(np.linalg.norm(hook - lug)), [end(None, hook), end("load", lug)], None)
        for i, lug in enumerate(lugs)
    ]
    rest = at_rest(document([load], ropes=legs))
    assert (rest.found["neutral"], rest.found["unstable"]) == (1, 0)
    # By symmetry about x the two legs behind share alike: moments about y, T₁ z₁ 3 = 2 T₂ z₂ 2, and W in all.
    upright = rest.tensions * height / np.linalg.norm(hook - lugs, axis=1)
    assert upright == pytest.approx(mass * G * np.array([0.4, 0.3, 0.3]), rel=1e-9)
    arm = height + below
    wanted = [2 * math.pi * math.sqrt((one + mass * arm**2) / (mass * G * arm)) for one in inertia[:2]]
    squares = rest.squares[1:3]
    assert sorted(2 * math.pi / np.sqrt(squares)) == pytest.approx(sorted(wanted), rel=1e-8)


def test_two_crane_tandem_lift() -> None:
    """Tandem lift, centre of gravity a and b from plumb falls: W b/(a + b) and W a/(a + b), four periods.

    Along the line of hooks ω² = g/L, across it with the roll that of (MD4), about the plumb W a b/(I L).
    """
    mass, length, below, a, b = 200e3, 20.0, 1.5, 4.0, 8.0
    inertia = (4e5, 3e6, 2.5e6)
    ropes = [
        rope(f"hoist{i}", length, [end(None, (x, 0, length)), end("load", (x, 0, 0))], None)
        for i, x in enumerate((0.0, a + b))
    ]
    load = body("load", free((0, 0, 0)), mass, centre_of_gravity=(a, 0, -below), inertia=inertia)
    rest = at_rest(document([load], ropes=ropes))
    shares = np.array([b, a]) / (a + b)
    assert rest.tensions == pytest.approx(mass * G * shares, rel=1e-9)
    along = G / length
    # Yaw moves the falls' lower ends across by a θ and b θ, and nothing else, since it is about the centre.
    yaw = mass * G * a * b / (inertia[2] * length)
    across = np.linalg.eigvals(
        np.linalg.solve(
            mass * np.array([[1.0, below], [below, below**2 + inertia[0] / mass]]),
            mass * G * np.array([[1 / length, 0.0], [0.0, below]]),
        )
    ).real
    assert sorted(rest.squares) == pytest.approx(sorted([along, yaw, *across]), rel=1e-7)


@pytest.mark.parametrize("axial_stiffness", [1e9, 1e14])
def test_two_slings_that_lean(axial_stiffness: float) -> None:
    """Two slings that lean by α from hooks 6 m to either side to lugs b = 4 m to either side, headed 31°:
    slow motions are no matter of rounding beside fast ones, however stiff the slings. Out of their plane as
    (MD4), L the depth of the lugs below the hooks. In it a sling stretches by ± γ·(x, θ) and moves across
    itself by τ·(x, θ), and

    M = diag(m, I), K = 2 k γγᵀ + 2T/ℓ ττᵀ + 2T diag(0, τ₂), γ = (sin α, h sin α − b cos α),
    τ = (cos α, h cos α + b sin α), 2T cos α = m g, k = EA/L.
    """
    mass, turns, high, hook, lug = 40e3, 3e5, 1.5, 6.0, 4.0
    along = np.array([math.cos(math.radians(31)), math.sin(math.radians(31))])
    top = high + math.sqrt(12.0**2 - (hook - lug) ** 2)
    slings = [
        rope(
            f"s{side}",
            12.0,
            [
                end(None, (*(hook * side * along), top)),
                end("load", (*(lug * side * along), high)),
            ],
            axial_stiffness,
        )
        for side in (-1, 1)
    ]
    load = body("load", free((0, 0, 0)), mass, inertia=(turns, turns, 5e5))
    rest = at_rest(document([load], ropes=slings))
    depth = top - high - rest.body("load")[2]
    length = math.hypot(hook - lug, depth)
    sine, cosine = (hook - lug) / length, depth / length
    # A length of 12 m is known to 2e-15 m, which 1e14 N makes 4e-8 of T: motions go with it as it is.
    pull = rest.tensions.sum()
    gravity = pull * cosine / mass
    assert gravity == pytest.approx(G, rel=1e-7)
    masses = np.array([[1.0, high], [high, high**2 + turns / mass]])
    out = np.linalg.eigvals(np.linalg.solve(masses, np.diag([gravity / depth, gravity * high]))).real

    weigh = np.diag([mass**-0.5, turns**-0.5])
    stretch = weigh @ [sine, high * sine - lug * cosine]
    across = np.array([cosine, high * cosine + lug * sine])
    geometric = weigh @ (pull / length * np.outer(across, across) + np.diag([0, pull * across[1]])) @ weigh
    stiff = 2 * axial_stiffness / 12.0
    # det K/det M without the difference of large numbers: (2 k) γᵀ adj(K′) γ + det K′, K′ the rest of K.
    trace = stiff * stretch @ stretch + np.trace(geometric)
    turned = np.array([stretch[1], -stretch[0]])
    product = stiff * turned @ geometric @ turned + np.linalg.det(geometric)
    within = 2 * product / (trace + math.sqrt(trace**2 - 4 * product))
    for square in (*out, within):
        assert np.abs(rest.squares / square - 1).min() < 1e-11


def test_tilting_under_one_equalizer() -> None:
    """Tilting of a load by hand, 5.2 s with its lugs held, and on slings, 3.9 s."""
    # lifts of 300 t with the lugs' middle h = 2.5 m above the centre of gravity. Held there by a ball, a hand
    # calculation: T = 2π √((I + m h²)/(m g h)) = 5.2 s.
    mass, inertia, below = 300e3, 3.125e6, 2.5
    ball = {"type": "ball", "orientation": [1, 0, 0, 0], "angular_velocity": [0, 0, 0]}
    held = at_rest(
        document([body("load", ball, mass, centre_of_gravity=(0, 0, -below), inertia=(inertia,) * 3)])
    )
    by_hand = 2 * math.pi * math.sqrt((inertia + mass * below**2) / (mass * G * below))
    assert by_hand == pytest.approx(5.2, abs=0.05)
    periods = 2 * math.pi / np.sqrt(held.squares[1:])
    assert held.found["neutral"] == 1
    assert periods == pytest.approx([by_hand] * 2, rel=1e-9)
    # On slings the lugs' middle is not held: a double pendulum of the sling length L and the load,
    # M = m [[1, h], [h, h² + I/m]], K = m g diag(1/L, h) in (path, tilt). It tilts in 3.9 s.
    length = 26.0
    lugs = ((-2.5, 2.5), (2.5, 2.5), (0, 0), (-2.5, -2.5), (2.5, -2.5))
    system = one_equalizer(lugs, lengths=[length] * 5, plumb=True, sheave_mass=1.0, axial_stiffness=1e10)
    rest = at_rest(system)
    m = np.array([[1.0, below], [below, below**2 + inertia / mass]])
    k = np.diag([G / length, G * below])
    swing, tilt = sorted(2 * math.pi / np.sqrt(np.linalg.eigvals(np.linalg.solve(m, k)).real))[::-1]
    assert tilt == pytest.approx(3.9, abs=0.05)
    for wanted in (swing, tilt):
        # A sling of 1e10 N stretches by 6e-5, and a sheave of 1 kg moves with the load.
        assert np.min(np.abs(rest.periods / wanted - 1)) < 1e-4


def test_unstable_motions_stand_first() -> None:
    """Inverted pendulum: ω² = −m g l/(I + m l²)."""
    rest = at_rest(document([body("pole", hinge(), 40.0, centre_of_gravity=(0, 0, 1.5), inertia=(8, 8, 1))]))
    assert (rest.found["neutral"], rest.found["unstable"]) == (0, 1)
    assert rest.squares == pytest.approx([-40 * G * 1.5 / (8 + 40 * 1.5**2)], rel=1e-12)


def test_what_nothing_holds_has_no_period() -> None:
    """A load on one rope from a hook: two swings, and a turn about the plumb that nothing holds."""
    ropes = [rope("r", 10.0, [end(None, (0, 0, 11)), end("load", (0, 0, 1))], 1e8)]
    rest = at_rest(document([body("load", free((0, 0, 0)), 1e4, inertia=(1e3, 1e3, 1e3))], ropes=ropes))
    assert (rest.found["neutral"], rest.found["unstable"]) == (1, 0)
    modes = rest.core.modes()
    assert abs(modes["square"][0]) < 1e-9
    assert math.isnan(modes["damping_ratio"][0])


def test_a_mode_as_a_recording() -> None:
    """A mode recorded over one period: forces are mass times ω² times displacement."""
    lift = Statics(SCENARIOS / "equalizer")
    rest = lift.equilibrium()
    modes = lift.modes()
    bounce = next(mode for mode in modes if mode.motion == f"{LOAD} moves along z")
    recording = lift.swing(bounce, amplitude=0.01, frames=41)
    assert recording.time[-1] == pytest.approx(bounce.period, rel=1e-12)
    height = recording.column("body_position", LOAD)[:, 2]
    at = rest.recording.column("body_position", LOAD)[-1, 2]
    # The sheaves move more than the load in it, by at most 1 cm.
    assert height[[0, 20, 40]] == pytest.approx([at] * 3, abs=1e-12)
    swing = height - at
    assert np.abs(swing).max() == pytest.approx(abs(swing[10]), rel=1e-9)
    assert 1e-3 < abs(swing[10]) <= 0.01
    # Force on the load is m ω² times what it is out of place: slings pull more when it is low.
    pulls = np.sum(
        [
            recording.column("rope_tension", sling.rope) * sling_direction(recording, sling)[:, 2]
            for sling in recording.rig.slings
        ],
        axis=0,
    )
    extra = float(pulls[30] - pulls[10]) / 2
    assert extra * math.copysign(1.0, -swing[30]) > 0
    drawn = {name for name, draw in PICTURES.items() if draw(recording) is not None}
    assert drawn >= {"sling_tension", "sheave_travel", "attitude", "hook_load", "system"}
    # Squares cancel between up and down; cubes are the square of 1 cm over 23 m.
    assert abs(extra) == pytest.approx(300e3 * bounce.square * abs(swing[30]), rel=2e-7)


@pytest.mark.parametrize("sheaves", [100, 200])
def test_a_few_slow_motions_of_a_large_lift(sheaves: int) -> None:
    """The six slowest of E(n), found one by one, are those of the dense matrices."""
    core = _core.Statics(gantline_document(equalizer_lift(sheaves)))
    core.settle()
    few, all_of_them = core.modes(6), core.modes()
    assert few["square"].shape == (6,)
    assert all_of_them["square"].shape == (sheaves + 7,)
    # The fastest have 2e5 1/s², whose rounding the dense matrices leave on the slowest; one nothing holds.
    assert few["square"] == pytest.approx(all_of_them["square"][:6], abs=1e-9)
    assert abs(few["square"][0]) < 1e-9
    alike = np.abs(few["body_motion"][1:]), np.abs(all_of_them["body_motion"][1:6])
    assert np.abs(alike[0] - alike[1]).max() < 1e-7 * alike[1].max()
