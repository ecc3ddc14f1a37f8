"""Vessels in the words of a lift file against closed forms and hand figures."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from afloat import (
    ADDED,
    BOOM,
    BOOM_INERTIA,
    BREADTH,
    DEPTH,
    DRAFT,
    HEAD,
    KG,
    LENGTH,
    MASS,
    ROWS,
    WEIGHTS,
    barge,
    lift_of,
    sheerleg,
    written,
)
from floating import SEA, pitch_and_roll
from gantline.assembly import assemble
from gantline.checks import Verdict, check_recording
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.variable import FloatArray
from gantline.scenario import load_scenario
from gantline.simulation import simulate
from gantline.statics import Mode, Statics
from gantline.statics.inclining import metacentric_heights

G = 9.81
AHEAD, ABOVE = 65.0, 60.0


def last(recording: Recording, name: str, vessel: str = "barge") -> float:
    return float(recording.column(f"vessel_{name}", vessel)[-1])


def test_barge_with_a_load_ahead_of_its_bow(tmp_path: Path) -> None:
    """1000 t at 65 m ahead of the middle and 60 m up: T = ∇/LB = 4.325 m, GM_L = T/2 + L²/12T − KG = 185.70 m
    and with it 1.508°. Exactly: B stands below G, t (GM + BM t²/2) = x_G with t = tan θ; no deck is wet.
    """
    masses = barge()["masses"] | {
        "load": {"mass": "1000 t", "at": [f"{LENGTH / 2 + AHEAD} m", "0 m", f"{ABOVE} m"]}
    }
    vessel = barge(masses=masses, heading="30 deg", trim="1 deg")
    question = Statics(written(tmp_path, lift_of(vessel)))
    rest = question.equilibrium()
    assert (rest.unstable, rest.neutral) == (0, 3), "nothing holds surge, sway and yaw"
    total = MASS + 1e6
    draft = total / (SEA * LENGTH * BREADTH)
    kg, lever = (MASS * KG + 1e6 * ABOVE) / total, 1e6 * AHEAD / total
    bm = LENGTH**2 / (12 * draft)
    gm = draft / 2 + bm - kg
    assert (draft, gm) == pytest.approx((4.325, 185.70), abs=0.005)
    assert math.degrees(lever / gm) == pytest.approx(1.508, abs=0.0005)
    (tangent,) = (root.real for root in np.roots([bm / 2, 0, gm, -lever]) if abs(root.imag) < 1e-9)
    recording = rest.recording
    # The equilibrium is found to 1e-9 of the forces, and GM is a twentieth of a hull's size: 1e-9 of the
    # angle. The bow is down: trim is negative.
    assert math.tan(-last(recording, "trim")) == pytest.approx(tangent, rel=2e-9)
    assert last(recording, "heel") == pytest.approx(0, abs=1e-12)
    # Along the vessel's z the section of the middle is T, and at the ends L/2 tan θ more and less.
    found = [last(recording, f"draft{end}") for end in ("", "_aft", "_forward")]
    wanted = [draft, draft - LENGTH / 2 * tangent, draft + LENGTH / 2 * tangent]
    assert found == pytest.approx(wanted, rel=1e-8)
    assert last(recording, "freeboard") == pytest.approx(
        (DEPTH - wanted[2]) * math.cos(math.atan(tangent)), rel=1e-8
    )
    assert last(recording, "displacement") == pytest.approx(total, rel=1e-9)
    bow, side = pitch_and_roll(recording["body_orientation"].values[-1, 0])
    assert (bow, side) == pytest.approx((last(recording, "trim"), 0), abs=1e-12)


def test_a_vessel_starts_as_it_is_said_to_lie(tmp_path: Path) -> None:
    """The water is T along the vessel's z above the keel at half length; towards the stern it rises by
    tan(trim)/cos(heel), towards starboard by tan(heel), along these axes.
    """
    trim, heel, heading = math.radians(1.5), math.radians(-4.0), math.radians(30.0)
    said = {"position": ["10 m", "-5 m"], "heading": "30 deg", "heel": "-4 deg", "trim": "1.5 deg"}
    given = lift_of(barge(**said), water={"level": "0.7 m"}, start="as_given")
    path = written(tmp_path, given)
    (body,) = assemble(load_scenario(path)).document["bodies"]
    assert body["joint"]["position"][:2] == [10.0, -5.0]
    turn = axes(np.array(body["joint"]["orientation"]))
    # Its bow points 30° from x towards y, and rises by the trim; port rises where it heels to starboard.
    bow = [math.cos(trim) * math.cos(heading), math.cos(trim) * math.sin(heading), math.sin(trim)]
    assert turn[:, 0] == pytest.approx(bow, abs=1e-15)
    assert turn[2, 1] == pytest.approx(math.cos(trim) * math.sin(heel), abs=1e-15)
    for at in ((0.0, 0.0), (100.0, 15.0), (30.0, -15.0)):
        up = math.tan(trim) / math.cos(heel) * (50.0 - at[0]) - math.tan(heel) * at[1]
        place = np.array(body["joint"]["position"]) + turn @ [*at, DRAFT + up]
        assert place[2] == pytest.approx(0.7, abs=1e-12)
    run = simulate(path, duration=0.02)
    lies = [float(run.column(f"vessel_{name}", "barge")[0]) for name in ("draft", "heel", "trim")]
    assert lies == pytest.approx([DRAFT, heel, trim], abs=1e-12)


def test_metacentric_heights_with_a_slack_tank(tmp_path: Path) -> None:
    """Upright, GM = T/2 + I/∇ − KG − i/∇ with the second moments of waterplane and tank, liquid of the same
    density; KG with the liquid as it lies.
    """
    length, breadth, content = 20.0, 10.0, 800e3
    depth = content / (SEA * length * breadth)
    tank = {"box": ["20 m", "10 m", "7 m"], "bottom": ["50 m", "0 m", "0 m"], "content": f"{content} kg"}
    question = Statics(written(tmp_path, lift_of(barge(tanks={"middle": tank}))))
    rest = question.equilibrium()
    volume = (MASS + content) / SEA
    draft = volume / (LENGTH * BREADTH)
    kg = (MASS * KG + content * depth / 2) / (MASS + content)
    found = metacentric_heights(question, rest)["barge"]
    for height, (along, across), (own, other) in (
        (found.transverse, (LENGTH, BREADTH), (length, breadth)),
        (found.longitudinal, (BREADTH, LENGTH), (breadth, length)),
    ):
        second = along * across**3 / 12 - own * other**3 / 12
        # By derivatives of an equilibrium that is found to 1e-9 of the forces.
        assert height == pytest.approx(draft / 2 + second / volume - kg, rel=1e-7)


def test_shares_of_critical_damping_come_out_of_the_modes(tmp_path: Path) -> None:
    """20, 6 and 9 % of critical for heave, roll and pitch of a barge whose motions go by themselves; heave
    goes with √(ρgA/(m + a₃₃)).
    """
    added = {"heave": "15000 t", "roll": "6e5 t m^2", "pitch": "9e6 t m^2", "at": ["50 m", "0 m", f"{KG} m"]}
    shares = {"heave": "20 %", "roll": "6 %", "pitch": "9 %"}
    question = Statics(
        written(tmp_path, lift_of(barge(added_mass=added, water_damping={"critical": shares})))
    )
    question.equilibrium()
    swinging = [mode for mode in question.modes() if mode.period is not None]
    heave = 2 * math.pi * math.sqrt((MASS + 15e6) / (SEA * G * LENGTH * BREADTH))
    moved = {_motion(mode): mode for mode in swinging}
    assert moved["heave"].period == pytest.approx(heave, rel=1e-9)
    found = {motion: mode.damping_ratio for motion, mode in moved.items()}
    # The draft is that of the equilibrium to rounding, so stiffness and inertia are the same.
    assert found == {
        "heave": pytest.approx(0.2, rel=1e-6),
        "roll": pytest.approx(0.06, rel=1e-6),
        "pitch": pytest.approx(0.09, rel=1e-6),
    }


def _motion(mode: Mode) -> str:
    """The largest of a vessel's motions with heading 0, turns times half a length."""
    sizes = np.abs(mode.body_motion[0]) * [1, 1, 1, 50, 50, 50]
    return ("surge", "sway", "heave", "roll", "pitch", "yaw")[int(np.argmax(sizes))]


