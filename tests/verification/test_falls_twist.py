"""Hook blocks that the torque of their ropes turns: the law of the falls, and the check of lifts by hand.

The law is that of a rod on two slings, which is held against measurements in `tests/validation`.
"""

from __future__ import annotations

from math import asin, cos, hypot, sin
from pathlib import Path

import pytest
from scipy.optimize import brentq

import gantline
from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Statics
from of_recording import check_of, checks_of

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
TEXT = FILE.read_text(encoding="utf-8")
ROPE = "hoist_42: {construction: 6x36 IWRC,"
REEVING = (
    "{ropes: 2, parts_each: 8, rope: hoist_42, sheave_diameter: 1.0 m, sheave_efficiency: 0.98, "
    "upper_sheaves_at: 60 m}"
)
#: Upper sheaves less those of the hook block at the start [m]; the falls are plumb.
FALLS = 60.0 - (16.75 + 3.0)
DIAMETER = 0.042
NAME = "rope_torque_of_falls"


def lift(rope: str = "", reeving: str = REEVING, limit: str = "") -> Scenario:
    """The hoist with its rope, reeving and limits said otherwise."""
    assert ROPE in TEXT and REEVING in TEXT and "limits:\n" in TEXT
    text = TEXT.replace(ROPE, f"{ROPE} {rope}").replace(REEVING, reeving)
    return parse_scenario(text.replace("limits:\n", f"limits:\n{limit}"))


def at_rest(rope: str = "", reeving: str = REEVING, limit: str = "") -> Recording:
    """The same at rest with its load, which hangs clear."""
    return Statics(lift(rope, reeving, limit)).equilibrium().recording


def falls_check(recording: Recording) -> Check:
    (found,) = checks_of(recording, NAME)
    return found


def drop(angle: float, falls: list[float], length: float) -> float:
    """How far below its upper sheaves a hook block hangs that is turned by an angle [rad].

    Falls at these distances from the middle [m] share one rope, so that the sum of their lengths stays.
    """

    def excess(height: float) -> float:
        return sum(hypot(height, 2 * radius * sin(angle / 2)) - length for radius in falls)

    return float(brentq(excess, 0.5 * length, length, xtol=1e-14, rtol=1e-15))


@pytest.mark.parametrize("arm", [0.2, 0.6, 0.95])
def test_a_hook_block_turns_until_its_rise_takes_the_torque(arm: float) -> None:
    """(FT2) by virtual work: torque x turn = weight x rise, W cancels; six falls, two on each of three radii.

    (FT2) takes the falls to stay plumb; what that leaves out is of second order in radius over length.
    """
    radii, length = [0.5, 0.5, 0.6, 0.6, 0.7, 0.7], 40.0
    spread = sum(radius**2 for radius in radii) / len(radii)
    torque = arm * spread / length  # over the weight [m]

    def gives(angle: float) -> float:
        step = 1e-4
        rise = drop(angle - step, radii, length) - drop(angle + step, radii, length)
        return rise / (2 * step) - torque

    angle = float(brentq(gives, 0.0, 1.5, xtol=1e-12))
    # The derivative of asin at 0.95 is 3.2, and what is left out 2 (0.7/40)^2 of the sine.
    assert sin(angle) == pytest.approx(arm, rel=2 * (0.7 / 40.0) ** 2 + 1e-6)
    assert cos(angle) > 0.0


def test_the_falls_of_a_lift_against_a_sum_by_hand() -> None:
    """Sixteen falls on eight sheaves of 1 m, 84 mm apart: (FT3) and (FT4) number by number."""
    rows = [84e-3 * (place - 3.5) for place in range(8)]
    spread = 0.5**2 + sum(row**2 for row in rows) / 8
    assert spread == pytest.approx(0.25 + 0.084**2 * 63 / 12, rel=1e-12)
    found = falls_check(gantline.simulate(lift("torque_factor: 8 %,")))
    # The hook rises from where it starts, slings still slack.
    assert found.time == 0.0
    assert found.value == pytest.approx(0.08 * DIAMETER * FALLS / spread, rel=1e-9)
    assert found.verdict is Verdict.OK and found.limit == 1.0
    assert f"it turns by {asin(found.value or 0.0) * 57.29578:.0f} deg" in found.formula


