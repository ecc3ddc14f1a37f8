"""A box of 120 t on one hook in four slings without weight, with a tank in it that the plan may pump."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from gantline.scenario import Scenario, parse_scenario

G = 9.81
#: The load by itself [kg], its sides [m], and how high its centre of gravity is over its underside [m].
OWN, SIZE, HIGH = 120e3, (12.0, 6.0, 4.0), 2.0
#: Density of what is in tanks [kg/m^3].
SEA = 1025.0
#: Of the hook over the underside of the load before slings stretch [m].
HOOK = 20.0

Json = dict[str, Any]


def tank(place: Sequence[float], content: float, box: Sequence[float] = (4.0, 4.0, 3.0), **more: Any) -> Json:
    """A tank with the middle of its bottom at a place [m] and so much in it [t]."""
    return {
        "box": [f"{size} m" for size in box],
        "bottom": [f"{part} m" for part in place],
        "content": f"{float(content)!r} t",
        **more,
    }


def pump(step: str, way: tuple[str, str], rate: str, **rest: Any) -> Json:
    """A step that pumps from one to the other."""
    return {"step": step, "pump": {"from": way[0], "to": way[1]}, "rate": rate, **rest}


def hold(step: str, time: str = "30 s") -> Json:
    """A step that holds."""
    return {"step": step, "hold": time}


def document(tanks: Mapping[str, Any] | None, plan: Sequence[Json] = (), **changes: Any) -> Json:
    """A lift file; `load` among the changes is put into its load, what else there is beside it."""
    lugs = {"A": (5.0, 2.5), "B": (-5.0, 2.5), "C": (-5.0, -2.5), "D": (5.0, -2.5)}
    load = {
        "name": "module",
        "shape": {"box": [f"{size} m" for size in SIZE]},
        "position": ["0 m", "0 m", "10 m"],
        "weight": {"calculated": f"{OWN} kg"},
        "centre_of_gravity": {"at": ["0 m", "0 m", f"{HIGH} m"]},
        "lugs": {name: {"at": [f"{x} m", f"{y} m", f"{SIZE[2]} m"]} for name, (x, y) in lugs.items()},
        **({"tanks": dict(tanks)} if tanks is not None else {}),
        **changes.pop("load", {}),
    }
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    length = (5.0**2 + 2.5**2 + (HOOK - SIZE[2]) ** 2) ** 0.5
    return {
        "format": 1,
        "lift": {"title": "A load with a tank"},
        "duration": "400 s",
        "cranes": {"crane": {"type": "fixed_hook", "at": ["0 m", "0 m", f"{10 + HOOK} m"], "hoist": hoist}},
        "ropes": {"stiff": {"axial_stiffness": "2000 MN", "damping_time": "20 ms"}},
        "slings": {
            name: {"from": "crane", "to": f"module.{name}", "rope": "stiff", "length": f"{length!r} m"}
            for name in lugs
        },
        "load": load,
        **({"plan": list(plan)} if plan else {}),
        **changes,
    }


def lift(tanks: Mapping[str, Any] | None, plan: Sequence[Json] = (), **changes: Any) -> Scenario:
    """It as a scenario; JSON is YAML."""
    return parse_scenario(json.dumps(document(tanks, plan, **changes)))
