"""A load with its centre of gravity above its lugs, aside of the middle of them, under one equalizer.

It turns over, and on the way the search for where it comes to rest may end: "no step brings its forces closer
to balance (tower)", and nothing of why. The message says now how far above the lugs the centre of gravity is.
In the middle of its lugs the same load is found upright and unstable, as it was.
"""

from __future__ import annotations

import pytest

from gantline import NoEquilibriumError, ScenarioError, Statics, parse_scenario, simulate
from gantline.assembly.origin import with_advice

LIFT = """\
format: 1
lift: {{title: Top-heavy under one equalizer}}
duration: 10 s
ropes:
  s: {{axial_stiffness: 120 MN, damping_time: 10 ms, mass: none}}
load:
  name: tower
  shape: {{box: [4 m, 4 m, 9 m]}}
  datum: bottom_centre
  weight: {{calculated: 80 t}}
  centre_of_gravity: {{at: [{aside} m, 0 m, {height} m]}}
  lugs:
    A: {{at: [-1.6 m, 0 m, 3.5 m]}}
    B: {{at: [1.6 m, 0 m, 3.5 m]}}
cranes:
  h: {{type: fixed_hook, at: [0 m, 0 m, 20 m], hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}
equalizers:
  q:
    hangs_from: h
    frame: {{mass: 2 t, length: 5 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 2 m}}
    hinge: {{axis: vertical}}
    rope: s
    rope_ends: {{along: [-2.4 m, 2.4 m], below_hook: 3 m}}
    fixed_sheaves: {{along: [0 m], below_hook: 3 m, pitch_diameter: 1.6 m}}
    moving_sheaves: {{along: [-1.6 m, 1.6 m], below_hook: 5 m, pitch_diameter: 1.6 m, mass: 300 kg}}
    travel: {{up: 1.5 m, down: 2 m, stops: true}}
slings:
  A: {{from: q.1, to: tower.A, length: 11.5 m, rope: s}}
  B: {{from: q.2, to: tower.B, length: 11.5 m, rope: s}}
plan:
  - {{step: hold, hold: until_end}}
"""
NO_STEP = "no step brings its forces closer to balance"
#: 5 m less 3.5 m.
SAID = "; its centre of gravity is 1.50 m above the highest lug that it hangs from, so that it may turn over"


def test_it_is_said_that_it_is_top_heavy() -> None:
    """Of statics and of a run alike."""
    lift = parse_scenario(LIFT.format(aside=0.05, height=5.0))
    with pytest.raises(NoEquilibriumError) as found:
        Statics(lift).equilibrium()
    assert found.value.cause.endswith(SAID)
    with pytest.raises(ScenarioError) as refused:
        simulate(lift)
    assert SAID in str(refused.value)


def test_a_load_below_its_lugs_is_not_blamed() -> None:
    """Nor what is no load; a search may end for other reasons."""
    top_heavy, low = (parse_scenario(LIFT.format(aside=0.05, height=height)) for height in (5.0, 2.0))
    assert with_advice(low, "tower", NO_STEP) == NO_STEP
    assert SAID not in with_advice(top_heavy, "q", NO_STEP)
    assert with_advice(top_heavy, "tower", NO_STEP) == NO_STEP + SAID


def test_in_the_middle_of_its_lugs_it_is_unstable() -> None:
    """About the line of its lugs, and with them: an equalizer gives no tilt stiffness."""
    rest = Statics(parse_scenario(LIFT.format(aside=0.0, height=5.0))).equilibrium()
    assert (rest.is_stable, rest.unstable) == (False, 2)
