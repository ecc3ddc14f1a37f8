"""Barges with tanks as lift files."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from gantline.scenario import Scenario, parse_scenario

#: A box of 100 × 30 × 8 m.
LENGTH, BREADTH, DEPTH = 100.0, 30.0, 8.0
#: What it weighs by itself [kg], and how high [m].
OWN, KG = 11e6, 5.0

DAMPED = {"at": ["50 m", "0 m", "0 m"], "heave": "15 MN s/m", "roll": "400 MN m s", "pitch": "9000 MN m s"}
ADDED = {
    "at": ["50 m", "0 m", "0 m"],
    "heave": "15000 t",
    "roll": "6e5 t m^2",
    "pitch": "9e6 t m^2",
}


def tank(place: Sequence[float], content: float, box: Sequence[float] = (20.0, 20.0, 6.0)) -> dict[str, Any]:
    """A tank with the middle of its bottom at a place [m] and so much in it [t]."""
    return {
        "box": [f"{size} m" for size in box],
        "bottom": [f"{part} m" for part in place],
        "content": f"{float(content)!r} t",
    }


def barge(tanks: Mapping[str, Any], **changes: Any) -> dict[str, Any]:
    """A barge of 11 000 t with tanks."""
    return {
        "draft": "4 m",
        "hull": {"box": [f"{LENGTH} m", f"{BREADTH} m", f"{DEPTH} m"]},
        "masses": {"hull": {"mass": f"{OWN} kg", "at": [f"{LENGTH / 2} m", "0 m", f"{KG} m"]}},
        "radii_of_gyration": ["11 m", "27 m", "27 m"],
        "tanks": dict(tanks),
        **changes,
    }


def lift(vessel: Mapping[str, Any], plan: Sequence[Any] = (), **changes: Any) -> Scenario:
    """A lift with a barge; JSON is YAML."""
    return parse_scenario(text(vessel, plan, **changes))


def text(vessel: Mapping[str, Any], plan: Sequence[Any] = (), **changes: Any) -> str:
    """Its lift file."""
    given = {
        "format": 1,
        "lift": {"title": "A barge with tanks"},
        "duration": "600 s",
        "vessels": {"barge": dict(vessel)},
        **({"plan": list(plan)} if plan else {}),
        **changes,
    }
    return json.dumps(given, indent=1)


def pump(source: str, target: str, rate: str, **rest: Any) -> dict[str, Any]:
    """A step of the plan."""
    return {"step": f"{source} to {target}", "pump": {"from": source, "to": target}, "rate": rate, **rest}
