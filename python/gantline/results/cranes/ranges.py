"""How far what traverses, travels or slews may go, and chain that is paid out."""

from __future__ import annotations

from dataclasses import dataclass

from gantline.results.file.form import Range
from gantline.results.strength import FromJson

__all__ = ["DriveRange"]


@dataclass(frozen=True)
class DriveRange(FromJson):
    """The ends of the way of a trolley, a crane or an upper structure, or of the chain of a chain hoist.

    Attributes:
        name: Its name in the plan.
        joint: Its joint, which counts as `to` of the plan does.
        range: Least and largest position [m], of what turns [rad].
        turns: Whether it turns.
        pays_out: Whether it is a sling with a chain hoist.
    """

    name: str
    joint: str = ""
    range: Range = (0.0, 0.0)
    turns: bool = False
    pays_out: bool = False
