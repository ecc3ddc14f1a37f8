"""The plan on the first page left out ropes of `mechanics` that carry the load beside its slings.

A module on two slings and two chain hoists hung on two slings at one end there, and on four in the side view.
Falls are left out of the plan, since they would cover where slings are.
"""

from __future__ import annotations

import gantline
from beside_mechanics import BESIDE_MECHANICS
from gantline.report.sketch import sketches
from gantline.report.subject import Subject


def test_both_views_have_all_four() -> None:
    found = sketches(Subject(gantline.simulate(gantline.parse_scenario(BESIDE_MECHANICS))))
    assert [one.title.split()[0] for one in found] == ["side", "plan"]
    for view in found:
        kinds = [mark.style for mark in view.marks if mark.style in ("sk-sling", "sk-rope")]
        assert sorted(kinds) == ["sk-rope", "sk-rope", "sk-sling", "sk-sling"], view.title
