"""Places of hooks that cannot be, told as sensitivities that are missing.

A load that two hooks turn hangs with its tailing hook so far below the other that no place of them makes
both plumb: its lugs are 6.02 m apart, and plumb slings would put one 6.7 m above the other. A step of the
search on which the tailing slings were slack ended it at once: `the lift has no sensitivities to these
quantities (nothing holds what place_x of tail sets going)`, which says nothing of the slings. A shorter
step is tried now, and what is slack is named.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import parse_scenario
from gantline.study import CannotBeError, plumb_hooks
from hooked_lift import hooked_lift

#: At the end of the plan their bearings are at 18.5 m and 12 m.
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
  - {step: turn on, hoist: main, speed: 0.1 m/s, by: 1.5 m}
"""
#: How far below its hook each pair of lugs is where slings hang in a plane along x through the hook [m].
DEPTHS = math.sqrt(10.3**2 - 2.2**2), math.sqrt(10.5**2 - 2.2**2)


def test_it_says_that_it_cannot_be() -> None:
    higher = (18.5 - DEPTHS[0]) - (12.0 - DEPTHS[1])
    assert higher > math.hypot(5.6, 2.2)  # 6.7 m > 6.02 m
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
    text = text.replace("as_given", "rest").replace("duration: 10 s", "duration: 110 s")
    with pytest.raises(CannotBeError) as found:
        plumb_hooks(parse_scenario(text))
    assert str(found.value).startswith("slack on the way: C, D; ")
