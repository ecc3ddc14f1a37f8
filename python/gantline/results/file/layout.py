"""What a recording consists of: its variables with their dimensions, and the names that its rig counts on."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from gantline.results.file.form import FormError
from gantline.results.loads.hinges import HINGE_WAYS
from gantline.results.rig import Rig

__all__ = ["BY_RIG", "COUNTED", "DIMS", "FIXED", "OPTIONAL", "hold_variable"]

#: Variables by their dimensions; with numbers but for those of `_TEXTS`.
_OVER: dict[tuple[str, ...], str] = {
    ("time",): "time residual_constraint residual_complementarity",
    ("time", "rope"): "rope_tension rope_lengthening",
    ("time", "rope", "rope_end"): "rope_end_tension",
    ("rope",): "rope_peak_tension rope_peak_time",
    ("rope_point",): "rope_of_point",
    ("time", "rope_point", "xyz"): "rope_point",
    ("time", "segment"): "segment_tension segment_length",
    ("time", "wrapped_sheave"): "wrap_angle",
    ("time", "wrapped_sheave", "sheave_side"): "fleet_angle",
    ("time", "body", "xyz"): "body_position body_velocity body_angular_velocity",
    ("time", "body", "wxyz"): "body_orientation",
    ("time", "xyz"): "momentum angular_momentum",
    ("time", "joint"): "joint_position",
    ("time", "moving_sheave"): "sheave_travel",
    ("time", "compensator"): "rod_out",
    ("time", "sheave"): "rope_passed groove_slip",
    ("time", "sheave", "side"): "sheave_tension",
    ("time", "drum"): "rope_paid_out",
    ("time", "chain_hoist"): "chain_paid_out",
    ("time", "counted_drum"): "drum_wraps drum_layer",
    ("time", "tank"): "tank_content",
    ("time", "pin"): "pin_force",
    ("time", "hinge", "hinge_way"): "hinge_push",
    ("time", "hinge"): "hinge_force hinge_moment",
    ("hinge_peak", "hinge", "hinge_way"): "hinge_peak_push",
    ("hinge_peak", "hinge"): "hinge_peak_moment",
    ("hinge_peak",): "hinge_peak_time",
    ("time", "contact"): "contact_force",
    ("contact",): "contact_peak_force contact_peak_time",
    ("time", "pair"): "clearance",
    ("time", "pair", "pair_side", "xyz"): "clearance_point",
    ("time", "hook"): "hook_load hoist_load",
    ("hook",): "hook_peak_load hook_peak_time hoist_peak_load hoist_peak_time",
    ("time", "crane_hook"): "hook_height falls_out_of_plumb",
    ("time", "compensated_hook"): "heave_compensation",
    ("time", "corner"): "corner_load",
    ("time", "boom"): "boom_angle luffing_pull slew_angle crane_heel crane_trim",
    ("time", "boom_hook"): "crane_radius off_lead side_lead",
    ("time", "crawler"): "tipping_utilisation",
    ("time", "track_corner"): "track_pressure ground_pressure",
    ("time", "vessel"): "vessel_draft vessel_draft_aft vessel_draft_forward vessel_heel vessel_trim "
    "vessel_freeboard vessel_displacement vessel_wave_elevation",
    ("time", "mooring_line"): "mooring_tension",
    ("time", "fender"): "fender_force",
    ("time", "guide"): "guide_force",
    ("time", "hull"): "displaced_volume",
    ("time", "load"): "load_borne load_transferred load_tilt load_swing wind_at_load",
    ("time", "energy_kind"): "energy",
    ("event",): "event_time event_kind event_name",
}
#: Dimensions of each variable.
DIMS = {name: dims for dims, names in _OVER.items() for name in names.split()}
_TEXTS = frozenset({"rope_of_point", "event_kind", "event_name"})
#: Variables that not every recording has whose dimensions are there.
OPTIONAL = frozenset(
    {
        "residual_constraint",
        "residual_complementarity",
        "rope_lengthening",
        "rope_end_tension",
        "groove_slip",
        "luffing_pull",
        "slew_angle",
        "clearance_point",
        "contact_peak_force",
        "contact_peak_time",
        "hook_peak_load",
        "hook_peak_time",
        "hoist_peak_load",
        "hoist_peak_time",
        "hinge_peak_push",
        "hinge_peak_moment",
        "hinge_peak_time",
        "momentum",
        "angular_momentum",
        "load_swing",
        "vessel_wave_elevation",
        "wind_at_load",
    }
)
#: Dimensions whose entries are counted and have no names.
COUNTED = frozenset({"time", "event", "rope_point", "hinge_peak"})
#: Names along dimensions that are the same in every recording.
FIXED = {
    "xyz": ("x", "y", "z"),
    "wxyz": ("w", "x", "y", "z"),
    "sheave_side": ("arriving", "leaving"),
    "pair_side": ("first", "second"),
    "rope_end": ("first", "last"),
    "hinge_way": HINGE_WAYS,
    "side": ("before", "after"),
}
_Names = Callable[[Rig], list[str]]

#: Names along a dimension that the rig counts on.
BY_RIG: dict[str, _Names] = {
    "rope": lambda rig: [
        *(rope.name for rope in rig.ropes),
        *(sling.rope for sling in rig.slings),
        *(rope for one in rig.equalizers for rope in (*one.slings, one.equalizing_rope) if rope),
        *rig.outer_ropes,
        *(sheave.rope for sheave in rig.sheaves),
        *(sheave.rope for sheave in rig.wrapped_sheaves),
        *(rope for boom in rig.booms for rope in boom.ropes),
        *(rope for load in rig.loads for rope in load.other_ropes),
        *(one.gas for one in rig.compensators),
    ],
    "body": lambda rig: [
        *(load.body for load in rig.loads),
        *(one.body for one in rig.equalizers),
        *(body for one in rig.compensators for body in (one.body, one.rod)),
        *(sling.over for sling in rig.slings if sling.over is not None),
        *(vessel.body for vessel in rig.vessels),
        *(body for boom in rig.booms for body in (boom.boom, boom.base)),
    ],
    "segment": lambda rig: [fall for hook in rig.hooks for fall in hook.falls],
    "joint": lambda rig: [trolley.name for crane in rig.cranes for trolley in crane.trolleys],
    "contact": lambda rig: [
        *(contact for load in rig.loads for contact in load.contacts),
        *(fender.contact for fender in rig.fenders),
        *(contact for guide in rig.guides for contact in guide.contacts),
        *(corner for crane in rig.crawlers for corner in crane.corners),
    ],
    "moving_sheave": lambda rig: [sheave for one in rig.equalizers for sheave in one.moving_sheaves],
    "compensator": lambda rig: [one.name for one in rig.compensators],
    "hinge": lambda rig: [hinge.name for hinge in rig.hinges],
    "hook": lambda rig: [hook.name for hook in rig.hooks],
    "crane_hook": lambda rig: [hook.name for hook in rig.carried_hooks],
    "corner": lambda rig: [corner for crane in rig.cranes for corner in crane.corners],
    "boom": lambda rig: [boom.name for boom in rig.booms],
    "boom_hook": lambda rig: [hook.name for boom in rig.booms for hook in boom.hooks],
    "crawler": lambda rig: [crane.name for crane in rig.crawlers],
    "track_corner": lambda rig: [corner for crane in rig.crawlers for corner in crane.corners],
    "vessel": lambda rig: [vessel.name for vessel in rig.vessels],
    "mooring_line": lambda rig: [line.name for line in rig.mooring_lines],
    "fender": lambda rig: [fender.name for fender in rig.fenders],
    "guide": lambda rig: [guide.name for guide in rig.guides],
    "tank": lambda rig: [tank.name for tank in rig.tanks],
    "sheave": lambda rig: [sheave.name for sheave in rig.sheaves],
    "wrapped_sheave": lambda rig: [sheave.name for sheave in rig.wrapped_sheaves],
    "drum": lambda rig: [drum.name for drum in rig.drums],
    "counted_drum": lambda rig: [drum.name for drum in rig.drums if drum.wraps_at_start is not None],
    "chain_hoist": lambda rig: [one.name for one in rig.chain_hoists],
    "pair": lambda rig: [watch.name for watch in rig.watches],
    "load": lambda rig: [load.name for load in rig.loads],
    "energy_kind": lambda rig: ["kinetic", "gravity", "elastic", "drive_work"],
}


def hold_variable(name: str, dims: tuple[str, ...], dtype: Any) -> None:
    """Hold what a file says of a variable against what it has to be, before its values are read.

    Args:
        name: Its name; any other than those of a recording is right.
        dims: Names of its dimensions.
        dtype: Type of its values, as numpy has it.

    Raises:
        FormError: If it is something else.
    """
    if name not in DIMS:
        return
    if dims != DIMS[name]:
        raise FormError(
            f"variable '{name}' has the dimensions ({', '.join(dims)}); expected ({', '.join(DIMS[name])})"
        )
    kind = np.dtype(dtype).kind
    if name in _TEXTS and kind not in "OSU":
        raise FormError(f"variable '{name}' has values of type {np.dtype(dtype)}; expected text")
    if name not in _TEXTS and kind != "f":
        found = "text" if kind in "OSU" else f"values of type {np.dtype(dtype)}"
        raise FormError(f"variable '{name}' has {found}; expected floating-point numbers")
