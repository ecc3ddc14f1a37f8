"""Long names of slings could not be told from each other in pictures.

In the top view of `system.png` they stood whole upon each other, across all panels; in the sketches of the
first page they were cut off at the edge, where only their ends differ.
"""

from __future__ import annotations

import gantline
from gantline.plot.views import system
from gantline.report import render_report
from gantline.results.ropes.families import shortened_inside
from long_names import LONG_NAMES, SLING


def test_both_ends_of_a_long_name() -> None:
    """21 characters, in which the four slings differ by their last one."""
    short = [shortened_inside(f"{SLING}{k}") for k in range(4)]
    assert short[0] == "sling_betw…ard_side_0"
    assert len(set(short)) == 4
    assert shortened_inside("main_hook_of_crane_21") == "main_hook_of_crane_21"


def test_pictures_name_slings_by_both_ends() -> None:
    """The top view and the sketches of the first page."""
    recording = gantline.simulate(gantline.parse_scenario(LONG_NAMES))
    short = {shortened_inside(f"{SLING}{k}") for k in range(4)}
    figure = system(recording)
    assert figure is not None
    written = {text.get_text() for panel in figure.axes for text in panel.texts}
    assert short <= written
    assert not any(text.startswith(SLING) for text in written)
    page = render_report(recording)
    assert all(f">{name}</text>" in page for name in short)
    assert f">{SLING}0</text>" not in page
