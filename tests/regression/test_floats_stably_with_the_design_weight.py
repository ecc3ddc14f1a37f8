"""A barge that floats stably with the weight that is simulated, and turns over with the design weight.

A load stood amidships on a barge whose GM it left at 10 mm; its contingency of a tenth makes that -6 mm. The
barge lay upright in either case, so that heel said nothing, and GM with the design weight was asked only
where the lift file had a limit for it: with 'simulate: design' the lift was a NO-GO, with the calculated
weight nothing was told. Nor was it where the load stood a millimetre aside: the barge then heels by degrees
with the design weight, and derivatives of how it lies upright, with a GM that is left, made that a tenth of
a degree.
"""

from __future__ import annotations

import math

import pytest
from scipy.optimize import brentq

from gantline.checks import Check, Verdict
from gantline.results.afloat.vessels import AtRest, ByContingency
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

LENGTH, BREADTH, DEPTH, WATER = 60.0, 20.0, 5.0, 1025.0
#: Masses of barge and load [kg], height of the load's centre over the keel [m], its contingency.
BARGE, LOAD, LOAD_AT, CONTINGENCY = 2.46e6, 100e3, 6.5, 1.1
#: What four moorings add to GM [m]: of 10 kN EA each, more than a hundredth of what is looked for, no more.
OF_MOORINGS = 1.5e-3


def kept(load: float, height: float) -> float:
    """GM = KB + BM - KG of the box hull with a load on deck, its own mass at a height over the keel [m]."""
    mass = BARGE + load
    draft = mass / (WATER * LENGTH * BREADTH)
    return draft / 2 + BREADTH**2 / (12 * draft) - (BARGE * height + load * LOAD_AT) / mass


def height_for(gm: float) -> float:
    """Of the barge's own mass over its keel [m], for GM with the simulated weight."""
    return (kept(LOAD, 0.0) - gm) * (BARGE + LOAD) / BARGE


def aboard(
    height: float, simulated: str = "calculated", *, contingency: float = CONTINGENCY, aside: float = 0.0
) -> Scenario:
    """A load on the deck of a moored barge, amidships or so far to port [m], its sling slack."""
    lines = "".join(
        f"  {name}: {{vessel: barge, fairlead: [{x} m, {y} m, 5 m], to: [{to} m, {40 * y} m, 5 m], "
        "rope: nylon, pretension: 1 kN, type: spring}\n"
        for name, x, y, to in (
            ("a", 60, 10, 400),
            ("b", 60, -10, 400),
            ("c", 0, 10, -340),
            ("d", 0, -10, -340),
        )
    )
    draft = (BARGE + LOAD) / (WATER * LENGTH * BREADTH)
    return parse_scenario(f"""\
format: 1
lift: {{title: Aboard a barge}}
duration: 1 s
start: rest
water: {{density: {WATER} kg/m^3, level: 0 m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 3500 kN, mass: none}}
  nylon: {{axial_stiffness: 10 kN, damping_time: 0.5 s, minimum_breaking_force: 800 kN, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  position: [30 m, {aside!r} m, {DEPTH - draft} m]
  weight: {{calculated: {LOAD} kg, contingency: {contingency}, simulate: {simulated}}}
  centre_of_gravity: {{at: [0 m, 0 m, {LOAD_AT - DEPTH} m]}}
  lugs: {{A: {{at: [0 m, 0 m, 3 m], capacity: 80 t}}}}
vessels:
  barge:
    draft: {draft} m
    hull: {{box: [{LENGTH} m, {BREADTH} m, {DEPTH} m]}}
    masses: {{all: {{mass: {BARGE} kg, at: [30 m, 0 m, {height!r} m]}}}}
    radii_of_gyration: [7 m, 17 m, 17 m]
mooring_lines:
{lines}cranes:
  hook:
    {{type: fixed_hook, at: [30 m, {aside!r} m, 17 m], rated_capacity: 150 t,
      hoist: {{speed: 4 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings: {{A: {{from: hook, to: box.A, length: 14 m}}}}
mechanics:
  body_contacts:
    on_deck: {{between: [box, barge], stiffness: 1000 MN/m, damping: 1 MN s/m, friction: 0.3}}
plan:
  - {{step: stand, hold: until_end}}
""")


