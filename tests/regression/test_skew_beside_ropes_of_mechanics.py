"""Two slings beside two ropes of `mechanics` in one hook had a skew load factor of 1.000.

Two slings of a hook have no choice, by themselves; with two ropes beside them the four share by their
lengths, as four slings do. `rules: {skew_load_factor: 1.25}` was left out of their forces by that. The factor
cannot be told now, since ropes of `mechanics` may end on drums, and that of the rule counts.
"""

from __future__ import annotations

import pytest

import gantline
from beside_mechanics import BESIDE_MECHANICS
from gantline.checks import check_recording

RULES = """\
rules: {skew_load_factor: 1.25}
limits: {rule: yard, sling_factor_on_breaking_force: 3}
"""


def test_ropes_beside_slings_leave_no_factor_and_that_of_the_rule_counts() -> None:
    recording = gantline.simulate(gantline.parse_scenario(BESIDE_MECHANICS + RULES))
    checks = {one.name: one for one in check_recording(recording)}
    skew = checks["skew_load_factor"]
    assert skew.value is None
    assert skew.remark.startswith("ropes of 'mechanics' in their hook share with them: A, C")
    # A quarter of the weight by the cosine of the sling: 7.9 m of which it goes down 7.49 m when it hangs.
    cosine = (7.9**2 - 2.5**2) ** 0.5 / 7.9
    share = 40.0 * 9.81 / 4 / cosine
    lug = checks["lug_load_of_capacity"]
    assert lug.value == pytest.approx(1.25 * share / (40.0 * 9.81), rel=5e-3)


def test_slings_alone_have_theirs() -> None:
    """The same two over the middle of the load, without the ropes: they have no choice."""
    head, tail = (BESIDE_MECHANICS + RULES).split("mechanics:\n")
    alone = f"{head}plan:\n{tail.split('plan:')[1]}".replace("at: [2 m, ", "at: [0 m, ")
    checks = {one.name: one for one in check_recording(gantline.simulate(gantline.parse_scenario(alone)))}
    assert checks["skew_load_factor"].value == pytest.approx(1.0)
