"""A taut tag line, drawn as a slack one.

Pictures draw slack ropes dashed and grey: those with less than a thousandth of the largest tension in the
picture. Beside slings of 800 kN that is 0.8 kN, and a tag line that a tugger pulled with 0.5 kN was slack in
every picture.
"""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize, to_rgba_array
from matplotlib.figure import Figure

import gantline
from four_slings import LIFT
from gantline.plot.drawing import SIDE, SLACK, draw
from gantline.plot.scene import snapshot
from gantline.scenario import parse_scenario
from lift_text import changed

LINE = """\
  tag: {axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}
tag_lines:
  west: {at: [-3 m, 2 m, 0 m], to: [-30 m, 2 m, 0 m], rope: tag, pull: 50 N}
load:
"""


def test_a_line_that_pulls_is_not_drawn_slack() -> None:
    """50 N beside slings of 108 kN, a two-thousandth; the slings have not yet been taken up."""
    recording = gantline.simulate(parse_scenario(changed(LIFT, ("load:\n", LINE))))
    styles = []
    for sample in (0, len(recording.time) - 1):
        panel = Figure().add_subplot(xlim=(-40.0, 40.0), ylim=(-1.0, 20.0))
        snap = snapshot(recording, sample)
        draw(panel, snap, SIDE, Normalize(0.0, 108e3))
        drawn = [one for one in panel.collections if isinstance(one, LineCollection)]
        slack = [one for one in drawn if np.array_equal(one.get_edgecolor(), to_rgba_array(SLACK))]
        grey = [path for one in slack for path in one.get_paths()]
        taut = [rope.name for rope in snap.ropes if rope.tension > 0.0]
        styles.append((len(grey), taut))
    slings = [f"sling.{name}" for name in "ABCD"]
    assert styles == [(4, ["tag.west"]), (0, [*slings, "tag.west"])]
