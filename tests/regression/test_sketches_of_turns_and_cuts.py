"""The side view of a load turned by 90° looked along its turning, that of a cut sling was without the sling.

The title named the moment of a turned load alone. In the plan two of four lugs in a row had no names, and the
name of a hook stood on the falls of another.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.report.sketch import Sketch, sketches
from gantline.report.sketch_names import hides_none, text_box
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift
from sample_lift import ringing_lift


def names(sketch: Sketch) -> set[str]:
    return {mark.text for mark in sketch.marks if mark.style == "sk-number"}


@pytest.mark.parametrize(("up", "to_the_right"), [(5.0, "x"), (0.0, "y")])
def test_the_side_view_looks_across_the_turning_of_a_load(up: float, to_the_right: str) -> None:
    """The load is longer in y, and one end of its x axis goes up: it leans towards x."""
    hooks = {"A": (-4.0, 0.0, 20.0), "B": (4.0, -6.0, 20.0), "C": (4.0, 6.0, 20.0)}
    lugs = {name: (x, y, 2.0) for name, (x, y, _) in hooks.items()}
    slings = {f"S{name}": (name, name, 12.0) for name in hooks}
    plan = f"plan:\n  - {{step: turn, hoist: A, speed: 0.1 m/s, by: {max(up, 0.05)} m}}\n"
    text = hooked_lift(hooks, lugs, slings, box=(10.0, 14.0, 4.0), position=(0.0, 0.0, 6.0), more=plan)
    text = text.replace("duration: 10 s", "duration: 70 s").replace("as_given", "rest")
    side, _ = sketches(Subject(gantline.simulate(parse_scenario(text))))
    assert side.title.endswith(f"{to_the_right} to the right")


def test_a_lift_of_which_a_sling_parts_is_drawn_before_that() -> None:
    """Samples are 0.02 s apart and the lift goes on to 40 s; slings are taken off as planned."""
    lift_off = (0.0, "step_begin", "hoist")
    cut = ringing_lift(events=[lift_off, (12.35, "cut", "sling.S2"), (20.0, "broken", "sling.S3")])
    taken_off = ringing_lift(events=[lift_off, (12.35, "detached", "sling.S2")])
    for recording, moment in ((cut, "12.3"), (taken_off, "40.0")):
        assert [one.title.split(",")[0] for one in sketches(Subject(recording))] == [
            f"side view at {moment} s",
            f"plan at {moment} s",
        ]


def test_all_lugs_of_a_row_have_their_names_in_the_plan() -> None:
    """0.5 m apart, 4 mm on paper: between two dots there is no room for a line of letters."""
    hooks = {f"H{k}": (2.0, 0.75 - 0.5 * k, 14.0) for k in range(4)}
    lugs = {f"L{k}": (2.0, 0.75 - 0.5 * k, 4.0) for k in range(4)}
    slings = {f"S{k}": (f"H{k}", f"L{k}", 10.1) for k in range(4)}
    recording = gantline.Simulation(parse_scenario(hooked_lift(hooks, lugs, slings))).run(until=0.1)
    _, plan = sketches(Subject(recording))
    assert names(plan) == set(slings)
    dots = [np.array([mark.x, mark.y]) for mark in plan.marks if mark.style == "sk-lug"]
    boxes = [text_box(mark.x, mark.y, mark.text) for mark in plan.marks if mark.style == "sk-number"]
    assert all(hides_none(box, dots) for box in boxes)
