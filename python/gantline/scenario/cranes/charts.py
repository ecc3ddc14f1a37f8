"""Rating charts of cranes with a boom: of all hooks of a crane, and of hooks that have one of their own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gantline.scenario.cranes.boom import BoomHook, FloatingCrane
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.rating import Rating
from gantline.scenario.errors import PathPart
from gantline.scenario.model import Scenario

__all__ = ["Chart", "boom_charts"]


@dataclass(frozen=True)
class Chart:
    """A rating chart and whose it is.

    Attributes:
        crane: name of the crane.
        hook: full name of the hook whose own it is; None of that of the crane.
        hooks: the hooks that it rates, as the lift file has them.
        rating: the chart.
        path: where the lift file has it.
    """

    crane: str
    hook: str | None
    hooks: tuple[BoomHook, ...]
    rating: Rating
    path: tuple[PathPart, ...]

    @property
    def owner(self) -> str:
        """Name of the crane or hook."""
        return self.crane if self.hook is None else self.hook


def boom_charts(scenario: Scenario) -> Iterator[Chart]:
    """That of each crane, then those of its hooks."""
    for name, crane in (scenario.cranes or {}).items():
        if not isinstance(crane, FloatingCrane | Crawler):
            continue
        if crane.rating is not None:
            shared = tuple(hook for hook in crane.hooks.values() if hook.rating is None)
            yield Chart(name, None, shared, crane.rating, ("cranes", name, "rating"))
        for hook, one in crane.hooks.items():
            if one.rating is not None:
                path = ("cranes", name, "hooks", hook, "rating")
                yield Chart(name, f"{name}.{hook}", (one,), one.rating, path)
