"""A dynamic factor of 8.7 in the table of a run, of a hook that had let a load down to turn it.

A load of 20 t is turned by 54 deg between two hooks. The tailing hook bore 91 kN as it was lifted off and
12 kN in the hold at the end; its peak of 107 kN over these 12 kN stood in the column `dynamic factor` of
`gantline run` as 8.745, while the check `hook_dynamic_factor` says of the same hook that nothing tells what
of its peak is static.
"""

from __future__ import annotations

import gantline
from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.scenario import parse_scenario
from hooked_lift import turned_by_two_hooks

HOLD = "  - {step: rest, hold: 20 s}\n"


def test_the_table_has_no_factor_where_the_check_has_none() -> None:
    recording = gantline.simulate(parse_scenario(turned_by_two_hooks(HOLD)))
    checks = check_recording(recording)
    (of_check,) = (one for one in checks if one.name == "hook_dynamic_factor")
    assert of_check.element == "main" and of_check.remark.endswith("a hold there does: tail")
    rows = [line.split() for line in summary(recording, checks, str) if " hook load " in line]
    factors = {row[0]: row[-2] for row in rows if row[1:3] == ["hook", "load"] and row[0] in ("main", "tail")}
    assert factors["tail"] == "-" and of_check.value is not None
    assert float(factors["main"]) == round(of_check.value, 3)
