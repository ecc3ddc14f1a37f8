"""Booms, hooks at their heads, and luffing, against geometry and moments about the heel pins.

The crane is a sheerleg of 3600 t: heel pins 98 m ahead of the stern and 9 m above the keel, boom of 110 m and
1500 t with its centre at 48 %, head gear of 140 t, A-frame top 70 m ahead and 62 m up, bow at 105.6 m.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from boom_lift import (
    A_FRAME,
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
    boom_lift,
)
from gantline import Simulation
from gantline.checks import check_recording
from gantline.results import Recording
from gantline.results.rotation import axes
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study.inclining import metacentric_heights


def simulated(text: str) -> Recording:
    return Simulation(parse_scenario(text)).run()


def head(angle: float) -> tuple[float, float]:
    """Ahead of the base's origin and above it [m]."""
    return HEEL[0] + LENGTH * math.cos(angle), HEEL[1] + LENGTH * math.sin(angle)


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


def tackle(angle: float) -> tuple[float, float, float]:
    """Of a tackle at an angle its length d, the lever of its pull, -dd/dangle [m], and d2d/dangle2 [m]."""
    back, up = A_FRAME[0] - HEEL[0], A_FRAME[1] - HEEL[1]
    ahead, high = LENGTH * math.cos(angle), LENGTH * math.sin(angle)
    length = math.hypot(ahead - back, high - up)
    lever = (ahead * up - high * back) / length
    # d2 = a2 + L2 - 2 a.h, so d d' = -a.h' and d d'' = a.h - d'^2
    return length, lever, (ahead * back + high * up - lever**2) / length


ROW = "\n".join(
    f"H{n}: {{type: H, across: {y} m, height: 40 m}}" for n, y in enumerate((-11.25, -3.75, 3.75, 11.25))
)


#: Of boom and head gear about the heel pins [kg m^2].
BOOM_INERTIA = 1.51e9 + BOOM * (CENTRE * LENGTH) ** 2 + HEAD_GEAR * LENGTH**2


def weight_moment(angle: float, on_head: float) -> float:
    """Moment of boom, head gear and a further mass [kg] at the head about the heel pins [N m]."""
    return 9.81 * math.cos(angle) * LENGTH * (CENTRE * BOOM + HEAD_GEAR + on_head)


def test_pull_of_the_tackles_is_that_of_moments_about_the_heel_pins() -> None:
    """Head gear, hook blocks and falls of 460 t at the head and 1096 t on the hooks: about 2090 t by hand.

    Here: head gear 140 t, four sheave blocks of 8 t, hook blocks of 50 t, and 296 t on each hook.
    """
    hung = "\n".join(f"L{n}: {{parent: fc.H{n}, joint: {{type: fixed}}, mass: 296 t}}" for n in range(4))
    recording = simulated(boom_lift(duration=2.0, start="rest", luffing=TACKLES, hooks=ROW, bodies=hung))
    pull = recording["luffing_pull"].values[:, 0]
    angle = math.radians(60)
    on_head = 4 * (SHEAVE_BLOCK + HOOK_BLOCK + 296e3)
    # Each tackle runs in a plane along the boom, so that all have one lever.
    expected = weight_moment(angle, on_head) / tackle(angle)[1]
    assert pull[0] == pytest.approx(expected, rel=1e-9)
    assert pull[0] / 9810 == pytest.approx(2090, rel=1e-3)
    # It stands where the lift file has it, and stays there: lengths are those under this pull.
    assert recording["boom_angle"].values[:, 0] == pytest.approx(angle, abs=1e-12)
    tension = recording["rope_tension"].values[0]
    names = list(recording.coordinates["rope"])
    luffing = [tension[names.index(f"luff.fc.{n}")] for n in range(1, 5)]
    assert luffing == pytest.approx([expected / 64] * 4, rel=1e-9)


