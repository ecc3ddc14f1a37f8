"""What cranes do in steps that lead a load, as tables of `gantline check`: before anything is simulated."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gantline.cli.table import ABSENT, show, table

if TYPE_CHECKING:
    from gantline.scenario import Scenario
    from gantline.scenario.cranes.charts import Chart


def lead_table(scenario: Scenario, width: int) -> list[str]:
    """For each hook that leads its way by radius, slew and boom, the least rated there, the fastest drive.

    Args:
        scenario: the lift.
        width: columns of text that a line may have.
    """
    from gantline.assembly.doubts.lead import row_of
    from gantline.scenario.consistency.lead import drives_along, fastest
    from gantline.scenario.plan.lead import LeadStep
    from gantline.scenario.plan.leading import led_hooks, pose_before, way_of
    from gantline.scenario.plan.positions import places_of_cranes

    rows = []
    for step, before in zip(scenario.plan, places_of_cranes(scenario), strict=False):
        if not isinstance(step, LeadStep):
            continue
        hooks = led_hooks(scenario, step)
        way = way_of(step, hooks, before)
        for index, led in enumerate(hooks):
            begin = pose_before(led, before)
            drives = drives_along(step, way, index, led, begin)
            upper, second, hoist = drives
            angles = [begin.angle] if led.travels else list(second.places)
            radii = [led.radius(angle) for angle in angles]
            busiest = max(drives, key=lambda one: fastest(one)[0])
            chart = row_of(scenario, led)
            rows.append(
                (
                    f"'{step.step}'",
                    led.name,
                    f"{radii[0]:.2f} to {show(radii[-1], 'm', 2)}",
                    ABSENT if chart is None else show(_least_rated(chart, radii, angles), "t", 1),
                    f"{_degrees(upper.places[0])} to {show(upper.places[-1], 'deg', 1)}",
                    f"{_degrees(angles[0])} to {show(angles[-1], 'deg', 1)}",
                    show(hoist.places[-1], "m", 2),
                    f"{busiest.of.name} {show(fastest(busiest)[0], '%', 0)}",
                )
            )
    head = ("Led by step", "hook", "radius", "rated there", "slew", "boom", "hoists", "nearest to its speed")
    return table(head, rows, "llrrrrrl", width, keys=2) if rows else []


def _degrees(angle: float) -> str:
    return show(angle, "deg", 1).removesuffix(" deg")


def _least_rated(chart: Chart, radii: list[float], angles: list[float]) -> float:
    """Least that may hang along the way [kg]."""
    import numpy as np

    rating = chart.rating
    at, of = (radii, rating.radius) if rating.radius is not None else (angles, rating.angle or ())
    order = np.argsort(of)
    places, rated = np.asarray(of)[order], np.asarray(rating.rated)[order]
    if rating.between == "lower":
        above = np.clip(np.searchsorted(places, at), 1, len(places) - 1)
        return float(np.minimum(rated[above - 1], rated[above]).min())
    return float(np.interp(at, places, rated).min())
