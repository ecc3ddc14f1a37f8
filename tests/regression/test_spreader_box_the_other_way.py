"""A bar whose box lies across its lugs had no thrust, and lugs metres off a spreader were in order.

Thrust was that along the longest side of the box. Of a bar of `size: [0.35 m, 9.4 m, 0.35 m]` with lugs at
x = +-4.5 m, two numbers in the other order, it was 0 kN of a limit of 100 kN, GO, where slings push it
together with 156 kN; and nobody was told that these lugs lie 4.3 m outside of the box. Of a frame what pushes
across its longer side was never looked at.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.checks import Verdict
from gantline.results.loads.spreaders import thrust
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from of_recording import checks_of
from spreader_lifts import BAR, LOAD, frame, one_bar

G = 9.81
ACROSS = one_bar(0.0).replace("size: [8.4 m, 0.4 m, 0.4 m]", "size: [0.4 m, 8.4 m, 0.4 m]")


def at_rest(text: str) -> Recording:
    return Statics(parse_scenario(text)).equilibrium().recording


def warnings(text: str) -> list[str]:
    return [one for one in assemble(parse_scenario(text)).warnings if "spreader" in one]


def test_thrust_is_that_of_the_slings() -> None:
    """(W + B)/2 tan a, (SP3), whichever way the box lies; past a limit it fails."""
    rules = "rules: {dynamic_amplification_factor: 1.1}\n"
    limited = ACROSS.replace("limits: {rule: yard", f"{rules}limits: {{rule: yard, spreader_thrust: 150 kN")
    recording = at_rest(limited)
    upper = recording.column("rope_tension", "sling.up_1")[-1]
    sine = 4.0 / (8.0 * (1.0 + upper / 100e6))
    by_hand = (LOAD + BAR) * G / 2 * sine / math.sqrt(1.0 - sine**2)
    assert thrust(recording, recording.rig.spreaders[0])[-1] == pytest.approx(by_hand, rel=1e-5)
    [check] = checks_of(recording, "spreader_thrust")
    assert check.verdict is Verdict.FAILED


def test_thrust_across_a_frame() -> None:
    """Four slings from the hook to lugs at x = +-4 m, y = +-2 m of a frame whose box is longest along y.

    Each bears (W + B)/4 upright and pulls 4/h of that along x, 2/h along y, h the height of the hook over
    the lugs: two of them together (W + B)/2 x 4/h along x, which is more.
    """
    text = frame().replace("size: [8.4 m, 4.4 m, 0.4 m]", "size: [8.4 m, 8.6 m, 0.4 m]")
    recording = at_rest(text)
    upper = recording.column("rope_tension", "sling.up_1")[-1]
    height = math.sqrt((8.0 * (1.0 + upper / 100e6)) ** 2 - 4.0**2 - 2.0**2)
    found = thrust(recording, recording.rig.spreaders[0])[-1]
    assert found == pytest.approx((LOAD + BAR) * G / 2 * 4.0 / height, rel=1e-5)


def test_lugs_off_the_box_are_told() -> None:
    """4 m - 0.2 m outside of the box."""
    assert not warnings(one_bar())
    [*told] = warnings(ACROSS)
    assert len(told) == 1
    assert "lugs A1, A2, B1, B2 of spreader bar lie up to 3.8 m outside of its box" in told[0]


def test_lugs_counted_from_an_end_are_told() -> None:
    """Of a bar of 8.4 m from its west end they are at 0.2 m and 8.2 m, 4 m beyond the end of the box."""
    text = one_bar(0.0)
    for height in ("0.2 m", "-0.2 m"):
        text = text.replace(f"[-4 m, 0 m, {height}], capacity: 60", f"[0.2 m, 0 m, {height}], capacity: 60")
        text = text.replace(f"[4 m, 0 m, {height}], capacity: 60", f"[8.2 m, 0 m, {height}], capacity: 60")
    [told] = warnings(text.replace("length: 6 m", "length: 12 m"))
    assert "lugs A2, B2 of spreader bar lie up to 4 m outside of its box" in told
