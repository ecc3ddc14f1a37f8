"""Rope that passes sheaves with losses or inertia, and leaves drums."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gantline.results.gear import Drum, Sheave
from gantline.results.rig import Rig
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = ["drum_fleet_angle", "drum_warnings", "rope_flows"]

#: Part of a turn in which rope climbs onto the next layer, as in the core (`docs/concepts/winch.md`).
_CLIMB = 0.5


def rope_flows(columns: Columns, names: Names, rig: Rig) -> Derived:
    """Variables of sheaves that are not ideal and of drums, with the names along their dimensions.

    Args:
        columns: columns of the core by name.
        names: names along their dimensions.
        rig: the lift.
    """
    variables: dict[str, Variable] = {}
    labels: dict[str, Sequence[str]] = {}
    if rig.sheaves:
        labels |= {"sheave": [sheave.name for sheave in rig.sheaves], "side": ("before", "after")}
        variables |= _of_sheaves(columns, names, rig.sheaves)
    if rig.drums:
        labels["drum"] = [drum.name for drum in rig.drums]
        flow = dict(zip(names["joint"], columns["joint_position"].T, strict=True))
        variables["rope_paid_out"] = Variable(
            ("time", "drum"),
            np.stack([_paid_out(drum, flow[drum.joint]) for drum in rig.drums], axis=1),
            "m",
            "rope that a drum has paid out over its rim, negative where it has hauled in",
        )
    known = [drum for drum in rig.drums if drum.wraps_at_start is not None]
    if known:
        labels["counted_drum"] = [drum.name for drum in known]
        wraps = np.stack([drum_wraps(drum, columns, names) for drum in known], axis=1)
        full = np.array([drum.wraps_per_layer or np.inf for drum in known])
        layer = np.maximum(np.ceil(wraps / full), 1.0)
        dims = ("time", "counted_drum")
        variables["drum_wraps"] = Variable(dims, wraps, "1", "turns of rope on a drum")
        variables["drum_layer"] = Variable(dims, layer, "1", "layer in which rope comes on, the first is 1")
    return variables, labels


def _of_sheaves(columns: Columns, names: Names, sheaves: Sequence[Sheave]) -> dict[str, Variable]:
    """What passes sheaves, slips in their grooves, and pulls on both sides of them."""
    joints, segments = list(names["joint"]), list(names["segment"])
    passed = columns["joint_position"][:, [joints.index(sheave.name) for sheave in sheaves]]
    sides = np.array([[segments.index(name) for name in sheave.segments] for sheave in sheaves])
    variables = {
        "rope_passed": Variable(
            ("time", "sheave"),
            passed,
            "m",
            "rope that has passed a sheave, towards the last end of its route",
        )
    }
    if any(sheave.groove_friction is not None for sheave in sheaves):
        turned = passed.copy()
        for place, sheave in enumerate(sheaves):
            if sheave.spins:
                turned[:, place] = columns["joint_position"][:, joints.index(f"{sheave.name}/spin")]
            elif sheave.ratio is None:
                turned[:, place] = 0.0
        variables["groove_slip"] = Variable(
            ("time", "sheave"),
            passed - turned,
            "m",
            "rope that has slipped in the groove of a sheave, towards the last end of its route",
        )
    variables["sheave_tension"] = Variable(
        ("time", "sheave", "side"),
        columns["segment_tension"][:, sides],
        "N",
        "tension before and after a sheave, along the route of its rope",
    )
    return variables


def drum_wraps(drum: Drum, columns: Columns, names: Names) -> FloatArray:
    """Turns of rope on a drum whose turns at the start are known [1], shape (time,)."""
    turned = columns["joint_position"][:, list(names["joint"]).index(drum.joint)] * -drum.paid_out
    wraps: FloatArray = (drum.wraps_at_start or 0.0) + turned / (math.pi * drum.diameter)
    return wraps


def drum_fleet_angle(drum: Drum, wraps: FloatArray) -> FloatArray | None:
    """Angle of a rope to the plane of its drum's groove where it has so many turns, by (WI7) [rad].

    Args:
        drum: on which it is.
        wraps: turns on it; shape as what is returned.

    Returns:
        None where the first sheave, the width of a layer or the rope's diameter is not known.
    """
    if drum.first_sheave is None or drum.wraps_per_layer is None or drum.rope_diameter is None:
        return None
    across = np.mod(np.maximum(wraps, 0.0), drum.wraps_per_layer) - 0.5 * drum.wraps_per_layer
    angle: FloatArray = np.arctan(np.abs(across) * drum.rope_diameter / drum.first_sheave)
    return angle


def drum_warnings(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """Drums on which too many turns did not find room: once for each, the worst."""
    warnings = []
    for drum in rig.drums:
        if drum.wraps_at_start is None or not len(columns["time"]):
            continue
        wraps = drum_wraps(drum, columns, names)
        most = int(np.argmax(wraps))
        room = drum.layers * drum.wraps_per_layer if drum.wraps_per_layer is not None else None
        if room is not None and wraps[most] > room:
            sentence = f"{drum.name} would have {wraps[most]:.1f} turns at {columns['time'][most]:.2f} s"
            warnings.append(f"{sentence}; it has room for {room:g}")
    return warnings


def _paid_out(drum: Drum, position: FloatArray) -> FloatArray:
    """Rope that went over the rim, by layers, where the flow of a drum has come to `position`."""
    first = drum.paid_out * position
    if drum.wraps_per_layer is None or drum.wraps_at_start is None or drum.layer_step == 0.0:
        return first
    growth, turn = 2 * drum.layer_step / drum.diameter, math.pi * drum.diameter

    def climbed(turns: FloatArray) -> FloatArray:
        assert drum.wraps_per_layer is not None
        total: FloatArray = np.zeros_like(turns)
        climbs = math.floor((float(turns.max(initial=0.0)) + 0.5 * _CLIMB) / drum.wraps_per_layer)
        for layer in range(1, climbs + 1):
            over = np.maximum((turns - layer * drum.wraps_per_layer) / _CLIMB + 0.5, 0.0)
            total += _CLIMB * np.where(over < 1.0, 0.5 * over**2, over - 0.5)
        return total

    start = np.full_like(first, drum.wraps_at_start)
    more: FloatArray = climbed(start - first / turn) - climbed(start)
    return first - turn * growth * more
