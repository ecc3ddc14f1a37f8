"""A vessel whose GM is below zero was a GO, as long as nothing in the lift file was askew.

A barge of 5700 t with its centre of gravity 2 m above its metacentre lay upright for a minute, as a pencil
stands on its point: nothing in a run that is symmetrical to the last bit pushes it but rounding, 1e-16 that
grows by e in 1.8 s. `gantline run` said GO, 0 warnings, and `gantline statics` "UNSTABLE" above a GO. What
rights a vessel is asked for now where a run begins at rest and where it ends, by the equilibrium there.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

LENGTH, BREADTH, DENSITY, MASS = 80.0, 24.0, 1025.0, 5.7e6
#: A tank over the whole breadth, so that what is pumped into it has a free surface [m].
TANK = 70.0
WAIT = "  - {step: wait, hold: until_end}"
FILL = "  - {step: fill, pump: {from: sea, to: barge.deep}, rate: 60000 t/h, by: 500 t}"


def lift(height: float, step: str = WAIT) -> str:
    """A barge with its centre of gravity at a height above its keel [m]."""
    return f"""
format: 1
lift: {{title: Barge, number: 1}}
duration: 60 s
water: {{density: 1025 kg/m^3, level: 0 m}}
vessels:
  barge:
    draft: 2.9 m
    hull: {{box: [80 m, 24 m, 6 m]}}
    masses: {{all: {{mass: 5700 t, at: [40 m, 0 m, {height!r} m]}}}}
    radii_of_gyration: [8 m, 23 m, 24 m]
    tanks: {{deep: {{box: [{TANK} m, 24 m, 5 m], bottom: [40 m, 0 m, 0.5 m], content: 0}}}}
plan:
{step}
"""


def metacentre(mass: float = MASS) -> float:
    """KM = KB + BM of the box, upright [m]."""
    draft = mass / (DENSITY * LENGTH * BREADTH)
    return draft / 2 + BREADTH**2 / 12 / draft


def checked(recording: Recording) -> list[Check]:
    return checks_of(recording, "floats_stably")


@pytest.mark.parametrize("above", [0.1, 2.0])
def test_fails_though_it_has_not_heeled(above: float) -> None:
    recording = gantline.simulate(parse_scenario(lift(metacentre() + above)))
    assert abs(recording.column("vessel_heel", "barge")).max() < 0.002
    [check] = checked(recording)
    assert (check.element, check.verdict, check.time) == ("barge", Verdict.FAILED, 0.0)
    assert f"its GM is {-above:.2f} m" in check.remark
    assert verdict_of(check_recording(recording)).startswith("NO-GO")
    first, last = recording.rig.vessels[0].righting
    assert [first[1], last[1]] == pytest.approx([-above, -above], rel=1e-3)


def test_fails_by_a_free_surface_that_comes_on_the_way() -> None:
    """GM = KM - KG - ρ i/Δ, i = l b³/12 of the tank, of 500 t spread over its bottom."""
    recording = gantline.simulate(parse_scenario(lift(metacentre() - 5.0, FILL)))
    whole = MASS + 5e5
    level = 0.5 + 5e5 / (DENSITY * TANK * BREADTH) / 2
    centre = (MASS * (metacentre() - 5.0) + 5e5 * level) / whole
    surface = DENSITY * TANK * BREADTH**3 / 12 / whole
    [check] = checked(recording)
    # As the first has come in, with all of its surface; then the more, the better, up to the end of the step.
    assert check.time is not None and check.time < 20.0
    *_, (time, height, _) = recording.rig.vessels[0].righting
    assert time == pytest.approx(60.0)
    assert height == pytest.approx(metacentre(whole) - centre - surface, rel=1e-4)
    assert height < -4.0


def test_nothing_is_said_of_one_that_is_righted() -> None:
    assert not checked(gantline.simulate(parse_scenario(lift(metacentre() - 0.1))))


def test_an_unstable_equilibrium_is_no_go_either() -> None:
    rest = gantline.Statics(parse_scenario(lift(metacentre() + 0.5))).equilibrium(time=60.0)
    assert not rest.is_stable
    [check] = checked(rest.recording)
    assert (check.verdict, check.time) == (Verdict.FAILED, None)


def test_the_file_keeps_it(tmp_path: Path) -> None:
    recording = gantline.simulate(parse_scenario(lift(metacentre() + 0.5)))
    path = recording.save(tmp_path / "recording.nc")
    assert [one.remark for one in checked(gantline.open_recording(path))] == [
        one.remark for one in checked(recording)
    ]
