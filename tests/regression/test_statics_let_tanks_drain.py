"""Equilibria that drained a tank by the way, and said that they had not.

In equilibria nothing runs through holes of tanks: what the lift file gives is in them, as the warning says.
But a plan with a step that waits for a condition is followed from rest to rest, with all that a run looks
at, and holes were among that. A caisson of 60 t with 49.2 t in it had 101.5 t on its hook at the end of the
step that hoists it out and 60.4 t at the end of the lift, under the warning that all of it was still in.
"""

from __future__ import annotations

import pytest

from gantline.statics import Statics
from tanked_load import OWN, G, hold, lift, tank


def test_a_plan_that_waits_drains_nothing_either() -> None:
    """The hook carries (W + m) g at the end, m of the lift file, whether a step has waited or not."""
    holes = {"valve": {"at": ["0 m", "0 m", "0.5 m"], "area": "0.05 m^2"}}
    up = {"step": "up", "hoist": "crane", "speed": "1 m/min"}
    for ends in ({"by": "1 m"}, {"until": {"slings": "taut"}}):
        plan = [{**up, **ends}, hold("drains", "until_end")]
        rest = Statics(lift({"inside": tank((0, 0, 0.5), 24.0, holes=holes)}, plan)).equilibrium(400.0)
        assert rest.recording.column("tank_content", "module.inside")[-1] == 24e3, ends
        assert rest.recording.column("hook_load", "crane")[-1] == pytest.approx((OWN + 24e3) * G, rel=1e-9)