@pytest.mark.parametrize("parts", [1, 7, 16])
def test_parts_of_line_share_the_pull_whether_even_or_odd(parts: int) -> None:
    """All parts of one tackle together have the moment of the weights, wherever its dead end is."""
    luffing = TACKLES.replace("parts: 16", f"parts: {parts}").replace("count: 4", "count: 1")
    recording = simulated(boom_lift(duration=0.1, start="rest", luffing=luffing))
    on_head = SHEAVE_BLOCK + HOOK_BLOCK + 300e3
    expected = weight_moment(math.radians(60), on_head) / tackle(math.radians(60))[1]
    assert recording.column("rope_tension", "luff.fc.1")[0] * parts == pytest.approx(expected, rel=1e-9)


OUT_AND_BACK = """\
{step: out, luff: fc, speed: 10 deg/min, to: 55 deg}
{step: back, luff: fc, speed: 10 deg/min, by: 3 deg}
{step: stand, hold: until_end}"""


def test_the_drum_supplies_what_the_geometry_asks_for() -> None:
    """Ropes that hardly stretch: 60 deg to 55 deg and 3 deg back, each as long as angle over speed."""
    recording = simulated(
        boom_lift(OUT_AND_BACK, duration=100.0, luffing=TACKLES, luff_stiffness=1e6, start="rest")
    )
    angle = recording["boom_angle"].values[:, 0]
    # 64 parts of 1e6 MN give 2e-5 m under 1100 t, over a lever of 60 m: 3e-7 rad.
    assert angle[-1] == pytest.approx(math.radians(58), abs=1e-6)
    ends = [time for time, _, _ in recording.events("step_end")]
    # 5 deg at 10 deg/min, and the ramps: 10 deg/min / 0.05 deg/s2, half of it at either end.
    ramp = 10 / 60 / 0.05
    assert ends[:2] == pytest.approx([30 + ramp, 30 + ramp + 18 + ramp], rel=1e-9)
    at = int(np.searchsorted(recording.time, ends[0]))
    assert angle[at] == pytest.approx(math.radians(55), abs=2e-6)


def test_a_boom_in_tackles_stretches_them_as_it_comes_down() -> None:
    """At 55 deg the pull is higher than at 60 deg: the boom stands lower than the drum counts.

    Rope that was paid out under a strain e had the length 1/(1 + e) of what the drum let go, so that with the
    tensions of start and end the unstretched length is known to the change of tension on the way:
    n d + l = L (1 + T/EA), L from L0 by n (d55 - d60)/(1 + T/EA), T between those of start and end.
    """
    recording = simulated(
        boom_lift(OUT_AND_BACK.splitlines()[0], duration=300.0, luffing=TACKLES, start="rest", damping="1 s")
    )
    angle = float(recording["boom_angle"].values[-1, 0])
    pull = recording["luffing_pull"].values[:, 0]
    strains = pull[[0, -1]] / 64 / 238e6
    start, planned = tackle(math.radians(60))[0], tackle(math.radians(55))[0]
    first = (16 * start + 5.0) / (1 + strains[0])
    lengths = [first + 16 * (planned - start) / (1 + strain) for strain in strains]
    ends = [(length * (1 + strains[1]) - 5.0) / 16 for length in lengths]
    # Lower by 0.01 deg, a stretch of 11 mm; what the swing of the load leaves is below 0.1 mm.
    assert min(ends) - 1e-4 < tackle(angle)[0] < max(ends) + 1e-4
    assert 1e-4 < math.radians(55) - angle < 3e-4


def test_luffing_in_tackles_keeps_the_books() -> None:
    """The boom comes down: the winch takes what gravity gives, less what ropes keep and lose."""
    recording = simulated(boom_lift(OUT_AND_BACK, duration=100.0, luffing=TACKLES, start="rest"))
    assert recording.metrics()["energy_remainder"] < 1e-9


