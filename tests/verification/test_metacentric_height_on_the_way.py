"""GM of a barge of which it is least neither where its run begins nor where it ends, against KB + BM - KG."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import pytest

import gantline
from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

LENGTH, BREADTH, DENSITY, MASS = 80.0, 24.0, 1025.0, 5.7e6
#: Length and height of a tank over the whole breadth, the height of its bottom [m], and its contents at the
#: ends of both steps [kg].
TANK, TALL, BOTTOM, SLACK = 10.0, 5.0, 0.5, 1e5
FULL = DENSITY * TANK * BREADTH * TALL
#: Of the pump [kg/s].
RATE = 60e6 / 3600.0


@dataclass(frozen=True)
class Barge:
    """A barge with its centre of gravity at a height [m] whose tank is filled by a part, then to its top."""

    centre: float

    def lift(self, more: str = "") -> str:
        return f"""
format: 1
lift: {{title: Barge}}
duration: 120 s
water: {{density: {DENSITY} kg/m^3, level: 0 m}}
{more}
vessels:
  barge:
    draft: 2.9 m
    hull: {{box: [{LENGTH} m, {BREADTH} m, 6 m]}}
    masses: {{all: {{mass: {MASS} kg, at: [{LENGTH / 2} m, 0 m, {self.centre} m]}}}}
    radii_of_gyration: [8 m, 23 m, 24 m]
    tanks:
      deep: {{box: [{TANK} m, {BREADTH} m, {TALL} m], bottom: [{LENGTH / 2} m, 0 m, {BOTTOM} m], content: 0}}
plan:
  - {{step: begin, pump: {{from: sea, to: barge.deep}}, rate: 60000 t/h, by: {SLACK} kg}}
  - {{step: fill up, pump: {{from: sea, to: barge.deep}}, rate: 60000 t/h, by: {FULL - SLACK} kg}}
  - {{step: wait, hold: until_end}}
"""

    def height(self, content: float) -> float:
        """GM = KB + BM - KG, of a tank that is slack less the free surface (i/∇ of its own water)."""
        whole = MASS + content
        draft = whole / (DENSITY * LENGTH * BREADTH)
        level = BOTTOM + content / (DENSITY * TANK * BREADTH) / 2
        centre = (MASS * self.centre + content * level) / whole
        moves = DENSITY * TANK * BREADTH**3 / 12 / whole if 0.0 < content < FULL else 0.0
        return draft / 2 + BREADTH**2 / 12 / draft - centre - moves


def failed(recording: Recording, name: str) -> tuple[float, float | None, str]:
    """When a check failed, with its value and what it remarks."""
    [check] = checks_of(recording, name)
    assert check.verdict is Verdict.FAILED and check.element == "barge" and check.time is not None
    return check.time, check.value, check.remark


@pytest.mark.parametrize(("settings", "late"), [({}, 1e-6), ({"integrator": "del", "step": 0.02}, 0.04)])
def test_the_least_is_where_a_step_ends_that_leaves_a_free_surface(
    settings: dict[str, Any], late: float
) -> None:
    """A limit that start and end keep: 100 t of 1230 t have come in then, with a free surface."""
    barge = Barge(centre=9.0)
    least = barge.height(SLACK)
    assert least < 6.9 and min(barge.height(0.0), barge.height(FULL)) > 7.4
    scenario = parse_scenario(barge.lift("limits: {metacentric_height: 7.2 m}"))
    recording = gantline.simulate(scenario, **settings)
    time, value, _ = failed(recording, "metacentric_height")
    # A pump comes to its rate in 10 s and stops as slowly: it has moved its share before that, and half of it
    # by half of the time.
    assert time == pytest.approx(2.0 * math.sqrt(10.0 * SLACK / RATE), abs=late)
    # `del` has up to 0.02 s of the pump's next run by then, a third of a kilogram.
    assert value == pytest.approx(least, rel=1e-5)


def test_what_nothing_rights_between_start_and_end_is_told_though_it_lies_upright() -> None:
    """Nothing pushes it but rounding: at rest it would lie over by tens of degrees meanwhile."""
    barge = Barge(centre=16.3)
    least = barge.height(SLACK)
    assert least < 0.0 < min(barge.height(0.0), barge.height(FULL))
    recording = gantline.simulate(parse_scenario(barge.lift()))
    assert abs(recording.column("vessel_heel", "barge")).max() < 1e-3
    _, _, remark = failed(recording, "floats_stably")
    assert f"its GM is {least:.2f} m" in remark


def test_a_run_that_goes_on_elsewhere_knows_where_its_steps_ended() -> None:
    """Against the run in one piece: saved after the first step, taken up by another simulation."""
    scenario = parse_scenario(Barge(centre=9.0).lift("limits: {metacentric_height: 7.2 m}"))
    first = gantline.Simulation(scenario)
    first.run(until=60.0)
    other = gantline.Simulation(scenario)
    other.restore(first.save())
    whole = failed(gantline.simulate(scenario), "metacentric_height")
    assert failed(other.run(), "metacentric_height") == whole
