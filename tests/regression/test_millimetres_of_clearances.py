"""A margin of 4 mm read `0.00 m` in tables and on the first page, beside a limit of 50 mm."""

from __future__ import annotations

import numpy as np

from gantline.checks import LIMITS
from gantline.checks.check import Check, Verdict
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.variable import Variable


def test_a_margin_below_a_metre_has_millimetres() -> None:
    measure = LIMITS["clearance_margin"]

    def shown(value: float) -> tuple[str, str]:
        check = Check("clearance_margin", Verdict.OK, measure.meaning, value=value, limit=0.0)
        check = Check(**{**vars(check), "unit": measure.unit, "digits": measure.digits, "at_least": True})
        return check.shown(check.value), check.shown(check.limit)

    assert shown(0.004) == ("0.004 m", "0.000 m")
    assert shown(2.5) == ("2.50 m", "0.00 m")


def test_so_has_the_tightest_clearance_of_the_first_page() -> None:
    variables = {
        "time": Variable(("time",), np.arange(2.0), "s", ""),
        "clearance": Variable(("time", "pair"), np.array([[0.3], [0.054]]), "m", ""),
    }
    rig = {"watches": [{"name": "hull - wall", "between": ["hull", "wall"], "smallest": 0.05}]}
    rows = attitude(Subject(Recording(variables, {"pair": ["hull - wall"]}, {"rig": rig})))
    assert ("tightest clearance", "hull - wall 0.054 m, at least 0.05 m, at 1.0 s") in rows
