"""Recordings of given hoist loads and radii, of hooks at booms whose cranes have a rating chart."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from gantline.results.recording import Recording
from gantline.results.variable import FloatArray, Variable

G = 9.81
T = 1e3 * G
RADII = (12.0, 14.0, 16.0, 18.0)
RATED = (360 * T, 283 * T, 231 * T, 195 * T)


def recording(
    radius: list[list[float]],
    load: list[list[float]],
    *,
    cranes: tuple[str, ...] = ("c1",),
    rated: tuple[float, ...] = RATED,
    shares: dict[str, float] | None = None,
    lead: float | FloatArray = 0.0,
    factors: dict[str, Any] | None = None,
    limits: dict[str, float] | None = None,
    plan: Sequence[dict[str, Any]] = (),
) -> Recording:
    """One hook to each crane, or several to one; radius [m] and hoist load [t] are (time, hook),
    and so may the off-lead be [rad].

    Samples are a second apart; step n of the plan ends with sample n.
    """
    count = len(radius[0])
    hooks = [f"H{n}" for n in range(count)]
    crane_of = dict(zip(hooks, cranes if len(cranes) == count else cranes * count, strict=True))
    hoist = np.array(load) * T
    by_hook, by_crane = ("time", "hook"), ("time", "crane")
    slings = [f"sling.{hook}" for hook in hooks]
    plumb = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]] * count)
    still = np.zeros((len(radius), len(cranes)))
    variables = {
        "time": Variable(("time",), np.arange(len(radius), dtype=float), "s", ""),
        "hoist_load": Variable(by_hook, hoist, "N", ""),
        "hook_load": Variable(by_hook, np.maximum(hoist - 9 * T, 0.0), "N", ""),
        "crane_radius": Variable(by_hook, np.array(radius), "m", ""),
        "hook_height": Variable(
            ("time", "crane_hook"), np.array([[30.0 + n for n in range(count)]] * len(radius)), "m", ""
        ),
        "boom_angle": Variable(by_crane, still + math.radians(60), "rad", ""),
        "off_lead": Variable(by_hook, np.full(hoist.shape, lead), "rad", ""),
        "side_lead": Variable(by_hook, np.zeros(hoist.shape), "rad", ""),
        "crane_heel": Variable(by_crane, still, "rad", ""),
        "crane_trim": Variable(by_crane, still, "rad", ""),
        "rope_tension": Variable(("time", "rope"), hoist, "N", ""),
        "rope_peak_tension": Variable(("rope",), hoist.max(axis=0), "N", ""),
        "rope_peak_time": Variable(("rope",), np.zeros(count), "s", ""),
        "rope_point": Variable(("time", "rope_point", "xyz"), np.stack([plumb] * len(radius)), "m", ""),
        "rope_of_point": Variable(("rope_point",), np.repeat(slings, 2), "1", ""),
        "event_time": Variable(("event",), np.arange(len(plan), dtype=float), "s", ""),
        "event_kind": Variable(("event",), np.array(["step_end" for _ in plan]), "1", ""),
        "event_name": Variable(("event",), np.array([step["step"] for step in plan]), "1", ""),
    }
    charts = [
        {
            "crane": crane,
            "over": "radius",
            "at": RADII,
            "rated": rated,
            "includes_hook_block": True,
            "hooks": [hook for hook in hooks if crane_of[hook] == crane],
            "hook_shares": shares or {},
            "off_lead": math.radians(1.0),
        }
        for crane in dict.fromkeys(cranes)
    ]
    rig = {
        "hooks": [{"name": hook, "crane": crane_of[hook], "direct_slings": [hook]} for hook in hooks],
        "slings": [{"name": hook, "rope": f"sling.{hook}", "from": hook, "to_lug": "L"} for hook in hooks],
        "rating_charts": charts,
        "factors": factors or {},
        "limits": limits or {},
        "plan": list(plan),
    }
    labels = {
        "hook": hooks,
        "crane_hook": hooks,
        "crane": list(dict.fromkeys(cranes)),
        "rope": slings,
        "xyz": ["x", "y", "z"],
    }
    return Recording(variables, labels, {"title": "", "rig": rig})
