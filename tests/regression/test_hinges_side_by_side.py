"""`gantline compare` said nothing of hinges: a gripper that bore a tenth more stood in no table.

Ropes and hook loads of both lifts are compared over time, and what one of them has alone is named. The force
between a load and its hinge was left out, and a lift with a hinge beside one without told of no difference
but in its ropes.
"""

from __future__ import annotations

import pytest

from gantline.cli.comparison_table import comparison_table
from gantline.plot.comparison import comparison_figures
from gantline.results.comparison import compare
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from hinged_mast import FOOT, HEAD, MAST, WEIGHT, mast


def lying(*changes: tuple[str, str]) -> Recording:
    """The mast as it lies under its hook, with words changed."""
    text = mast("  - {step: hold, hold: 5 s}\n", hook=(19.0, 0.0, 60.0)).replace("900 s", "5 s")
    for old, new in changes:
        text = text.replace(old, new)
    return simulate(parse_scenario(text))


def test_what_the_hinge_bears_is_compared() -> None:
    """W (1 - 18/39) of 100 t and of 110 t, in a hinge of another name."""
    heavier = lying((f"{MAST} kg}}", f"{1.1 * MAST} kg}}"), ("hinges: {foot:", "hinges: {pins:"))
    comparison = compare(lying(), heavier)
    (hinge,) = comparison.hinges
    by_foot = WEIGHT * (1.0 - FOOT / HEAD)
    assert (hinge.name, hinge.name_b) == ("foot", "pins")
    assert (hinge.peak_a.value, hinge.peak_b.value) == pytest.approx((by_foot, 1.1 * by_foot), rel=1e-6)
    assert hinge.deviation is not None and hinge.deviation.rms == pytest.approx(0.1 * by_foot, rel=1e-6)
    lines = comparison_table(comparison, (None, None))
    (row,) = (line for line in lines if line.strip().startswith("foot | pins"))
    assert "528.2 kN" in row and "581.1 kN" in row
    assert comparison.to_json()["hinges"][0]["name_b"] == "pins"
    assert "compare_hinge_force" in dict(comparison_figures(comparison))


def test_a_hinge_that_one_has_alone_is_named() -> None:
    given = lying()
    hinges = "hinges: {foot: {at: [-20 m, 0 m, 1 m], axis: [0, 1, 0]}}"
    comparison = compare(given, lying((hinges, "")))
    assert comparison.hinges == [] and comparison.only_a == {"hinge": ["foot"]}
    assert "Only in A: hinges foot" in comparison_table(comparison, (None, None))
