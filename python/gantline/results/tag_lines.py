"""Tag lines in a recording."""

from __future__ import annotations

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
        is_let_go: Whether a step of the plan lets go of it.
    """

    name: str
    rope: str
    pull: float | None = None
    slipping_winch: str | None = None
    speed: float | None = None
    is_let_go: bool = False
