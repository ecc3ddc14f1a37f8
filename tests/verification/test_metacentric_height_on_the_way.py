"""GM of a barge of which it is least neither where its run begins nor where it ends, against KB + BM - KG.

Where a step ends that leaves a tank slack, and within a step as a tank gets its surface or loses it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.study import run_steps
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
    """A barge with its centre of gravity at a height [m] whose tank is filled by a part and drained again.

    `bottom` is that of the tank [m]; filled `at_once`, to its top, it is slack where no step begins or ends.
    """

    centre: float
    bottom: float = BOTTOM
    at_once: bool = False
    mass: float = MASS

    def lift(self, more: str = "") -> str:
        steps = [("fill", "from: sea, to: barge.deep", FULL)]
        if not self.at_once:
            steps = [
                ("begin", "from: sea, to: barge.deep", SLACK),
                ("drain", "from: barge.deep, to: sea", SLACK),
            ]
        rate = 6000 if self.at_once else 60000
        pumped = "\n".join(
            f"  - {{step: {step}, pump: {{{between}}}, rate: {rate} t/h, by: {part} kg}}"
            for step, between, part in steps
        )
        return f"""
format: 1
lift: {{title: Barge}}
duration: {800 if self.at_once else 120} s
water: {{density: {DENSITY} kg/m^3, level: 0 m}}
{more}
vessels:
  barge:
    draft: {self.mass / (DENSITY * LENGTH * BREADTH)} m
    hull: {{box: [{LENGTH} m, {BREADTH} m, 12 m]}}
    masses: {{all: {{mass: {self.mass} kg, at: [{LENGTH / 2} m, 0 m, {self.centre} m]}}}}
    radii_of_gyration: [8 m, 23 m, 24 m]
    tanks:
      deep:
        box: [{TANK} m, {BREADTH} m, {TALL} m]
        bottom: [{LENGTH / 2} m, 0 m, {self.bottom} m]
        content: 0
plan:
{pumped}
  - {{step: wait, hold: until_end}}
"""

    def height(self, content: float) -> float:
        """GM = KB + BM - KG, of a tank that is slack less the free surface (i/∇ of its own water)."""
        whole = self.mass + content
        draft = whole / (DENSITY * LENGTH * BREADTH)
        level = self.bottom + content / (DENSITY * TANK * BREADTH) / 2
        centre = (self.mass * self.centre + content * level) / whole
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
    assert least < 6.9 and barge.height(0.0) > 7.4
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
    assert least < 0.0 < barge.height(0.0)
    recording = gantline.simulate(parse_scenario(barge.lift()))
    assert abs(recording.column("vessel_heel", "barge")).max() < 1e-3
    time, _, remark = failed(recording, "floats_stably")
    # So high up, the first liquid is good but for its surface: least once it is nearly drained, at a mark.
    assert content_at(recording, time) == pytest.approx(0.02 * FULL, abs=RATE)
    assert f"its GM is {barge.height(content_at(recording, time)):.2f} m" in remark


def test_a_run_that_goes_on_elsewhere_knows_where_its_steps_ended() -> None:
    """Against the run in one piece: saved after the first step, taken up by another simulation."""
    scenario = parse_scenario(Barge(centre=9.0).lift("limits: {metacentric_height: 7.2 m}"))
    first = gantline.Simulation(scenario)
    first.run(until=60.0)
    other = gantline.Simulation(scenario)
    other.restore(first.save())
    whole = failed(gantline.simulate(scenario), "metacentric_height")
    assert failed(other.run(), "metacentric_height") == whole


def content_at(recording: Recording, time: float) -> float:
    """What the tank holds at a moment [kg]; its pump runs evenly there."""
    return float(np.interp(time, recording.time, recording.column("tank_content", "barge.deep")))


@pytest.mark.parametrize(("mass", "bottom", "mark"), [(15e6, 0.5, 0.02), (MASS, 6.0, 0.98)])
def test_the_least_is_within_a_step_as_the_surface_comes_or_before_it_goes(
    mass: float, bottom: float, mark: float
) -> None:
    """Low in a deep barge liquid is good but for its surface: least as that comes; high up as it goes."""
    barge = Barge(centre=6.0 if mass > MASS else 9.0, bottom=bottom, at_once=True, mass=mass)
    others = [share * FULL for share in np.linspace(0.02, 0.98, 49)]
    assert barge.height(mark * FULL) == min(map(barge.height, others))
    ends = min(barge.height(0.0), barge.height(FULL))
    assert barge.height(mark * FULL) < ends - 0.5
    recording = gantline.simulate(
        parse_scenario(barge.lift(f"limits: {{metacentric_height: {ends - 0.01} m}}"))
    )
    time, value, _ = failed(recording, "metacentric_height")
    content = content_at(recording, time)
    # A step of the method leads past it: by less than 10 s while nothing moves, at a tenth of that rate.
    assert content == pytest.approx(mark * FULL, abs=RATE)
    # KB + BM - KG to the rounding of the equilibrium; what is pumped between samples is even.
    assert value == pytest.approx(barge.height(content), rel=1e-5)


def test_statics_have_the_least_within_a_step() -> None:
    """A row at 50 and at 98 % of the time of a pump that comes to its rate in 10 s; none where GM is more."""
    barge = Barge(centre=9.0, bottom=6.0, at_once=True)
    question = gantline.Statics(parse_scenario(barge.lift()))
    assert [one.name for one in run_steps(question)] == ["start", "fill", "end of the lift"]
    start, half, most, *_ = run_steps(question, pumping=True)
    assert [start.name, half.name, most.name] == ["start", "fill at 50 %", "fill at 98 %"]
    assert start.heights["barge"].transverse == pytest.approx(barge.height(0.0), rel=1e-6)
    assert half.heights["barge"].transverse == pytest.approx(barge.height(0.5 * FULL), rel=1e-6)
    assert most.heights["barge"].transverse < barge.height(0.98 * FULL)


def test_what_nothing_rights_within_a_step_is_told_though_it_lies_upright() -> None:
    """A high tank is pressed up in one step: before that, it would lie over by tens of degrees."""
    barge = Barge(centre=15.1, bottom=6.0, at_once=True)
    assert barge.height(0.98 * FULL) < 0.0 < min(barge.height(0.0), barge.height(FULL))
    recording = gantline.simulate(parse_scenario(barge.lift()))
    assert abs(recording.column("vessel_heel", "barge")).max() < 1e-3
    time, _, remark = failed(recording, "floats_stably")
    least = barge.height(content_at(recording, time))
    assert f"its GM is {least:.2f} m" in remark
