"""How far what traverses, travels or slews may go."""

from __future__ import annotations

from dataclasses import dataclass

from gantline.results.form import Range
from gantline.results.strength import FromJson

__all__ = ["DriveRange"]


@dataclass(frozen=True)
class DriveRange(FromJson):
    """The ends of the way of a trolley, a crane or an upper structure.

    Attributes:
        name: Its name in the plan.
        joint: Its joint, which counts as `to` of the plan does.
        range: Least and largest position [m], of what turns [rad].
        turns: Whether it turns.
    """

    name: str
    joint: str = ""
    range: Range = (0.0, 0.0)
    turns: bool = False
