"""A hook whose slings are cut all at once, by equations of motion.

The load M hangs in a hook m on n parts of one undamped rope of the length L and the axial stiffness EA, which
give way to the hook by k = n² EA/L. Cut, the hook swings about its own rest until the falls are slack, flies,
and comes back into them. With x down from where they are just taut,

    x = m g/k + (M g/k) cos ω t,  ω² = k/m,  until cos ω t = -m/M,

and then freely with the speed that it has. It rises from rest by what the falls held over its weight, and it
falls back through the same:

    H = ½ k ((M + m) g/k)²/m g = (M + m)² g/2 m k .
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline import parse_scenario, simulate
from gantline.assembly import assemble

G, LOAD, HOOK, PARTS, EA, CUT = 9.81, 60e3, 8e3, 6, 40e6, 0.5
LIFT = f"""
format: 1
lift: {{title: A hook that is let go}}
duration: 1.5 s
start: rest
ropes:
  sling: {{axial_stiffness: 200 MN, mass: none}}
  hoist: {{axial_stiffness: {EA} N, mass: none}}
load:
  name: module
  shape: {{box: [6 m, 6 m, 4 m]}}
  datum: bottom_centre
  position: [0 m, 0 m, 6 m]
  weight: {{calculated: {LOAD} kg, contingency: 1.0, simulate: calculated}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  lugs: {{A: {{at: [2 m, 0 m, 4 m]}}, B: {{at: [-2 m, 0 m, 4 m]}}}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 20 m]
    rated_capacity: 100 t
    block: {{mass: {HOOK} kg, height: 2 m}}
    reeving:
      {{ropes: 1, parts_each: {PARTS}, rope: hoist, sheave_diameter: 0.6 m, sheave_efficiency: 1.0,
       upper_sheaves_at: 40 m}}
    hoist: {{speed: 5 m/min, acceleration: 0.02 m/s^2}}
    drum: {{diameter: 0.8 m}}
slings:
  A: {{from: hook, to: module.A, length: 10.3 m, rope: sling, cut_at: {CUT} s}}
  B: {{from: hook, to: module.B, length: 10.3 m, rope: sling, cut_at: {CUT} s}}
plan: [{{step: hold, hold: until_end}}]
simulation: {{sample_interval: 5 ms, tension_tolerance: 0.1 N, position_tolerance: 1e-8 m}}
"""


def test_it_flies_up_and_falls_back() -> None:
    """Its course until it is back in its falls, to 1e-6 of H, and when these are slack and taut, to 1 µs."""
    lift = parse_scenario(LIFT)
    (falls,) = [rope for rope in assemble(lift).document["ropes"] if rope["name"].startswith("hoist.")]
    k = PARTS**2 * EA / falls["length"]
    omega, rest, swing = math.sqrt(k / HOOK), HOOK * G / k, LOAD * G / k
    slack = math.acos(-HOOK / LOAD) / omega
    speed = swing * omega * math.sin(omega * slack)
    taut = slack + 2.0 * speed / G
    highest = (LOAD + HOOK) ** 2 * G / (2.0 * HOOK * k)

    run = simulate(lift)
    since = np.clip(run.time - CUT, 0.0, None)
    flying = since - slack
    x = np.where(flying < 0.0, rest + swing * np.cos(omega * since), -speed * flying + 0.5 * G * flying**2)
    level = run.column("body_position", "hook")[:, 2]
    until = since < taut
    assert not until[-1]
    assert (level - level[0])[until] == pytest.approx((rest + swing - x)[until], abs=1e-6 * highest)
    assert rest + swing + 0.5 * speed**2 / G == pytest.approx(highest, rel=1e-12)
    events = zip(run["event_kind"].values, run["event_name"].values, run["event_time"].values, strict=True)
    turns = [(str(kind), time - CUT) for kind, name, time in events if name == falls["name"]]
    assert turns[:2] == [("slack", pytest.approx(slack, abs=1e-6)), ("taut", pytest.approx(taut, abs=1e-6))]
