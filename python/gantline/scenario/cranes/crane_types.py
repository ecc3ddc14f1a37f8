"""The types of crane that a lift file may have."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import Discriminator, Tag

from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.cranes.boom import FloatingCrane, PlacedBoom, placed_boom
from gantline.scenario.cranes.crane import CRANE_TYPES, FixedHook
from gantline.scenario.cranes.crawler import Crawler, crawler_boom
from gantline.scenario.cranes.goliath import Goliath

__all__ = ["AnyCrane", "Crane", "any_boom", "crane_type"]

AnyCrane = FixedHook | Goliath | FloatingCrane | Crawler


def crane_type(data: Any) -> str:
    """Which model a crane of a lift file is read by; an unknown type is left to the first to refuse."""
    kind = data.get("type") if isinstance(data, dict) else getattr(data, "type", None)
    return kind if kind in CRANE_TYPES else CRANE_TYPES[0]


Crane = Annotated[
    Annotated[FixedHook, Tag("fixed_hook")]
    | Annotated[Goliath, Tag("goliath")]
    | Annotated[FloatingCrane, Tag("floating_crane")]
    | Annotated[Crawler, Tag("crawler")],
    Discriminator(crane_type),
]


def any_boom(name: str, crane: AnyCrane, vessels: Mapping[str, Vessel]) -> PlacedBoom | None:
    """The boom of a crane of any type with what bears it; None of a crane without one."""
    match crane:
        case Crawler():
            return crawler_boom(name, crane)
        case FloatingCrane():
            return placed_boom(name, crane, vessels)
        case FixedHook() | Goliath():
            return None
