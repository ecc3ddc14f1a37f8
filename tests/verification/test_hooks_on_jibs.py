"""A hook on a jib beside the main hook of one boom, against geometry and moments.

The crane is that of `test_booms.py`. Its jib hook H2 hangs 12 m beyond the head and 5 m below the middle line
of the boom, at equation (BM6).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from boom_lift import (
    BELOW,
    BOW,
    HEEL,
    HOOK_BLOCK,
    LENGTH,
    SHEAVE_BLOCK,
    TACKLES,
    boom_lift,
    head,
    simulated,
    tackle,
    weight_moment,
)
from crawler_lift import GAUGE, crawler_lift, own_mass, own_moment
from crawler_lift import HOOK_BLOCK as CRAWLER_HOOK_BLOCK
from gantline.results.metrics import metrics_of
from mechanics import G
from of_recording import check_of

ALONG, ABOVE = 12.0, -5.0
HOOKS = f"""\
H1: {{type: H, height: 40 m}}
H2: {{type: H, along: {ALONG} m, above: {ABOVE} m, height: 60 m}}"""
HUNG = """\
L1: {parent: fc.H1, joint: {type: fixed}, mass: 300 t}
L2: {parent: fc.H2, joint: {type: fixed}, mass: 120 t}"""


def jib(angle: float) -> tuple[float, float]:
    """Place of the pin of H2 ahead of the base's origin and above it [m], equation (BM6)."""
    along = LENGTH + ALONG
    return (
        HEEL[0] + along * math.cos(angle) - ABOVE * math.sin(angle),
        HEEL[1] + along * math.sin(angle) + ABOVE * math.cos(angle),
    )


@pytest.mark.parametrize("angle", [75.0, 60.0, 45.0])
def test_a_hook_on_a_jib_hangs_where_geometry_has_it(angle: float) -> None:
    """Outreach and height of its pin turn with the boom about the heel pins, to rounding."""
    recording = simulated(boom_lift(angle=angle, duration=0.1, hooks=HOOKS, bodies=HUNG))
    for hook, (ahead, up) in (("fc.H1", head(math.radians(angle))), ("fc.H2", jib(math.radians(angle)))):
        assert recording.column("crane_radius", hook)[0] == pytest.approx(ahead - BOW, abs=1e-9)
        sheaves = recording.column("body_position", f"{hook}/upper_sheaves")
        assert sheaves[0, 2] + BELOW == pytest.approx(up, abs=1e-9)


def test_luffing_tackles_hold_both_hooks_by_moments() -> None:
    """Each mass pulls at its own lever, how far its pin is ahead of the heel pins: (BM3) with (BM6)."""
    recording = simulated(boom_lift(duration=2.0, start="rest", luffing=TACKLES, hooks=HOOKS, bodies=HUNG))
    angle = math.radians(60)
    main, on_jib = SHEAVE_BLOCK + HOOK_BLOCK + 300e3, SHEAVE_BLOCK + HOOK_BLOCK + 120e3
    moment = weight_moment(angle, main) + G * on_jib * (jib(angle)[0] - HEEL[0])
    assert recording["luffing_pull"].values[0, 0] == pytest.approx(moment / tackle(angle)[1], rel=1e-9)
    # The ropes begin with these lengths: the boom stands as the lift file has it.
    assert recording["boom_angle"].values[:, 0] == pytest.approx(angle, abs=1e-12)


LUFF_OUT = """\
{step: out, luff: fc, speed: 10 deg/min, to: 55 deg}
{step: up, hoist: fc.H2, speed: 3 m/min, to: 62 m}"""


def test_a_hook_is_hoisted_to_a_height_from_a_pin_that_the_boom_has_lowered() -> None:
    """Luffed from 60 to 55 deg the pin of H2 sinks by (BM6), and its hook too; the step makes up for it."""
    recording = simulated(boom_lift(LUFF_OUT, duration=210.0, hooks=HOOKS, bodies=HUNG))
    time, height = recording.time, recording.column("hook_height", "fc.H2")
    out, up = (end for end, _, _ in recording.events("step_end"))
    sunk = jib(math.radians(60))[1] - jib(math.radians(55))[1]
    assert sunk > 5.0
    # A load that swings by the 0.2 deg of the luffing on 60 m of falls is lifted by less than 1 mm of it.
    assert height[int(np.searchsorted(time, out))] == pytest.approx(60.0 - sunk, abs=5e-3)
    assert height[int(np.searchsorted(time, up))] == pytest.approx(62.0, abs=5e-3)


CRAWLER_HOOKS = """    hooks:
      H: {type: H, height: 30 m}
      A: {type: H, along: 4 m, above: -1.5 m, height: 40 m}
"""


