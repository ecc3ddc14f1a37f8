"""A lift made of given numbers, so that results, checks and plots are tested without the simulator.

Five slings hang from the moving sheaves of one equalizer under one hook and carry a load of 300 t, with the
geometry of the reference lift. Tensions, travels and contact forces are whatever the caller says.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.results.derive import recording_of
from gantline.results.direct import DIRECT
from gantline.results.file.layout import COUNTED, DIMS, FIXED
from gantline.results.recording import Recording

Array = npt.NDArray[np.float64]

WEIGHT = 300e3 * 9.81
HOOK = 36.483
ALONG = (-3.2, -1.6, 0.0, 1.6, 3.2)
LUGS = ((-2.5, 2.5), (2.5, 2.5), (0.0, 0.0), (-2.5, -2.5), (2.5, -2.5))
LENGTHS = (23.0, 26.0, 26.0, 26.0, 23.0)
SLINGS = [f"sling.S{i}" for i in range(1, 6)]
SHEAVES = [f"e1.{i}" for i in range(1, 6)]
CORNERS = [f"block.corner_{i}" for i in range(1, 5)]
ENERGIES = [
    "kinetic",
    "gravity",
    "elastic",
    "drive_work",
    "rope_damping",
    "joint_damping",
    "contact_damping",
    "friction",
    "impact",
    "parting",
    "adjusting",
    "method",
    "remainder",
]


def sample_rig(**limits: Any) -> dict[str, Any]:
    return {
        "title": "One equalizer lifts a 300 t load",
        "number": "EQ-300",
        "revision": "0",
        "remark": "",
        "gravity": 9.81,
        "loads": [
            {
                "name": "block",
                "body": "block",
                "weight": WEIGHT,
                "calculated_mass": 3e5,
                "contingency": 1.0,
                "design_mass": 3e5,
                "contact_group": "block",
                "contacts": CORNERS,
                "lugs": {
                    f"L{i}": {"at": [x, y, 2.5], "main_plate_normal": [0, 1, 0], "capacity": 80e3 * 9.81}
                    for i, (x, y) in enumerate(LUGS, 1)
                },
                "centre_of_gravity_from_datum": [0, 0, 2.5],
            }
        ],
        "hooks": [
            {
                "name": "test_hook",
                "crane": "test_hook",
                "bearing_joints": ["e1"],
                "direct_slings": [],
                "rated_capacity": 400e3 * 9.81,
                "rating_includes_hook_block": False,
                "hoist_weight_extra": 50e3,
                "drive_body": "test_hook",
            }
        ],
        "equalizers": [
            {
                "name": "e1",
                "hook": "test_hook",
                "body": "e1",
                "equalizing_rope": "e1.equalizing",
                "slings": SLINGS,
                "moving_sheaves": SHEAVES,
                "travel_up": 1.4,
                "travel_down": 1.9,
                "rated_capacity": 330e3 * 9.81,
                "heading_joint": "e1",
            }
        ],
        "slings": [
            {
                "name": f"S{i}",
                "rope": f"sling.S{i}",
                "from": f"e1.{i}",
                "to_load": "block",
                "to_lug": f"L{i}",
                "length": LENGTHS[i - 1],
                "tolerance": 0.0025,
                "minimum_breaking_force": 3039e3,
                "shackles": {},
                "segment": f"sling.S{i}/0",
            }
            for i in range(1, 6)
        ],
        "ropes": [
            {"name": "e1.equalizing", "mass_per_length": 8.65, "minimum_breaking_force": 1476e3},
            *({"name": rope, "mass_per_length": 0.0, "minimum_breaking_force": 3039e3} for rope in SLINGS),
        ],
        "limits": limits,
        "plan": [
            {"step": "hoist", "kind": "hoist", "drives": ["test_hook.hoist"], "report": [], "require": {}},
            {"step": "hold", "kind": "hold", "drives": [], "report": [], "require": {}},
        ],
    }


def sample_scene() -> dict[str, Any]:
    def body(name: str, kind: str, shape: dict[str, Any] | None) -> dict[str, Any]:
        return {"name": name, "shape": shape, "centre_of_gravity": [0, 0, 0], "kind": kind}

    def box(x: float, y: float, z: float, centre: list[float]) -> dict[str, Any]:
        return {"type": "box", "size": [x, y, z], "centre": centre}

    frame = body("e1", "frame", box(8.0, 1.6, 3.3, [0, 0, -5.85]))
    frame["centre_of_gravity"] = [0, 0, -5.0]
    sheaves = [
        {"body": f"e1.{i}", "centre": [0, 0, 0], "axis": [0, 1, 0], "radius": 0.4, "kind": "moving"}
        for i in range(1, 6)
    ]
    sheaves += [
        {"body": "e1", "centre": [x, 0, -6.65], "axis": [0, 1, 0], "radius": 0.4, "kind": "fixed"}
        for x in (-2.4, -0.8, 0.8, 2.4)
    ]
    return {
        "bodies": [
            body("test_hook", "hook", None),
            frame,
            *(body(name, "sheave", None) for name in SHEAVES),
            body("block", "load", box(10.0, 10.0, 5.0, [0, 0, 0])),
        ],
        "sheaves": sheaves,
        "ropes": [
            {"name": "e1.equalizing", "kind": "equalizing"},
            *({"name": name, "kind": "sling"} for name in SLINGS),
        ],
        "ground": {"level": 0.0},
        "axes": None,
    }


def turned(yaw: Array, points: Array) -> Array:
    """Points of shape (P, 3) or (T, P, 3) turned about z by yaw (T); result of shape (T, P, 3)."""
    points = np.broadcast_to(points, (len(yaw), *points.shape[-2:]))
    c, s = np.cos(yaw)[:, None], np.sin(yaw)[:, None]
    x, y, z = np.moveaxis(points, -1, 0)
    return np.stack([c * x - s * y, s * x + c * y, z], axis=-1)


def equalizing_points(travel: Array) -> Array:
    """Path of the equalizing rope in the frame, (T, P, 3), below the bearing of the hook."""
    angle = np.linspace(np.pi, 0.0, 9)
    parts = [np.full((len(travel), 1, 3), [-3.6, 0.0, -6.65])]
    for i, x in enumerate(ALONG):
        below = -8.65 - travel[:, i, None] - 0.4 * np.sin(angle)
        along = np.broadcast_to(x + 0.4 * np.cos(angle), below.shape)
        parts.append(np.stack([along, np.zeros_like(below), below], axis=-1))
        if i < 4:
            arc = np.stack([x + 0.8 + 0.4 * np.cos(angle), 0 * angle, -6.65 + 0.4 * np.sin(angle)], axis=-1)
            parts.append(np.broadcast_to(arc, (len(travel), 9, 3)))
    parts.append(np.full((len(travel), 1, 3), [3.6, 0.0, -6.65]))
    return np.concatenate(parts, axis=1)


def sample_columns(
    time: Array,
    *,
    tension: Array,
    travel: Array | None = None,
    contact: Array | None = None,
    yaw: Array | None = None,
    hook: Array | None = None,
    load_z: Array | None = None,
    tilt: Array | None = None,
    load_yaw: Array | None = None,
    energy: dict[str, Array] | None = None,
    events: list[tuple[float, str, str]] | None = None,
) -> tuple[dict[str, Array], dict[str, list[str]]]:
    """Columns and names of the sample lift, as the core gives them.

    Args:
        time: (T,) s.
        tension: of the slings (T, 5) N; the equalizing rope has half of their mean.
        travel: of the moving sheaves (T, 5) m, down positive.
        contact: force of each corner (T, 4) N.
        yaw: of the frame (T,) rad.
        hook: height of the bearing (T,) m.
        load_z: height of the load's centre of gravity (T,) m.
        tilt: of the load about world y (T,) rad.
        load_yaw: of the tilted load about plumb (T,) rad; its lugs stay.
        energy: by kind (T,) J.
        events: time, kind, name.
    """
    count = len(time)
    zero = np.zeros(count)
    travel = np.zeros((count, 5)) if travel is None else travel
    contact = np.zeros((count, 4)) if contact is None else contact
    yaw = zero if yaw is None else yaw
    hook = zero + HOOK if hook is None else hook
    load_z = zero + 2.5 if load_z is None else load_z
    tilt = zero if tilt is None else tilt
    load_yaw = zero if load_yaw is None else load_yaw
    events = [] if events is None else events
    lift = np.stack([zero, zero, hook], axis=-1)[:, None]
    sheave = np.stack([zero[:, None] + ALONG, np.zeros((count, 5)), -8.65 - travel], axis=-1)
    sheave = turned(yaw, sheave) + lift
    lugs = np.array([[x, y, 2.5] for x, y in LUGS])
    c, s = np.cos(tilt)[:, None], np.sin(tilt)[:, None]
    lug = (
        np.stack(
            [
                c * lugs[:, 0] + s * lugs[:, 2],
                np.broadcast_to(lugs[:, 1], (count, 5)),
                -s * lugs[:, 0] + c * lugs[:, 2],
            ],
            axis=-1,
        )
        + np.stack([zero, zero, load_z], axis=-1)[:, None]
    )
    equalizing = turned(yaw, equalizing_points(travel)) + lift
    slings = np.stack([sheave, lug], axis=2).reshape(count, 10, 3)
    centre = np.stack([zero, zero, hook - 5.0], axis=-1)[:, None]
    load = np.stack([zero, zero, load_z], axis=-1)[:, None]
    upright = np.stack([np.cos(yaw / 2), zero, zero, np.sin(yaw / 2)], axis=-1)[:, None]
    (c_tilt, s_tilt), (c_yaw, s_yaw) = ((np.cos(one / 2), np.sin(one / 2)) for one in (tilt, load_yaw))
    attitude = [c_yaw * c_tilt, -s_yaw * s_tilt, c_yaw * s_tilt, s_yaw * c_tilt]
    tilted = np.stack(attitude, axis=-1)[:, None]
    rope_tension = np.column_stack([tension.mean(axis=1) / 2, tension])
    joint_force = np.zeros((count, 8, 3))
    joint_force[:, 1, 2] = tension.sum(axis=1) + 21.5e3 * 9.81
    kinds = dict.fromkeys(ENERGIES, zero) | (energy or {})
    columns = {
        "time": time,
        "rope_tension": rope_tension,
        "segment_tension": tension,
        "segment_length": np.linalg.norm(slings[:, ::2] - slings[:, 1::2], axis=-1),
        "rope_point": np.concatenate([equalizing, slings], axis=1),
        "body_position": np.concatenate([lift, centre, sheave, load], axis=1),
        "body_orientation": np.concatenate([upright * 0 + [1, 0, 0, 0], *[upright] * 6, tilted], axis=1),
        "body_velocity": np.zeros((count, 8, 3)),
        "body_angular_velocity": np.zeros((count, 8, 3)),
        "momentum": np.zeros((count, 3)),
        "angular_momentum": np.zeros((count, 3)),
        "joint_position": np.column_stack([hook - hook[0], yaw, travel]),
        "joint_force": joint_force,
        "contact_force": contact,
        "contact_lift": contact,
        "energy": np.column_stack([kinds[kind] for kind in ENERGIES]),
        "residual_constraint": zero,
        "residual_complementarity": zero,
        "rope_peak_tension": rope_tension.max(axis=0),
        "rope_peak_time": time[rope_tension.argmax(axis=0)],
        "event_time": np.array([e[0] for e in events], dtype=np.float64),
    }
    names = {
        "rope": ["e1.equalizing", *SLINGS],
        "segment": [f"{name}/0" for name in SLINGS],
        "rope_point": ["e1.equalizing"] * equalizing.shape[1] + [name for name in SLINGS for _ in range(2)],
        "body": ["test_hook", "e1", *SHEAVES, "block"],
        "joint": ["test_hook", "e1", *SHEAVES],
        "contact": CORNERS,
        "energy_kind": ENERGIES,
        "event_kind": [e[1] for e in events],
        "event_name": [e[2] for e in events],
    }
    return with_empty_ones(columns, names)


def with_empty_ones(columns: dict[str, Any], names: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """The same with the columns and names that the core hands out empty, of what the lift has none of."""
    for name in DIRECT:
        dims = DIMS[name]
        columns.setdefault(name, np.zeros([len(columns["time"]) if dim == "time" else 0 for dim in dims]))
        for dim in set(dims) - COUNTED - set(FIXED):
            names.setdefault(dim, [])
    return columns, names


def sample_recording(time: Array, *, rig: dict[str, Any] | None = None, **given: Any) -> Recording:
    """A recording of the sample lift, of what `sample_columns` makes of the same arguments."""
    columns, names = sample_columns(time, **given)
    return recording_of(
        columns,
        names,
        sample_rig() if rig is None else rig,
        title="One equalizer lifts a 300 t load",
        gantline_version="0.0.0",
        scenario="format: 1\n",
        settings={"integrator": {"type": "del", "step": 0.001}, "duration": 40.0},
        warnings=[],
        scene=sample_scene(),
        counters={"steps": 10},
        energy_remainder=1e-4,
        status="done",
    )


def ringing_lift(**given: Any) -> Recording:
    """A lift of which every number can be worked out by hand.

    The corners carry the weight until t = 10 s, nothing after; the slings carry nothing until then and after
    that 600, 606, 594, 600, 600 kN with 100 kN of ringing at 1 Hz upon it, in the same ratio. The hoist works
    until 20 s.
    """
    time = np.linspace(0.0, 40.0, 2001)
    clear = time >= 10.0
    tension = np.outer(clear * (600e3 + 100e3 * np.sin(2 * np.pi * time)), [1.0, 1.01, 0.99, 1.0, 1.0])
    contact = np.repeat(np.where(clear, 0.0, WEIGHT / 4)[:, None], 4, axis=1)
    work = np.minimum(time, 20.0) * 50.0
    settings: dict[str, Any] = {
        "tension": tension,
        "contact": contact,
        "energy": {"drive_work": work, "gravity": work},
        "events": [
            (0.0, "step_begin", "hoist"),
            (9.99, "lift_off", "block"),
            (20.0, "step_end", "hoist"),
            (20.0, "step_begin", "hold"),
            (40.0, "step_end", "hold"),
        ],
    }
    return sample_recording(time, **{**settings, **given})
