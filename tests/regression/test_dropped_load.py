"""A load that ran away from its hoist, and a verdict of GO WITH WARNINGS.

An emergency stop threw in a brake that was weaker than what hung in the falls. 150 t fell 3.7 m to the
ground, `hoist_follows` warned that "motor or brake pull all they can", and the lift was a go with exit code
0. Within a second the fall was not even told.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario
from mechanics import G
from weak_hoist import DRUM, HOOK_BLOCK, PARTS, hanging

#: Mass of the load [kg]; what hangs; what the drum counts for at the hook, its rim being PARTS times as fast.
MASS = 2000.0
HANGS, TURNS = MASS + HOOK_BLOCK, DRUM * PARTS**2
STOP = 20.0  # s
PLAN = """\
{step: look, hold: 10 s}
{step: lower, lower: crane, speed: 6 m/min, emergency_stop_at: 20 s}"""


def checks_with(brake: float, duration: float) -> list[Check]:
    """Checks of the lift with an emergency stop by a brake of so many kN."""
    text = hanging(PLAN, MASS / 1e3, f"capacity: 20 kN, brake: {brake} kN", duration)
    return check_recording(gantline.simulate(parse_scenario(text)))


def follows(checks: list[Check]) -> Check | None:
    return next((one for one in checks if one.name == "hoist_follows"), None)


def deceleration(brake: float) -> float:
    """Of hook and load against the brake [m/s^2]."""
    return (PARTS * brake * 1e3 - HANGS * G) / (HANGS + TURNS)


@pytest.mark.parametrize("lasts", [0.8, 2.0])
def test_a_load_that_runs_away_fails(lasts: float) -> None:
    """It gains a t^2/2 on the speed that it had, a of (2.1 t x g - 2 x 8 kN)/(2.1 t + 2 t)."""
    checks = checks_with(8.0, STOP + lasts)
    found = follows(checks)
    assert found is not None and found.verdict is Verdict.FAILED
    assert found.time == pytest.approx(STOP, abs=1e-3)
    told = float(found.remark.split("runs away, ")[1].split(" m")[0])
    # To the rounding of what is told; the rope gives 20 kN / 36 MN x 13 m more or less.
    assert told == pytest.approx(-deceleration(8.0) * lasts**2 / 2.0, abs=0.015)
    assert verdict_of(checks).startswith("NO-GO")


def test_a_brake_that_takes_long_is_a_warning() -> None:
    """0.1 m/s over (2 x 10.4 kN - 2.1 t x g)/(2.1 t + 2 t): 2.1 s to rest, slower all the time."""
    found = follows(checks_with(10.4, STOP + 5.0))
    assert found is not None and found.verdict is Verdict.WARNING
    # To the rounding of what is told.
    lasted = float(found.remark.split("for ")[1].split(" s")[0])
    assert lasted == pytest.approx(0.1 / deceleration(10.4), abs=0.005)
    assert "runs away" not in found.remark


def test_a_brake_that_holds_is_no_matter() -> None:
    assert 0.1 / deceleration(13.0) < 0.1  # s
    assert follows(checks_with(13.0, STOP + 5.0)) is None
