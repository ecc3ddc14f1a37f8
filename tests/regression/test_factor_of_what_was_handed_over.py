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
from hooked_lift import hooked_lift

HOOKS = {"main": (0.0, 2.6, 13.0), "tail": (0.0, -3.2, 11.0)}
LUGS = {"A": (-2.2, 2.6, 3.0), "B": (2.2, 2.6, 3.0), "C": (-2.2, -3.0, 0.8), "D": (2.2, -3.0, 0.8)}
SLINGS = {
    "A": ("main", "A", 10.3),
    "B": ("main", "B", 10.3),
    "C": ("tail", "C", 10.5),
    "D": ("tail", "D", 10.5),
}
PLAN = """\
ground: {friction: 0.5}
plan:
  - {step: lift, hoist: [main, tail], speed: 0.1 m/s, by: 4 m}
  - {step: turn, lower: tail, speed: 0.1 m/s, by: 3 m}
  - {step: on, hoist: main, speed: 0.1 m/s, by: 1.5 m}
  - {step: rest, hold: 20 s}
"""


def test_the_table_has_no_factor_where_the_check_has_none() -> None:
    text = hooked_lift(
        HOOKS,
        LUGS,
        SLINGS,
        mass=20e3,
        centre=(0.0, 0.0, 1.45),
        box=(4.8, 6.0, 3.0),
        axial_stiffness=20e6,
        more=PLAN,
    )
    text = text.replace("  name: load\n", "  name: load\n  stands_on: ground\n")
    lift = parse_scenario(text.replace("as_given", "rest").replace("duration: 10 s", "duration: 110 s"))
    recording = gantline.simulate(lift)
    checks = check_recording(recording)
    (of_check,) = (one for one in checks if one.name == "hook_dynamic_factor")
    assert of_check.element == "main" and of_check.remark.endswith("a hold there does: tail")
    rows = [line.split() for line in summary(recording, checks, str) if " hook load " in line]
    factors = {row[0]: row[-2] for row in rows if row[1:3] == ["hook", "load"] and row[0] in HOOKS}
    assert factors["tail"] == "-" and of_check.value is not None
    assert float(factors["main"]) == round(of_check.value, 3)
