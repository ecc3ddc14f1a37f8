"""The reading of a load cell "at 100 %" was that of a load that a hinge held by half, or held down.

It is the mean of the first seconds in which the load is clear, of supports: a monopile of 1000 t was to show
591.1 t at 100 %, less than the 597.0 t at 50 %, and 847.7 t at 75 %. A mast of 100 t that its hook pulled
against its foot pins, never let go, was to show 658.3 t at 100 %. Whoever reads load cells stops by that
table. That of a load in a hinge at its hold points stands elsewhere, which was not said.
"""

from __future__ import annotations

import pytest

from gantline.report.carried import hook_row
from gantline.report.first_page import stop_if
from gantline.report.subject import ABSENT, Subject
from gantline.scenario import load_scenario, parse_scenario
from gantline.simulation import simulate
from hinged_mast import RAISE, mast
from reference_lift import ROOT


def readings(subject: Subject) -> list[str]:
    (hook,) = subject.rig.hooks
    row: list[str] = hook_row(subject, hook)["readings"]
    return row


def test_a_load_that_is_never_let_go_has_none() -> None:
    assert readings(Subject(simulate(parse_scenario(mast(RAISE))))) == [ABSENT] * 4


def test_readings_go_by_what_has_come_over() -> None:
    """95.5 t of hook block, falls and half of the slings, and shares of 1002.9 t, pile and other half.

    With the hinge shut there is none at 75 % and 100 %.
    """
    lift = load_scenario(ROOT / "scenarios/monopile/scenario.yaml")
    subject = Subject(simulate(lift.changed({"duration": "800 s"})))
    quarter, half, *rest = readings(subject)
    assert (float(quarter), float(half)) == pytest.approx((346.2, 597.0), rel=5e-4)
    assert rest == [ABSENT, ABSENT]
    assert stop_if(subject)[0].endswith(
        "in the table “Hooks”, as pile turns from those under “Hooks at hold points”"
    )
