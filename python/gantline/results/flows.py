"""Rope that passes sheaves with losses or inertia, and leaves drums."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gantline.results.rig import Rig
from gantline.results.variable import FloatArray, Variable

__all__ = ["rope_flows"]


def rope_flows(
    columns: Mapping[str, FloatArray], names: Mapping[str, Sequence[str]], rig: Rig
) -> tuple[dict[str, Variable], dict[str, Sequence[str]]]:
    """Variables of sheaves that are not ideal and of drums, with the names along their dimensions.

    Args:
        columns: columns of the core by name.
        names: names along their dimensions.
        rig: the lift.
    """
    variables: dict[str, Variable] = {}
    labels: dict[str, Sequence[str]] = {}
    joints, segments = list(names["joint"]), list(names["segment"])
    if rig.sheaves:
        labels |= {"sheave": [sheave.name for sheave in rig.sheaves], "side": ("before", "after")}
        at = [joints.index(sheave.name) for sheave in rig.sheaves]
        sides = np.array([[segments.index(name) for name in sheave.segments] for sheave in rig.sheaves])
        variables["rope_passed"] = Variable(
            ("time", "sheave"),
            columns["joint_position"][:, at],
            "m",
            "rope that has passed a sheave, towards the last end of its route",
        )
        if any(sheave.groove_friction is not None for sheave in rig.sheaves):
            passed = columns["joint_position"][:, at]
            turned = passed.copy()
            for place, sheave in enumerate(rig.sheaves):
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
    if rig.drums:
        labels["drum"] = [drum.name for drum in rig.drums]
        at = [joints.index(drum.name) for drum in rig.drums]
        variables["rope_paid_out"] = Variable(
            ("time", "drum"),
            columns["joint_position"][:, at],
            "m",
            "rope that a drum has paid out on its own diameter, negative where it has hauled in",
        )
    return variables, labels
