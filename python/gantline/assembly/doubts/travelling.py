"""Crawler cranes that travel with the load, under a rule whose dynamic factor is for those that stand."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.rule_data import PRESETS, dynamic_factor
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import HoistStep, HookStep, LowerStep, TravelStep
from gantline.units import format_quantity

__all__ = ["doubtful_travelling"]

#: Onshore and inshore columns of 0027/ND, table 5-1: crawler cranes that travel with a load take the latter
#: where nothing else is documented, by note 2 to the table.
_STANDING, _TRAVELLING = "nd_0027_onshore", "nd_0027_inshore"


def doubtful_travelling(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """That crawler cranes travel with the load, and what dynamic factor the rule asks of them.

    Nothing is said where the lift file has a factor of its own.

    Args:
        scenario: The lift.
        rigging: What hangs from which hook.
    """
    rules = scenario.rules
    if rules is None or rules.preset != _STANDING or rules.dynamic_amplification_factor is not None:
        return
    found = list(_with_the_load(scenario, rigging))
    mass = scenario.load.weight.design if scenario.load is not None else None
    stands, travels = (dynamic_factor(PRESETS[name], mass) for name in (_STANDING, _TRAVELLING))
    if not found or stands is None or travels is None:
        return
    cranes = list(dict.fromkeys(crane for _, crane in found))
    goes = " and ".join(f"'{crane}'" for crane in cranes) + (" travels" if len(cranes) == 1 else " travel")
    asks, has = (format_quantity(one.value, "", 2) for one in (travels, stands))
    sentence = (
        f"{goes} with the load in '{found[0][0]}': 0027/ND, note 2 to table 5-1, asks crawler cranes for "
        f"{asks} then, of its inshore column, in place of {has}, where nothing else is documented; "
        f"'preset: {_TRAVELLING}' has that, or write a 'dynamic_amplification_factor' of your own"
    )
    yield Doubt(("rules", "preset"), sentence)


def _with_the_load(scenario: Scenario, rigging: Rigging) -> Iterator[tuple[str, str]]:
    """Each step in which a crawler crane travels with the load in its slings, and the crane.

    What stands is lifted by the first step that hoists a hook with slings on, and set down by one that lowers
    until something holds.
    """
    cranes = scenario.cranes or {}
    hangs = scenario.load is not None and scenario.load.stands_on is None
    for step, on in zip(scenario.plan, slings_on(scenario), strict=True):
        holds = {
            scenario.hooks[name].crane
            for name in scenario.hooks
            if any(sling.name in on for sling in slings_under(rigging, name))
        }
        for crane in _travelling(scenario, step):
            if hangs and crane in holds and isinstance(cranes[crane], Crawler):
                yield step.step, crane
        hooks = step.lead if isinstance(step, LeadStep) else step.moved if isinstance(step, HookStep) else ()
        if holds & {scenario.hooks[name].crane for name in full_names(hooks, scenario.hooks)}:
            hangs = (hangs or _lifts(step)) and not _sets_down(step)


def _lifts(step: Step) -> bool:
    return isinstance(step, HoistStep) or (isinstance(step, LeadStep) and step.by[2] > 0.0)


def _sets_down(step: Step) -> bool:
    """What lowers until a load has another tilt turns it in the air."""
    return isinstance(step, LowerStep) and step.until is not None and step.until.load_tilt is None


def _travelling(scenario: Scenario, step: Step) -> list[str]:
    """Cranes that a step has travel."""
    if isinstance(step, LeadStep):
        return full_names(step.travelling, scenario.cranes or {})
    return full_names(step.moved, scenario.cranes or {}) if isinstance(step, TravelStep) else []
