"""Tag lines in a recording."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gantline.results.strength import FromJson

__all__ = ["TagLine"]


@dataclass(frozen=True)
class TagLine(FromJson):
    """A tag line.

    Attributes:
        name: Its name in the lift file.
        rope: Its name among the ropes of the recording.
        pull: Tension that is kept in it [N]; None of one that is made fast.
        slipping_winch: Joint of its winch if that has a capacity, at which it slips.
        speed: At which its tugger would haul in if nothing held it [m/s]; None of one that is made fast.
        let_go_in: Steps of the plan that let go of it.
        is_let_go: The same of recordings that do not know which: whether any does.
    """

    name: str
    rope: str
    pull: float | None = None
    slipping_winch: str | None = None
    speed: float | None = None
    let_go_in: Sequence[str] = ()
    is_let_go: bool = False
