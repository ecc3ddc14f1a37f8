"""What a hook is made of, wherever it hangs, and the types that several hooks share."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.cranes.crane import Hoist
from gantline.scenario.cranes.reeving import HoistDrum, HookBlock, Reeving
from gantline.scenario.quantities import Length, Name, PositiveLength, PositiveMass

__all__ = ["CarriedHook", "HookParts", "HookType"]


class HookParts(Element):
    """All that a hook type may say; a type says what its hooks share, a hook what differs."""

    what: ClassVar[str] = "a hook"

    rated_capacity: PositiveMass | None = Field(None, description="Rated capacity of the hook.")
    highest: PositiveLength | None = Field(None, description="Highest position of the hook's bearing.")
    hook_block: HookBlock | None = Field(None, alias="block", description="Hook block.")
    reeving: Reeving | None = Field(None, description="Ropes that the hook hangs in.")
    drum: HoistDrum | None = Field(None, description="Drum of the hoist.")
    hoist: Hoist | None = Field(None, description="Speed and acceleration of the hoist, of the hook.")


class HookType(HookParts):
    """A type of hook, for several hooks with the same gear."""

    what: ClassVar[str] = "a hook type"


class CarriedHook(HookParts):
    """A hook under something that takes its upper sheaves along: a trolley or a boom."""

    type: Name | None = Field(None, description="A name of 'hook_types' that gives what is not said here.")
    height: Length = Field(description="Height of the hook's bearing at the start, in the world.")
