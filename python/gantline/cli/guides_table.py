"""How landing guides fit the load as it is at the start, and up to where they catch it."""

from __future__ import annotations

from collections.abc import Mapping

from gantline.assembly.doubts.guides import GuideFit
from gantline.cli.table import show, table

__all__ = ["guides_table"]


def guides_table(fits: Mapping[str, GuideFit], width: int) -> list[str]:
    """Every landing guide; nothing in a lift without.

    Args:
        fits: how each fits, by its name.
        width: columns of text that a line may have.
    """
    rows = [(name, *_place(fit), show(min(fit.catches.values()), "m", 3)) for name, fit in fits.items()]
    head = ("Guide", "at the start", "of what is on the load", "caught up to")
    return table(head, rows, "llrr", width) if rows else []


def _place(fit: GuideFit) -> tuple[str, str]:
    """What of a guide stands where from what of it is on the load, and how far off."""
    one, other = fit.offset
    if "wall" in fit.catches:
        return ("behind the face of the wall" if one < 0 else "before the face of the wall"), show(
            abs(one), "m", 3
        )
    along = f"{show(abs(one), 'm', 3)} {'fore' if one >= 0 else 'aft'}"
    across = f"{show(abs(other), 'm', 3)} {'port' if other >= 0 else 'starboard'}"
    return "post from the middle of the frame", f"{along}, {across}"
