"""That a run did not get through its lift, for a terminal: when, where, likely cause, what to do next."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gantline.cli.table import wrapped
from gantline.results.ending import ending_of

if TYPE_CHECKING:
    from gantline.results.recording import Recording

__all__ = ["ending_lines"]


def ending_lines(recording: Recording, width: int) -> list[str]:
    """Lines that tell it; none of a run that got through, or of one that ended before its plan.

    Of the latter the checks tell all, with what its step waits for.

    Args:
        recording: Any recording.
        width: Columns that a line may have.
    """
    ending = ending_of(recording)
    if ending is None or ending.how == "ends":
        return []
    said = {ending.head: ending.happened, "Likely cause": ending.cause, "What to do next": ending.advice}
    told = [f"{head}: {text}" for head, text in said.items() if text]
    return [
        line
        for text in (*told, f"No GO can be taken from it: {ending.no_go}")
        for line in wrapped(text, width, "", "  ")
    ]
