"""Warnings of a run about what a program moved, and ropes that left their sheaves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

__all__ = ["command_warnings", "sheave_warnings"]


def command_warnings(columns: Mapping[str, Any], names: Mapping[str, Any]) -> list[str]:
    """A note of what a program has moved: the plan says no more how it moved."""
    times: dict[tuple[str, str], list[float]] = {}
    for at, name, motion in zip(
        columns.get("command_time", ()),
        names.get("command_name", ()),
        names.get("command_motion", ()),
        strict=True,
    ):
        times.setdefault((name, motion), []).append(at)
    return [
        f"{name} was moved by a program from {at[0]:.2f} s on and not by the plan ({motion}, "
        f"commands: {len(at)})"
        for (name, motion), at in times.items()
    ]


def sheave_warnings(
    rig: Mapping[str, Any], columns: Mapping[str, Any], names: Mapping[str, Any]
) -> list[str]:
    """Warnings of ropes that left a sheave which they may not leave: once for each sheave, the first time."""
    held = {sheave["name"] for sheave in rig.get("wrapped_sheaves", ()) if not sheave["may_lift_off"]}
    first: dict[str, float] = {}
    for time_off, kind, name in zip(
        columns["event_time"], names["event_kind"], names["event_name"], strict=True
    ):
        if kind == "rope_off_sheave" and name in held:
            first.setdefault(name, float(time_off))
    return [
        f"the rope leaves the sheave {name} at {when:.3f} s: it is followed as if it were held in the groove"
        "; 'may_lift_off: true' lets it run straight past"
        for name, when in first.items()
    ]