def test_damping_on_moorings_has_their_period(tmp_path: Path) -> None:
    """Surge at 5 % of critical for 60 s: v falls by exp(−2ζωt), ω = 2π/60 s, with nothing to restore it."""
    damping = {"critical": {"surge": "5 %", "periods": {"surge": "60 s"}}}
    added = {"surge": "1000 t", "at": ["50 m", "0 m", f"{KG} m"]}
    path = written(tmp_path, lift_of(barge(added_mass=added, water_damping=damping)))
    forces = {force["name"]: force for force in assemble(load_scenario(path)).document["forces"]}
    found = np.array(forces["barge.critical_damping"]["damping"])
    wanted = np.zeros((6, 6))
    wanted[0, 0] = 2 * 0.05 * (2 * math.pi / 60) * (MASS + 1e6)
    assert found == pytest.approx(wanted, rel=1e-12, abs=1e-6)


def test_a_sheerleg_before_it_lifts_is_trimmed_by_the_stern(tmp_path: Path) -> None:
    """Hand figures of a 3600 t sheerleg without load on its hooks: 20 812 t at 4.18 m, 1.46° by the stern,
    5.53 m aft and 2.83 m forward, GM 32.2 and 206.7 m with free surfaces. They are rounded to three digits.
    """
    question = Statics(written(tmp_path, sheerleg()))
    rest = question.equilibrium()
    assert (rest.unstable, rest.neutral) == (0, 3)
    recording = rest.recording
    assert last(recording, "displacement", "crane") == pytest.approx(20_812e3, rel=1e-6)
    assert last(recording, "draft", "crane") == pytest.approx(4.18, abs=0.005)
    drafts = [last(recording, f"draft_{end}", "crane") for end in ("aft", "forward")]
    assert drafts == pytest.approx([5.53, 2.83], abs=0.005)
    assert math.degrees(last(recording, "trim", "crane")) == pytest.approx(1.46, abs=0.005)
    found = metacentric_heights(question, rest)["crane"]
    # The hand figure of the longitudinal height is that on even keel; trimmed by 1.46° a waterplane is longer
    # by 1/cos.
    assert found.transverse == pytest.approx(32.2, abs=0.05)
    assert found.longitudinal == pytest.approx(206.7, rel=2e-3)


