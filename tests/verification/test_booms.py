"""Booms, hooks at their heads, and luffing, against geometry.

The crane is a sheerleg of 3600 t: heel pins 98 m ahead of the stern and 9 m above the keel, boom of 110 m and
1500 t with its centre at 48 %, head gear of 140 t, A-frame top 70 m ahead and 62 m up, bow at 105.6 m.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from boom_lift import (
    BELOW,
    BOOM,
    BOW,
    CENTRE,
    HEAD_GEAR,
    HEEL,
    HOOK_BLOCK,
    LENGTH,
    PRESCRIBED,
    SHEAVE_BLOCK,
    TACKLES,
    boom_afloat,
    boom_lift,
    head,
    simulated,
    tackle,
    weight_moment,
)
from gantline.checks import check_recording
from gantline.results.cranes.boom import Boom, boom_state
from gantline.results.cranes.crane import CraneHook
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.statics.inclining import metacentric_heights


@pytest.mark.parametrize(
    ("axis", "degrees", "heel", "trim"),
    [((1.0, 0.0, 0.0), 2.0, 2.0, 0.0), ((0.0, 1.0, 0.0), -3.0, 0.0, 3.0), ((0.0, 0.0, 1.0), 40.0, 0.0, 0.0)],
    ids=["port side up", "boom up", "turned"],
)
def test_heel_and_trim_of_what_bears_a_boom(
    axis: tuple[float, float, float], degrees: float, heel: float, trim: float
) -> None:
    """Base and boom turn about x (ahead), y (to port) and z, by the right hand; no turn changes the boom's
    angle over the base. The base has its origin 2 m behind its centre of gravity, and outreach counts from
    5 m ahead of that.
    """
    half = math.radians(degrees) / 2
    turn = np.array([math.cos(half), *(math.sin(half) * part for part in axis)])
    columns = {
        "time": np.zeros(1),
        "body_position": np.array([[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [30.0, 0.0, -40.0]]]),
        "body_orientation": np.array([[turn, turn, [1.0, 0.0, 0.0, 0.0]]]),
    }
    hook = CraneHook("h", top="boom")
    boom = Boom(
        "c", boom="boom", base="base", reach_from=(5.0, 0.0, 0.0), base_from=(-2.0, 0.0, 0.0), hooks=[hook]
    )
    found, _ = boom_state(columns, {"body": ["base", "boom", "h"], "joint": []}, [boom])
    for name, angle in (("crane_heel", heel), ("crane_trim", trim), ("boom_angle", 0.0)):
        assert found[name].values[0, 0] == pytest.approx(math.radians(angle), abs=1e-12)
    ahead = math.radians(degrees if axis[2] else 0.0)
    base = 3.0 * math.cos(math.radians(degrees)) if axis[1] else 3.0
    assert found["crane_radius"].values[0, 0] == pytest.approx(30.0 * math.cos(ahead) - base, abs=1e-12)


@pytest.mark.parametrize(
    ("angle", "outreach", "height"),
    [
        (75, 20.9, 115.3),
        (70, 30.0, 112.4),
        (65, 38.9, 108.7),
        (60, 47.4, 104.3),
        (55, 55.5, 99.1),
        (50, 63.1, 93.3),
        (45, 70.2, 86.8),
    ],
)
def test_outreach_and_height_of_the_head(angle: float, outreach: float, height: float) -> None:
    """The table is rounded to 0.1 m; the hook hangs below the head from the start, within rounding."""
    recording = simulated(boom_lift(angle=angle, duration=0.1))
    ahead, up = head(math.radians(angle))
    assert recording["boom_angle"].values[0, 0] == pytest.approx(math.radians(angle), abs=1e-12)
    reach = recording.column("crane_radius", "fc.H1")
    assert reach[0] == pytest.approx(ahead - BOW, abs=1e-9)
    assert reach[0] == pytest.approx(outreach, abs=0.0501)
    sheaves = recording.column("body_position", "fc.H1/upper_sheaves")
    assert sheaves[0, 2] + BELOW == pytest.approx(up, abs=1e-9)
    assert sheaves[0, 2] + BELOW == pytest.approx(height, abs=0.0501)


def test_hooks_stand_in_a_row_across_the_head_whatever_its_heading() -> None:
    """Four hooks at +-3.75 m and +-11.25 m of a crane that points 30 deg from x towards y."""
    across = (-11.25, -3.75, 3.75, 11.25)
    hooks = "\n".join(f"H{n}: {{type: H, across: {y} m, height: 40 m}}" for n, y in enumerate(across))
    hung = "\n".join(f"L{n}: {{parent: fc.H{n}, joint: {{type: fixed}}, mass: 300 t}}" for n in range(4))
    base = "    position: [10 m, 20 m, -4.4 m]\n    heading: 30 deg\n"
    recording = simulated(boom_lift(duration=5.0, base=base, hooks=hooks, bodies=hung))
    ahead, up = head(math.radians(60))
    turn = math.radians(30)
    for n, y in enumerate(across):
        place = recording.column("body_position", f"fc.H{n}")
        x = 10 + ahead * math.cos(turn) - y * math.sin(turn)
        # Hung as they start, with the stretch of their falls taken up beforehand: nothing moves.
        assert place[:, 0] == pytest.approx(x, abs=1e-6)
        assert place[:, 1] == pytest.approx(20 + ahead * math.sin(turn) + y * math.cos(turn), abs=1e-6)
        assert place[:, 2] == pytest.approx(40, abs=1e-5)
        assert recording.column("hoist_load", f"fc.H{n}")[-1] == pytest.approx(350e3 * 9.81, rel=1e-5)
        assert recording.column("crane_radius", f"fc.H{n}")[-1] == pytest.approx(ahead - BOW, abs=1e-6)
        assert recording.column("body_position", f"fc.H{n}/upper_sheaves")[0, 2] == pytest.approx(
            -4.4 + up - BELOW, abs=1e-9
        )


LUFF_OUT = "{step: out, luff: fc, speed: 10 deg/min, to: 55 deg}"


def test_the_head_goes_along_a_circle_and_the_hook_comes_down_with_it() -> None:
    """The drum stands on the head: what the head sinks, the hook sinks too."""
    recording = simulated(boom_lift(LUFF_OUT, duration=120.0))
    angle = recording["boom_angle"].values[:, 0]
    assert angle[-1] == pytest.approx(math.radians(55), abs=1e-12)
    hung = recording.column("body_position", "fc.H1/upper_sheaves")
    orientation = recording.column("body_orientation", "fc.H1/upper_sheaves")
    # The centre of gravity of the sheave block hangs at its depth below the pin, turned as that is about y.
    turned = 2 * np.arctan2(orientation[:, 2], orientation[:, 0])
    pin = hung[:, [0, 2]] + BELOW * np.stack((np.sin(turned), np.cos(turned)), axis=1)
    circle = np.array(HEEL) + LENGTH * np.stack((np.cos(angle), np.sin(angle)), axis=1)
    assert np.abs(pin - circle).max() < 1e-9
    sunk = head(math.radians(60))[1] - head(math.radians(55))[1]
    height = recording.column("hook_height", "fc.H1")
    # It swings a little once the boom stands: what that lifts it, length (1 - cos), is below 5 mm.
    assert height[-1] == pytest.approx(40.0 - sunk, abs=5e-3)


def test_luffing_under_load_keeps_the_books() -> None:
    """Work of the drive that lowers the boom: the change of energy, to the bound of the audit."""
    recording = simulated(boom_lift(LUFF_OUT, duration=120.0))
    assert recording.metrics()["energy_remainder"] < 1e-9


def test_off_lead_of_a_head_that_sets_off_is_that_of_a_pendulum() -> None:
    """From rest with the acceleration a of the head the falls, L long, trail by a/g (1 - cos(sqrt(g/L) t)).

    The boom stands almost upright, so that its head goes level. L is from its pin down to the sheaves of the
    hook block, which stays upright.
    """
    luffing = "speed: 30 deg/min, acceleration: 0.01 deg/s^2, range: [40 deg, 89 deg]"
    step = "{step: out, luff: fc, speed: 30 deg/min, towards: minus, brake_from: 20 s}"
    recording = simulated(boom_lift(step, duration=20.0, angle=88.0, luffing=luffing, stiffness=1e6))
    falls = head(math.radians(88))[1] - 40.0 - 3.0
    omega = math.sqrt(9.81 / falls)
    push = math.radians(0.01) * LENGTH * math.sin(math.radians(88))
    expected = -(push / 9.81) * (1 - np.cos(omega * recording.time))
    # Of the largest 0.0039: the head sinks by a 30th of its way, the falls are 0.2 m longer by then, and the
    # sheave block of 8 t swings with them 1.3 m below the pin; each changes the swing by less than 1 %.
    assert np.abs(recording.column("off_lead", "fc.H1") - expected).max() < 0.02 * np.abs(expected).max()
    assert np.abs(recording.column("side_lead", "fc.H1")).max() < 1e-12


def test_the_head_comes_down_and_ahead_as_the_vessel_comes_to_even_keel() -> None:
    """From 1.46 deg by the stern at 4.18 m to even keel at 4.40 m: 2.55 m ahead and 2.78 m down.

    Hand figures of small angles about the middle of the waterline: 100 m above it and 100.2 m ahead of it,
    0.0255 rad, and 0.22 m of sinking; the turn itself is within 0.04 m of them.
    """
    before, after = (simulated(boom_afloat(draft, trim)) for draft, trim in ((4.18, 1.46), (4.40, 0.0)))
    (aft, _, high), (ahead, _, low) = (
        recording.column("body_position", "fc.H1/upper_sheaves")[0] for recording in (before, after)
    )
    turn, x, z = math.radians(1.46), *head(math.radians(60))
    x, above = x - 105.6 / 2, z - 4.18
    assert ahead - aft == pytest.approx(x - (x * math.cos(turn) - above * math.sin(turn)), abs=1e-9)
    sunk = x * math.sin(turn) + above * math.cos(turn) - (z - 4.40)
    assert high - low == pytest.approx(sunk, abs=1e-9)
    assert ahead - aft == pytest.approx(2.55, abs=0.05)
    assert high - low == pytest.approx(2.78, abs=0.05)
    # The angle is that over the deck, the sheave block hangs plumb, and outreach counts from the bow.
    assert before["boom_angle"].values[0, 0] == pytest.approx(math.radians(60), abs=1e-12)
    assert before.column("off_lead", "fc.H1")[0] == pytest.approx(0.0, abs=1e-12)
    assert after.column("crane_radius", "fc.H1")[0] == pytest.approx(47.4, abs=1e-9)


@pytest.mark.parametrize(("ropes", "parts"), [(1, 16), (2, 16), (2, 15), (3, 7)])
def test_what_hangs_at_the_head_counts_there_for_heel(ropes: int, parts: int) -> None:
    """GM = KB + BM - KG with a hook of 350 t at the upper sheaves, 1.3 m below the head, for any reeving.

    Its ropes hardly stretch: side by side, each about its own middle, they would hold the boom up.
    """
    text = boom_afloat(4.27, 0.0).replace("[39 m, 0 m, 5 m]", "[44.4564 m, 0 m, 5 m]")
    reeving = f"ropes: {ropes}, parts_each: {parts}"
    assert "ropes: 2, parts_each: 16" in text
    question = Statics(parse_scenario(text.replace("ropes: 2, parts_each: 16", reeving), "boom.yaml"))
    rest = question.equilibrium()
    found = metacentric_heights(question, rest)["barge"].transverse
    _, z = head(math.radians(60))
    own, boom, gear, hung, sheaves = 18852e3, BOOM, HEAD_GEAR, HOOK_BLOCK + 300e3, SHEAVE_BLOCK
    total = own + boom + gear + hung + sheaves
    middle = HEEL[1] + CENTRE * (z - HEEL[1])
    moments = own * 5 + boom * middle + gear * z + (hung + sheaves) * (z - BELOW)
    draft = total / (1025 * 105.6 * 46)
    assert abs(float(rest.recording.column("vessel_trim", "barge")[-1])) < 1e-3
    # A trim of 0.001 rad counts in its square; hooks swing out by stretch of 1e-4.
    assert found == pytest.approx(draft / 2 + 46**2 / (12 * draft) - moments / total, rel=1e-4)


def test_limits_of_booms_are_checked() -> None:
    """To the end of its range and no further; leads and factors of luffing ropes against their limits."""
    more = "limits: {off_lead: 0.5 deg, side_lead: 0.5 deg, rope_factor_on_breaking_force: 8}\n"
    step = "{step: out, luff: fc, speed: 10 deg/min, to: 55 deg}"
    luffing = PRESCRIBED.replace("40 deg", "55 deg")
    checks = {
        one.name: one
        for one in check_recording(simulated(boom_lift(step, duration=60.0, luffing=luffing, more=more)))
    }
    assert checks["boom_angle_margin"].verdict == "ok" and checks["boom_angle_margin"].value == 0.0
    assert checks["off_lead"].verdict == "failed" and checks["off_lead"].element == "fc.H1"
    assert checks["side_lead"].verdict == "ok"
    assert checks["falls_out_of_plumb"].value == pytest.approx(checks["off_lead"].value, rel=1e-9)
    hanging = simulated(boom_lift(duration=0.1, start="rest", luffing=TACKLES, more=more))
    ropes = {one.name: one for one in check_recording(hanging)}["rope_factor_on_breaking_force"]
    # The hoist ropes have no breaking force here: the luffing ropes are those that are known.
    pull = weight_moment(math.radians(60), SHEAVE_BLOCK + HOOK_BLOCK + 300e3) / tackle(math.radians(60))[1]
    assert ropes.value == pytest.approx(3617e3 / (pull / 64), rel=1e-6)


@pytest.mark.parametrize("luffing", [PRESCRIBED, TACKLES])
def test_an_emergency_stop_brings_the_boom_to_rest(luffing: str) -> None:
    """From 10 deg/min at 10 s with 0.2 deg/s2: 60 deg less (10 s - ramp/2) of that speed and its way."""
    stop = "emergency_stop: {at: 10 s}\n"
    quick = luffing.replace("0.05 deg/s^2", "0.05 deg/s^2, emergency_acceleration: 0.2 deg/s^2")
    text = boom_lift(LUFF_OUT, duration=60.0, start="rest", luffing=quick, luff_stiffness=1e6, more=stop)
    angle = simulated(text)["boom_angle"].values[:, 0]
    speed = 10 / 60
    way = speed * (10 - speed / 0.05 / 2) + speed**2 / 2 / 0.2
    # In tackles the winch goes at the mean speed of the whole step, 1 % more than the first degree asks for.
    within = 1e-9 if luffing == PRESCRIBED else 0.02 * way
    assert math.degrees(angle[-1]) == pytest.approx(60 - way, abs=within)
    # It stands: the boom springs on the stretch of its ropes, and no further.
    assert np.ptp(angle[200:]) < (1e-12 if luffing == PRESCRIBED else 1e-6)


def test_a_boom_without_luffing_keeps_its_angle() -> None:
    """It is fixed at 60 deg; there is no pull and no range to record."""
    recording = simulated(boom_lift(duration=1.0, luffing=""))
    assert recording["boom_angle"].values[:, 0] == pytest.approx(math.radians(60), abs=1e-12)
    assert "luffing_pull" not in recording
    checks = {one.name: one for one in check_recording(recording)}
    assert "boom_angle_margin" not in checks
