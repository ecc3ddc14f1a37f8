"""Chain hoists of slings into drums at their upper ends, which drives turn as the plan says."""

from __future__ import annotations

from gantline.assembly.afloat.moorings import warn_of_hauled
from gantline.assembly.parts import Json, Parts
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.chain_hoist import chain_flow
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.movers import movers
from gantline.scenario.plan.steps import LineStep
from gantline.scenario.rigging import SlingRigging
from gantline.units import format_by_size, format_quantity

__all__ = ["add_chain_hoist", "chain_drive", "chain_hoist_rig", "paid_out_by"]

#: Mass that moves with the chain [kg]: next to nothing beside a load, and its motion is given.
_INERTIA = 1.0
#: Chain hoists and cylinders go by some metres in a minute; beyond this a unit has slipped [m/s].
_FASTEST = 0.5


def chain_drive(sling: str) -> str:
    """Name of the drive of the chain hoist of a sling."""
    return f"{chain_flow(sling)}.drive"


def add_chain_hoist(parts: Parts, scenario: Scenario, sling: SlingRigging) -> None:
    """Add what pays chain out into a sling; nothing of a sling without."""
    hoist = sling.chain_hoist
    if hoist is None:
        return
    parts.add_drive(chain_drive(sling.name))
    parts.add_flow(chain_flow(sling.name), _INERTIA, drive=chain_drive(sling.name))
    warn_of_hauled(parts, scenario, f"sling.{sling.name}", sling.length)
    _warn_of_empty(parts, scenario, f"sling.{sling.name}")
    path = ("slings", sling.name, "chain_hoist")
    if hoist.speed > _FASTEST:
        speed = format_quantity(hoist.speed, "m/min", 0)
        sentence = f"the chain hoist of sling {sling.name} hauls in at up to {speed}"
        parts.doubts.append(Doubt((*path, "speed"), f"{sentence}; a unit has slipped, m/s for m/min"))
    if hoist.rated_capacity is not None and hoist.mass > hoist.rated_capacity:
        mass, rated = (format_by_size(one, "mass") for one in (hoist.mass, hoist.rated_capacity))
        sentence = f"the chain hoist of sling {sling.name} weighs {mass}, and may carry {rated}"
        parts.doubts.append(Doubt((*path, "mass"), f"{sentence}; a unit has slipped, t for kg"))


def _warn_of_empty(parts: Parts, scenario: Scenario, rope: str) -> None:
    """Warn of a step that moves the chain hoist of a sling that it takes off as it begins."""
    slings = movers(scenario, "line")
    for place, step in enumerate(scenario.plan):
        if not isinstance(step, LineStep) or rope not in step.detach:
            continue
        if rope in {full_name(text, slings) for text in step.moved}:
            sentence = f"step '{step.step}' takes {rope} off as it begins, and moves its chain hoist then"
            right = "it carries nothing: a step for each, in the order that is meant, is right"
            parts.doubt(("plan", place, "detach"), f"{sentence}; {right}")


def paid_out_by(sling: SlingRigging, top: Json) -> Json:
    """The upper end of a sling, with the chain hoist that pays out there; as it is of a sling without."""
    if sling.chain_hoist is None:
        return top
    return {**top, "drum": {"flow": chain_flow(sling.name), "rate": 1.0}}


def chain_hoist_rig(scenario: Scenario, rigging: Rigging) -> Json:
    """What results need to know of chain hoists; nothing in a lift without."""
    gravity = scenario.simulation.gravity
    hoists = [
        {
            "name": name,
            "joint": chain_flow(name),
            "rated_capacity": None if rated is None else rated * gravity,
            "range": None if hoist.range_ is None else list(hoist.range_),
            "weight": hoist.mass * gravity,
        }
        for name, sling in rigging.slings.items()
        if (hoist := sling.chain_hoist) is not None
        for rated in [hoist.rated_capacity]
    ]
    return {"chain_hoists": hoists} if hoists else {}
