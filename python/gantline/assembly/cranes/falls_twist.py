"""What turns a hook block in its falls, and what holds against it; `docs/concepts/falls_twist.md`."""

from __future__ import annotations

from typing import Final

from gantline.assembly.cranes.reeving import ReevedHook
from gantline.assembly.parts import Json
from gantline.scenario import Scenario
from gantline.scenario.cranes.reeving import Reeving
from gantline.scenario.gear import RopeMaterial

__all__ = ["twist_of_falls"]

#: Torque factor taken of ropes of six strands whose maker's is not given [1]: that of 6x25F in ordinary lay.
_USUAL_TORQUE_FACTOR: Final = 0.089
#: The least distance of sheaves on one axle, over the diameter of the rope: a groove has two flanges.
_LEAST_SPACING: Final = 2.0


def twist_of_falls(scenario: Scenario, hook: ReevedHook) -> Json:
    """The arm of the ropes' torque and the spread of the falls [SI]; empty where either is not known.

    Args:
        scenario: the lift.
        hook: the hook.
    """
    reeving, kind = hook.reeving, (scenario.ropes or {})[hook.reeving.rope]
    factor = kind.torque_factor if kind.torque_factor is not None else _usual(kind)
    if reeving.lay == "left_and_right":
        factor = 0.0
    # A hook on single parts has no sheaves, and hangs on swivels.
    if factor is None or kind.diameter is None or reeving.parts_each == 1:
        return {}
    return {
        "falls_spread": _spread(reeving, kind.diameter),
        "rope_torque": factor * kind.diameter,
        "is_rope_torque_known": kind.torque_factor is not None or reeving.lay == "left_and_right",
    }


def _usual(kind: RopeMaterial) -> float | None:
    """Torque factor of ropes like this one [1]; None of those of which no usual one is known."""
    has_six_strands = kind.catalogue is not None and kind.catalogue.name.startswith("6x")
    return _USUAL_TORQUE_FACTOR if has_six_strands else None


def _spread(reeving: Reeving, rope_diameter: float) -> float:
    """Mean square of the distances of the falls from the middle of the hook block [m^2], (FT3).

    Two falls to each sheave, all sheaves side by side; a dead end on the hook block is in its middle.
    """
    parts, radius = reeving.parts_each, reeving.diameter(rope_diameter) / 2
    spacing = reeving.sheave_spacing or _LEAST_SPACING * rope_diameter
    sheaves = reeving.ropes * (parts // 2)
    at_sheaves = 2 * (parts // 2) / parts
    return at_sheaves * (radius**2 + spacing**2 * (sheaves**2 - 1) / 12)
