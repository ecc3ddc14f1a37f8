"""Tanks of everything that floats, and which of them the plan pumps."""

from __future__ import annotations

from typing import Final

from gantline.scenario.hooks import full_name
from gantline.scenario.model import Scenario
from gantline.scenario.steps import PumpStep
from gantline.scenario.water import SEA_WATER, Afloat, BallastTank

__all__ = [
    "SEA",
    "bodies_afloat",
    "ends_of_pump",
    "pumped_at_most",
    "pumped_tanks",
    "sea_density",
    "tanks_of",
]

#: What a pump may draw from and discharge to beside tanks.
SEA: Final = "sea"


def bodies_afloat(scenario: Scenario) -> dict[str, Afloat]:
    """Vessels and bodies of `mechanics` by name: all that water may act on."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    return {**(scenario.vessels or {}), **plain}


def tanks_of(scenario: Scenario) -> dict[str, BallastTank]:
    """All tanks by their full name, `<vessel>.<tank>`."""
    return {
        f"{name}.{tank_name}": tank
        for name, body in bodies_afloat(scenario).items()
        for tank_name, tank in (body.tanks or {}).items()
    }


def ends_of_pump(scenario: Scenario, step: PumpStep) -> tuple[str | None, str | None]:
    """Full names of the tanks from and to which a step pumps; None is the sea."""
    known = tanks_of(scenario)
    source, target = (
        None if text == SEA else full_name(text, known) for text in (step.pump.from_, step.pump.to)
    )
    return source, target


def pumped_tanks(scenario: Scenario) -> set[str]:
    """Full names of the tanks that a step of the plan pumps."""
    steps = [step for step in scenario.plan if isinstance(step, PumpStep)]
    return {name for step in steps for name in ends_of_pump(scenario, step) if name is not None}


def pumped_at_most(scenario: Scenario) -> dict[str, tuple[float, float]]:
    """What the plan has pumped into each tank, at its least and at its most, by steps with an amount [kg]."""
    now: dict[str, float] = {}
    found: dict[str, tuple[float, float]] = {}
    for step in scenario.plan:
        if not isinstance(step, PumpStep) or step.by is None:
            continue
        for name, amount in zip(ends_of_pump(scenario, step), (-step.by, step.by), strict=True):
            if name is not None:
                now[name] = now.get(name, 0.0) + amount
                least, most = found.get(name, (0.0, 0.0))
                found[name] = (min(least, now[name]), max(most, now[name]))
    return found


def sea_density(scenario: Scenario) -> float:
    """Density of the water around [kg/m^3]."""
    return SEA_WATER if scenario.water is None else scenario.water.density
