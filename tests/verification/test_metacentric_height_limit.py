"""The limit `metacentric_height` against GM of boxes, KB + BM - KG less free surfaces."""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

LENGTH, BREADTH, DENSITY, MASS, HEIGHT = 80.0, 24.0, 1025.0, 5.7e6, 9.0
#: Length of a tank over the whole breadth, and what is pumped into it [m, kg].
TANK, PUMPED = 10.0, 1e5
WAIT = "{step: wait, hold: until_end}"
FILL = "{step: fill, pump: {from: sea, to: barge.deep}, rate: 20000 t/h, by: 100 t}"


def lift(limit: str, step: str = WAIT, more: str = "") -> str:
    return f"""
format: 1
lift: {{title: Barge}}
duration: 60 s
water: {{density: 1025 kg/m^3, level: 0 m}}
{more}
vessels:
  barge:
    draft: 2.9 m
    hull: {{box: [80 m, 24 m, 6 m]}}
    masses: {{all: {{mass: 5700 t, at: [40 m, 0 m, {HEIGHT} m]}}}}
    radii_of_gyration: [8 m, 23 m, 24 m]
    tanks: {{deep: {{box: [{TANK} m, 24 m, 5 m], bottom: [40 m, 0 m, 0.5 m], content: 0}}}}
plan:
  - {step}
limits: {{metacentric_height: {limit}}}
"""


def upright(mass: float = MASS) -> float:
    """KM = KB + BM."""
    draft = mass / (DENSITY * LENGTH * BREADTH)
    return draft / 2 + BREADTH**2 / 12 / draft


def filled() -> float:
    """GM after `FILL`: the water lies level on the bottom of its tank, with its free surface."""
    whole = MASS + PUMPED
    level = 0.5 + PUMPED / (DENSITY * TANK * BREADTH) / 2
    centre = (MASS * HEIGHT + PUMPED * level) / whole
    return upright(whole) - centre - DENSITY * TANK * BREADTH**3 / 12 / whole


def told(recording: Recording) -> Check:
    [check] = checks_of(recording, "metacentric_height")
    return check


@pytest.mark.parametrize(("over", "verdict"), [(-0.01, Verdict.OK), (0.01, Verdict.FAILED)])
@pytest.mark.parametrize("by", ["run", "statics"])
def test_a_barge_has_it_or_not(by: str, over: float, verdict: Verdict) -> None:
    """GM = KB + BM - KG of a box, at rest and of a run, with a limit 10 mm below and above it."""
    height = upright() - HEIGHT
    scenario = parse_scenario(lift(f"{height + over} m"))
    recording = (
        gantline.simulate(scenario) if by == "run" else gantline.Statics(scenario).equilibrium().recording
    )
    check = told(recording)
    assert (check.verdict, check.element) == (verdict, "barge")
    assert check.value == pytest.approx(height, rel=1e-6)


def test_the_least_is_where_a_run_ends_with_a_slack_tank() -> None:
    """Its surface, 24 m wide, takes 2.0 m; the barge trims by it, for which 1e-3 is left."""
    recording = gantline.simulate(parse_scenario(lift("8 m", FILL)))
    check = told(recording)
    assert filled() < 8.0 < upright() - HEIGHT
    assert check.verdict is Verdict.FAILED and check.time == pytest.approx(60.0)
    assert check.value == pytest.approx(filled(), rel=1e-3)


def test_nothing_is_known_of_a_run_that_neither_begins_at_rest_nor_has_ended() -> None:
    """Against nothing: what is asked for is that it is not said to hold."""
    run = gantline.Simulation(parse_scenario(lift("1 m", more="start: as_given")))
    run.advance_to(5.0)
    check = told(run.recording())
    assert check.verdict is not Verdict.OK
    assert "begins at rest" in check.remark
