"""The ship of `heavy_lift_ship` leads its reactor over the deck: at rest on the way, by hand."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.results.recording import Recording
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import led_hooks, pose_before, way_of
from gantline.scenario.plan.positions import places_of_cranes
from mechanics import G

FOLDER = Path(__file__).parents[2] / "scenarios" / "heavy_lift_ship"
#: EA of a hoist rope of 54 mm, 6x36 IWRC, as `gantline check` lists it [N]; parts and tackles of a boom.
STIFF, PARTS, TACKLES = 134.1e6, 18, 2
#: The rope from the last sheave at the top down to the drum [m].
LEAD_LINE = 5.0
#: Way of the step, its speed and acceleration.
WAY, SPEED, ACCELERATION = 20.85, 1.2 / 60.0, 0.002
#: Shares of the way that are looked at.
SHARES = (0.0, 0.5, 1.0)


@cache
def asked() -> gantline.Statics:
    """The lift, which goes on from one share of the way to the next."""
    return gantline.Statics(FOLDER)


@cache
def at_rest(share: float) -> Recording:
    """The equilibrium where that share of the way has been gone, the pumps going on alongside."""
    statics = asked()
    begin = statics.when("over the deck", "begins")
    assert begin is not None
    ramp = SPEED / ACCELERATION
    wait = {0.0: 0.0, 1.0: WAY / SPEED + ramp}.get(share, share * WAY / SPEED + ramp / 2)
    return statics.equilibrium(begin + wait).recording


def test_drives_are_where_inverse_kinematics_has_them() -> None:
    """By plane trigonometry: slew atan2, radius, angle of the boom and rope of its tackles, hook by the head.

    Amid the way sigma goes evenly, and has gone v (t - v/2a) of 20.85 m.
    """
    share = 0.5
    recording = at_rest(share)
    reach, out = math.hypot(4.5, 30.0), math.atan2(30.0, -4.5)
    start = math.radians(44.509)

    def tackle(angle: float) -> float:
        return math.sqrt(reach**2 + 44.0**2 - 2 * reach * 44.0 * math.cos(out - angle))

    for crane, begins in (("fore", 115.463), ("aft", 64.537)):
        radius, slew = 3.5 + 44.0 * math.cos(start), math.radians(begins)
        x, y = radius * math.cos(slew), radius * math.sin(slew) - share * WAY
        boom = math.acos((math.hypot(x, y) - 3.5) / 44.0)
        drum = recording.column("joint_position", f"{crane}.boom.drum")[-1]
        assert recording.column("slew_angle", crane)[-1] == pytest.approx(math.atan2(y, x), abs=1e-11)
        assert drum == pytest.approx(tackle(start) - tackle(boom), abs=1e-10)


def test_tackles_that_stretch_let_the_boom_down() -> None:
    """(LD10) against the angle that the winch asks for, at the beginning, amid the way and at its end.

    The ropes have the length with which they hold boom and hook block at the start, without a load: of that S
    is less. What the winch takes up is wound with its stretch, by trapezoids over three places. 3 %
    for these and for the curve of the arc.
    """
    scenario = asked().scenario
    place = [step.step for step in scenario.plan].index("over the deck")
    step, before = scenario.plan[place], places_of_cranes(scenario)[place]
    assert isinstance(step, LeadStep)
    hooks = led_hooks(scenario, step)
    way = way_of(step, hooks, before)
    for index, led in enumerate(hooks):
        gear = led.boom.gear
        assert gear is not None
        # Boom at 45 %, head gear, sheave block, hook block and falls (BM3), at the start.
        first = math.radians(44.509)
        borne = (120e3 * 0.45 + 20e3 + 32e3 + 8.5e3) * 44.0 * math.cos(first) * G
        unloaded = borne / (gear.rate(first, first) * TACKLES * PARTS)
        wound, last = 0.0, (0.0, 0.0)
        for share in SHARES:
            *_, pose = way.poses(index, led, pose_before(led, before), np.linspace(0.0, share, 9).tolist())
            pull = at_rest(share).column("luffing_pull", led.crane)[-1] / (TACKLES * PARTS)
            taken_up = gear.taken_up(pose.angle)
            wound += (taken_up - last[0]) * ((pull + last[1]) / 2 - unloaded) / STIFF if share else 0.0
            last = taken_up, pull
            longer = (gear.distance(pose.angle) + LEAD_LINE / PARTS) * (pull - unloaded) / STIFF + wound
            sinks = longer / gear.rate(pose.angle, pose.angle)
            assert sinks > math.radians(0.01)
            found = at_rest(share).column("boom_angle", led.crane)[-1]
            assert pose.angle - found == pytest.approx(sinks, rel=0.03)


def test_shares_stay_all_the_way() -> None:
    """(LD9): 640 t with its centre of gravity 0.6 m from the middle of 20 m, and 2 t of slings on both."""
    for share in SHARES:
        recording = at_rest(share)
        loads = [recording.column("hook_load", f"{crane}.H")[-1] for crane in ("fore", "aft")]
        wanted = [640e3 * G * part for part in (10.6 / 20.0, 9.4 / 20.0)]
        rigging = sum(loads) - sum(wanted)
        assert 2.0e3 * G < rigging < 4.6e3 * G
        assert loads == pytest.approx([one + rigging / 2 for one in wanted], rel=1e-3)


def test_falls_are_plumb_and_the_ship_upright_all_the_way() -> None:
    """Both heads are equally high, so that heel leaves falls plumb; pumps keep her within 0.5 deg."""
    for share in SHARES:
        recording = at_rest(share)
        assert recording["falls_out_of_plumb"].values[-1].max() < math.radians(0.02)
        assert abs(recording.column("vessel_heel", "ship")[-1]) < math.radians(0.5)
