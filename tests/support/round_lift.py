"""Lifts of a round load, which differ in what it is and what it lies on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import gantline
from gantline.assembly import Assembly, assemble
from gantline.scenario import load_scenario
from hull_lift import text

__all__ = ["assembled", "round_lift", "simulated"]


def round_lift(cylinder: Mapping[str, Any], centre: Sequence[float], **changes: Any) -> dict[str, Any]:
    """A round load of 200 t at the origin under a hook whose slings are slack, other sections by `changes`.

    Those of `load` are joined with its own; None leaves a section out.
    """
    load = {
        "name": "column",
        "shape": {"cylinder": dict(cylinder)},
        "weight": {"calculated": "200 t"},
        "centre_of_gravity": {"at": [f"{part!r} m" for part in centre]},
        "lugs": {name: {"at": [f"{part!r} m" for part in centre]} for name in ("a",)},
        **changes.pop("load", {}),
    }
    given: dict[str, Any] = {
        "format": 1,
        "lift": {"title": "A round load"},
        "duration": "1 s",
        "start": "as_given",
        "ground": {"level": "0 m", "stiffness": "200 MN/m", "damping": "2 MN s/m", "friction": 0.5},
        "ropes": {"sling": {"axial_stiffness": "100 MN", "damping_time": "10 ms", "mass": "none"}},
        "load": {key: value for key, value in load.items() if value is not None},
        "cranes": {
            "hook": {
                "type": "fixed_hook",
                "at": ["0 m", "0 m", "200 m"],
                "hoist": {"speed": "5 m/min", "acceleration": "0.02 m/s^2"},
            }
        },
        "slings": {"a": {"from": "hook", "to": "column.a", "length": "300 m", "rope": "sling"}},
        "plan": [{"step": "hold", "hold": "until_end"}],
        **changes,
    }
    return {key: value for key, value in given.items() if value is not None}


def simulated(folder: Path, given: Mapping[str, Any], **settings: Any) -> gantline.Recording:
    """Run a lift, its file in a folder; `settings` as for `gantline.simulate`."""
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    return gantline.simulate(path, **settings)


def assembled(folder: Path, given: Mapping[str, Any]) -> Assembly:
    """The same in words of mechanics."""
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    return assemble(load_scenario(path))
