"""A bridge section that two crawlers take from a barge onto two piers, read line by line.

`body_contacts` between the load and a structure, which touch by themselves, were there twice, of twice the
stiffness, without a word. A hull that drifted into a pier was told that "drawn sizes of cranes are rough".
Hooks whose levels differ by 0.5 mm were both "0.000 m up" beside a difference of "1 mm".
"""

from __future__ import annotations

import re

import pytest

from gantline import Simulation
from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.scenario import ScenarioError, parse_scenario
from module_lift import BARGE, module_lift

JETTY = "structures: {jetty: {type: box, x: [39 m, 60 m], y: [-20 m, 20 m], z: [-10 m, 3 m]}}\n"
TWICE = """\
mechanics:
  body_contacts:
    mine: {between: [module, jetty], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
"""


def lift(around: str) -> str:
    ground = "ground: {level: -10 m}\n"
    return module_lift(0.5, place=(50.0, 12.0), speed=30.0, duration=2.0, ground=ground, around=around)


def test_what_touches_by_itself_touches_once() -> None:
    said = (
        "module and jetty touch by themselves, as the load does all 'structures': leave this out; a structure"
    )
    with pytest.raises(ScenarioError, match=said) as refused:
        assemble(parse_scenario(lift(JETTY + TWICE)))
    assert refused.value.problems[0].path == "mechanics.body_contacts.mine.between"


def test_hulls_are_not_drawn_roughly() -> None:
    checks = check_recording(Simulation(parse_scenario(lift(BARGE + JETTY))).run())
    (found,) = (one for one in checks if one.name == "no_overlap")
    assert found.element == "barge to jetty"
    assert "hulls go through each other and structures unless fenders" in found.remark
    assert "crane" not in found.remark


def test_levels_are_written_as_far_as_they_differ() -> None:
    """Two hooks, of which one goes 0.4 mm further up."""
    recording = Simulation(parse_scenario(TWO_HOOKS)).run()
    (found,) = (one for one in check_recording(recording) if one.name == "hook_level_difference")
    assert found.value == pytest.approx(0.4e-3, abs=1e-9)
    # Where it first is a tenth below its largest, each level to a tenth of a millimetre.
    levels = [float(level) for level in re.findall(r"[AB] (\d\.\d{4}) m", found.formula)]
    assert levels[0] - levels[1] == pytest.approx(0.4e-3, abs=0.04e-3 + 0.1e-3)


TWO_HOOKS = """
format: 1
lift: {title: Two hooks}
duration: 20 s
start: as_given
ropes: {sling: {axial_stiffness: 100 MN, damping_time: 50 ms}}
load:
  name: beam
  shape: {box: [8 m, 2 m, 1 m]}
  position: [0 m, 0 m, 4 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 0.5 m]}
  lugs: {A: {at: [-3 m, 0 m, 1 m]}, B: {at: [3 m, 0 m, 1 m]}}
cranes:
  A: {type: fixed_hook, at: [-3 m, 0 m, 10 m], hoist: {speed: 30 m/min, acceleration: 0.5 m/s^2}}
  B: {type: fixed_hook, at: [3 m, 0 m, 10 m], hoist: {speed: 30 m/min, acceleration: 0.5 m/s^2}}
slings:
  A: {from: A, to: beam.A, length: 5 m, rope: sling}
  B: {from: B, to: beam.B, length: 5 m, rope: sling}
plan:
  - {step: up A, hoist: A, speed: 0.2 m/s, by: 1.0004 m}
  - {step: up B, hoist: B, speed: 0.2 m/s, by: 1 m, starts: with_previous}
  - {step: hold, hold: until_end}
limits: {hook_level_difference: 50 mm}
"""
