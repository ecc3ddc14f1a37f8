"""Where and why a simulation failed, in words of the lift file: the core knows bodies, ropes and joints."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gantline.scenario.loads.hinge import failed_at as failed_in_hinge

if TYPE_CHECKING:
    from gantline.scenario.model import Scenario

__all__ = ["failed_at"]

#: How the core says that a body has met the next place of its rope (`event/standstill.rs`).
_MET = "it has come to the next place that "


def failed_at(scenario: Scenario, element: str, cause: str) -> tuple[str, str]:
    """Where a simulation failed, and why, of hooks and hinges as who wrote the lift file knows them.

    Args:
        scenario: The lift.
        element: Name of what it failed at.
        cause: What failed.
    """
    if cause.startswith(_MET) and element in scenario.hooks:
        met = "its hook block has come up to the sheaves above it (two-blocking), and nothing stops it there"
        return element, f"{met}: hoist it less far; 'highest' of a hook is checked"
    return failed_in_hinge(scenario, element, cause)
