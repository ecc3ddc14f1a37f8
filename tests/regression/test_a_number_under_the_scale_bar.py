"""In the plan of a ship block half of the number of a sling was under the scale bar.

Lugs stood in pairs at the edges of the load, with their hook between them. The number of the lowest had no
room above its lug and came below it, where the plate of title and scale bar covers what is drawn.
"""

from __future__ import annotations

from gantline import simulate
from gantline.report.sketch import sketches
from gantline.report.sketch_paper import HEIGHT, PLATE
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario

#: Half of the height of a line of text [mm].
HALF_A_LINE = 1.7
LIFT = """\
format: 1
lift: {title: Pairs of lugs at the edges}
duration: 1 s
ropes: {sling: {axial_stiffness: 200 MN, damping_time: 50 ms}}
load:
  name: block
  shape: {box: [24 m, 18 m, 12 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 400 t}
  centre_of_gravity: {at: [0 m, 0 m, 5 m]}
  lugs:
    A1: {at: [-9 m, 8 m, 12 m]}
    A2: {at: [-9 m, 6 m, 12 m]}
    A3: {at: [-9 m, -6 m, 12 m]}
    A4: {at: [-9 m, -8 m, 12 m]}
    K1: {at: [9 m, 5 m, 12 m]}
    K2: {at: [9 m, -5 m, 12 m]}
cranes:
  U1: {type: fixed_hook, at: [-9 m, 7 m, 25.9 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
  U2: {type: fixed_hook, at: [-9 m, -7 m, 25.9 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
  L: {type: fixed_hook, at: [9 m, 0 m, 26.9 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
slings:
  A1: {from: U1, to: block.A1, length: 12 m}
  A2: {from: U1, to: block.A2, length: 12 m}
  A3: {from: U2, to: block.A3, length: 12 m}
  A4: {from: U2, to: block.A4, length: 12 m}
  K1: {from: L, to: block.K1, length: 14 m}
  K2: {from: L, to: block.K2, length: 14 m}
sling_defaults: {rope: sling}
"""


def test_numbers_of_slings_stand_clear_of_what_lies_over_them() -> None:
    _, plan = sketches(Subject(simulate(parse_scenario(LIFT))))
    numbers = {mark.text: mark.y for mark in plan.marks if mark.style == "sk-number"}
    assert set(numbers) == {"A1", "A2", "A3", "A4", "K1", "K2"}
    assert all(HALF_A_LINE <= y <= HEIGHT - PLATE - HALF_A_LINE for y in numbers.values())
