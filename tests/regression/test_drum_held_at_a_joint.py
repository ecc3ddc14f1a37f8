"""Statics of a lift with a drum that its brake holds, while other things move.

From rest to rest, and where a run is taken up, the place of such a drum is known to rounding only. What
that wound up, 1e-15 m, lay on the drum as a piece of rope of its own, with the strain of the moment, and
the drum was then held within rounding of the joint of two pieces. The force that turns it, T (1 + ε/2)/(1 +
ε_d) in statics, has two values there, some 1e-4 apart for working ropes: no step could bring that balance
below the 1e-5 that is asked for, and the answer was "no step brings its forces closer to balance", element:
the drum. Of 150 random rigs with braked drums one had no equilibrium at any time after a crane and another
drum had moved, one none where its own damped run had come to rest after a sling had been cut, and of a
third the drum was named in place of the body that falls.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from mechanics import G, body, contact, document, drum, end, flow, free, half_turn, rope, slider
from resting import at_rest

MASS, TRAVELS = 917.0, (1.0, 0.2, 0.0)
GROUND, STIFFNESS = 4.12, 968e3
EA, FIRST = 766e3, (-3.68, 0.0988, 8.0)


def system() -> dict[str, Any]:
    """A load that stands, on two ropes over a carriage: from a braked drum, and from one that hauls in."""
    bodies = [
        body("carriage", slider(TRAVELS, drive="travel"), 5100.0, position=(0, 0, 12)),
        body("load", free((-0.644, 0.0254, 5.57)), MASS, inertia=(373, 497, 435)),
        flow("braked", 10.2, brake=1e7),
        flow("hauling", 76.5, drive="haul"),
    ]
    hauled = drum(None, (-3.71, -0.0727, 8.0), "hauling")
    hauled["drum"]["layers"] = {"radius": 0.3, "step": 0.03, "turns": 1.52, "start": 5.39}
    routes = [
        (drum(None, FIRST, "braked"), (-0.682, 0.0988, 0.0), (0.207, -0.699, 1.16)),
        (hauled, (-0.711, -0.0727, 0.0), (0.61, 0.301, 1.16)),
    ]
    ropes = [
        rope(name, None, [start, half_turn("carriage", centre, 0.3, True), end("load", lug)], stiffness)
        for name, stiffness, (start, centre, lug) in zip(("held", "other"), (EA, 400e3), routes, strict=True)
    ]
    corners = [(x, y, -1.16) for x, y in ((-1.16, -1.16), (1.16, -1.16), (1.16, 1.16), (-1.16, 1.16))]
    stands = [
        contact(f"c{k}", "load", at, plane_point=[0, 0, GROUND], stiffness=STIFFNESS)
        for k, at in enumerate(corners)
    ]
    moves = [
        {"drive": name, "velocity": speed, "acceleration": 20.0, "shape": "smooth"}
        for name, speed in (("travel", -0.39), ("haul", -0.525))
    ]
    step = {"name": "go", "moves": moves, "until": {"type": "duration", "duration": 0.5}, "start_at": 0.437}
    drives = [{"name": "travel"}, {"name": "haul"}]
    return document(bodies, ropes=ropes, contacts=stands, drives=drives, plan=[step])


@pytest.mark.parametrize(("time", "is_taut"), [(0.6, True), (1.0, False), (5.0, False)])
def test_a_drum_that_its_brake_holds_has_an_equilibrium(time: float, is_taut: bool) -> None:
    """T = max(0, EA (ℓ − L)/L) of the rope from the drum that stands, and the weight on ropes and ground.

    ℓ is what the recorded segments and half a turn give, L the same at the start, where it is just taut.
    """
    rest = at_rest(system(), time)
    names = rest.core.names()
    # Each of the parts from rest to rest, some dozen, may leave 1e-11 m of what does not give.
    assert abs(rest.joint("braked")) < 1e-9
    columns = rest.core.columns()
    segments = columns["segment_length"]
    first = [k for k, name in enumerate(names["segment"]) if name.startswith("held")]
    given = document_length()
    length = segments[-1, first].sum() + math.pi * 0.3
    tension = max(0.0, EA * (length - given) / given)
    assert (tension > 100.0) == is_taut
    # 1e-12 m of rounding on 90 kN/m, and 1e-10 m of what the brake lets through.
    assert rest.tensions[0] == pytest.approx(tension, abs=1e-4)
    # Along z each rope pulls its lug by T times the rise of its last segment over its length.
    points = columns["rope_point"][-1]
    lifted = 0.0
    for name, force in zip(names["rope"], rest.tensions, strict=True):
        rows = [k for k, point in enumerate(names["rope_point"]) if point.startswith(name)]
        way = points[rows[-2]] - points[rows[-1]]
        lifted += force * way[2] / float(np.linalg.norm(way))
    borne = columns["contact_force"][-1].sum()
    assert lifted + borne == pytest.approx(MASS * G, rel=1e-9)


def document_length() -> float:
    """Unstretched: from the drum to the sheave, half a turn, and to the lug, all at the start [m]."""
    enter, leave = np.array((-0.982, 0.0988, 12.0)), np.array((-0.382, 0.0988, 12.0))
    lug = np.array((-0.644 + 0.207, 0.0254 - 0.699, 5.57 + 1.16))
    straight = np.linalg.norm(enter - np.array(FIRST)) + np.linalg.norm(lug - leave)
    return float(straight) + math.pi * 0.3
