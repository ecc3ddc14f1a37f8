"""When the steps of a plan went, what is left of it, and how plots say so."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.text import Text

from gantline.plot import figures
from gantline.results.progress import Stretch, stretches, unfinished
from gantline.viewer import pack
from sample_lift import ringing_lift

#: Two hooks side by side, of which one is there first; then nothing until a hold, and nothing after it.
SIDE_BY_SIDE = [
    (0.0, "step_begin", "hoist a"),
    (0.0, "step_begin", "hoist b"),
    (10.0, "step_end", "hoist a"),
    (20.0, "step_end", "hoist b"),
    (30.0, "step_begin", "hold"),
    (35.0, "step_end", "hold"),
]


def texts_of(figure: Figure) -> list[str]:
    texts: list[Text] = figure.findobj(Text)
    return [text.get_text() for text in texts]


def test_steps_side_by_side_are_one_stretch_and_idle_time_is_none() -> None:
    found = stretches(ringing_lift(events=SIDE_BY_SIDE))
    assert found == [Stretch(("hoist a", "hoist b"), 0.0, 20.0), Stretch(("hold",), 30.0, 35.0)]
    assert found[0].name == "hoist a + hoist b"


def test_a_step_without_an_end_goes_to_the_next_or_to_the_end_of_the_run() -> None:
    events = [(0.0, "step_begin", "hoist"), (25.0, "step_begin", "hold")]
    assert [(one.begin, one.end) for one in stretches(ringing_lift(events=events))] == [(0, 25), (25, 40)]


def test_what_a_run_leaves_of_its_plan() -> None:
    assert unfinished(ringing_lift()) is None
    within = unfinished(ringing_lift(events=[(0.0, "step_begin", "hoist")]))
    assert within is not None
    assert (within.under_way, within.not_begun) == (("hoist",), ("hold",))
    before = unfinished(ringing_lift(events=[(0.0, "step_begin", "hoist"), (9.0, "step_end", "hoist")]))
    assert before is not None
    assert (before.under_way, before.not_begun) == ((), ("hold",))
    # A hold to the end has nothing left to do.
    events = [(0.0, "step_begin", "hoist"), (9.0, "step_end", "hoist"), (9.0, "step_begin", "hold")]
    assert unfinished(ringing_lift(events=events)) is None


def test_plots_mark_the_end_of_a_run_that_is_shorter_than_its_plan() -> None:
    cut = ringing_lift(events=[(0.0, "step_begin", "hoist")])
    drawn = dict(figures(cut))["hook_load"]
    assert "the run ends in 'hoist'" in texts_of(drawn)
    ends = [line for line in drawn.axes[0].get_lines() if np.array_equal(line.get_xdata(), [40.0, 40.0])]
    assert len(ends) == 1
    assert pack(cut).header["unfinished"] == "the run ends in 'hoist'"
    assert pack(ringing_lift()).header["unfinished"] is None
    assert not any("the run ends" in text for text in texts_of(dict(figures(ringing_lift()))["hook_load"]))
