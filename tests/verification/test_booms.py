"""Booms, hooks at their heads, and luffing, against geometry and moments about the heel pins.

The crane is a sheerleg of 3600 t: heel pins 98 m ahead of the stern and 9 m above the keel, boom of 110 m and
1500 t with its centre at 48 %, head gear of 140 t, A-frame top 70 m ahead and 62 m up, bow at 105.6 m.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from boom_lift import BELOW, BOW, HEEL, LENGTH, boom_lift
from gantline import Simulation
from gantline.results import Recording
from gantline.scenario import parse_scenario


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
