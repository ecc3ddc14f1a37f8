"""A skid is landed on a platform from a crane barge in swell, turned by a right angle: all is the same.

Heave compensation, landing guides, supports on a structure, mooring lines on the sea bed, water that
remembers and wave forces, drift forces among them, as the scenario `onto_a_platform` has them. Structures lie
along x and y of the world, so a right angle it is; waves count from the origin, about which all is turned.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import yaml

import gantline
from gantline.checks import check_recording
from gantline.results import Recording

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "onto_a_platform" / "scenario.yaml"


def number(quantity: str) -> float:
    return float(quantity.split()[0])


def place(at: list[str]) -> list[str]:
    """(x, y) to (−y, x), z as it is."""
    return [f"{-number(at[1])!r} m", at[0], *at[2:]]


def turned(tree: dict[str, Any]) -> dict[str, Any]:
    """Whatever of a lift file is in axes of the world."""
    for one in (tree["load"], *tree["vessels"].values()):
        one["position"] = place(one.get("position", ["0 m", "0 m"]))
        one["heading"] = "90 deg"
    for one in tree["structures"].values():
        one["x"], one["y"] = [f"{-number(y)!r} m" for y in reversed(one["y"])], one["x"]
    for one in tree["mooring_lines"].values():
        one["to"] = place(one["to"])
    for one in tree["guides"].values():
        one["post"]["at"] = place(one["post"]["at"])
    (swell,) = tree["waves"].values()
    swell["direction"] = f"{number(swell['direction']) + 90.0!r} deg"
    return tree


def simulated(tree: dict[str, Any]) -> Recording:
    document = json.dumps({"format": tree.pop("format"), **tree})
    return gantline.simulate(gantline.parse_scenario(document, str(FILE)))


def test_a_landing_turned_by_a_right_angle() -> None:
    """Tensions, contacts, moorings, tilt and trim to 1e-6 of their largest; events, verdicts and the worst
    elements of checks. The heading of 90 deg is off by 1e-16, and contacts make more of that in 165 s.
    """
    text = FILE.read_text(encoding="utf-8")
    was, found = simulated(yaml.safe_load(text)), simulated(turned(yaml.safe_load(text)))
    shared = ("rope_tension", "contact_force", "hook_load", "mooring_tension", "load_tilt", "vessel_trim")
    for name in shared:
        values = was[name].values
        assert np.abs(found[name].values - values).max() < 1e-6 * np.abs(values).max(), name
    for name in was.coordinates["body"]:
        x, y, z = was.column("body_position", name).T
        moved = np.column_stack([-y, x, z])
        assert np.abs(found.column("body_position", name) - moved).max() < 1e-6, name
    assert [event[1:] for event in found.events()] == [event[1:] for event in was.events()]
    seen = [
        [(one.name, one.element, one.verdict) for one in check_recording(run) if one.name != "no_warnings"]
        for run in (was, found)
    ]
    assert seen[0] == seen[1]
