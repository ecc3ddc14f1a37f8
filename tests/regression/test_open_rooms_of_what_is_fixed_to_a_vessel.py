"""A barge whose GM was 6.7 m too large, with two rooms open to the sea in a body fixed to her.

What runs through holes as a vessel heels takes from her GM, but only her own tanks were looked at. The same
two wing rooms in a body fixed to her, such as sponsons, were held: GM 6.61 m for -0.10 m, and
`floats_stably` said nothing. What is fixed to her is a part of her, and what is fixed to that.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from ballasted import ADDED, BREADTH, DAMPED, LENGTH, OWN, barge, lift, tank
from gantline.statics import Statics
from gantline.statics.inclining import metacentric_heights

SEA = 1025.0
#: Length, breadth and height of each room, how far aside its middle is [m]; what bears them [kg].
ROOM, ASIDE, FRAME = (60.0, 10.0, 8.0), 10.0, 1e3


@pytest.mark.parametrize("high", [5.0, 12.0])
@pytest.mark.parametrize("on", ["frame", "sponsons"])
def test_gm_is_that_of_lost_buoyancy(high: float, on: str) -> None:
    """GM Δ = (KB + BM - KG) Δ', BM and Δ' of what is left of the hull, as of rooms of her own.

    The frame's weight is as high as hers. The rooms' places are counted from their body, which lies 2 m
    to port and 1 m up.
    """
    own, area = OWN / SEA, LENGTH * BREADTH - 2 * ROOM[0] * ROOM[1]
    draft = own / area
    second = LENGTH * BREADTH**3 / 12 - 2 * (ROOM[0] * ROOM[1] ** 3 / 12 + ROOM[0] * ROOM[1] * ASIDE**2)
    expected = (draft / 2 + second / own - high) * own / (LENGTH * BREADTH * draft)
    aside, up = 2.0, 1.0
    tanks: dict[str, Any] = {}
    for name, y in (("port", ASIDE), ("starboard", -ASIDE)):
        place = (0.0, y - aside, -up)
        gash = {"at": [f"{part} m" for part in place], "area": "10 m^2"}
        tanks[name] = tank(place, SEA * ROOM[0] * ROOM[1] * draft / 1e3, ROOM) | {"holes": {"gash": gash}}
    frame = {
        "parent": "barge",
        "at": ["50 m", f"{aside} m", f"{up} m"],
        "joint": {"type": "fixed"},
        "mass": f"{FRAME} kg",
        "centre_of_gravity": ["0 m", f"{-aside} m", f"{high - up} m"],
        "inertia": {axis: "1 t m^2" for axis in ("xx", "yy", "zz")},
    }
    bodies: dict[str, Any] = {"frame": frame}
    if on == "frame":
        frame["tanks"] = tanks
    else:
        bodies["sponsons"] = {"parent": "frame", "joint": {"type": "fixed"}, "tanks": tanks}
    vessel = barge({}, added_mass=ADDED, water_damping=DAMPED)
    del vessel["tanks"]
    hull = {"mass": f"{OWN - FRAME} kg", "at": ["50 m", "0 m", f"{high} m"]}
    vessel |= {"masses": {"hull": hull}, "hull": {"box": ["100 m", "30 m", "12 m"]}}
    question = Statics(lift(vessel, start="as_given", mechanics={"bodies": bodies}))
    rest = question.equilibrium(0.0)
    assert rest.recording.column("vessel_draft_aft", "barge")[-1] == pytest.approx(draft, abs=1e-6)
    assert math.isclose(metacentric_heights(question, rest)["barge"].transverse, expected, abs_tol=1e-6)
