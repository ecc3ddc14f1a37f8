"""Two ways in which lugs with ropes of `mechanics` bore less than they do.

A rope that goes up from a lug and comes back to it counted with one of its falls. And a lashing or tugger at
the lug of a sling, slack or not, took the rule's skew load factor from the sling: vectors of one time were
added up there, and what a rule puts on each was forgotten, and peaks between samples of one alone.
"""

from __future__ import annotations

import pytest

from gantline.checks import check_recording
from gantline.checks.lug_figures import LugFigures, lug_figures
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import changed

G = 9.81
#: 40 t below a hook that is 4 m over the lugs, which are 3 m to the side of it: slings of 5 m with cos = 4/5.
_FOUR = """\
format: 1
lift: {title: Four slings}
duration: 1 s
start: rest
ropes:
  sling: {axial_stiffness: 2000 MN, mass: none}
load:
  name: box
  shape: {box: [8 m, 6 m, 3 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 40 t, contingency: 1.1}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs:
    A: {at: [1.8 m, 2.4 m, 3 m], capacity: 50 t}
    B: {at: [-1.8 m, 2.4 m, 3 m], capacity: 50 t}
    C: {at: [1.8 m, -2.4 m, 3 m], capacity: 50 t}
    D: {at: [-1.8 m, -2.4 m, 3 m], capacity: 50 t}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 12 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
slings:
  A: {from: hook, to: box.A, length: 5 m, rope: sling}
  B: {from: hook, to: box.B, length: 5 m, rope: sling}
  C: {from: hook, to: box.C, length: 5 m, rope: sling}
  D: {from: hook, to: box.D, length: 5 m, rope: sling}
mechanics:
  ropes:
    lash:
      rope: sling
      length: 9 m
      route: [{type: end, body: box, lug: A}, {type: end, body: world, at: [3 m, 4 m, 1 m]}]
plan:
  - {step: hold, hold: until_end}
rules: {skew_load_factor: 1.25, dynamic_amplification_factor: 1.1, lug_consequence_factor: 1.3}
"""
_THERE_AND_BACK = """\
format: 1
lift: {title: A rope over an eye}
duration: 1 s
start: rest
ropes: {stay: {axial_stiffness: 2000 MN, mass: none}}
load:
  name: box
  shape: {box: [2 m, 2 m, 2 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 20 t, contingency: 1.1}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L: {at: [0 m, 0 m, 3 m], capacity: 25 t}}
mechanics:
  bodies: {top: {at: [0 m, 0 m, 20 m], joint: {type: fixed}}}
  ropes:
    up:
      rope: stay
      length: as_routed
      route:
        - {type: end, body: box, lug: L}
        - {type: eye, body: top, at: [0 m, 0 m, 0 m]}
        - {type: end, body: box, lug: L}
plan:
  - {step: hold, hold: until_end}
"""


def at_rest(text: str) -> Recording:
    return Statics(parse_scenario(text)).equilibrium(time=0.0).recording


def figures(recording: Recording) -> dict[str, LugFigures]:
    return {one.lug: one for one in lug_figures(recording)}


def test_a_slack_lashing_leaves_the_sling_its_skew_load_factor() -> None:
    """Each lug bears W/4/cos, times contingency, skew, dynamic and consequence factor."""
    found = figures(at_rest(_FOUR))
    by_hand = 40e3 * G / 4 / 0.8 * 1.1 * 1.25 * 1.1 * 1.3
    assert found["box.B"].force == pytest.approx(by_hand, rel=1e-3)
    assert found["box.A"].force == pytest.approx(found["box.B"].force, rel=1e-6)
    assert found["box.A"].slings == ("A", "lash")


def test_a_lashing_that_pulls_down_comes_on_top() -> None:
    """It is forgotten, and 80 mm too short for the load as it hangs: its pull is on the lug too."""
    rest = at_rest(changed(_FOUR, ("length: 9 m", "length: 7.2 m")))
    tension = float(rest.column("rope_tension", "lash")[-1])
    own = float(rest.column("rope_tension", "sling.A")[-1])
    assert tension > 10e3
    # What slings have with perfect lengths nothing tells beside a lashing: contingency, dynamic, consequence.
    at_least = (own + tension) * 1.1 * 1.1 * 1.3
    force = figures(rest)["box.A"].force
    assert force is not None
    assert force >= at_least * (1 - 1e-9)


def test_a_rope_that_comes_back_to_its_lug_pulls_with_both_falls() -> None:
    """All 20 t hang in two falls at one lug, so that it bears 20 t times 1.1 of 25 t."""
    rest = at_rest(_THERE_AND_BACK)
    [lug] = [one for one in check_recording(rest) if one.name == "lug_load_of_capacity"]
    assert lug.value == pytest.approx(20.0 * 1.1 / 25.0, rel=1e-6)
    assert figures(rest)["box.L"].slings == ("up",)
