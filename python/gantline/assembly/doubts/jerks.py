"""Drives of cranes that start and stop as none does."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path

__all__ = ["doubtful_accelerations"]

#: Hoists of cranes start and stop with some hundredths of gravity; a tenth of it and more is none [m/s^2].
_MOST = 1.0


def doubtful_accelerations(scenario: Scenario) -> Iterator[Doubt]:
    """Each hoist whose acceleration is that of no crane."""
    told: set[Path] = set()
    for name, hook in scenario.hooks.items():
        path: Path = (*hook.paths["hoist"], "acceleration")
        if hook.hoist.acceleration > _MOST and path not in told:
            told.add(path)
            starts = f"the hoist of {name} starts and stops with {hook.hoist.acceleration:g} m/s^2"
            yield Doubt(path, f"{starts}; 0.05 to 0.5 m/s^2 is usual, and a digit or a unit has slipped")
