"""The curve of heave compensation in a report seemed to throw the hook up by 245 mm in one sample.

A hoist that compensates comes to rest within 4 s of the end of its step, and the hook stays there; heights
count anew from then on, and what is recorded of compensation is 0. The curve jumped there, under the words
"hook raised positive", and nothing said that the hook does not.
"""

from __future__ import annotations

import numpy as np

from compensated import EASE, HOOK, compensated
from gantline.report.plots import HookLoads
from gantline.report.subject import Subject
from gantline.simulation import simulate

#: When compensation ends [s]: amid waves, which have grown by then.
END = 40.0
PLAN = f"""\
  - {{step: with, hold: {END:g} s, compensate_heave: H1}}
  - {{step: without, hold: until_end}}
"""


def test_the_plot_says_that_the_hook_stays() -> None:
    """What it says is so: in the sample in which the curve goes to 0 the drum stands still within 1 mm."""
    recording = simulate(compensated(PLAN, lasts="50 s"))
    raised = recording.column("heave_compensation", HOOK)
    (last,) = np.flatnonzero((raised[:-1] != 0.0) & (raised[1:] == 0.0) & (recording.time[1:] > END))
    assert END < recording.time[last] < END + EASE + 0.1
    assert abs(raised[last]) > 0.02
    paid_out = recording.column("rope_paid_out", f"{HOOK}.drum")
    assert abs(paid_out[last + 1] - paid_out[last]) < 1e-3
    (plot,) = (one for one in HookLoads().plots(Subject(recording)) if one["groups"] == ["heave"])
    assert plot["note"] == "0 once it has ended: the hook stays where it is then."
