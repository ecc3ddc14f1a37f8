"""What the lift file says of a vessel that sinks or capsizes on its way to rest."""

from __future__ import annotations

import math

from gantline.assembly.vessels import upright_hydrostatics
from gantline.assembly.water import frozen
from gantline.scenario import Scenario
from gantline.units import format_quantity

__all__ = ["foundered"]

#: What the core says of a vessel.
_SINKS = "it sinks: no hull bears that weight"
_CAPSIZES = "it capsizes before it comes to rest"


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
    own = [(one.mass, one.at[2]) for one in vessel.masses.values()]
    own += [(tank.content, frozen(tank)[0][2]) for tank in tanks if tank.content]
    mass = sum(one for one, _ in own)
    weighs = f"its masses and tanks alone are {format_quantity(mass, 't', 0)}"
    if cause.endswith(_SINKS):
        whole = upright_hydrostatics(scenario, element, vessel, draft=math.inf)
        return f"; {weighs}, and all of its hull displaces {format_quantity(whole.mass, 't', 0)}"
    centre = sum(one * height for one, height in own) / mass
    upright = upright_hydrostatics(scenario, element, vessel)
    gm = format_quantity(upright.km_transverse - centre, "m", 2)
    above = f"{format_quantity(centre, 'm', 2)} above the keel"
    return f"; {weighs}, their centre {above}, which gives it a GM of {gm} at its draft"
