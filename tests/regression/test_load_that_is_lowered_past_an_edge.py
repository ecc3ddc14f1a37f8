"""An engine that was lowered past an edge was "picked up again ... for 646.2 s: pay out more slack".

It met a beam on its way down at 849.7 s, slid off at 853.8 s and went on down with its hook. What lets a load
go in the step that lowers it, so that it hangs lower from then on, picks nothing up.
"""

from __future__ import annotations

from gantline import simulate
from gantline.checks import check_recording
from gantline.scenario import parse_scenario

#: The load hangs 0.3 m above a deck, meets it 6 s after it begins to go down, at 12 s, and goes on to 0.6 m
#: below that, while the deck goes away from under it to 2 m below.
LIFT = """\
format: 1
lift: {title: Past a deck that goes away}
duration: 26 s
start: rest
ropes: {soft: {axial_stiffness: 20 MN, damping_time: 10 ms}}
load:
  name: box
  shape: {box: [2 m, 2 m, 2 m]}
  position: [0 m, 0 m, 0.3 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {top: {at: [0 m, 0 m, 2 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 7.3 m], hoist: {speed: 30 m/min, acceleration: 0.2 m/s^2}}
slings: {S: {from: hook, to: box.top, length: 5 m, rope: soft}}
mechanics:
  bodies:
    deck:
      at: [10 m, 0 m, 0 m]
      joint: {type: slider, axis: [0, 0, 1], motion: [{at: 13 s, duration: 0.5 s, velocity: -0.4 m/s},
                                                      {at: 18 s, duration: 0.5 s, velocity: 0 m/s}]}
      mass: 1000 t
      shape: {box: [24 m, 4 m, 1 m], centre: [0 m, 0 m, -0.5 m]}
  body_contacts:
    on_deck: {between: [box, deck], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
plan:
  - {step: wait, hold: 6 s}
  - {step: down, lower: hook, speed: 3 m/min, by: 0.9 m}
  - {step: end, hold: until_end}
simulation: {sample_interval: 10 ms}
"""


def test_it_has_not_been_picked_up() -> None:
    recording = simulate(parse_scenario(LIFT))
    kinds = [kind for _, kind, name in recording.events() if name == "box"]
    assert kinds[0] == "set_down" and kinds[-1] == "lift_off"  # it stood, and hangs in the end
    assert [one for one in check_recording(recording) if one.name == "stays_set_down"] == []
