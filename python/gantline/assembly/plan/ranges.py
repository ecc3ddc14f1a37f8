"""How far trolleys, cranes, upper structures and chain hoists may go, for checks of where they come to."""

from __future__ import annotations

from gantline.assembly.parts import Json
from gantline.scenario import Scenario
from gantline.scenario.cranes.chain_hoist import chain_flow
from gantline.scenario.cranes.crawler import Crawler, along_body
from gantline.scenario.plan.movers import movers

__all__ = ["range_rig"]


def range_rig(scenario: Scenario) -> Json:
    """Ends of range of what traverses, travels, slews or pays out [m, rad]; nothing in a lift without."""
    cranes = scenario.cranes or {}
    found = [
        # A crawler crane travels on a joint of its own, everything else on that of its name.
        {
            "name": name,
            "joint": along_body(name) if kind == "crane" and isinstance(cranes[name], Crawler) else one.name,
            "range": list(one.range),
            "turns": kind == "upper",
        }
        for kind in ("trolley", "crane", "upper")
        for name, one in movers(scenario, kind).items()
        if one is not None and one.range is not None
    ]
    found += [
        {
            "name": name,
            "joint": chain_flow(name.removeprefix("sling.")),
            "range": list(one.range),
            "pays_out": True,
        }
        for name, one in movers(scenario, "line").items()
        if one is not None and one.range is not None
    ]
    return {"ranges": found} if found else {}
