"""Warnings of a lift that its verdict passed over.

A sling that had been left out of the lift file, or a lug in mid-air, was GO as long as what was left held:
the first was not told at all, the second by a line that the verdict did not know of.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.checks import NO_WARNINGS, Verdict, check_recording, verdict_of
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario

STRONG = LIFT.replace("13.2 t", "40 t").replace("46 t", "90 t")
STRONG += "limits: {sling_factor_on_breaking_force: 3.0}\n"
SLING = "  D: {from: crane, to: module.D, length: 8.6 m, rope: sling}\n"
LEFT_OUT = STRONG.replace(SLING, "")
IN_MID_AIR = STRONG.replace("D: {at: [ 2.5 m, -1.5 m, 3 m]", "D: {at: [ 2.5 m, -1.5 m, 4.5 m]").replace(
    SLING, SLING.replace("8.6 m", "7.6 m")
)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (LEFT_OUT, "scenario.yaml:17: load.lugs.D: no sling leads to lug D"),
        (IN_MID_AIR, "scenario.yaml:17: load.lugs.D.at: lug D lies 1.5 m outside the load's box"),
    ],
    ids=["a sling left out", "a lug in mid-air"],
)
def test_a_lift_with_warnings_is_no_plain_go(text: str, told: str) -> None:
    recording = gantline.simulate(parse_scenario(text))
    assert recording.attributes["warnings"] == [told]
    checks = check_recording(recording)
    (found,) = (one for one in checks if one.name == NO_WARNINGS)
    assert (found.verdict, found.remark) == (Verdict.WARNING, told)
    assert verdict_of(checks).startswith("GO WITH WARNINGS")
    # On the first page it stands for itself: 'warning no warnings: ...' was no English.
    page = FirstPage().content(Subject(recording))
    assert page is not None
    assert {"about": "", "text": told} in page["verdict"]["warned"]


def test_a_lift_without_warnings_is_go() -> None:
    recording = gantline.simulate(parse_scenario(STRONG))
    assert recording.attributes["warnings"] == []
    assert verdict_of(check_recording(recording)).startswith("GO;")
