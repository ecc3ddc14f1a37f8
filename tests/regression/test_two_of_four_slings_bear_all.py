"""Two of four slings carried all of a load, and nothing warned of the two that hung slack.

Of four stiff slings without an equalizer, one 30 mm short, two across carry all: 309 kN each of 60 t in place
of 154 kN. As the load came off one of the others had 23 kN for a moment, so that it was not "slack over the
whole lift", and each sling by itself kept its limits; of an equilibrium slack slings were a word in a table.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

WEIGHT = 60e3 * 9.81
#: Axial stiffness of a sling [N]; its length, and how far below the hook that has its lug at (3, 2) m.
STIFFNESS, LENGTH = 600e6, 12.0
DEPTH = (LENGTH**2 - 3.0**2 - 2.0**2) ** 0.5


def lift(first: float = LENGTH, third: float = LENGTH, parts: str = "") -> Scenario:
    return parse_scenario(f"""\
format: 1
lift: {{title: Four slings}}
duration: 60 s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: {STIFFNESS} N, damping_time: 10 ms, minimum_breaking_force: 1500 kN, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs:
    L1: {{at: [-3 m,  2 m, 3 m], capacity: 40 t}}
    L2: {{at: [ 3 m,  2 m, 3 m], capacity: 40 t}}
    L3: {{at: [ 3 m, -2 m, 3 m], capacity: 40 t}}
    L4: {{at: [-3 m, -2 m, 3 m], capacity: 40 t}}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, 14 m], rated_capacity: 100 t,
      hoist: {{speed: 2 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling, length: {LENGTH} m}}
slings:
  S1: {{from: hook, to: box.L1, length: {first} m{parts}}}
  S2: {{from: hook, to: box.L2}}
  S3: {{from: hook, to: box.L3, length: {third} m}}
  S4: {{from: hook, to: box.L4}}
plan:
  - {{step: lift off, hoist: hook, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: hook, speed: 1 m/min, by: 0.2 m}}
  - {{step: hold, hold: until_end}}
""")


def told(recording: Recording) -> Check:
    (found,) = checks_of(recording, "slings_carry")
    assert found.verdict is Verdict.WARNING
    return found


def test_at_rest_two_across_carry_all() -> None:
    """EA d/4L, by which a sling that is d short has more and its neighbours less, is more than W/4.

    So these are slack, and each of the two has W/(2 cos).
    """
    short = 0.03
    quarter = WEIGHT / 4.0 * LENGTH / DEPTH
    assert STIFFNESS * short / (4.0 * LENGTH) > quarter
    rest = Statics(lift(LENGTH - short)).equilibrium().recording
    tension = {
        name: float(rest.column("rope_tension", f"sling.{name}")[-1]) for name in ("S1", "S2", "S3", "S4")
    }
    # A thousandth: cos is that of slings of equal lengths, and the load leans by 0.2 degrees.
    assert tension["S1"] == pytest.approx(2.0 * quarter, rel=1e-3)
    assert tension["S3"] == pytest.approx(2.0 * quarter, rel=1e-3)
    assert tension["S2"] == tension["S4"] == 0.0
    assert told(rest).remark == "slack while the load hangs clear, beside others that carry it: S2, S4"


def test_one_that_was_taut_for_a_moment_is_told_of_a_run() -> None:
    run = simulate(lift(LENGTH - 0.03))
    assert float(run.column("rope_peak_tension", "sling.S2")) > 20e3
    remark = told(run).remark
    assert "slack over the whole lift: S4" in remark
    assert "slack while the load hangs clear, beside others that carry it: S2" in remark


def test_four_that_carry_are_no_matter() -> None:
    assert not checks_of(simulate(lift()), "slings_carry")
    assert not checks_of(Statics(lift()).equilibrium().recording, "slings_carry")


def test_one_that_is_cut_is_not_said_to_be_slack() -> None:
    """Its parting is told; of those that are left the one across hangs slack."""
    run = simulate(lift(parts=", cut_at: 45 s"))
    (parted,) = checks_of(run, "rope_parted")
    assert parted.element == "sling.S1"
    assert not checks_of(run, "slings_carry")