def test_a_crawler_leans_on_its_tracks_by_each_hook_at_its_own_radius() -> None:
    """An empty hook block on the jib weighs on the tracks by its mass at its own radius.

    By moments about the middle of the tracks, boom to the left. On ground of 200 GN/m the crane leans by less
    than 2e-5 rad, which moves 25 m high masses by 0.5 mm of levers of 16 m and more.
    """
    text = crawler_lift(100e3, slew=90.0, ground=2e11)
    text = text.replace("    hooks:\n      H: {type: H, height: 30 m}\n", CRAWLER_HOOKS)
    recording = simulated(text)
    angle = float(recording["boom_angle"].values[-1, 0])
    radii = {hook: float(recording.column("crane_radius", f"c1.{hook}")[-1]) for hook in "HA"}
    apart = 4.0 * math.cos(angle) + 1.5 * math.sin(angle)
    assert radii["A"] - radii["H"] == pytest.approx(apart, abs=1e-3)
    moment = own_moment(16.0) + 100e3 * radii["H"] + CRAWLER_HOOK_BLOCK * radii["A"]
    corners = recording.rig.crawlers[0].corners
    forces = {corner: float(recording.column("contact_force", corner)[-1]) for corner in corners}
    left = math.fsum(force for corner, force in forces.items() if "left" in corner)
    right = math.fsum(force for corner, force in forces.items() if "right" in corner)
    # Each sheave block has 1 kg.
    assert left + right == pytest.approx((own_mass() + 100e3 + CRAWLER_HOOK_BLOCK + 2.0) * G, rel=1e-6)
    assert (left - right) * GAUGE / 2 == pytest.approx(moment * G, rel=1e-3)


def test_a_crawler_that_does_not_start_at_rest_stands_with_its_empty_jib_hook() -> None:
    """Already at the first sample the corners press with the moments of all that is on the crane.

    A hook block of 7 t on the jib, 5 m above the middle line of the boom, and one of 7 t and 1 kg under the
    head: by moments about the middle of the tracks, boom to the left, as above.
    """
    text = crawler_lift(CRAWLER_HOOK_BLOCK + 1.0, slew=90.0, ground=2e11, start="as_given")
    hooks = CRAWLER_HOOKS.replace("-1.5 m", "5 m")
    recording = simulated(text.replace("    hooks:\n      H: {type: H, height: 30 m}\n", hooks))
    radii = {hook: float(recording.column("crane_radius", f"c1.{hook}")[0]) for hook in "HA"}
    moment = own_moment(16.0) + (CRAWLER_HOOK_BLOCK + 1.0) * radii["H"] + CRAWLER_HOOK_BLOCK * radii["A"]
    crane = recording.rig.crawlers[0]
    left, right = (
        math.fsum(
            float(recording.column("contact_force", corner)[0]) for corner in crane.corners if side in corner
        )
        for side in ("left", "right")
    )
    assert (left - right) * GAUGE / 2 == pytest.approx(moment * G, rel=1e-3)


CHART = """\
    rating: {outreach: [20 m, 40 m, 60 m, 80 m], rated: [900 t, 800 t, 500 t, 300 t], hooks_share: 100 %}
"""


def _chart(outreach: float) -> float:
    """What the chart rates at an outreach [t]."""
    return float(np.interp(outreach, (20.0, 40.0, 60.0, 80.0), (900.0, 800.0, 500.0, 300.0)))


def test_hooks_at_two_places_of_a_boom_use_up_shares_of_their_own_rows() -> None:
    """350 t on the main hook and 170 t on the jib hook, each over what the chart rates at its outreach."""
    text = boom_lift(duration=2.0, hooks=HOOKS, bodies=HUNG).replace("    luffing:", CHART + "    luffing:")
    recording = simulated(text)
    outreach = {hook: float(recording.column("crane_radius", f"fc.{hook}")[-1]) for hook in ("H1", "H2")}
    shares = 350.0 / _chart(outreach["H1"]), 170.0 / _chart(outreach["H2"])
    metric = metrics_of(recording)["rating_utilisation.fc"]
    # Hook loads stay as they are to the 1e-5 by which falls stretch and ring.
    assert metric == pytest.approx(math.fsum(shares), rel=1e-4)
    check = check_of(recording, "hoist_load_of_rating")
    assert check.value == pytest.approx(math.fsum(shares), rel=1e-4)
    assert f"at {outreach['H1']:.2f} m and {outreach['H2']:.2f} m" in check.formula


def test_an_empty_hook_outside_of_the_chart_keeps_nothing_from_the_others() -> None:
    """At 44 deg the jib hook is at 84 m, where the chart ends at 80 m: empty it counts at the last row."""
    text = boom_lift(duration=2.0, angle=44.0, hooks=HOOKS, bodies=HUNG.splitlines()[0])
    recording = simulated(text.replace("    luffing:", CHART + "    luffing:"))
    outreach = {hook: float(recording.column("crane_radius", f"fc.{hook}")[-1]) for hook in ("H1", "H2")}
    assert outreach["H1"] < 80.0 < outreach["H2"]
    shares = 350.0 / _chart(outreach["H1"]) + 50.0 / 300.0
    assert metrics_of(recording)["rating_utilisation.fc"] == pytest.approx(shares, rel=1e-4)