LIGHT = boom_lift(duration=1.0, start="rest", luffing=TACKLES).replace("mass: 50 t", "mass: 1 t")
LIGHT = LIGHT.replace("sheave_block_mass: 8 t", "sheave_block_mass: 1 kg").replace(
    "mass: 300 t", "mass: 100 kg"
)


def test_the_boom_on_its_tackles_is_a_spring_and_a_mass() -> None:
    """omega^2 = K/I, K the second derivative of the energy of ropes and weights over the angle.

    K = 4 [k (n d')^2 + T n d''] - sum m g h, k = EA/L of a rope with n parts of length d, heights h over the
    heel pins; I of boom, head gear, and of the hook what its falls take along, up and down.
    """
    angle = math.radians(60)
    length, lever, curve = tackle(angle)
    hook, sheave_block = 1.1e3, 1.0
    moment = weight_moment(angle, hook + sheave_block)
    tension = moment / lever / 64
    rope = (16 * length + 5.0) / (1 + tension / 238e6)
    stiffness = 4 * (238e6 / rope * (16 * lever) ** 2 + tension * 16 * curve) - moment * math.tan(angle)
    inertia = BOOM_INERTIA + hook * (LENGTH * math.cos(angle)) ** 2 + sheave_block * LENGTH**2
    expected = stiffness / inertia
    statics = Statics(parse_scenario(LIGHT))
    statics.equilibrium(0.0)
    modes = statics.modes()
    nearest = min((mode.square for mode in modes), key=lambda one: abs(one - expected))
    # The hook of 1.1 t stretches its own falls, which give 1e-4 of its share, 4e-4, of the inertia; its
    # pendulum of 0.06 Hz is far off.
    assert nearest == pytest.approx(expected, rel=1e-5)


def afloat(draft: float, trim: float, **rest: str) -> str:
    """The crane on its vessel, with the middle of its waterline at x = 0."""
    turn = math.radians(trim)
    stern = -(105.6 / 2 * math.cos(turn) - draft * math.sin(turn))
    vessel = f"""\
vessels:
  barge:
    position: [{stern!r} m, 0 m]
    draft: {draft} m
    trim: {trim} deg
    hull: {{box: [105.6 m, 46 m, 7.5 m]}}
    masses: {{all: {{mass: 18852 t, at: [39 m, 0 m, 5 m]}}}}
    radii_of_gyration: [15 m, 28.5 m, 30 m]
"""
    return boom_lift(duration=0.1, base="    vessel: barge\n", more=vessel, **rest)  # type: ignore[arg-type]


def test_the_head_comes_down_and_ahead_as_the_vessel_comes_to_even_keel() -> None:
    """From 1.46 deg by the stern at 4.18 m to even keel at 4.40 m: 2.55 m ahead and 2.78 m down.

    Hand figures of small angles about the middle of the waterline: 100 m above it and 100.2 m ahead of it,
    0.0255 rad, and 0.22 m of sinking; the turn itself is within 0.04 m of them.
    """
    before, after = (simulated(afloat(draft, trim)) for draft, trim in ((4.18, 1.46), (4.40, 0.0)))
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
    text = afloat(4.27, 0.0).replace("[39 m, 0 m, 5 m]", "[44.4564 m, 0 m, 5 m]")
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


LOST = """\
{step: hold, hold: 2 s}
{step: lost, hold: until_end, cut: bond}"""


