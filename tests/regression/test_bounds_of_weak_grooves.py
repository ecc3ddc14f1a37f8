"""Where rope slips in grooves, `gantline statics` found no bounds, and counted each sheave twice.

Of a sheave with a bearing and a groove that is weaker, both were to give way: the bearing resisted with more
than the groove can hold, and the search came to "no step brings its forces closer to balance". So did
`gantline statics` and `cases` of an equalizer with `bearing: plain, groove_friction: 0.01`, which ended with
3. And three sheaves were "losses of 6 sheaves left out", since the spin of each was another.

Now the weaker of both gives way, (F11) of docs/concepts/flows.md, and the other holds.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.results import series
from gantline.scenario import parse_scenario

PARTS = 3
BEARING, WRAP = 0.96, math.pi
LIFT = """\
format: 1
lift: {title: A weight on three parts}
duration: 10 s
ropes: {fall: {axial_stiffness: 30000 MN, mass: 0.001 kg/m, damping_time: 10 ms}}
mechanics:
  bodies:
    head: {at: [0 m, 0 m, 12 m], joint: {type: fixed}}
    weight: {at: [0 m, 0 m, 4 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 t}
  ropes:
    fall:
      rope: fall
      rope_weight: none
      length: as_routed
      route:
        - {type: end, body: weight, at: [-0.9 m, 0 m, 0 m]}
        - {type: half_turn, body: head, enter: [-0.9 m, 0 m, 0 m], leave: [-0.3 m, 0 m, 0 m], LOSSES,
           bulge: [0, 0, 1]}
        - {type: half_turn, body: weight, enter: [-0.3 m, 0 m, 0 m], leave: [0.3 m, 0 m, 0 m], LOSSES,
           bulge: [0, 0, -1]}
        - {type: half_turn, body: head, enter: [0.3 m, 0 m, 0 m], leave: [0.9 m, 0 m, 0 m], LOSSES,
           bulge: [0, 0, 1]}
        - {type: end, body: world, at: [0.9 m, 0 m, 4 m]}
"""


def statics(friction: float) -> gantline.Statics:
    """The weight on three parts, with that friction in all grooves."""
    losses = f"bearing: plain, sheave_mass: 60 kg, groove_friction: {friction}"
    return gantline.Statics(parse_scenario(LIFT.replace("LOSSES", losses)))


@pytest.mark.parametrize("friction", [0.002, 0.005, 0.01, 0.0129, 0.0131, 0.1])
def test_the_weaker_gives_way(friction: float) -> None:
    """K = min(e^(mu theta), 1/eta): the lead line by (WI5) raising, the dead end lowering.

    With K of each sheave the latter is W/(1 + 1/K + 1/K^2). Both are of rope that does not stretch; at a
    strain of 1e-6 they hold to about that.
    """
    ratio = min(math.exp(friction * WRAP), 1.0 / BEARING)
    weight = 10e3 * 9.81
    asked = statics(friction)
    along = asked.equilibrium(losses="forward").recording
    against = asked.equilibrium(losses="backward").recording
    lead = weight * (ratio - 1.0) / (1.0 - ratio**-PARTS)
    dead = weight / sum(ratio**-number for number in range(PARTS))
    assert series.tightest_tension(along, "fall")[-1] == pytest.approx(lead, rel=1e-6)
    assert series.tightest_tension(against, "fall")[-1] == pytest.approx(dead, rel=1e-6)


def test_each_sheave_is_counted_once() -> None:
    assert statics(0.01).equilibrium().lossy == ("fall/sheave_1", "fall/sheave_2", "fall/sheave_3")
