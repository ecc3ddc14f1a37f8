"""A lift of 200 kg in tables made for hundreds of tonnes.

Its weight was `0.2 t` and its design weight, 5 % more, `0.2 t` as well. Its load cell had to read 0.1 t at
a quarter of the weight and at half of it, 0.2 t at three quarters and at all of it, and the lift was to stop
if it differed by more than 10 %. Its hook, rated for 250 kg, was rated for `0`; one of 12.5 t was rated for
`12`. Its slings carried `1` kN.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

import gantline
from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.report.carried import hook_row, sling_rows
from gantline.report.first_page import FirstPage
from gantline.report.plots import HookLoads
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A beam of 200 kg}
duration: 12 s
ground: {friction: 0.5}
ropes:
  sling: {construction: 6x36 IWRC, grade: 1960, diameter: 8 mm, damping_time: 10 ms}
load:
  name: beam
  shape: {box: [1.2 m, 0.2 m, 0.2 m]}
  weight: {calculated: 200 kg, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 0.1 m]}
  stands_on: ground
  lugs:
    A: {at: [-0.4 m, 0 m, 0.2 m]}
    B: {at: [0.4 m, 0 m, 0.2 m]}
cranes:
  jib:
    type: fixed_hook
    at: [0 m, 0 m, 1.05 m]
    rated_capacity: 250 kg
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
slings:
  A: {from: jib, to: beam.A, length: 0.95 m, rope: sling}
  B: {from: jib, to: beam.B, length: 0.95 m, rope: sling}
plan:
  - {step: lift off, hoist: jib, speed: 0.2 m/min, until: {supports: clear}}
  - {step: hold, hold: until_end}
"""
#: 200 kg and what lies on the hook and the lugs, two slings of 0.95 m of 0.262 kg/m: 0.409 kg/m for each
#: 100 mm^2 of d^2, EN 12385-4, 6x36 with steel core [kg].
HANGS = 200.0 + 2 * 0.95 * 0.409 * 8.0**2 / 100.0


@pytest.fixture(scope="module")
def subject() -> Subject:
    return Subject(gantline.simulate(parse_scenario(LIFT)))


def test_readings_of_the_load_cell_can_be_told_apart(subject: Subject) -> None:
    """A reading that differs by 10 % stops the lift, so a tenth of that is to be seen."""
    row = hook_row(subject, subject.rig.hooks[0])
    readings = [float(text) for text in row["readings"]]
    for (share, low), (_, high) in pairwise(zip((0.25, 0.5, 0.75, 1.0), readings, strict=True)):
        assert low < high, share
    # Means over the swings of a load that has just come clear: 1 % covers those.
    assert readings[-1] * 1e3 == pytest.approx(HANGS, rel=0.01)
    assert float(row["static"]) * 1e3 == pytest.approx(HANGS, rel=0.01)
    assert row["rated"] == "0.25"


def test_weights_and_slings_have_three_digits(subject: Subject) -> None:
    weights = dict(FirstPage().content(subject)["weights"])
    assert weights["beam, calculated"] == "0.200 t"
    assert weights["× contingency 1.05 = design weight"] == "0.210 t"
    # Half of the weight each, at an angle from plumb of which the sine is 0.4 m/0.95 m.
    pull = HANGS / 2.0 * 9.81e-3 / math.sqrt(1.0 - (0.4 / 0.95) ** 2)
    assert float(sling_rows(subject, 8)[0][0]["static"]) == pytest.approx(pull, rel=0.01)


def test_so_does_the_console(subject: Subject) -> None:
    recording = subject.recording
    lines = summary(recording, check_recording(recording), str)
    assert any("simulated weight 0.200 t" in line and "design 0.210 t" in line for line in lines)
    hook = next(line.split() for line in lines if line.split()[:3] == ["jib", "hook", "load"])
    assert float(hook[3]) == pytest.approx(HANGS * 9.81e-3, rel=0.01)


def test_the_rated_capacity_in_the_plot_is_what_it_is(subject: Subject) -> None:
    """2.5 kN were `2 kN`."""
    labels = [line["label"] for plot in HookLoads().plots(subject) for line in plot.get("limits", ())]
    assert labels == ["rated capacity 2.45 kN"]
