"""The types of crane that a lift file may have."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Discriminator, Tag

from gantline.scenario.boom import FloatingCrane
from gantline.scenario.crane import FixedHook
from gantline.scenario.goliath import Goliath

__all__ = ["AnyCrane", "Crane", "crane_type"]

AnyCrane = FixedHook | Goliath | FloatingCrane


def crane_type(data: Any) -> str:
    """Which model a crane of a lift file is read by; an unknown type is left to the first to refuse."""
    kind = data.get("type") if isinstance(data, dict) else getattr(data, "type", None)
    return kind if kind in ("goliath", "floating_crane") else "fixed_hook"


Crane = Annotated[
    Annotated[FixedHook, Tag("fixed_hook")]
    | Annotated[Goliath, Tag("goliath")]
    | Annotated[FloatingCrane, Tag("floating_crane")],
    Discriminator(crane_type),
]