def test_sheaves_farther_apart_hold_more() -> None:
    """The spread grows by s^2 (N^2 - 1)/12, from 84 to 200 mm.

    The rope over the upper sheaves is longer, and stretches by 0.2 % of 2 m more: 1e-5 of the falls.
    """
    narrow = falls_check(at_rest("torque_factor: 9 %,")).value
    wide = falls_check(
        at_rest("torque_factor: 9 %,", REEVING.replace("{ropes", "{sheave_spacing: 200 mm, ropes"))
    ).value
    assert narrow is not None and wide is not None
    ratio = (0.25 + 0.2**2 * 63 / 12) / (0.25 + 0.084**2 * 63 / 12)
    assert narrow / wide == pytest.approx(ratio, rel=5e-5)


@pytest.mark.parametrize("parts", [3, 5, 7])
def test_a_dead_end_on_the_hook_block_holds_nothing(parts: int) -> None:
    """Two thirds, four fifths, six sevenths of what one part less has: the shares of the rope makers' boards.

    With all sheaves in one place, which one sheave is; of more the rest of (FT3) is divided out.
    """
    one_rope = REEVING.replace("ropes: 2, parts_each: 8", f"ropes: 1, parts_each: {parts}")
    recording = at_rest("torque_factor: 9 %,", one_rope)
    sheaves = (parts - 1) // 2
    beside = 0.25 + 0.084**2 * (sheaves**2 - 1) / 12
    (hook,) = recording.rig.hooks
    assert hook.falls_spread / beside == pytest.approx((parts - 1) / parts, rel=1e-12)


def test_falls_that_twist_up_are_no_go() -> None:
    """At 27 % the ropes turn harder than falls of 39 m give back: 0.27 x 42 mm x 39.3 m / 0.287 m2 = 1.55.

    The sheaves start 40.25 m apart; the hook has come up by 0.95 m before the load hangs.
    """
    recording = at_rest("torque_factor: 27 %,")
    found = falls_check(recording)
    assert found.value == pytest.approx(1.553, abs=5e-4)
    assert found.verdict is Verdict.FAILED
    assert "it turns by" not in found.formula
    assert outcome_of(check_recording(recording)) is Outcome.NO_GO


def test_falls_on_the_way_there_warn() -> None:
    """Past half, or past a limit of the lift file."""
    assert falls_check(at_rest("torque_factor: 12 %,")).verdict is Verdict.WARNING
    asked = at_rest("torque_factor: 9 %,", limit=f"  {NAME}: 40 %\n")
    assert check_of(asked, NAME).verdict is Verdict.FAILED


def test_ropes_of_both_lays_hold_each_other() -> None:
    """One of left-hand and one of right-hand lay: no torque is left, whatever that of the ropes is."""
    both = REEVING.replace("{ropes", "{lay: left_and_right, ropes")
    found = falls_check(at_rest("torque_factor: 27 %,", both))
    assert found.value == 0.0 and found.verdict is Verdict.OK


def test_a_rope_of_six_strands_is_taken_as_they_usually_are() -> None:
    """No word where 8.9 % would do, and a warning where it would not: falls three times as long."""
    assert checks_of(at_rest(), NAME) == []
    high = REEVING.replace("upper_sheaves_at: 60 m", "upper_sheaves_at: 120 m")
    found = falls_check(at_rest(reeving=high))
    assert found.verdict is Verdict.WARNING and found.value is None
    assert "the torque factor of its rope is not known: hook" in found.remark
    assert "the falls of hook twist up: torque factor x diameter = 3.74 mm" in found.remark
