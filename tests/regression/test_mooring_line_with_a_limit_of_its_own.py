"""A mooring line within the limit that its lift file sets for it warned by a rule for slings.

`mooring_tension_of_breaking_force: 50 %` allows a factor of 2 on the breaking force. A line at 46 %, a
factor of 2.16, was `ok` there, and a warning of `rope_factor_on_breaking_force`, since 0027/ND has 2.3
for slings at least: a lift off a barge was GO WITH WARNINGS, "past a limit that only warns", in a sea in
which all limits of its file were kept.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from moored_by_springs import MOORED


def checks(lift: str) -> dict[str, Check]:
    return {check.name: check for check in check_recording(simulate(parse_scenario(lift)))}


def test_it_is_held_against_its_own_limit_alone() -> None:
    found = checks(MOORED + "limits: {mooring_tension_of_breaking_force: 50 %}\n")
    tension, factor = found["mooring_tension_of_breaking_force"], found["rope_factor_on_breaking_force"]
    assert tension.value is not None
    assert tension.value == pytest.approx(0.46)
    assert tension.verdict is Verdict.OK
    assert factor.value == pytest.approx(1.0 / tension.value)
    assert factor.verdict is Verdict.OK


def test_without_one_it_warns() -> None:
    factor = checks(MOORED)["rope_factor_on_breaking_force"]
    assert factor.verdict is Verdict.WARNING
    assert factor.limit == 2.3
