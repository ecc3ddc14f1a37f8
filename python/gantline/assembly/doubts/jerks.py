"""Drives of cranes that start and stop, or run, as none does."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path

__all__ = ["doubtful_accelerations"]

#: Hoists of cranes start and stop with some hundredths of gravity; a tenth of it and more is none [m/s^2].
_MOST = 1.0
#: The fastest hoists, of tower cranes with next to nothing in the hook, make 180 m/min [m/s].
_FASTEST = 3.0


def doubtful_accelerations(scenario: Scenario) -> Iterator[Doubt]:
    """Each hoist whose acceleration or speed is that of no crane."""
    told: set[Path] = set()
    for name, hook in scenario.hooks.items():
        path: Path = (*hook.paths["hoist"], "acceleration")
        if hook.hoist.acceleration > _MOST and path not in told:
            told.add(path)
            starts = f"the hoist of {name} starts and stops with {hook.hoist.acceleration:g} m/s^2"
            yield Doubt(path, f"{starts}; 0.05 to 0.5 m/s^2 is usual, and a digit or a unit has slipped")
        path = (*hook.paths["hoist"], "speed")
        if hook.hoist.speed > _FASTEST and path not in told:
            told.add(path)
            runs = f"the hoist of {name} makes {hook.hoist.speed:g} m/s, {60.0 * hook.hoist.speed:g} m/min"
            yield Doubt(path, f"{runs}; 1 to 120 m/min is usual, and a digit or a unit has slipped")
