"""A load was lifted from below a beam by slings that ran through the beam: GO.

Slings that go through their load were a warning; through structures and hulls of the lift file they went as
if these were not there, and nothing told it: the hook stood above the beam, the load hung below.
"""

from __future__ import annotations

from math import hypot

import pytest

from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

#: Length of the slings, how far their lugs are aside of the hook, and how high they stand at the start [m].
LENGTH, ASIDE, LUGS = 11.2, 1.5, 3.0
#: Top of the beam [m].
TOP = 9.0
WATCHED = "watch: [{between: [slings, beam], smallest: 0.1 m}]\n"


def lift(middle: float, more: str = "") -> str:
    """The load, and a beam of 2 m by 1 m across above it, its middle so far aside of the hook [m]."""
    return f"""\
format: 1
lift: {{title: Through a beam}}
duration: 60 s
ground: {{level: 0 m, stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.4}}
structures:
  beam: {{type: box, x: [{middle - 1.0} m, {middle + 1.0} m], y: [-3 m, 3 m], z: [{TOP - 1.0} m, {TOP} m]}}
ropes:
  sling: {{axial_stiffness: 60 MN, damping_time: 20 ms, minimum_breaking_force: 9 MN, mass: none}}
load:
  name: cube
  shape: {{box: [6 m, 3 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 50 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs:
    A: {{at: [-{ASIDE} m, 0 m, {LUGS} m], capacity: 100 t}}
    B: {{at: [{ASIDE} m, 0 m, {LUGS} m], capacity: 100 t}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 14 m], rated_capacity: 100 t,
    hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
slings:
  A: {{from: hook, to: cube.A, rope: sling, length: {LENGTH} m}}
  B: {{from: hook, to: cube.B, rope: sling, length: {LENGTH} m}}
plan:
  - {{step: up, hoist: hook, speed: 3 m/min, by: 1 m}}
  - {{step: look, hold: until_end}}
limits: {{hoist_load_of_rated_capacity: 100 %, sling_factor_on_breaking_force: 5}}
{more}"""


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "sling_outside_structures")


def test_through_a_beam() -> None:
    """Taut, the hook stands sqrt(L^2 - a^2) over the lugs; a sling leaves the beam by its top."""
    recording = simulate(parse_scenario(lift(0.0)))
    (found,) = told(recording)
    assert (found.verdict, found.element) == (Verdict.WARNING, "A")
    high = (LENGTH**2 - ASIDE**2) ** 0.5
    from_hook = (LUGS + high - TOP) * hypot(high, ASIDE) / high
    # As the slings begin to carry, within 20 ms at 50 mm/s of that.
    assert found.remark.startswith(f"A, B through 'beam', up to {from_hook:.1f}")
    assert verdict_of(check_recording(recording)).startswith("GO WITH WARNINGS")


def test_at_rest() -> None:
    (found,) = told(Statics(parse_scenario(lift(0.0))).equilibrium(60.0).recording)
    assert "through 'beam'" in found.remark


@pytest.mark.parametrize(("middle", "more"), [(2.5, ""), (0.0, WATCHED)], ids=["beside", "watched"])
def test_beside_a_beam(middle: float, more: str) -> None:
    """At 8 m a sling is 0.8 m aside of the hook; who watches the pair is told by that."""
    assert told(simulate(parse_scenario(lift(middle, more)))) == []
