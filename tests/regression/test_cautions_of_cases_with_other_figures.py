"""`gantline cases` said one caution five times, with 33.5, 33.6 and 33.7 deg in it.

What is to be known of a check stood below the table once for each figure in it: how far slings lean is
another one in every case that changes their lengths. It stands once, with the least and the most.
"""

from __future__ import annotations

import math

from gantline.cli.cases_table import cases_table
from gantline.scenario import parse_scenario
from gantline.study import run_cases
from module_on_a_barge import LIFT

CASES = """
limits: {lug_out_of_plane_angle: 40 deg}
cases:
  longer: {set: {sling_defaults.length: 8.8 m}}
  longest: {set: {sling_defaults.length: 8.9 m}}
"""
#: How far lugs are from the middle of the module, level [m].
ASIDE = math.hypot(3.0, 2.0)


def lean(length: float) -> float:
    """Angle of four slings of a length [m] that carry 60 t, their stretch in it: asin(a/l) [deg]."""
    plumb = math.sqrt(length**2 - ASIDE**2)
    tension = 60e3 * 9.81 / 4 * length / plumb
    return math.degrees(math.asin(ASIDE / (length * (1.0 + tension / 60e6))))


def test_a_caution_stands_once() -> None:
    text = LIFT.replace("PULL", "pretension: 20 kN, type: spring") + CASES
    table = cases_table(run_cases(parse_scenario(text), 0.0), width=400, variants=False)
    (said,) = [line for line in table if "by which slings lean" in line]
    assert f"the {lean(8.9):.1f} to {lean(8.7):.1f} deg by which slings lean" in said
    assert said.endswith("module.A, module.B, module.C and 1 more: everywhere")
