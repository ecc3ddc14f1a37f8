"""A barge on which a load was set down aside had a GM of 18.2 m, more than without it, and kept its limit.

Set down 6 m aside, 100 t heel a barge of 2460 t by 0.96 degrees and raise what weighs on it: its GM goes from
14.7 m to 14.0 m, by hand and by `gantline statics --held`. A run asks equilibria without friction what rights
a vessel, since friction of fenders rights none. There the load slid along the deck until its slings, slack in
the run, held it: and with it, stuck to the deck as the barge was inclined, its crane held the barge.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict
from gantline.cli.vessels import vessels_at_rest
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

LENGTH, BREADTH, DEPTH, DRAFT, WATER = 60.0, 20.0, 5.0, 2.0, 1.025
#: Masses [t], heights of their centres over the keel [m], and how far the load stands aside [m].
BARGE, LOAD, ASIDE = WATER * LENGTH * BREADTH * DRAFT, 100.0, 6.0
BARGE_AT, LOAD_AT = 3.0, DEPTH + 1.5


def lift(limit: float = 1.0) -> Scenario:
    lines = "".join(
        f"  {name}: {{vessel: barge, fairlead: [{x} m, {y} m, 5 m], to: [{to} m, {6 * y} m, 5 m], "
        "rope: nylon, pretension: 20 kN, type: spring}\n"
        for name, x, y, to in (("a", 60, 10, 120), ("b", 60, -10, 120), ("c", 0, 10, -60), ("d", 0, -10, -60))
    )
    slings = "".join(
        f"  {lug}: {{from: hook, to: box.{lug}, length: 12 m}}\n" for lug in ("A", "B", "C", "D")
    )
    return parse_scenario(f"""\
format: 1
lift: {{title: Set down aside on a barge}}
duration: 400 s
start: rest
water: {{density: {WATER} t/m^3, level: 0 m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 3500 kN, mass: none}}
  nylon: {{axial_stiffness: 1 MN, damping_time: 0.5 s, minimum_breaking_force: 800 kN, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  position: [30 m, {ASIDE} m, 6 m]
  weight: {{calculated: {LOAD} t}}
  centre_of_gravity: {{at: [0 m, 0 m, {LOAD_AT - DEPTH} m]}}
  lugs:
    A: {{at: [-3 m,  2 m, 3 m], capacity: 80 t}}
    B: {{at: [ 3 m,  2 m, 3 m], capacity: 80 t}}
    C: {{at: [ 3 m, -2 m, 3 m], capacity: 80 t}}
    D: {{at: [-3 m, -2 m, 3 m], capacity: 80 t}}
vessels:
  barge:
    position: [0 m, 0 m]
    draft: {DRAFT} m
    hull: {{box: [{LENGTH} m, {BREADTH} m, {DEPTH} m]}}
    masses: {{all: {{mass: {BARGE} t, at: [30 m, 0 m, {BARGE_AT} m]}}}}
    radii_of_gyration: [7 m, 17 m, 17 m]
    water_damping:
      critical: {{surge: 10 %, sway: 10 %, heave: 20 %, roll: 10 %, pitch: 20 %, yaw: 10 %,
        periods: {{surge: 30 s, sway: 30 s, yaw: 30 s}}}}
mooring_lines:
{lines}cranes:
  hook:
    {{type: fixed_hook, at: [30 m, {ASIDE} m, 20.4 m], rated_capacity: 150 t,
      hoist: {{speed: 4 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
{slings}mechanics:
  body_contacts:
    on_deck: {{between: [box, barge], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}}
plan:
  - {{step: hang, hold: 10 s}}
  - {{step: set down, lower: hook, speed: 1 m/min, until: {{load_transferred: 2 %}}}}
  - {{step: further, lower: hook, speed: 1 m/min, by: 0.3 m}}
  - {{step: end, hold: until_end}}
limits: {{metacentric_height: {limit} m}}
""")


def by_hand(*weights: tuple[float, float]) -> float:
    """GM of the barge with weights [t] at heights over its keel [m]: half its draft, B²/12T, less KG."""
    mass = sum(weight for weight, _ in weights)
    draft = mass / (WATER * LENGTH * BREADTH)
    return draft / 2.0 + BREADTH**2 / (12.0 * draft) - sum(weight * at for weight, at in weights) / mass


def heights(recording: Recording) -> list[float]:
    (vessel,) = recording.rig.vessels
    return [height for _, height, _ in vessel.righting]


def test_what_stands_aboard_goes_along() -> None:
    """Lines of 1 MN right the barge by a little more than the water does, before and after alike."""
    known = heights(simulate(lift()))
    bare, loaded = by_hand((BARGE, BARGE_AT)), by_hand((BARGE, BARGE_AT), (LOAD, LOAD_AT))
    assert known[0] == pytest.approx(bare, abs=0.03)
    # Heel of a degree adds BM tan²/2, 2 mm.
    assert known[-1] - known[0] == pytest.approx(loaded - bare, abs=0.01)
    assert min(known) == pytest.approx(known[-1], rel=1e-9)


def test_a_limit_that_it_does_not_keep_has_failed() -> None:
    (found,) = checks_of(simulate(lift(limit=14.3)), "metacentric_height")
    assert found.verdict is Verdict.FAILED


def test_statics_says_what_holds_the_barge() -> None:
    """Without friction, as unless asked for, the load hangs in its slings a little; held, it does not."""
    said = "GM as an inclining experiment finds it: box, partly lifted, holds its crane to what it stands on"
    question = Statics(lift())
    assert any(said in line for line in vessels_at_rest(question, question.equilibrium()))
    held = vessels_at_rest(question, question.equilibrium(losses="held"))
    assert not any(said in line for line in held)
    (found,) = checks_of(question.equilibrium().recording, "metacentric_height")
    assert found.verdict is Verdict.WARNING
    assert "box, partly lifted, holds its crane to what it stands on" in found.remark
    (found,) = checks_of(question.equilibrium(losses="held").recording, "metacentric_height")
    assert found.verdict is Verdict.OK
    loaded = by_hand((BARGE, BARGE_AT), (LOAD, LOAD_AT))
    (row,) = [line for line in held if line.startswith("  barge") and line.count(" m") == 2]
    assert float(row.split()[1]) == pytest.approx(loaded, abs=0.05)
