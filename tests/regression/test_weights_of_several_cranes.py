"""Weights on the first page of a lift by several cranes of which one alone has a rated capacity.

The largest hoist load of all hooks of all cranes stood over the rated capacity of that one crane: 674.2 t, of
which a floating crane bears 384 t and two crawler cranes the rest, "of 3600 t, 19 %".
"""

from __future__ import annotations

from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from several_cranes import HANGS, HOOKS, at_rest, last

_ROW = "largest hoist load, simulated"


def weights(recording: Recording) -> dict[str, str]:
    return dict(FirstPage().content(Subject(recording))["weights"])


def test_one_cranes_rating_is_not_for_all() -> None:
    recording = at_rest(HANGS)
    tonnes = [last(recording, "hoist_load", hook) / recording.rig.gravity / 1e3 for hook in HOOKS]
    assert weights(recording)[_ROW] == f"{sum(tonnes):.1f} t"


def test_a_crane_with_all_hooks_of_the_lift_is_named() -> None:
    """Its own hook alone: hoist load over rated capacity."""
    recording = at_rest(HANGS)
    rig = dict(recording.attributes["rig"])
    own = HOOKS[0]
    rig["hooks"] = [one for one in rig["hooks"] if one["name"] == own]
    alone = Recording(recording.variables, recording.coordinates, {**recording.attributes, "rig": rig})
    tonnes = last(recording, "hoist_load", own) / recording.rig.gravity / 1e3
    assert weights(alone)[_ROW] == f"{tonnes:.1f} t of 3600 t, {100 * tonnes / 3600:.0f} %"
