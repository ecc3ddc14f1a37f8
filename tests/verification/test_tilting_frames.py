"""Equalizer frames that tilt under their hooks, against closed forms.

The lift: two pinned moving sheaves at ±a along a frame, h below the hook's bearing, and on them two slings
that hardly stretch, to lugs as far apart, H above the centre of gravity of a load W that is e off their
middle along the frame. Slings of equal length and as far apart above as below stay parallel, so frame and
load tilt alike, by θ. Slings bear no level force, so they hang plumb, T₁ + T₂ = W; about the bearing and
about the centre of gravity of the load, with the frame's weight W_f at d below the bearing, the weight w of a
sheave and a friction M_f that holds back,

    (T₁ - T₂) a cos θ = (W h + W_f d + 2 w h) sin θ + M_f,     (T₁ - T₂) a cos θ = W e cos θ - W H sin θ,

    W e cos θ - (W (h + H) + W_f d + 2 w h) sin θ = M_f.                                                (1)

Held upright, θ = 0, the frame bears whatever moment that takes:

    T₁ - T₂ = W e/a.                                                                                    (2)
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.results import series
from gantline.results.loads.skew import skew_loads
from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Statics
from lift_text import spoiled

Floats = npt.NDArray[np.float64]

G = 9.81
LOAD, FRAME, SHEAVE = 60e3, 5e3, 200.0
A, H_SHEAVES, D, H_LUGS, SLING = 2.0, 5.0, 2.0, 1.5, 10.0
SIZE = (5.0, 1.0, 2.0)  # of the frame

LIFT = """\
format: 1
lift: {{title: A frame that tilts}}
duration: 10 s
start: rest
ropes:
  sling: {{axial_stiffness: 1000000 MN, damping_time: 2 ms, mass: none}}
  thick: {{axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}}
load:
  name: module
  shape: {{box: [8 m, 6 m, 3 m]}}
  position: [0 m, 0 m, {height} m]
  weight: {{calculated: 60 t, contingency: 1.0}}
  centre_of_gravity: {{at: [{along} m, 0 m, 1.5 m]}}
  lugs:
    L1: {{at: [-2 m, 0 m, 3 m], capacity: 80 t}}
    L2: {{at: [ 2 m, 0 m, 3 m], capacity: 80 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 20 m]
    hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}
equalizers:
  e1:
    hangs_from: hook
    frame: {{mass: 5 t, length: 5 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 2 m}}
    hinge: {{{hinge}}}
    rope: thick
    rope_ends: {{along: [-2.4 m, 2.4 m], below_hook: 3 m}}
    fixed_sheaves: {{along: [0 m], below_hook: 3 m, pitch_diameter: 0.8 m}}
    moving_sheaves: {{along: [-2 m, 2 m], below_hook: 5 m, pitch_diameter: 0.8 m, mass: 200 kg}}
    travel: {{up: 1 m, down: 1 m, locked: true}}
slings:
  S1: {{from: e1.1, to: module.L1, length: 10 m, rope: sling}}
  S2: {{from: e1.2, to: module.L2, length: 10 m, rope: sling}}
plan:
  - {{step: hold, hold: until_end}}
