"""Random rigs of extension sheaves at rest, up to three deep with sixteen lugs, against balances by hand.

Nothing of gantline's own geometry is used but where bodies are: ropes are straight from end to end, a sling
over a sheave has the sum of two such parts, T = EA (ℓ/L − 1), and forces on every sheave, and forces and
moments on the load, add up to nothing.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import gantline
from mechanics import Floats, G

EA, SHEAVE, HOISTED = 60e6, 200.0, 6.0
LUG_HEIGHT = 4.0


def rig(seed: int) -> tuple[dict[str, Any], dict[str, Floats], Floats, float]:
    """A lift as a mapping, its lugs and centre of gravity on the load, and the mass of that."""
    rng = np.random.default_rng(seed)
    depth, tops = int(rng.integers(1, 4)), int(rng.integers(1, 3))
    mass = float(rng.uniform(20e3, 200e3))
    centre = np.array([*rng.uniform(-0.4, 0.4, 2), rng.uniform(0.5, 2.0)])
    level = 8.0  # of a sling and the next, about [m]
    lugs: dict[str, Floats] = {}
    sheaves: dict[str, Any] = {}
    slings: dict[str, Any] = {}

    def hang(below: int, middle: float, wide: float) -> tuple[str, Floats]:
        """What a sling leads to, and about where that is as the slings go taut."""
        if below == 0:
            name = f"L{len(lugs)}"
            lugs[name] = np.array([middle + rng.uniform(-0.4, 0.4), rng.uniform(-2, 2), LUG_HEIGHT])
            return f"block.{name}", lugs[name]
        name = f"X{len(sheaves)}"
        sheaves[name] = {"mass": f"{SHEAVE} kg"}
        parts = [hang(below - 1, middle + side * wide, wide / 2) for side in (-1, 1)]
        aside = np.mean([place for _, place in parts], axis=0)
        place = np.array([*aside[:2], LUG_HEIGHT + level * below])
        length = sum(float(np.linalg.norm(place - end)) for _, end in parts) + 1.0
        slings[f"S{name}"] = {"over": name, "to": [to for to, _ in parts], "length": f"{length!r} m"}
        return name, place

    hook = np.array([0.0, 0.0, LUG_HEIGHT + level * (depth + 1)])
    for top in range(tops):
        to, place = hang(depth, (2 * top - tops + 1) * 2.2, 3.0 / tops)
        length = float(np.linalg.norm(hook - place)) + rng.uniform(0.8, 1.0)
        slings[f"T{top}"] = {"from": "hook", "to": to, "length": f"{length!r} m"}
    lift = {
        "format": 1,
        "lift": {"title": f"Random rig {seed}"},
        "duration": "70 s",
        "ground": {"level": "0 m"},
        "ropes": {"sling": {"axial_stiffness": f"{EA} N", "damping_time": "5 ms", "mass": "none"}},
        "load": {
            "name": "block",
            "shape": {"box": ["12 m", "6 m", f"{LUG_HEIGHT} m"]},
            "position": [0, 0, 0],
            "stands_on": "ground",
            "weight": {"calculated": f"{mass!r} kg"},
            "centre_of_gravity": {"at": [f"{part!r} m" for part in centre.tolist()]},
            "lugs": {name: {"at": [f"{part!r} m" for part in at.tolist()]} for name, at in lugs.items()},
        },
        "cranes": {
            "hook": {
                "type": "fixed_hook",
                "at": [0, 0, f"{hook[2]} m"],
                "hoist": {"speed": "6 m/min", "acceleration": "0.1 m/s^2"},
            }
        },
        "extension_sheaves": sheaves,
        "sling_defaults": {"rope": "sling"},
        "slings": slings,
        "plan": [{"step": "up", "hoist": "hook", "speed": "6 m/min", "by": f"{HOISTED} m"}],
    }
    return lift, lugs, centre, mass


def turned(quaternion: Floats) -> Floats:
    """Matrix of a unit quaternion (w, x, y, z)."""
    w, *vector = quaternion
    cross = np.cross(np.eye(3), np.array(vector))
    matrix: Floats = np.eye(3) + 2 * w * cross + 2 * cross @ cross
    return matrix


@pytest.mark.parametrize("seed", range(8))
def test_a_random_rig_is_in_balance(seed: int) -> None:
    """Forces on all sheaves and the load, moments on it, tensions of all slings, to 1e-9 of the weight."""
    lift, lugs, centre, mass = rig(seed)
    rest = gantline.Statics(gantline.parse_scenario(lift)).equilibrium()
    assert rest.is_stable
    recording = rest.recording
    load, attitude = (recording.column(f"body_{what}", "block")[-1] for what in ("position", "orientation"))
    place = {f"block.{name}": load + turned(attitude) @ (at - centre) for name, at in lugs.items()}
    for body in ("hook", *lift["extension_sheaves"]):
        place[body] = recording.column("body_position", body)[-1]
    forces = {body: np.array([0.0, 0.0, -SHEAVE * G]) for body in lift["extension_sheaves"]}
    forces |= {"block": np.array([0.0, 0.0, -mass * G]), "hook": np.zeros(3)}
    moment = np.zeros(3)
    for name, sling in lift["slings"].items():
        start = sling.get("over") or sling["from"]
        ends = sling["to"] if "over" in sling else [sling["to"]]
        parts = [place[end] - place[start] for end in ends]
        unstretched = float(sling["length"].removesuffix(" m"))
        tension = EA * (sum(float(np.linalg.norm(part)) for part in parts) / unstretched - 1.0)
        assert rest.tension(f"sling.{name}") == pytest.approx(tension, abs=1e-9 * mass * G)
        for end, part in zip(ends, parts, strict=True):
            pull = tension * part / np.linalg.norm(part)
            forces[start] = forces[start] + pull
            body = end.partition(".")[0]
            forces[body] = forces[body] - pull
            if body == "block":
                moment -= np.cross(place[end] - load, pull)
    weight = forces.pop("hook")
    assert max(float(np.abs(force).max()) for force in [*forces.values(), moment]) < 1e-9 * mass * G
    whole = mass + SHEAVE * len(lift["extension_sheaves"])
    assert weight == pytest.approx([0.0, 0.0, -whole * G], abs=1e-9 * mass * G)
