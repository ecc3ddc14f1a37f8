"""A load on two slings that lean out of the plane xz, with lugs whose main plates are given."""

from __future__ import annotations

import math

from hooked_lift import hooked_lift

#: Of each lug from the middle of the load [m].
ASIDE = 2.9


def plated_lift(lean: float, plate: str) -> str:
    """Slings to the lugs A and B, each at the angle `lean` from plumb in the plane yz [rad].

    Args:
        lean: Angle of both slings [rad].
        plate: `main_plate` of both lugs, as it stands in a lift file.
    """
    up = ASIDE / math.tan(lean)
    lugs = {"A": (0.0, ASIDE, 4.0), "B": (0.0, -ASIDE, 4.0)}
    slings = {name: ("hook", name, math.hypot(ASIDE, up)) for name in lugs}
    text = hooked_lift({"hook": (0.0, 0.0, 9.0 + up)}, lugs, slings, position=(0.0, 0.0, 5.0))
    for name, at in lugs.items():
        known = f"{name}: {{at: [{at[0]!r} m, {at[1]!r} m, {at[2]!r} m]"
        assert known in text
        text = text.replace(known, f"{known}, main_plate: {plate}")
    return text