"""
#: Height of the load's datum with its slings straight and plumb [m].
HANGING = 20.0 - H_SHEAVES - SLING - 3.0


def lift(hinge: str, along: float) -> Scenario:
    return parse_scenario(LIFT.format(hinge=hinge, along=along, height=HANGING))


def by_hand(along: float, friction: float = 0.0) -> float:
    """Tilt by (1) [rad]: A cos θ - B sin θ = M, so cos(θ + β) = M/√(A² + B²) with tan β = B/A."""
    driving = LOAD * G * along
    holding = G * (LOAD * (H_SHEAVES + H_LUGS) + FRAME * D + 2 * SHEAVE * H_SHEAVES)
    return math.acos(friction / math.hypot(driving, holding)) - math.atan2(holding, driving)


@pytest.mark.parametrize("along", [0.05, 0.3, 0.6])
def test_frame_and_load_tilt_alike(along: float) -> None:
    """(1), to what slings of EA 1e12 N stretch, 6e-6 m over 4 m."""
    rest = Statics(lift("tilts: true", along)).equilibrium()
    frame = tilt_of_frame(rest.recording)
    assert frame == pytest.approx(by_hand(along), rel=1e-4)
    assert rest.recording.column("load_tilt", "module")[-1] == pytest.approx(frame, rel=1e-4)
    difference = rest.tension("sling.S2") - rest.tension("sling.S1")
    tangent = math.tan(by_hand(along))
    assert difference == pytest.approx(LOAD * G * (along - H_LUGS * tangent) / A, rel=1e-4)
    assert rest.tension("sling.S1") + rest.tension("sling.S2") == pytest.approx(LOAD * G, rel=1e-9)


def test_a_frame_that_is_held_upright_bears_the_moment() -> None:
    """(2): slings share 345.3 to 243.3 kN, (1) gives them 328.5 to 260.1 kN."""
    rest = Statics(lift("axis: vertical", 0.3)).equilibrium()
    difference = rest.tension("sling.S2") - rest.tension("sling.S1")
    assert difference == pytest.approx(LOAD * G * 0.3 / A, rel=1e-4)
    assert tilt_of_frame(rest.recording) == 0.0


@pytest.mark.parametrize("friction", [50.0, 150.0])
def test_friction_holds_tilt_back(friction: float) -> None:
    """(1): statics follow the frame from upright to where friction holds it."""
    rest = Statics(lift(f"tilts: true, tilt_friction: {friction} kN m", 0.3)).equilibrium()
    assert tilt_of_frame(rest.recording) == pytest.approx(by_hand(0.3, 1e3 * friction), rel=1e-4)


def test_friction_holds_a_frame_upright() -> None:
    """W e = 176.6 kN m is less than 180 kN m: in 10 s the frame does not tilt at all, and shares by (2)."""
    recording = gantline.simulate(lift("tilts: true, tilt_friction: 180 kN m", 0.3))
    assert series.frame_tilt(recording, recording.rig.equalizers[0]).max() < 1e-12
    tension = {one: recording.column("rope_tension", f"sling.{one}")[-1] for one in ("S1", "S2")}
    assert tension["S2"] - tension["S1"] == pytest.approx(LOAD * G * 0.3 / A, rel=1e-4)


def test_natural_periods() -> None:
    """In the plane of the slings a double pendulum, across it a triple one, small angles from plumb.

    Along: frame and load turn by θ, slings of length L by ψ; the load moves by (h + H) θ + L ψ. Across:
    frame φ, slings ψ, load χ; the load moves by h φ + L ψ + H χ. What slings of EA 1e12 N stretch is less
    than 1e-5 of a period.
    """
    length, width, high = SIZE
    along_load, across_load = (LOAD / 12 * (size**2 + 3.0**2) for size in (8.0, 6.0))
    hung = FRAME * D**2 + 2 * SHEAVE * H_SHEAVES**2
    along_frame = FRAME / 12 * (length**2 + high**2) + hung + 2 * SHEAVE * A**2
    across_frame = FRAME / 12 * (width**2 + high**2) + hung
    lever = FRAME * D + 2 * SHEAVE * H_SHEAVES
    arms = np.array([H_SHEAVES + H_LUGS, SLING])
    mass = LOAD * np.outer(arms, arms) + np.diag([along_frame + along_load, 0.0])
    stiffness = G * np.diag([lever + LOAD * arms[0], LOAD * SLING])
    wanted = periods(mass, stiffness)
    arms = np.array([H_SHEAVES, SLING, H_LUGS])
    mass = LOAD * np.outer(arms, arms) + np.diag([across_frame, 0.0, across_load])
    stiffness = G * np.diag([lever + LOAD * H_SHEAVES, LOAD * SLING, LOAD * H_LUGS])
    wanted += periods(mass, stiffness)
    question = Statics(lift("tilts: true", 0.0))
    question.equilibrium()
    found = np.array([mode.period for mode in question.modes() if mode.period is not None])
    nearest = [found[np.argmin(np.abs(found - one))] for one in wanted]
    assert nearest == pytest.approx(wanted, rel=1e-5)
    assert len(set(nearest)) == 5


@pytest.mark.parametrize(("along", "is_told"), [(0.086, False), (0.089, True)])
def test_a_hook_bears_a_degree_without_a_word(along: float, is_told: bool) -> None:
    """tan⁻¹(e/h) below the hook: 0.985° of 86 mm in 5 m, 1.020° of 89 mm."""
    assert bool(checks("frame_held_upright", lift("axis: vertical", along))) is is_told


def test_what_a_hook_bears_is_told() -> None:
    """W e = 176.6 kN m, 0.30 m beside a hook 5 m above the sheaves: 3.4°. With e of 0.05 m it is 0.6°."""
    [told] = checks("frame_held_upright", lift("axis: vertical", 0.3))
    assert (told.verdict, told.element) == (Verdict.WARNING, "e1")
    assert "upright with 177 kN m: its slings pull 0.30 m beside the hook" in told.remark
    assert not checks("frame_held_upright", lift("axis: vertical", 0.05))
    assert not checks("equalizer_tilt", lift("axis: vertical", 0.3))
    assert not checks("frame_held_upright", lift("tilts: true", 0.3))


@pytest.mark.parametrize(("limit", "verdict"), [("2.6 deg", Verdict.OK), ("2.5 deg", Verdict.FAILED)])
def test_a_limit_of_tilt(limit: str, verdict: Verdict) -> None:
    """(1): 2.56°."""
    text = lift("tilts: true", 0.3).text + f"limits: {{rule: yard, equalizer_tilt: {limit}}}\n"
    [found] = checks("equalizer_tilt", parse_scenario(text))
    assert (found.verdict, found.element) == (verdict, "e1")
    assert found.value == pytest.approx(by_hand(0.3), rel=1e-4)
    recording = gantline.simulate(parse_scenario(text))
    assert recording.metrics()["peak_equalizer_tilt"] == pytest.approx(by_hand(0.3), rel=1e-4)


def test_sheaves_that_are_free_share_along_their_guides_without_skew() -> None:
    """All parts of the equalizing rope along the guides: skew load factor 1, whatever the frame tilts by.

    Sheaves at -2 m and 1.6 m that pull alike pull 0.2 m beside the hook.
    """
    text = lift("tilts: true", 0.0).text
    for before, after in {
        "locked: true": "stops: true",
        "[-2.4 m, 2.4 m]": "[-2.4 m, 2 m]",
        "[-2 m, 2 m]": "[-2 m, 1.6 m]",
        "[0 m], below_hook: 3 m, pitch_diameter: 0.8 m": "[-0.2 m], below_hook: 3 m, pitch_diameter: 2.8 m",
    }.items():
        text = spoiled(before, after, text)
    rest = Statics(parse_scenario(text)).equilibrium()
    assert tilt_of_frame(rest.recording) > math.radians(2.0)
    assert [one.factor for one in skew_loads(rest.recording)] == pytest.approx([1.0, 1.0], abs=1e-9)
    assert rest.tension("sling.S1") != pytest.approx(rest.tension("sling.S2"), rel=1e-6)


def checks(name: str, scenario: Scenario) -> list[Check]:
    """The checks of that name of the equilibrium of a lift."""
    found = check_recording(Statics(scenario).equilibrium().recording)
    return [one for one in found if one.name == name]


def periods(mass: Floats, stiffness: Floats) -> list[float]:
    """2π/ω of det(K - ω² M) = 0 [s]."""
    squares = np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real
    return [2 * math.pi / math.sqrt(square) for square in squares]


def tilt_of_frame(recording: gantline.Recording) -> float:
    """At the last sample [rad]."""
    return float(series.frame_tilt(recording, recording.rig.equalizers[0])[-1])
