"""Places in the world that are under what one stands on there, or under the bottom of the water."""

from __future__ import annotations

from gantline.scenario import Scenario
from gantline.scenario.loads.structures import dock_of

__all__ = ["under_bottom", "under_ground"]

#: What is no deeper in the ground lies on it [m].
_ON_GROUND = 1e-3
#: A sea bed is not level; so much of the depth a place may be under it [1].
_SLOPES = 0.1


def under_ground(scenario: Scenario, place: tuple[float, float, float]) -> str | None:
    """How far a place (3,) [m] is under ground, or under the floor of a dock; None if it is above."""
    if scenario.ground is None:
        return None
    level, where, dock = scenario.ground.level, "the ground", dock_of(scenario)
    if dock is not None and all(
        least <= at <= most for at, (least, most) in zip(place, dock.extents().values(), strict=False)
    ):
        level, where = dock.floor, "the floor of the dock"
    depth = level - place[2]
    return f"{depth:.3g} m under {where}" if depth > _ON_GROUND else None


def under_bottom(scenario: Scenario, place: tuple[float, float, float]) -> str | None:
    """How far a place (3,) [m] is under the bottom of water whose depth is known; None if it is above."""
    water = scenario.water
    if water is None or water.depth is None:
        return None
    below = water.level - water.depth - place[2]
    bottom = f"the bottom of water {water.depth:g} m deep"
    return f"{below:.3g} m under {bottom}" if below > _SLOPES * water.depth else None
