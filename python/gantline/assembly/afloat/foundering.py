"""What the lift file says of a vessel that sinks or capsizes on its way to rest."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gantline.assembly.afloat.vessels import upright_hydrostatics
from gantline.assembly.afloat.water import frozen
from gantline.scenario import Scenario
from gantline.units import format_quantity

__all__ = ["foundered"]

#: What the core says of a vessel.
_SINKS = "it sinks: no hull bears that weight"
_CAPSIZES = "it capsizes before it comes to rest"
#: Share of KM by which the centre of what it weighs may be beside that of the water that it displaces: some
#: 6 deg of heel or trim bring it over that.
_OFF = 0.1
#: What lies along x and y, and the other way; from how far on it is told [m].
_BESIDE = (("ahead", "astern"), ("to port", "to starboard"))
_SHOWN = 0.005


def foundered(scenario: Scenario, element: str, cause: str) -> str:
    """What is behind it, as far as the vessel's own masses and tanks tell; nothing of anything else.

    Args:
        scenario: The lift.
        element: What the core names.
        cause: What it says of that.
    """
    if not cause.endswith((_SINKS, _CAPSIZES)):
        return ""
    vessel = (scenario.vessels or {}).get(element)
    if vessel is None:
        return ""
    tanks = (vessel.tanks or {}).values()
    own: list[tuple[float, Sequence[float]]] = [(one.mass, one.at) for one in vessel.masses.values()]
    own += [(tank.content, frozen(tank)[0]) for tank in tanks if tank.content]
    mass = sum(one for one, _ in own)
    weighs = f"its masses and tanks alone are {format_quantity(mass, 't', 0)}"
    if cause.endswith(_SINKS):
        whole = upright_hydrostatics(scenario, element, vessel, draft=math.inf)
        return f"; {weighs}, and all of its hull displaces {format_quantity(whole.mass, 't', 0)}"
    along, across, centre = (sum(one * at[axis] for one, at in own) / mass for axis in range(3))
    upright = upright_hydrostatics(scenario, element, vessel)
    gm = format_quantity(upright.km_transverse - centre, "m", 2)
    above = f"{format_quantity(centre, 'm', 2)} above the keel"
    said = f"; {weighs}, their centre {above}, which gives it a GM of {gm} at its draft"
    if upright.km_transverse < centre:
        return said
    off = tuple(float(part) for part in (along, across) - upright.centre_of_buoyancy[:2])
    if abs(off[0]) > _OFF * upright.km_longitudinal or abs(off[1]) > _OFF * upright.km_transverse:
        beside = [
            f"{format_quantity(abs(way), 'm', 2)} {words[way < 0.0]}"
            for way, words in zip(off, _BESIDE, strict=True)
            if abs(way) >= _SHOWN
        ]
        return f"{said}; but that centre is {' and '.join(beside)} of the one of its hull below the water"
    return f"{said}; what else is on it or pulls it turns it over: cranes, loads, mooring lines, fenders"
