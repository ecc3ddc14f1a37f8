"""Hooks that hang from one trolley or one crane, whose rated capacity they share."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.quantities import Flag, Names, PositiveMass

__all__ = ["HookGroup"]


class HookGroup(Element):
    """Hooks of one trolley or crane."""

    what: ClassVar[str] = "a group of hooks"

    type: Literal["trolley", "crane"] = Field(description="What bears the hooks: 'trolley' or 'crane'.")
    hooks: Names = Field(description="The hooks that it bears.")
    rated_capacity: PositiveMass = Field(description="Rated capacity of all of them together.")
    rating_includes_hook_block: Flag = Field(
        False,
        description="true: the rated capacity is compared with the hoist loads, false: with the hook loads.",
    )
