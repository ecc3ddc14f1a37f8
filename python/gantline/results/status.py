"""How a run ended, or that it goes on: the words of the attribute `status` of recordings."""

from __future__ import annotations

from typing import Final

__all__ = ["INCOMPLETE", "OVER", "READY"]

#: Of a run that has not begun.
READY: Final = "ready"
#: Where runs were that had not come to their end as their recording was made, in words.
INCOMPLETE: Final = {
    "running": "was under way",
    "paused": "was paused",
    "stopped": "was stopped",
    "failed": "failed",
}
#: Of runs that are over, or will not go on by themselves.
OVER: Final = ("done", "paused", "stopped", "failed")