def test_a_boom_that_loses_its_load_goes_up_against_its_stops() -> None:
    """2500 t on a rope that is cut: the boom springs up, its tackles go slack, the stop is at 60.05 deg.

    Tackles that hold the boom alone at 60 deg have no stretch left 0.05 deg higher. In the
    end the boom hangs in them again, at 60 deg.
    """
    hung = "hung: {at: [153 m, 0 m, 10 m], joint: {type: point}, mass: 2500 t}"
    route = "[{type: end, body: fc.H1}, {type: end, body: hung}]"
    bond = f"  ropes:\n    bond: {{rope: luff, length: as_routed, route: {route}}}\n"
    luffing = TACKLES.replace("80 deg", "60.05 deg")
    text = boom_lift(LOST, duration=30.0, start="rest", luffing=luffing, bodies=hung, ropes=bond)
    recording = simulated(text.replace("sample_interval: 0.1 s", "sample_interval: 2 ms"))
    slack = min(time for time, _, name in recording.events("slack") if name == "luff.fc.1")
    hit, _, name = recording.events("stop_hit")[0]
    assert 2.0 < slack < hit and name == "fc.boom"
    angle = recording["boom_angle"].values[:, 0]
    speed = np.gradient(angle, recording.time)
    at, turning = (float(np.interp(slack, recording.time, values)) for values in (angle, speed))
    length, lever, _ = tackle(math.radians(60))
    tension = weight_moment(math.radians(60), SHEAVE_BLOCK + HOOK_BLOCK) / lever / 64
    free = math.radians(60) + (length + 5.0 / 16) * tension / 238e6 / lever
    # Slack is where k (e + 10 ms de/dt) is zero; the lever changes by 1e-3 over the 8e-4 rad from 60 deg.
    assert at + 0.01 * turning == pytest.approx(free, abs=2e-6)
    # The stop, 0.001 rad under the level boom, takes at most the energy with which boom and hook arrive.
    stiffness = 9.81 * BOOM * CENTRE * LENGTH / 1e-3
    inertia = BOOM_INERTIA + (SHEAVE_BLOCK + HOOK_BLOCK) * LENGTH**2
    fastest = float(speed.max())
    most = fastest * math.sqrt(inertia / stiffness)
    assert math.radians(60.05) + most / 3 < angle.max() < math.radians(60.05) + most
    # What is left of the swing after 27 s is 0.01 deg.
    assert angle[-1] == pytest.approx(math.radians(60), abs=math.radians(0.01))
    assert recording.metrics()["energy_remainder"] < 1e-9


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


def test_rope_weight_of_tackles_hangs_half_at_the_head() -> None:
    """21.2 kg/m in 64 parts of 93 m: half of it at the head, with its moment in the pull."""
    text = boom_lift(duration=0.1, start="rest", luffing=TACKLES)
    text = text.replace("mass: none, diameter: 72 mm", "mass: 21.2 kg/m, diameter: 72 mm")
    recording = simulated(text)
    angle = math.radians(60)
    length, lever, _ = tackle(angle)
    # Halves of each part at either end; 16 parts end 16 times at the head, and the lengths are unstretched.
    pull = recording["luffing_pull"].values[0, 0]
    strain = pull / 64 / 238e6
    at_head = 4 * 16 * (length / 2) * 21.2 / (1 + strain)
    on_head = SHEAVE_BLOCK + HOOK_BLOCK + 300e3 + at_head
    # Masses were put with the routed length, a strain of 7e-4 longer than the rope, of 63 t in 2000 t.
    assert pull == pytest.approx(weight_moment(angle, on_head) / lever, rel=5e-5)


def test_pull_on_a_vessel_is_that_of_its_trim() -> None:
    """At rest afloat the boom stands at its angle and the trim over the horizon, where moments are taken."""
    recording = simulated(afloat(4.18, 1.46, luffing=TACKLES, start="rest"))
    along = axes(recording.column("body_orientation", "fc.boom")[0])[:, 0]
    horizon = math.asin(along[2])
    angle = float(recording["boom_angle"].values[0, 0])
    assert abs(horizon - angle) > math.radians(0.1)  # it does trim
    # The stretch was taken up for the trim of the lift file; that of the equilibrium changes it a little.
    assert angle == pytest.approx(math.radians(60), abs=2e-5)
    moment = weight_moment(horizon, SHEAVE_BLOCK + HOOK_BLOCK + 300e3)
    assert recording["luffing_pull"].values[0, 0] == pytest.approx(moment / tackle(angle)[1], rel=1e-9)