def test_a_sheerleg_that_holds_its_load_floats_on_even_keel(tmp_path: Path) -> None:
    """21 908 t at 4.40 m; GM 25.6 and 191.4 m, for which the load counts at the boom head, as it hangs."""
    question = Statics(written(tmp_path, sheerleg(1096.0)))
    rest = question.equilibrium(0.0)
    recording = rest.recording
    assert last(recording, "displacement", "crane") == pytest.approx(21_908e3, rel=1e-6)
    assert last(recording, "draft", "crane") == pytest.approx(4.40, abs=0.005)
    # Within 0.1° of even keel, by ballast that is given to a tonne: 1 t at 52.8 m trims it by 1e-5 rad.
    assert abs(math.degrees(last(recording, "trim", "crane"))) < 0.01
    found = metacentric_heights(question, rest)["crane"]
    assert found.transverse == pytest.approx(25.6, rel=3e-3)
    assert found.longitudinal == pytest.approx(191.4, rel=3e-3)


def test_natural_periods_of_a_sheerleg(tmp_path: Path) -> None:
    """Heave by itself, and roll with sway and yaw that nothing restores, against inertias by hand about the
    centre of gravity of all that is aboard. Hand figures of periods are about 9, 9 and 8.5 s; that of roll
    has less inertia in it than boom and head gear, far above, have. Shares of critical damping are those of
    the file, upright; it lies trimmed by 1.46°.
    """
    critical = {"heave": "20 %", "pitch": "20 %", "roll": "6 %"}
    question = Statics(written(tmp_path, sheerleg(water_damping={"critical": critical})))
    rest = question.equilibrium()
    modes = {_motion(mode): mode for mode in question.modes() if mode.period is not None}
    own = np.sum([mass * np.array([1, x, z]) for mass, x, z in WEIGHTS.values()], axis=0)
    ballast = [(content, x, content / (2 * 1.025 * 46 * 26.4)) for x, content in ROWS]
    apart = [(own[0], *(own[1:] / own[0])), (1500, *BOOM), (460, *HEAD), *ballast]
    mass = sum(one[0] for one in apart)
    middle = np.array([sum(one[0] * one[axis] for one in apart) for axis in (1, 2)]) / mass
    levers = [(one[0], one[1] - middle[0], one[2] - middle[1]) for one in apart]
    xx, zz, xz = (float(sum(m * a * b for m, a, b in pairs)) for pairs in _seconds(levers))
    slope = math.radians(60)
    xx += own[0] * 15**2 + BOOM_INERTIA * math.sin(slope) ** 2
    zz += own[0] * 30**2 + BOOM_INERTIA * math.cos(slope) ** 2
    xz += BOOM_INERTIA * math.cos(slope) * math.sin(slope)
    for content, _ in ((content, x) for x, content in ROWS):
        xx, zz = xx + content * 46**2 / 12, zz + content * (46**2 + 26.4**2) / 12
    # Sway, roll, yaw; the added mass in sway is at the keel at half length.
    inertia = np.array([[mass, 0, 0], [0, xx + ADDED["roll"], -xz], [0, -xz, zz + ADDED["yaw"]]])
    moves = np.array([1, middle[1], 52.8 - middle[0]])
    inertia += ADDED["sway"] * np.outer(moves, moves)
    follow = np.ix_([0, 2], [0, 2])
    roll = inertia[1, 1] - inertia[1, [0, 2]] @ np.linalg.solve(inertia[follow], inertia[[0, 2], 1])
    gm = metacentric_heights(question, rest)["crane"].transverse
    heave = math.sqrt((mass + ADDED["heave"]) / (1.025 * G * 105.6 * 46))
    # Upright by hand, trimmed by 1.46° in the lift; heave shares its mode with pitch, 6 % apart.
    assert modes["roll"].period == pytest.approx(2 * math.pi * math.sqrt(roll / (mass * G * gm)), rel=0.01)
    assert modes["heave"].period == pytest.approx(2 * math.pi * heave, rel=0.02)
    assert modes["heave"].period == pytest.approx(9.0, rel=0.05)
    assert modes["pitch"].period == pytest.approx(9.0, rel=0.10)
    ratios = {motion: mode.damping_ratio for motion, mode in modes.items()}
    assert ratios == {
        "heave": pytest.approx(0.20, rel=0.01),
        "pitch": pytest.approx(0.20, rel=0.01),
        "roll": pytest.approx(0.06, rel=0.01),
    }


