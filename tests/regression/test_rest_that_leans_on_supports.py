"""A load was told to rest 19.3 deg from where a run has it, where it leans on its supports at rest.

A vessel of 60 t hangs clear by 0.3 m in two baskets in which it rolls freely: its equilibrium lies on two of
its saddles, which bear 24 kN and 33 kN. Whether it would have stayed where it hung nothing tells then, and
`hangs_stably` says so; the list of what carries was asked, which is empty where contacts slide freely.
"""

from __future__ import annotations

from gantline import simulate
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from of_recording import checks_of

LIFT = """\
format: 1
lift: {title: A pressure vessel of 60 t in two baskets}
duration: 60 s
ground: {level: 0 m, friction: 0.5}
ropes:
  poly: {axial_stiffness: 12 MN, mass: 5 kg/m, diameter: 80 mm, damping_time: 20 ms}
load:
  name: tank
  shape: {box: [12 m, 3 m, 3 m]}
  datum: bottom_centre
  position: [0 m, 0 m, 0.5 m]
  stands_on: saddles
  weight: {calculated: 60 t, contingency: 1.05}
  centre_of_gravity: {at: [0.4 m, 0 m, 1.5 m]}
supports:
  saddles:
    {under: tank, grid: {x: [-5 m, 5 m], y: [-1 m, 1 m]}, height: 0.5 m,
     stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.4}
cranes:
  west: {type: fixed_hook, at: [-3 m, 0 m, 9 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
  east: {type: fixed_hook, at: [3 m, 0 m, 9 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
mechanics:
  ropes:
    west:
      rope: poly
      length: 19.5 m
      route:
        - {type: end, body: west}
        - {type: eye, body: tank, at: [-3.4 m, 1.5 m, 0 m]}
        - {type: eye, body: tank, at: [-3.4 m, 0 m, -1.5 m]}
        - {type: eye, body: tank, at: [-3.4 m, -1.5 m, 0 m]}
        - {type: end, body: west}
    east:
      rope: poly
      length: 19.5 m
      route:
        - {type: end, body: east}
        - {type: eye, body: tank, at: [2.6 m, 1.5 m, 0 m]}
        - {type: eye, body: tank, at: [2.6 m, 0 m, -1.5 m]}
        - {type: eye, body: tank, at: [2.6 m, -1.5 m, 0 m]}
        - {type: end, body: east}
plan:
  - {step: lift off, hoist: [west, east], speed: 1 m/min, until: {supports: clear}}
  - {step: up, hoist: [west, east], speed: 1 m/min, by: 0.3 m}
  - {step: hold, hold: until_end, report: [hook_load]}
"""


def test_what_leans_tells_nothing() -> None:
    scenario = parse_scenario(LIFT)
    rest = Statics(scenario).equilibrium(60.0).recording
    saddles = [name for name in rest.coordinates["contact"] if name.startswith("support.")]
    assert any(rest.column("contact_force", name)[-1] > 1e3 for name in saddles)
    recording = simulate(scenario)
    [check] = checks_of(recording, "hangs_stably")
    assert check.remark == (
        "no equilibrium was found in which tank hangs clear in west, east: whether a push rolls it over is "
        "not known; 'gantline statics' shows where it rests"
    )
