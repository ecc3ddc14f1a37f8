"""How a vessel lies with the design weight of its loads, from an equilibrium with the calculated one."""

from __future__ import annotations

import math
from importlib.resources import files

import numpy as np
import pytest
from scipy.optimize import brentq

from gantline.checks import Check, Verdict
from gantline.results import Recording
from gantline.results.afloat.vessels import ByContingency
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from of_recording import checks_of

LENGTH, BREADTH, DEPTH, DRAFT, WATER = 60.0, 20.0, 5.0, 2.0, 1025.0
#: Masses [kg], heights of their centres over the keel [m], and how far the load stands aside, to port [m].
BARGE, LOAD, ASIDE = WATER * LENGTH * BREADTH * DRAFT, 100e3, 6.0
BARGE_AT, LOAD_AT = 3.0, DEPTH + 1.5
CONTINGENCY = 1.1
SWELL = files("gantline.scenarios") / "crane_barge_in_swell.yaml"


def aboard(simulated: str = "calculated", limits: str = "heel: 5 deg") -> Scenario:
    """A load that stands on the deck of a barge, to one side, with slack slings to a hook ashore."""
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
    slings = "".join(
        f"  {lug}: {{from: hook, to: box.{lug}, length: 12 m}}\n" for lug in ("A", "B", "C", "D")
    )
    return parse_scenario(f"""\
format: 1
lift: {{title: Aboard a barge}}
duration: 2 s
start: rest
water: {{density: {WATER} kg/m^3, level: 0 m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 3500 kN, mass: none}}
  nylon: {{axial_stiffness: 10 kN, damping_time: 0.5 s, minimum_breaking_force: 800 kN, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  position: [30 m, {ASIDE} m, {DEPTH - DRAFT} m]
  weight: {{calculated: {LOAD} kg, contingency: {CONTINGENCY}, simulate: {simulated}}}
  centre_of_gravity: {{at: [0 m, 0 m, {LOAD_AT - DEPTH} m]}}
  lugs:
    A: {{at: [-3 m,  2 m, 3 m], capacity: 80 t}}
    B: {{at: [ 3 m,  2 m, 3 m], capacity: 80 t}}
    C: {{at: [ 3 m, -2 m, 3 m], capacity: 80 t}}
    D: {{at: [-3 m, -2 m, 3 m], capacity: 80 t}}
vessels:
  barge:
    draft: {DRAFT} m
    hull: {{box: [{LENGTH} m, {BREADTH} m, {DEPTH} m]}}
    masses: {{all: {{mass: {BARGE} kg, at: [30 m, 0 m, {BARGE_AT} m]}}}}
    radii_of_gyration: [7 m, 17 m, 17 m]
mooring_lines:
{lines}cranes:
  hook:
    {{type: fixed_hook, at: [30 m, {ASIDE} m, 17 m], rated_capacity: 150 t,
      hoist: {{speed: 4 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
{slings}mechanics:
  body_contacts:
    on_deck: {{between: [box, barge], stiffness: 1000 MN/m, damping: 1 MN s/m, friction: 0.3}}
plan:
  - {{step: stand, hold: until_end}}
limits: {{{limits}}}
""")


def in_swell(simulated: str, limits: str = "heel: 5 deg") -> Scenario:
    """A load that hangs from the sheerleg of a crane barge, without limits but these."""
    text = SWELL.read_text(encoding="utf-8")
    begin = text.index("\nlimits:")
    text = text[:begin] + f"\nlimits: {{{limits}}}\n"
    return parse_scenario(changed(text, ("simulate: calculated", f"simulate: {simulated}")), str(SWELL))


def heel_by_hand(load: float) -> float:
    """Of the barge with the load to port [rad].

    Wall-sided, Δ sin φ (GM + BM tan²φ/2) = m (a cos φ + h sin φ), the load in the last term, not in GM.
    """
    mass = BARGE + load
    draft = mass / (WATER * LENGTH * BREADTH)
    bm = BREADTH**2 / (12.0 * draft)

    def missing(angle: float) -> float:
        gm = draft / 2.0 + bm * (1.0 + math.tan(angle) ** 2 / 2.0) - BARGE_AT * BARGE / mass
        heeling = load * (ASIDE * math.cos(angle) + LOAD_AT * math.sin(angle))
        return mass * gm * math.sin(angle) - heeling

    return -float(brentq(missing, 0.0, 0.3, xtol=1e-14))


def told(recording: Recording) -> ByContingency:
    (vessel,) = recording.rig.vessels
    return vessel.by_contingency[-1]


