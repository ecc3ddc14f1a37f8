"""A clearance of 0.4978 m failed its 0.5 m as `FAILED clearance_margin 0.00 m >= 0.00 m`.

The warning below said `comes within 0.50 m ..., below 0.5 m`, and the first page `0.50 m, at least 0.5 m`.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks import Check, Verdict
from gantline.cli.check_table import check_table
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results.loads.clearances import contact_warnings
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import Variable
from of_recording import checks_of

APART = np.array([[0.6], [0.4978], [0.7]])
RIG = {
    "watches": [{"name": "hull - wall", "between": ["hull", "wall"], "smallest": 0.5}],
    "limits": {"clearance_margin": 0.0},
}


def recording() -> Recording:
    variables = {
        "time": Variable(("time",), np.arange(3.0), "s", ""),
        "clearance": Variable(("time", "pair"), APART, "m", ""),
    }
    return Recording(variables, {"pair": ["hull - wall"]}, {"rig": RIG})


def test_a_clearance_that_is_short_by_millimetres() -> None:
    given = recording()
    (check,) = checks_of(given, "clearance_margin")
    assert check.verdict is Verdict.FAILED
    assert (check.shown(check.value), check.shown(check.limit)) == ("-0.002 m", "0.000 m")  # 0.4978 - 0.5
    table = check_table([check], "", style=str, width=100, full=False)
    assert any("-0.002 m  >= 0.000 m" in line for line in table)
    columns = {"time": given.time, "clearance": APART, "event_time": np.zeros(0)}
    names = {"pair": ["hull - wall"], "event_kind": [], "event_name": []}
    assert contact_warnings(Rig.from_json(RIG), columns, names) == [
        "hull comes within 0.498 m of wall at 1.00 s, below 0.5 m from 1.00 s on"
    ]
    (row,) = [text for name, text in attitude(Subject(given)) if name == "tightest clearance"]
    assert row == "hull - wall 0.498 m, at least 0.5 m, at 1.0 s"


@pytest.mark.parametrize(
    ("value", "limit", "shown"),
    [
        (1.0003, 1.0, ("100.03 %", "100.00 %")),
        (1.002, 1.0, ("100.2 %", "100.0 %")),
        (1.0, 1.0, ("100.0 %", "100.0 %")),  # not past it
        (0.9997, 1.0, ("100.0 %", "100.0 %")),
    ],
)
def test_what_is_past_its_limit_does_not_read_like_it(
    value: float, limit: float, shown: tuple[str, str]
) -> None:
    check = Check("lug_load_of_capacity", Verdict.OK, "", value=value, limit=limit, unit="%", digits=1)
    assert (check.shown(check.value), check.shown(check.limit)) == shown
