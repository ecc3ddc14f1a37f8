"""Booms in their luffing tackles against moments about the heel pins.

The crane is a sheerleg of 3600 t: heel pins 98 m ahead of the stern and 9 m above the keel, boom of 110 m and
1500 t with its centre at 48 %, head gear of 140 t, A-frame top 70 m ahead and 62 m up, bow at 105.6 m.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from boom_lift import (
    BOOM,
    BOOM_INERTIA,
    CENTRE,
    HOOK_BLOCK,
    LENGTH,
    SHEAVE_BLOCK,
    TACKLES,
    boom_afloat,
    boom_lift,
    simulated,
    tackle,
    weight_moment,
)
from gantline.results.rotation import axes
from gantline.scenario import parse_scenario
from gantline.statics import Statics

ROW = "\n".join(
    f"H{n}: {{type: H, across: {y} m, height: 40 m}}" for n, y in enumerate((-11.25, -3.75, 3.75, 11.25))
)


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
    recording = simulated(boom_afloat(4.18, 1.46, luffing=TACKLES, start="rest"))
    along = axes(recording.column("body_orientation", "fc.boom")[0])[:, 0]
    horizon = math.asin(along[2])
    angle = float(recording["boom_angle"].values[0, 0])
    assert abs(horizon - angle) > math.radians(0.1)  # it does trim
    # The stretch was taken up for the trim of the lift file; that of the equilibrium changes it a little.
    assert angle == pytest.approx(math.radians(60), abs=2e-5)
    moment = weight_moment(horizon, SHEAVE_BLOCK + HOOK_BLOCK + 300e3)
    assert recording["luffing_pull"].values[0, 0] == pytest.approx(moment / tackle(angle)[1], rel=1e-9)
