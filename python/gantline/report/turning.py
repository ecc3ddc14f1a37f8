"""Tables of the first page: what hooks and slings carry as a load is turned."""

from __future__ import annotations

from typing import Any

from gantline.report.subject import ABSENT, Subject, number
from gantline.results.loads.turning import AtTilt, at_tilts

#: Most hooks that a table beside the attitude has room for.
_MOST_HOOKS = 4


def turnings(subject: Subject) -> list[dict[str, Any]]:
    """Of each load that is turned: hook loads, and the sling that governs, at given tilts."""
    read = {load.name: at_tilts(subject.recording, load) for load in subject.rig.loads}
    return [_table(subject, name, states) for name, states in read.items() if states]


def _table(subject: Subject, load: str, states: list[AtTilt]) -> dict[str, Any]:
    names = [hook.name for hook in subject.rig.hooks]
    most = {name: max(state.hook_loads[name] for state in states) for name in names}
    kept = sorted(names, key=lambda name: most[name], reverse=True)[:_MOST_HOOKS]
    hooks = [name for name in names if name in kept]
    gravity = subject.rig.gravity
    is_supported = any(state.supported > 0.0 for state in states)
    return {
        "load": load,
        "hooks": hooks,
        "hooks_left_out": len(names) - len(hooks),
        "is_supported": is_supported,
        "rows": [
            {
                "tilt": number(state.tilt, "deg", 1),
                "time": number(state.time, "s", 1),
                "hook_loads": [number(state.hook_loads[name] / gravity, "t", 1) for name in hooks],
                "supported": number(state.supported / gravity, "t", 1),
                "sling": state.sling or ABSENT,
                "tension": number(state.tension if state.sling else None, "kN", 0),
                "used": number(state.of_breaking_force, "%", 0),
            }
            for state in states
        ],
    }