def _seconds(levers: list[tuple[float, float, float]]) -> list[list[tuple[float, float, float]]]:
    """What second moments of masses at (x, z) are made of: about x, about z, and product."""
    return [
        [(mass, z, z) for mass, _, z in levers],
        [(mass, x, x) for mass, x, _ in levers],
        [(mass, x, z) for mass, x, z in levers],
    ]


@pytest.mark.parametrize("share", [0.0, 0.2])
def test_a_sheerleg_whose_load_is_lost(tmp_path: Path, share: float) -> None:
    """1096 t at the boom head are gone at once, and the sheerleg swings about how it lies without them,
    4.18 m and 1.462° by the stern. Its righting moment is straight as long as the deck is dry, so without
    damping it swings as far beyond, since energy is kept: to 2.92°, while it heaves from 4.40 m to 3.96 m;
    at 4.18 m of draft that would be 6.87 m aft and 0.6 m of freeboard. Damped by ζ, of each motion
    1 − e^(−ζωt) (cos ω_d t + ζω/ω_d sin ω_d t) of its way are gone.
    """
    damping = {"critical": {"heave": f"{100 * share} %", "pitch": f"{100 * share} %"}}
    path = written(tmp_path, sheerleg(1096.0, water_damping=damping))
    run = simulate(path, sample_interval=0.05)
    question = Statics(written(tmp_path, sheerleg(water_damping=damping)))
    question.equilibrium()
    rates = {_motion(mode): 2 * math.pi / mode.period for mode in question.modes() if mode.period is not None}
    time = run.time[run.time >= 2.0]

    def gone(motion: str) -> FloatArray:
        rate, damped = rates[motion], rates[motion] * math.sqrt(1 - share**2)
        swing = np.cos(damped * (time - 2)) + share * rate / damped * np.sin(damped * (time - 2))
        found: FloatArray = 1 - np.exp(-share * rate * (time - 2)) * swing
        return found

    trim = math.radians(1.462) * gone("pitch")
    aft = 4.40 - 0.22 * gone("heave") + 105.6 / 2 * np.tan(trim)
    metrics = run.metrics()
    # Heave and pitch are 6 % apart and share their modes a little.
    assert metrics["peak_trim"] == pytest.approx(trim.max(), rel=0.03)
    assert run.column("vessel_draft_aft", "crane").max() == pytest.approx(aft.max(), rel=0.02)
    assert metrics["least_freeboard"] == pytest.approx(7.5 - aft.max(), abs=0.1)
    if share == 0.0:
        assert math.degrees(metrics["peak_trim"]) == pytest.approx(2.92, rel=0.03)
    assert metrics["energy_remainder"] < 1e-6
    assert not run.events("flooding")


