"""Kinds of events that a recording may have: what a run tells, and what is found in its samples."""

from __future__ import annotations

from typing import Final

__all__ = ["EVENT_KINDS"]

#: As docs/reference/recording.md lists them; those of the run are named in `event/mod.rs` of the core.
EVENT_KINDS: Final = (
    "taut",
    "slack",
    "lift_off",
    "set_down",
    "stick",
    "slip",
    "cut",
    "broken",
    "detached",
    "attached",
    "stop_hit",
    "stop_left",
    "pin_pulled",
    "pin_put_in",
    "hinge_opened",
    "rope_off_sheave",
    "rope_on_sheave",
    "support_removed",
    "off_support",
    "too_close",
    "clear_again",
    "flooding",
    "surfacing",
    "capsized",
    "overload",
    "hook_too_high",
    "tipping",
    "step_begin",
    "step_end",
    "pump_stopped",
    "compensation_speed_limit",
    "compensation_acceleration_limit",
    "compensation_stroke_limit",
    "compensation_limit",
    "emergency_stop",
    "drum_slips",
    "drum_holds",
)
