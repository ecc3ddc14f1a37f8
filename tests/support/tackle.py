"""A lift of `mechanics` with a tackle of four parts on a winch, and what is built of such lifts."""

from __future__ import annotations

from typing import Any

from gantline.assembly import Assembly, assemble
from gantline.scenario import parse_scenario

#: Four parts of line on plain bearings, 20 t on a winch that first hauls in and then pays out.
TACKLE = """\
format: 1
lift: {title: A tackle}
duration: 24 s
ropes:
  hoist: {axial_stiffness: 200 MN, damping_time: 20 ms, mass: none}
mechanics:
  bodies:
    head: {at: [0 m, 0 m, 12 m], joint: {type: fixed}}
    load: {at: [0 m, 0 m, 2 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 20 t}
  drums:
    winch: {diameter: 0.8 m, rotating_mass: 2 t, drive: {speed: 30 m/min, acceleration: 0.2 m/s^2}}
  ropes:
    fall:
      rope: hoist
      length: as_routed
      route:
        - {type: end, body: head, at: [-0.9 m, 0 m, 0 m]}
        - {type: half_turn, body: load, enter: [-0.9 m, 0 m, 0 m], leave: [-0.3 m, 0 m, 0 m],
           bulge: [0, 0, -1], bearing: plain, sheave_mass: 60 kg}
        - {type: half_turn, body: head, enter: [-0.3 m, 0 m, 0 m], leave: [0.3 m, 0 m, 0 m],
           bulge: [0, 0, 1], loss: 4 %, moment_of_inertia: 2.7 kg m^2}
        - {type: half_turn, body: load, enter: [0.3 m, 0 m, 0 m], leave: [0.9 m, 0 m, 0 m],
           bulge: [0, 0, -1], efficiency: 96 %, rotating_mass: 30 kg}
        - {type: half_turn, body: head, enter: [0.9 m, 0 m, 0 m], leave: [1.5 m, 0 m, 0 m],
           bulge: [0, 0, 1], bearing: plain, groove_friction: 0.1, sheave_mass: 60 kg}
        - {type: end, body: world, at: [1.5 m, 0 m, 0 m], drum: winch}
plan:
  - {step: raise, haul_in: winch, speed: 12 m/min, by: 2 m}
  - {step: lower, pay_out: winch, speed: 6 m/min, acceleration: 0.1 m/s^2, by: 1 m}
  - {step: hold, hold: until_end}
"""


def assembled(text: str) -> Assembly:
    """A lift by the integrator that knows friction, as mechanics."""
    return assemble(parse_scenario(text.replace("integrator: del, step: 1 ms, ", "")))


def flows(assembly: Assembly) -> dict[str, dict[str, Any]]:
    """Joints of the flows by name."""
    bodies = assembly.document["bodies"]
    return {body["name"]: body["joint"] for body in bodies if body["joint"]["type"] == "flow"}