@pytest.mark.parametrize("apart", [200.5, 203.0])
def test_a_vessel_that_starts_elsewhere_is_told(tmp_path: Path, apart: float) -> None:
    """200 m of rope at the water line draw it to where they are slack; half a metre of that is not told."""
    route = [
        {"type": "end", "body": "barge", "at": ["100 m", "0 m", "4 m"]},
        {"type": "end", "body": "world", "at": [f"{100 + apart} m", "0 m", "0 m"]},
    ]
    ropes = {"line": {"axial_stiffness": "10 MN", "mass": "none", "damping_time": "20 ms"}}
    bollard = {"at": ["400 m", "0 m", "0 m"], "joint": {"type": "fixed"}, "mass": "1 t"}
    drawn = {"rope": "line", "length": "200 m", "route": route}
    mechanics = {"bodies": {"bollard": bollard}, "ropes": {"drawn": drawn}}
    given = lift_of(barge(draft="4 m"), duration="0.1 s", ropes=ropes, mechanics=mechanics)
    found = [one for one in simulate(written(tmp_path, given)).attributes["warnings"] if " starts " in one]
    way = apart - 200.0
    assert len(found) == (way > 1.0)
    assert all(one.startswith(f"barge starts {way:.1f} m from where") for one in found)


def test_limits_requirements_and_reports_of_vessels(tmp_path: Path) -> None:
    """A barge with 4° of heel, at rest with its weight 0.5 m off the centre: φ = 0.5/GM, GM 15.75 m, 1.8°."""
    masses = {"hull": {"mass": f"{MASS} kg", "at": ["50 m", "-0.5 m", f"{KG} m"]}}
    step = {"step": "look", "hold": "1 s", "report": ["draft", "heel", "trim", "freeboard"]}
    require = {"heel": "below 1 deg", "freeboard": "above 3 m", "trim": "below 1 deg"}
    given = lift_of(
        barge(masses=masses),
        duration="2 s",
        plan=[{**step, "require": require}],
        limits={"heel": "2 deg", "trim": "1 deg", "freeboard": "3.8 m"},
    )
    run = simulate(written(tmp_path, given))
    checks = {(check.name, check.step): check for check in check_recording(run)}
    gm = DRAFT / 2 + BREADTH**2 / (12 * DRAFT) - KG
    heel = checks["heel", ""]
    # The wall-sided formula bends by BM tan² φ/2 of GM, 6e-4.
    assert heel.value == pytest.approx(math.atan(0.5 / gm), rel=2e-3)
    verdicts = {key: check.verdict for key, check in checks.items()}
    assert verdicts == {
        ("heel", ""): Verdict.OK,
        ("trim", ""): Verdict.OK,
        ("freeboard", ""): Verdict.FAILED,
        ("heel", "look"): Verdict.FAILED,
        ("trim", "look"): Verdict.OK,
        ("freeboard", "look"): Verdict.OK,
        ("no_warnings", ""): Verdict.WARNING,  # it rests 1.8° from where the lift file has it
    }
