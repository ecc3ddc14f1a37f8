"""A Goliath crane of which two corners would have lifted off their rail.

All load hung on one side of a girder with a narrow base. Its corners at the other side had less than nothing
to bear; the check looked at the largest corner load alone, and the lift was GO.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks import Check, Verdict
from gantline.results.cranes.crane import Crane, corner_loads
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from of_recording import check_of

#: Weights of girder, legs and bogies, together [N]; distance of the corners of a leg and of the hook [m].
OWN, BASE, ACROSS = 400e3, 8.0, 6.0


def checked(hoist_load: float) -> Check:
    """`corner_load` of a crane that takes up a load in the middle of its span, at 1 s."""
    crane = {
        "name": "g",
        "span": 100.0,
        "fixed_leg_at": -50.0,
        "base": BASE,
        "weights": {"girder": OWN, "fixed": 0.0, "hinged": 0.0, "bogies": 0.0},
        "trolleys": [{"name": "g.t", "hooks": [{"name": "g.H", "top": "g.top", "across": ACROSS}]}],
    }
    columns = {
        "time": np.array([0.0, 1.0]),
        "joint_position": np.zeros((2, 1)),
        "body_position": np.tile([[0.0, ACROSS, 10.0], [0.0, ACROSS, 60.0]], (2, 1, 1)),
        "body_orientation": np.tile([1.0, 0.0, 0.0, 0.0], (2, 2, 1)),
    }
    names = {"joint": ["g.t"], "body": ["g.H", "g.top"]}
    hoist = np.array([0.0, hoist_load])
    found, labels = corner_loads(columns, names, [Crane.from_json(crane)], {"g.H": hoist})
    variables = {"time": Variable(("time",), columns["time"], "s", ""), **found}
    variables["hook_load"] = variables["hoist_load"] = Variable(("time", "hook"), hoist[:, None], "N", "")
    angle = np.zeros((2, 1))
    variables["falls_out_of_plumb"] = Variable(("time", "crane_hook"), angle, "rad", "")
    rig = {"cranes": [crane], "hooks": [{"name": "g.H", "crane": "g"}]}
    of = Recording(
        variables, {**labels, "hook": ["g.H"], "crane_hook": ["g.H"], "joint": ["g.t"]}, {"rig": rig}
    )
    return check_of(of, "corner_load")


def lightest(hoist_load: float) -> float:
    """A quarter of the crane, and 1/4 (1 - 2 η/b) of what hangs at η across a base b, by moments [N]."""
    return OWN / 4 + hoist_load / 4 * (1 - 2 * ACROSS / BASE)


def test_a_crane_whose_corner_lifts_fails() -> None:
    assert lightest(1000e3) == pytest.approx(-25e3)
    found = checked(1000e3)
    assert found.verdict is Verdict.FAILED
    assert "would lift off its rail at 1.00 s: the crane tips: g.fixed.back" in found.remark


def test_one_that_stands_has_no_limit() -> None:
    """The largest corner load, 1/4 of the crane and 1/4 (1 + 2 η/b) of what hangs."""
    assert lightest(700e3) == pytest.approx(12.5e3)
    found = checked(700e3)
    assert found.verdict is Verdict.NOT_CHECKED
    assert found.value == pytest.approx(OWN / 4 + 700e3 / 4 * (1 + 2 * ACROSS / BASE))
