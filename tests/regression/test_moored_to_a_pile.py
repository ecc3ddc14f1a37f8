"""A vessel on lines to a pile, a body of `mechanics` fixed in the ground, was not moored; nor by a bollard.

Its waves were told to take it along "ever faster", for "no mooring line holds" it; so it was with a line to a
bollard fixed aboard a vessel at anchor. And of a barge on a hawser behind another that nothing holds, in a
current, it was said only that "no step brings its forces closer to balance".
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import StartError, parse_scenario
from gantline.scenario.afloat.mooring import is_moored, lines_at
from gantline.simulation import Simulation

FIXED = "joint: {type: fixed}, mass: 1 t"
TEXT = f"""\
format: 1
lift: {{title: A tow}}
duration: 5 s
start: rest
water: {{density: 1025 kg/m^3, level: 0 m}}
current: {{speed: 1 m/s, direction: 180 deg}}
ropes: {{nylon: {{axial_stiffness: 4 MN, damping_time: 0.1 s, mass: none}}}}
vessels:
  lead:
    draft: 3 m
    hull: {{box: [60 m, 20 m, 5 m]}}
    masses: {{all: {{mass: 3690 t, at: [30 m, 0 m, 3 m]}}}}
    radii_of_gyration: [7 m, 16 m, 17 m]
    current_areas: {{none: {{area: 1 m^2, coefficient: 0, along: x}}}}
  tow:
    position: [-160 m, 0 m]
    draft: 2 m
    hull: {{box: [60 m, 24 m, 4.5 m]}}
    masses: {{all: {{mass: 2952 t, at: [30 m, 0 m, 2 m]}}}}
    radii_of_gyration: [8 m, 17 m, 18 m]
    current_areas: {{bow: {{area: 48 m^2, at: [30 m, 0 m, 1 m], coefficient: 2, along: x}}}}
mechanics:
  bodies:
    bollard: {{parent: lead, at: [1 m, 0 m, 5 m], {FIXED}}}
    pile: {{at: [100 m, 0 m, 0 m], {FIXED}}}
mooring_lines:
  hawser: {{vessel: tow, fairlead: [60 m, 0 m, 4.5 m], to: [0, 0, 0], held_by: bollard, rope: nylon,
           pretension: 40 kN, type: spring}}
"""
AHEAD = """\
  ahead: {vessel: lead, fairlead: [60 m, 0 m, 5 m], to: [0 m, 0 m, 5 m], held_by: pile, rope: nylon,
          pretension: 40 kN, type: spring}
"""
PLAN = "plan: [{step: hold, hold: until_end}]\n"


def test_a_pile_and_a_bollard_hold() -> None:
    """The pile stands in the ground, the bollard on the vessel at the pile."""
    lift = parse_scenario(TEXT + AHEAD + PLAN)
    assert [is_moored(lift, vessel) for vessel in ("lead", "tow")] == [True, True]
    assert lines_at(lift, "lead") == ["hawser", "ahead"]
    # The hawser at rest pulls what the current pushes the tow with, F = rho/2 C A u^2; it falls by 0.5 m in
    # 101 m, 1.2e-5 of the force, and the tow trims by some 1e-4.
    pull = Simulation(lift).run().column("mooring_tension", "hawser")[0]
    assert pull == pytest.approx(0.5 * 1025 * 2 * 48 * 1.0**2, rel=1e-4)


def test_what_nothing_holds_is_said() -> None:
    adrift = parse_scenario(TEXT + PLAN)
    assert [is_moored(adrift, vessel) for vessel in ("lead", "tow")] == [False, False]
    with pytest.raises(StartError, match=r"; no mooring line leads from it to the world, nor from what its"):
        Simulation(adrift)
    assert assemble(adrift).doubts == ()
