"""A crawler crane whose counterweight outweighs base and boom was said to tip with all four corners pressed.

A tail crane of a lift file had 600 t of counterweight 12 m behind: its own weight acted beyond the line
through its back track, and 38 t of hook block and falls at the head of its boom held it. It stood, with 24
t on each corner in front; `crane 'tail' tips at 0.00 s: both corners of one side are clear of the ground`
said the run, and statics that there is no equilibrium anywhere. Where its own weight does not hold a crane
about a line, what hangs does: u is the moment of its own weight about the line over that of what holds it,
1 where no corner beyond is pressed. That nothing else holds it is a warning of the lift file."""

from __future__ import annotations

import re

import numpy as np
import pytest

import gantline
from crawler_lift import AHEAD, BALLAST, BASE, BEHIND, BOOM, CENTRE, GAUGE, HOOK_BLOCK, crawler_lift
from gantline.assembly import assemble
from gantline.checks import Check, Verdict, check_recording
from gantline.results.cranes.track_pressure import tipping_utilisation
from gantline.scenario import parse_scenario
from gantline.statics import Statics

RADIUS = 16.0
#: Moment of base and boom about the line through the track behind [kg m].
HOLDS = (BASE + BALLAST) * GAUGE / 2 + BOOM * (GAUGE / 2 + AHEAD + CENTRE * (RADIUS - AHEAD))


def lift(counterweight: float, hoist_load: float) -> str:
    """A counterweight, and hook block with what hangs in it [kg], on ground that hardly gives."""
    text = crawler_lift(hoist_load, radius=RADIUS, ground=20e9)
    assert "{mass: 250 t, behind" in text
    return text.replace("{mass: 250 t, behind", f"{{mass: {counterweight} kg, behind")


def over(counterweight: float) -> float:
    """Moment of the crane alone over that line backwards [kg m]."""
    return counterweight * (BEHIND - GAUGE / 2) - HOLDS


def tipping(text: str) -> tuple[float, Check]:
    recording = gantline.simulate(parse_scenario(text))
    checks = check_recording(recording)
    [check] = [one for one in checks if one.name == "moment_of_tipping_moment"]
    return float(recording.column("tipping_utilisation", "c1")[0]), check


@pytest.mark.parametrize("hoist_load", [HOOK_BLOCK, 60e3])
def test_it_stands_as_long_as_what_hangs_holds_it(hoist_load: float) -> None:
    """880 t are 90 t m more than base and boom hold; 7 t at 16 m are 141 t m about that line."""
    used, check = tipping(lift(880e3, hoist_load))
    assert over(880e3) == pytest.approx(90.2e3, rel=1e-3)
    assert used == pytest.approx(over(880e3) / (hoist_load * (RADIUS + GAUGE / 2)), rel=5e-3)
    assert check.verdict is Verdict.OK and check.value == pytest.approx(used)
    assert Statics(parse_scenario(lift(880e3, hoist_load))).equilibrium(time=0.0).is_stable


def test_it_tips_where_that_is_too_little() -> None:
    """950 t are 251 t m more than base and boom hold, the hook block has 141 t m."""
    assert over(950e3) > HOOK_BLOCK * (RADIUS + GAUGE / 2)
    with pytest.raises(gantline.ScenarioError, match="'c1' would tip over as it stands"):
        assemble(parse_scenario(lift(950e3, HOOK_BLOCK)))


@pytest.mark.parametrize(("held", "used"), [(0.0, 1.0), (1.0, 0.5), (3.0, 0.25)])
def test_of_a_crane_beyond_its_line_what_holds_it_counts(held: float, used: float) -> None:
    """Its weight of 1 N is 1 m beyond the left track of tracks 2 m apart: 1 N m over. Right corners have F
    2 m."""
    corners = np.array([[5.0, 5.0, held / 4, held / 4]])
    middle = np.array([[0.0, 2.0]])
    found = tipping_utilisation(corners, np.array([1.0]), middle, 100.0, 2.0)
    assert found == pytest.approx([used])


@pytest.mark.parametrize(("counterweight", "is_told"), [(830e3, False), (880e3, True)])
def test_the_lift_file_is_warned(counterweight: float, is_told: bool) -> None:
    assert (over(counterweight) > 0.0) is is_told
    warnings = assemble(parse_scenario(lift(counterweight, 60e3))).warnings
    told = [one for one in warnings if "tip c1 over backwards" in one]
    assert bool(told) is is_told
    for one in told:
        assert re.search(r"about the line 4\.20 m behind its slewing axis, 2024 t m against 1934 t m", one)