def now(recording: Recording, variable: str) -> float:
    return float(recording.column(variable, "barge")[-1])


def test_heel_by_a_load_aboard_is_that_of_the_closed_form() -> None:
    """To first order: a tenth more of the load heels by a tenth of 0.96 deg.

    GM changes by 0.7 m of 18 for the whole load, and by a tenth of that on the way: 0.2 % of the change. The
    lines right it by less than 1e-5 of what water does.
    """
    rest = Statics(aboard()).equilibrium(0.0, losses="held").recording
    assert now(rest, "vessel_heel") == pytest.approx(heel_by_hand(LOAD), rel=1e-3)
    more = heel_by_hand(CONTINGENCY * LOAD) - heel_by_hand(LOAD)
    assert more < math.radians(-0.08)
    assert told(rest).heel == pytest.approx(more, rel=1e-2)
    # The deck edge at that side goes down by what the barge sinks, and by the turn.
    sinks = (CONTINGENCY - 1.0) * LOAD / (WATER * LENGTH * BREADTH)
    assert told(rest).freeboard == pytest.approx(-sinks + BREADTH / 2.0 * more, rel=1e-2)
    assert told(rest).trim == pytest.approx(0.0, abs=1e-9)


def test_it_is_that_of_an_equilibrium_with_the_design_weight() -> None:
    """A load at a boom: 5 % more of it. What is of second order is 5 % of how the boom's reach changes."""
    calculated, design = (
        Statics(in_swell(simulated)).equilibrium().recording for simulated in ("calculated", "design")
    )
    for change, variable in (
        ("heel", "vessel_heel"),
        ("trim", "vessel_trim"),
        ("freeboard", "vessel_freeboard"),
    ):
        between = now(design, variable) - now(calculated, variable)
        assert getattr(told(calculated), change) == pytest.approx(between, rel=2e-2, abs=1e-6), change
    assert not design.rig.vessels[0].by_contingency


def test_a_run_tells_it_where_it_begins_and_where_steps_end() -> None:
    """At rest and at the end of its hold alike, by the same closed form."""
    recording = simulate(aboard())
    (vessel,) = recording.rig.vessels
    assert [one.time for one in vessel.by_contingency] == pytest.approx([0.0, 2.0])
    more = heel_by_hand(CONTINGENCY * LOAD) - heel_by_hand(LOAD)
    assert [one.heel for one in vessel.by_contingency] == pytest.approx([more] * 2, rel=1e-2)


def heel_check(limit: float) -> Check:
    """That of the load aboard with a limit [deg]."""
    rest = Statics(aboard(limits=f"heel: {limit} deg")).equilibrium(0.0, losses="held")
    (found,) = checks_of(rest.recording, "heel")
    return found


def test_a_limit_that_the_design_weight_passes_is_a_warning() -> None:
    """It was a GO without a word, whose vessel heels past its limit with the weight that papers allow for."""
    calculated, design = (np.degrees(-heel_by_hand(factor * LOAD)) for factor in (1.0, CONTINGENCY))
    between = heel_check((calculated + design) / 2.0)
    assert between.verdict is Verdict.WARNING
    assert between.value == pytest.approx(np.radians(calculated), rel=1e-3)
    assert f"with the design weight it comes to {design:.2f} deg" in between.remark
    assert heel_check(calculated - 0.01).verdict is Verdict.FAILED
    kept = heel_check(design + 0.01)
    assert (kept.verdict, kept.remark) == (Verdict.OK, "")


def test_freeboard_is_warned_of_alike() -> None:
    """Deck edge by hand: depth less draft, less half the breadth times sin φ; cos φ is 0.9999."""
    by_hand = {
        factor: DEPTH
        - (BARGE + factor * LOAD) / (WATER * LENGTH * BREADTH)
        + BREADTH / 2.0 * math.sin(heel_by_hand(factor * LOAD))
        for factor in (1.0, CONTINGENCY)
    }
    rest = Statics(aboard(limits=f"freeboard: {sum(by_hand.values()) / 2.0} m")).equilibrium(
        0.0, losses="held"
    )
    (found,) = checks_of(rest.recording, "freeboard")
    assert found.verdict is Verdict.WARNING
    assert found.value == pytest.approx(by_hand[1.0], abs=2e-3)
    with_design = float(found.remark.partition("with the design weight it comes to ")[2].partition(" m")[0])
    # Two decimals, and what of it is of second order.
    assert with_design == pytest.approx(by_hand[CONTINGENCY], abs=6e-3)
