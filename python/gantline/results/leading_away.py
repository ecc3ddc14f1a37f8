"""What leads away from an equilibrium, in words."""

from __future__ import annotations

__all__ = ["stability"]


def stability(unstable: int, swinging: int) -> str:
    """How many motions lead away from an equilibrium, and how many of them by swinging, in words."""
    if not unstable:
        return "stable"
    count = "one motion leads" if unstable == 1 else f"{unstable} motions lead"
    how = f"{count} away"
    if swinging:
        how += ", swinging ever farther" if swinging == unstable else f", {swinging} by swinging ever farther"
    return how
