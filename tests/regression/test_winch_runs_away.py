"""A winch of `mechanics` that is too weak for what hangs on it.

A motor of 10 kN under a pull of 50 kN let the load fall for 20 s; 1646 m of rope ran off, and neither
table nor exit code said a word: hoists of hooks were looked at, and no other drum.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict
from gantline.scenario import parse_scenario
from of_recording import checks_of
from winch_lift import winch_lift


def told(brake: str) -> list[Check]:
    recording = gantline.simulate(parse_scenario(winch_lift(brake)))
    return checks_of(recording, "winch_follows")


def test_a_load_that_runs_away_is_told() -> None:
    """From 0.1 m/s with (m g - F)/(m + I/r2) = (98.1 - 50) kN/12 t = 4.01 m/s2, for 2 s.

    Stretch changes by 1 mm meanwhile, 58 kN for 98 kN in 8 m more of rope, and centimetres are printed: 6 mm.
    """
    (check,) = told("50 kN")
    assert (check.element, check.verdict) == ("winch", Verdict.WARNING)
    assert check.remark.startswith(
        "from 10 s on, for 2 s, motor or brake pull all they can, and do not hold: "
    )
    run_out = float(check.remark.split("hold: ")[1].split(" m of rope")[0])
    assert run_out == pytest.approx(0.1 * 2.0 + 0.5 * 48.1e3 / 12e3 * 2.0**2, abs=0.006)


def test_a_brake_that_holds_says_nothing() -> None:
    """110 kN stop 0.1 m/s within 0.1 s."""
    assert told("110 kN") == []
