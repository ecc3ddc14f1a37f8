"""Loads heavier than what they hang from may carry, than what they are made of, or than on Earth: a slip."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.assembly.checked import rating_charts, ratings
from gantline.cad.assumptions import STEEL
from gantline.scenario import Rigging, Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.hinge import opened_in
from gantline.units import format_by_size

__all__ = ["doubtful_density", "doubtful_gravity", "doubtful_weight"]

#: Loads that are tilted up by one end leave about half of their weight where they stand; what is more than
#: this many times what may be carried is a slip [1].
_SLIPPED = 2.0
#: What fills a solid cylinder is no denser than this [of steel]: lead has 1.44.
_DENSEST = 1.5
#: A tube weighs no more than this many times its wall of steel, and no less than that share of it [1]: a
#: lining of 150 mm makes two and a half of one of 30 mm, and glass fibre is a quarter as heavy as steel.
_OF_WALL, _LEAST_OF_WALL = 5.0, 0.1
#: Gravity is 9.764 m/s^2 to 9.834 m/s^2 on the ground, and some reckon with 10 m/s^2 [m/s^2].
_LEAST_GRAVITY, _MOST_GRAVITY = 9.75, 10.0


def doubtful_weight(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Whether the load by itself is more than the hooks that its slings lead to may carry together.

    None where a hook is not rated, or where `mechanics` may bear a part that nothing says, or a hinge that
    stays shut does.
    """
    if scenario.load is None or scenario.mechanics is not None:
        return
    if any(not opened_in(scenario, hinge) for hinge in scenario.hinges or {}):
        return
    hooks = {sling.hook for sling in rigging.slings.values()} & set(scenario.hooks)
    # Under water what is in its tanks weighs nothing.
    load, is_dry = scenario.load, scenario.load.in_water is None
    mass = load.mass_at_start if is_dry else load.weight.simulated
    carried = _carried_by(scenario, hooks) / scenario.simulation.gravity
    if hooks and mass > carried:
        beside = " with what is in its tanks" if mass > load.weight.simulated else ""
        weighs = f"the load weighs {format_by_size(mass, 'mass', 4)}{beside}"
        slipped = "; a unit or digit has slipped" if mass > _SLIPPED * carried else ""
        rated = format_by_size(carried, "mass", 4)
        sentence = f"{weighs}, and what its slings hang from may carry {rated} in all{slipped}"
        yield Doubt(("load", "weight"), sentence)


def doubtful_density(scenario: Scenario) -> Iterator[Doubt]:
    """Whether a round load weighs more than its cylinder has room for, or a tube other than its wall."""
    load = scenario.load
    cylinder = None if load is None else load.shape.cylinder
    if load is None or cylinder is None:
        return
    mass, is_tube = load.weight.simulated, cylinder.wall is not None
    solid = STEEL * cylinder.moments.volume
    most, least = (_OF_WALL, _LEAST_OF_WALL) if is_tube else (_DENSEST, 0.0)
    if not least * solid <= mass <= most * solid:
        of_steel = "its wall of steel" if is_tube else "solid steel of its size"
        weighs = f"the load weighs {format_by_size(mass, 'mass', 4)}"
        sentence = f"{weighs}, and {of_steel} {format_by_size(solid, 'mass', 4)}"
        yield Doubt(("load", "weight"), f"{sentence}; a digit of one of them has slipped")


def doubtful_gravity(scenario: Scenario) -> Iterator[Doubt]:
    """Whether a load weighs what it does nowhere: with a tenth of gravity ropes seem ten times as strong."""
    gravity = scenario.simulation.gravity
    if scenario.load is not None and not _LEAST_GRAVITY <= gravity <= _MOST_GRAVITY:
        sentence = f"a load weighs {gravity:g} N/kg nowhere on Earth, where gravity is 9.76 to 9.84 m/s^2"
        yield Doubt(("simulation", "gravity"), f"{sentence}; a unit or digit has slipped")


def _carried_by(scenario: Scenario, hooks: set[str]) -> float:
    """What some hooks may carry together, by what they, their trolleys and their cranes are rated for [N].

    Infinite where it is not known.
    """
    bounds = [(set(one["hooks"]), one["rated_capacity"]) for one in ratings(scenario)]
    for chart in rating_charts(scenario):
        own = {hook: max(one["rated"]) for hook, one in chart.get("own", {}).items()}
        # Shares of several charts come to one at most: no more than the largest of them rates.
        bounds.append((set(chart["hooks"]), max([*chart.get("rated", ()), *own.values()])))
        bounds += [({hook}, most) for hook, most in own.items()]
    shares: dict[frozenset[str], float] = {frozenset([hook]): math.inf for hook in hooks}
    for of, capacity in sorted(bounds, key=lambda one: len(one[0])):
        within = [some for some in shares if some <= of]
        if within and capacity is not None:
            together = sum(shares.pop(some) for some in within)
            shares[frozenset().union(*within)] = min(capacity, together)
    return sum(shares.values())
