"""How a run ended, or that it goes on: the words of the attribute `status` of recordings."""

from __future__ import annotations

from typing import Final

__all__ = ["BROKE_OFF", "GOES_ON", "OVER"]

#: Of a run that has not begun, and of one that is under way.
GOES_ON: Final = ("ready", "running")
#: How a run ended that did not come to its end, in words.
BROKE_OFF: Final = {"paused": "was paused", "stopped": "was stopped", "failed": "failed"}
#: Of all runs that are over, or will not go on by themselves.
OVER: Final = ("done", *BROKE_OFF)