def by_run(scenario: Scenario) -> Recording:
    return simulate(scenario, duration=0.5)


def by_statics(scenario: Scenario) -> Recording:
    return Statics(scenario).equilibrium(0.0, losses="held").recording


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "floats_stably")


@pytest.mark.parametrize("found", [by_run, by_statics])
def test_a_vessel_that_the_design_weight_turns_over_is_told(found) -> None:  # type: ignore[no-untyped-def]
    """GM is 10 mm as simulated, and by hand -7.2 mm with 10 t more, to which moorings add what they do."""
    height = height_for(0.010)
    by_hand = kept(CONTINGENCY * LOAD, height)
    assert by_hand == pytest.approx(-0.0072, abs=1e-4)
    recording = found(aboard(height))
    [check] = told(recording)
    assert (check.verdict, check.element) == (Verdict.WARNING, "barge")
    assert check.remark.startswith("with the design weight its GM is -0.006 m")
    least = recording.rig.vessels[0].by_contingency[0].least_height
    assert least is not None and 0.0 < least - by_hand < OF_MOORINGS
    # The same lift simulated with it.
    [[_, heel, _], *_] = found(aboard(height, "design")).rig.vessels[0].righting
    assert least == pytest.approx(heel, abs=1e-9)


@pytest.mark.parametrize("found", [by_run, by_statics])
def test_one_that_either_weight_leaves_stable_is_not(found) -> None:  # type: ignore[no-untyped-def]
    """The contingency takes 17 mm of 50 mm."""
    assert not told(found(aboard(height_for(0.050))))


@pytest.mark.parametrize("found", [by_run, by_statics])
def test_one_that_fails_as_simulated_is_told_so_alone(found) -> None:  # type: ignore[no-untyped-def]
    [check] = told(found(aboard(height_for(-0.010))))
    assert check.verdict is Verdict.FAILED
    assert check.remark.startswith("its GM is -0.01 m")


@pytest.mark.parametrize("found", [by_run, by_statics])
def test_one_that_lies_askew_by_a_hair_heels_by_degrees(found) -> None:  # type: ignore[no-untyped-def]
    """Wall-sided, Δ sin φ (GM + BM tan²φ/2) = m a cos φ: half a load more leaves GM = -35 mm of 50 mm."""
    height, aside, contingency = height_for(0.050), 1e-3, 1.5
    load = contingency * LOAD
    mass = BARGE + load
    bm = BREADTH**2 / (12 * mass / (WATER * LENGTH * BREADTH))

    def missing(angle: float, moorings: float) -> float:
        gm = kept(load, height) + moorings + bm * math.tan(angle) ** 2 / 2
        return mass * math.sin(angle) * gm - load * aside * math.cos(angle)

    least, most = (brentq(missing, 0.02, 0.3, args=(held,)) for held in (OF_MOORINGS, 0.0))
    assert 3.7 < math.degrees(least) < math.degrees(most) < 4.1
    recording = found(aboard(height, contingency=contingency, aside=aside))
    lies = recording.column("vessel_heel", "barge")[0]
    assert abs(math.degrees(lies)) < 0.1
    heel = -(lies + recording.rig.vessels[0].by_contingency[0].heel)
    assert least < heel < most


def test_one_without_an_equilibrium_is_told() -> None:
    """Of the lift as it rests with nothing more, told to rest nowhere with more."""
    question = Statics(aboard(height_for(0.050), "design"))
    nowhere = ByContingency(0.0, heel=0.0, trim=0.0, freeboard=0.0, rests=False)
    rest = question.equilibrium(0.0, losses="held").with_rest(AtRest({}, {"barge": nowhere}))
    [check] = told(rest.recording)
    assert check.verdict is Verdict.WARNING
    assert check.remark.startswith("with the design weight no equilibrium is found from here")
