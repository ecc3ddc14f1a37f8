"""The load in a hinge: joints that pins hold, one for each way it cannot go, and that in which it turns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import IDENTITY, Array, rotation_matrix, rotation_quaternion, unit
from gantline.scenario import Scenario
from gantline.scenario.loads.hinge import PUSHES, LoadHinge, hinge_joints, opened_in

__all__ = ["hinge_rig", "hinged_load"]

#: A load fits a hinge that is no farther from its place on the load than this [m].
_FITS = 0.02
#: Cosine to plumb beyond which an axis counts as plumb itself.
_PLUMB = 0.99
_ACROSS, _ALONG, _UPRIGHT = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
#: Axis of each joint that a pin holds, in the axes of the hinge, by what it is.
_AXES = {
    "across": ("slider", _ACROSS),
    "along": ("slider", _ALONG),
    "upright": ("slider", _UPRIGHT),
    "about_upright": ("hinge", _UPRIGHT),
    "about_across": ("hinge", _ACROSS),
}


def hinged_load(
    parts: Parts,
    scenario: Scenario,
    load: str,
    start: tuple[Sequence[float], Sequence[float]],
    centre: Array,
    own: Mapping[str, Any],
) -> None:
    """Add the load on its hinge; what holds that is there.

    Three sliders and two hinges carry one another, each held by a pin: the pins' forces are those of the
    hinge, and with all of them pulled the load moves as freely as one that was never held.

    Args:
        parts: What the bodies are added to.
        scenario: The lift, with one hinge.
        load: Name of the load.
        start: Its centre of gravity in the world [m] and its orientation at the start.
        centre: The same from its datum, its own axes (3,) [m].
        own: Mass and inertia of its body.

    Raises:
        ScenarioError: if the hinge stands elsewhere than its place on the load.
    """
    ((name, hinge),) = (scenario.hinges or {}).items()
    body = None if hinge.held_by == "world" else hinge.held_by
    position, turned = np.array(start[0]), rotation_matrix(start[1])
    at = np.array(hinge.at) - centre
    middle = position + turned @ at
    _check_fit(parts, scenario, name, hinge, middle)
    axes = _axes(turned @ np.array(unit(hinge.axis)), turned)
    base, base_axes = parts.pose(body)
    placed: dict[str, Any] = {
        "position": (base_axes.T @ (middle - base)).tolist(),
        "orientation": rotation_quaternion(base_axes.T @ axes),
    }
    parent = body
    for what, joint in hinge_joints(name).items():
        kind, axis = _AXES[what]
        parts.add_body(joint, _joint(kind, axis) | {"pin": True}, parent=parent, **placed)
        parent, placed = joint, {"position": (0.0, 0.0, 0.0), "orientation": IDENTITY}
    parts.add_body(name, _joint("hinge", _ALONG) | {"friction": hinge.friction}, parent=parent)
    to_load = axes.T @ turned
    parts.add_body(
        load,
        {"type": "fixed"},
        parent=name,
        position=(-to_load @ at).tolist(),
        orientation=rotation_quaternion(to_load),
        **own,
    )


def _joint(kind: str, axis: Sequence[float]) -> Json:
    still = {"position": 0.0, "velocity": 0.0, "damping": 0.0, "friction": 0.0}
    return {"type": kind, "axis": list(axis), "drive": None, "stops": None, **still}


def _axes(along: Array, turned: Array) -> Array:
    """Axes of a hinge as columns (3, 3), the second of them its own: across, along, upright.

    Upright is as nearly so as the axis allows; of an axis that is plumb it is level, the load's own x.
    """
    up = np.array(_UPRIGHT) if abs(along[2]) < _PLUMB else turned[:, 0]
    upright = up - (up @ along) * along
    if not upright.any():  # a plumb axis of a load whose x axis is plumb
        upright = turned[:, 1]
    upright = upright / np.linalg.norm(upright)
    return np.stack([np.cross(along, upright), along, upright], axis=1)


def _check_fit(parts: Parts, scenario: Scenario, name: str, hinge: LoadHinge, middle: Array) -> None:
    """The hinge stands where the load has its place for it."""
    if hinge.to is None:
        return
    body = None if hinge.held_by == "world" else hinge.held_by
    apart = parts.place(body, hinge.to) - middle
    if float(np.linalg.norm(apart)) <= _FITS:
        return
    assert scenario.load is not None  # a hinge without a load was refused
    base, base_axes = parts.pose(body)
    # Adding 0 takes the sign off a zero.
    place, right = (
        "({:g}, {:g}, {:g}) m".format(*(np.round(one, 3) + 0.0))
        for one in (base_axes.T @ (middle - base), np.array(scenario.load.position) + apart)
    )
    whose = "in the world" if body is None else f"in the axes of {body}"
    sentence = (
        f"the load has its place for it at {place} {whose} at the start, {np.linalg.norm(apart):.3g} m off"
    )
    raise scenario.start_error(
        ("hinges", name, "to"), f"{sentence}; it fits with the load's 'position' at {right}"
    )


def hinge_rig(scenario: Scenario, centre: Array | None) -> Json:
    """What results need to know of hinges; nothing in a lift without.

    Args:
        scenario: The lift.
        centre: Centre of gravity of its load from the datum, its own axes (3,) [m]; None without a load.
    """
    load, gravity = scenario.load, scenario.simulation.gravity
    if load is None or centre is None or not scenario.hinges:
        return {}
    return {
        "hinges": [
            {
                "name": name,
                "load": load.name,
                "at": [float(part) for part in np.array(hinge.at) - centre],
                "held_by": hinge.held_by if hinge.held_by != "world" else None,
                "pushes": [hinge_joints(name)[what] for what in PUSHES],
                "turns": [joint for what, joint in hinge_joints(name).items() if what not in PUSHES],
                "rated_capacity": None if hinge.rated_capacity is None else hinge.rated_capacity * gravity,
                "pins_apart": hinge.pins_apart,
                "opened_in": opened_in(scenario, name),
            }
            for name, hinge in scenario.hinges.items()
        ]
    }
