"""`gantline compare` of lifts alike but for rounding, whose table showed rounding as a difference.

A load that hangs still drifts by 1e-13 m in a run that paused and in one that did not; the table had
`+1.1e-13 m` and `+7.5e-14 deg`, as if B were another lift. The bound is that of all values alike, 1e-9 of
them, and where they are near nothing 1 mN, 1 nm, 1 ns and 1 nrad: ten million times the rounding of a number,
1.1e-16, which is what the steps of the longest runs add up to, and what statics is found to.
"""

from __future__ import annotations

import re

import numpy as np
import pytest

import gantline
from gantline.cli.comparison_table import comparison_table
from gantline.results.recording import Recording
from sample_lift import WEIGHT, sample_recording, sample_rig

TIME = np.linspace(0.0, 10.0, 101)
SAID = (
    "  Differences of no more than 1e-9 of a value, 1 mN of kN, 1 nm, 1 ns or 1 nrad are rounding: 0 above."
)


def lift(share: float = 0.0, tilt: float = 0.0) -> Recording:
    """The sample lift with a share more in each sling, and a tilt of its load [rad]."""
    tension = np.full((len(TIME), 5), WEIGHT / 5.0) * (1.0 + share)
    return sample_recording(TIME, rig=sample_rig(), tension=tension, tilt=np.full(len(TIME), tilt))


def told(other: Recording) -> list[str]:
    return comparison_table(gantline.compare(lift(), other), (None, None))


def cells(table: list[str], name: str) -> list[str]:
    (line,) = (one for one in table if one.startswith(f"  {name} "))
    return re.split(r"  +", line.strip())


@pytest.mark.parametrize(("share", "tilt"), [(1e-12, 0.0), (-1e-12, 1e-14), (0.0, 5e-10)])
def test_rounding_is_shown_as_alike(share: float, tilt: float) -> None:
    table = told(lift(share, tilt))
    assert cells(table, "sling.S1")[-3:] == ["0 kN", "0 kN", "-"]
    assert cells(table, "peak sling tension")[-2:] == ["0 kN", "0 %"]
    assert cells(table, "tilt of a load")[-2] == "0 deg"
    assert cells(table, "block")[1:] == ["0 mm", "0 mm", "-", "0 deg", "0 deg", "-"]
    assert SAID in table
    assert not re.search(r"e-1\d (kN|deg|mm|m|s)\b", "\n".join(table))


def test_more_than_rounding_is_shown() -> None:
    """1e-8 of WEIGHT/5 = 588.6 kN are 5.9 mN, and 2e-9 rad are 1.1e-7 deg."""
    table = told(lift(1e-8, 2e-9))
    assert cells(table, "sling.S1")[-3:] == ["5.9e-06 kN", "+5.9e-06 kN", "0.00 s"]
    assert cells(table, "tilt of a load")[-2] == "+1.1e-07 deg"
    assert cells(table, "block")[4:6] == ["1.1e-07 deg", "1.1e-07 deg"]


def test_the_same_lift_needs_no_bound() -> None:
    table = told(lift())
    assert cells(table, "sling.S1")[-3:] == ["0 kN", "0 kN", "-"]
    assert SAID not in table


def test_numbers_of_json_are_as_they_are() -> None:
    found = gantline.compare(lift(), lift(1e-12)).to_json()
    assert 0.0 < found["metrics"]["peak_sling_tension"]["difference"] < 1e-3
