"""Emergency stops that are no harder than any other, since nothing says how hard."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.movers import mover
from gantline.scenario.steps import MovingStep

__all__ = ["doubtful_stops"]


def doubtful_stops(scenario: Scenario) -> Iterator[Doubt]:
    """All trolleys, cranes and booms that an emergency stop stops as any step does."""
    soft: dict[str, int] = {}
    for place, step in enumerate(scenario.plan):
        if not isinstance(step, MovingStep):
            continue
        if scenario.emergency_stop is None and step.emergency_stop_at is None:
            continue
        moved = (mover(scenario, step.kind, text) for text in step.moved)
        for one in moved:
            if one is not None and one.stops_as_usual:
                soft.setdefault(one.name, place)
    if soft:
        stops = scenario.emergency_stop is not None
        yield Doubt(
            ("emergency_stop",) if stops else ("plan", min(soft.values()), "emergency_stop_at"),
            f"the emergency stop of {', '.join(soft)} is as soft as any stop, with the usual acceleration: "
            "brakes that are thrown in stop harder; 'emergency_acceleration' says how hard",
        )
