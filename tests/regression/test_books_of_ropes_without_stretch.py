"""Books of `del` for ropes that do not stretch had the work of tension along the curved path twice.

What a row takes from the motion in a step is h T G v of the linear path. A rope that stretches stores what it
is longer by along the curved one, and loss of the method is the rest. One that does not stretch stores none.
A pendulum let go at 37 degrees had a remainder of 1.2 % in steps of 1 ms, 11 J beside the 0.57 J that the
method takes; one on two ropes that turn it had one of the same size.
"""

from __future__ import annotations

import pytest

import gantline

START = """\
format: 1
lift: {title: Ropes that do not stretch}
duration: 5 s
ropes:
  r: {inextensible: true, mass: none, diameter: 20 mm}
mechanics:
"""
PENDULUM = f"""{START}  bodies:
    bob: {{joint: {{type: point, position: [3 m, 0 m, 6 m]}}, mass: 100 kg}}
  ropes:
    rope:
      rope: r
      length: 5 m
      route: [{{type: end, body: bob}}, {{type: end, body: world, at: [0 m, 0 m, 10 m]}}]
"""
BAR = f"""{START}  bodies:
    bar:
      joint: {{type: free, position: [3 m, 0.5 m, 6 m], angular_velocity: [0, 0, 0.5 rad/s]}}
      mass: 100 kg
      inertia: {{xx: 40 kg m^2, yy: 40 kg m^2, zz: 40 kg m^2}}
  ropes:
    one: {{rope: r, length: as_routed, route: [{{type: end, body: bar, at: [-1 m, 0 m, 0.2 m]}},
      {{type: end, body: world, at: [0 m, 0 m, 10 m]}}]}}
    other: {{rope: r, length: as_routed, route: [{{type: end, body: bar, at: [1 m, 0 m, 0.2 m]}},
      {{type: end, body: world, at: [0 m, 1 m, 10 m]}}]}}
"""
OVER_A_SHEAVE = f"""{START}  bodies:
    left: {{joint: {{type: point, position: [-0.5 m, 0.4 m, 5 m]}}, mass: 100 kg}}
    right: {{joint: {{type: point, position: [0.5 m, 0 m, 4 m]}}, mass: 80 kg}}
  ropes:
    over:
      rope: r
      length: as_routed
      route:
        - {{type: end, body: left}}
        - type: half_turn
          body: world
          enter: [-0.5 m, 0 m, 15 m]
          leave: [0.5 m, 0 m, 15 m]
          bulge: [0, 0, 1]
        - {{type: end, body: right}}
"""


@pytest.mark.parametrize("lift", [PENDULUM, BAR, OVER_A_SHEAVE], ids=["pendulum", "bar", "over a sheave"])
def test_what_the_method_takes_is_all_that_is_lost(lift: str) -> None:
    """The remainder is rounding: the rows' work is the method's, to the last joule, whatever the step."""
    for step in (4e-3, 1e-3):
        recording = gantline.simulate(gantline.parse_scenario(lift), integrator="del", step=step)
        assert recording.attributes["energy_remainder"] < 1e-10
        energy = recording.dataset["energy"]
        assert float(energy.sel(energy_kind="method")[-1]) > 0.0
