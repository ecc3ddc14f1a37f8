"""A hook that begins below the lugs that its slings hold.

A height with a wrong digit, 2.3 m for 8.3 m, puts the hook into the load. Slings of 6 m are long enough for
that, so the lift file was found in order, without a word; a run hoisted until its end and told that the plan
had not come further than its first step.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

LUGS = {"A": (-2.5, 0.0, 3.0), "B": (2.5, 0.0, 3.0)}
SLINGS = {"A": ("hook", "A", 6.0), "B": ("hook", "B", 6.0)}


@pytest.mark.parametrize(("height", "warned"), [(8.3, False), (3.0, False), (2.3, True)])
def test_hook_below_its_lugs(height: float, warned: bool) -> None:
    """It is told, with the sling and how far it goes up to its lug: 3 m less the height of the hook."""
    warnings = assemble(parse_scenario(hooked_lift({"hook": (0, 0, height)}, LUGS, SLINGS))).warnings
    told = [text for text in warnings if "cannot lift" in text]
    start = "sling A and 1 more cannot lift where this begins: from 'hook' to 'load.A' it goes 0.7 m up; "
    assert len(told) == warned
    assert all(text.startswith(start) for text in told)
