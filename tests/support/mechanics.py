"""Small systems for verification, written as the core's documents, and how to run them."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gantline._core import Simulation

G = 9.81
Floats = NDArray[np.float64]
Json = dict[str, Any]
#: Coordinates of a point.
Xyz = Sequence[float] | Floats


def body(
    name: str,
    joint: Json,
    mass: float,
    *,
    parent: str | None = None,
    position: Sequence[float] = (0, 0, 0),
    centre_of_gravity: Sequence[float] = (0, 0, 0),
    inertia: Sequence[float] = (0, 0, 0),
) -> Json:
    """A body whose joint sits at `position` of its parent; `inertia` about its centre of gravity."""
    return {
        "name": name,
        "parent": parent,
        "placement": {"position": list(position), "orientation": [1, 0, 0, 0]},
        "joint": joint,
        "mass": mass,
        "centre_of_gravity": list(centre_of_gravity),
        "inertia": [*inertia, 0, 0, 0],
    }


def slider(axis: Sequence[float] = (0, 0, 1), **start: Any) -> Json:
    return {"type": "slider", "axis": list(axis), **start}


def hinge(axis: Sequence[float] = (0, 1, 0), **start: Any) -> Json:
    return {"type": "hinge", "axis": list(axis), **start}


def point(position: Xyz, velocity: Sequence[float] = (0, 0, 0)) -> Json:
    return {"type": "point", "position": list(position), "velocity": list(velocity)}


def free(position: Xyz, **start: Any) -> Json:
    at_rest = {"orientation": [1, 0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0]}
    return {"type": "free", "position": list(position), **at_rest, **start}


def flow(name: str, inertia: float, **rest: Any) -> Json:
    """Rope that passes a sheave or leaves a drum; `inertia` of what turns over its radius squared [kg]."""
    return body(name, {"type": "flow", "inertia": inertia, **rest}, 0.0)


def end(body_name: str | None, at: Xyz = (0, 0, 0)) -> Json:
    return {"type": "end", "body": body_name, "at": list(at)}


def drum(body_name: str | None, at: Xyz, name: str, rate: float = 1.0) -> Json:
    """An end where the flow `name` pays out rope, `rate` times itself."""
    return {**end(body_name, at), "drum": {"flow": name, "rate": rate}}


def half_turn(
    body_name: str | None, centre: Sequence[float], radius: float, over: bool, **passing: Any
) -> Json:
    """A sheave in the x-z plane; the rope lies on its top where `over`, else below it.

    `passing`: `flow`, the name of the flow over it, and the `ratio` of tensions at which that slips.
    """
    x, y, z = centre
    enter, leave = [x - radius, y, z], [x + radius, y, z]
    return {
        "type": "half_turn",
        "body": body_name,
        "enter": enter,
        "leave": leave,
        "bulge": [0, 0, 1 if over else -1],
        **passing,
    }


def sheave(
    body_name: str | None, at: Sequence[float], axis: Sequence[float], radius: float, **rest: Any
) -> Json:
    """A sheave with true tangents; the rope runs about its axis."""
    return {"type": "sheave", "body": body_name, "at": list(at), "axis": list(axis), "radius": radius, **rest}


def eye(body_name: str | None, at: Xyz = (0, 0, 0)) -> Json:
    """A point that the rope slides through."""
    return {"type": "eye", "body": body_name, "at": list(at)}


def rope(
    name: str, length: float | None, route: Sequence[Json], ea: float | None, damping_time: float = 0.0
) -> Json:
    """A rope; without `ea` [N] it is inextensible."""
    material: Json = {"type": "inextensible"}
    if ea is not None:
        material = {"type": "elastic", "axial_stiffness": ea, "damping_time": damping_time}
    return {"name": name, "length": length, "material": material, "route": list(route)}


def contact(name: str, body_name: str, at: Sequence[float], **law: Any) -> Json:
    plane = {"plane_point": [0, 0, 0], "plane_normal": [0, 0, 1], "friction": 0.0, "damping_time": 0.0}
    return {"name": name, "group": body_name, "body": body_name, "at": list(at), **plane, **law}


def document(bodies: Sequence[Json], **rest: Any) -> Json:
    return {"gravity": [0, 0, -G], "bodies": list(bodies), **rest}


@dataclass(frozen=True)
class Run:
    """Columns of a finished run with access by name."""

    columns: Mapping[str, Floats]
    names: Mapping[str, list[str]]
    energy_remainder: float
    counters: Mapping[str, int]
    status: Mapping[str, Any] = field(default_factory=dict)

    @property
    def time(self) -> Floats:
        return self.columns["time"]

    def body(self, name: str, column: str = "body_position") -> Floats:
        return self.columns[column][:, self.names["body"].index(name)]

    def spin(self, name: str, inertia: Sequence[float] | Floats) -> tuple[Floats, Floats]:
        """Angular velocity in body axes [rad/s], momentum in space [kg m²/s]; principal `inertia`."""
        w, x, y, z = self.body(name, "body_orientation").T
        rotation = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        local = np.einsum("jit,tj->ti", rotation, self.body(name, "body_angular_velocity"))
        return local, np.einsum("ijt,tj->ti", rotation, local * np.asarray(inertia))

    def joint(self, name: str) -> Floats:
        return self.columns["joint_position"][:, self.names["joint"].index(name)]

    def tension(self, name: str) -> Floats:
        return self.columns["rope_tension"][:, self.names["rope"].index(name)]

    def peak(self, name: str) -> float:
        """Largest tension over all steps, not only at samples [N]."""
        return float(self.columns["rope_peak_tension"][self.names["rope"].index(name)])

    def energy(self, kind: str) -> Floats:
        return self.columns["energy"][:, self.names["energy_kind"].index(kind)]

    def events(self, kind: str) -> list[tuple[float, str]]:
        rows = zip(
            self.columns["event_time"], self.names["event_kind"], self.names["event_name"], strict=True
        )
        return [(float(time), name) for time, found, name in rows if found == kind]


def simulation(
    system: Json, duration: float, *, step: float = 1e-3, sample_interval: float | None = None, **method: Any
) -> Simulation:
    integrator = {"type": "del", "step": step, **method}
    settings = {
        "integrator": integrator,
        "duration": duration,
        "sample_interval": step if sample_interval is None else sample_interval,
    }
    return Simulation(json.dumps(system), json.dumps(settings))


def finished(run: Simulation, status: Mapping[str, Any]) -> Run:
    return Run(run.columns(), run.names(), run.energy_remainder(), run.counters(), status)


def simulate(system: Json, duration: float, **settings: Any) -> Run:
    """Runs a document to its end with `del`; samples every step unless told otherwise."""
    run = simulation(system, duration, **settings)
    status = run.run()
    assert status["status"] == "done", status
    return finished(run, status)


def adaptive(
    system: Json,
    duration: float,
    *,
    tension_tolerance: float | None = 1e-3,
    position_tolerance: float | None = 1e-7,
    sample_interval: float = 0.01,
) -> Run:
    """Runs a document to its end with `adaptive`."""
    tolerances = {"tension_tolerance": tension_tolerance, "position_tolerance": position_tolerance}
    settings = {
        "integrator": {"type": "adaptive", **tolerances},
        "duration": duration,
        "sample_interval": sample_interval,
    }
    run = Simulation(json.dumps(system), json.dumps(settings))
    status = run.run()
    assert status["status"] == "done", status
    return finished(run, status)


def period(time: Floats, values: Floats, *, about: float = 0.0) -> float:
    """Mean period of an oscillation from its upward crossings, each interpolated linearly [s]."""
    shifted = values - about
    at = np.flatnonzero((shifted[:-1] < 0) & (shifted[1:] >= 0))
    share = shifted[at] / (shifted[at] - shifted[at + 1])
    crossings = time[at] + share * (time[at + 1] - time[at])
    return float(np.diff(crossings).mean())


def elliptic_k(k: float) -> float:
    """Complete elliptic integral of the first kind of the modulus k, by the arithmetic-geometric mean."""
    a, b = 1.0, math.sqrt(1.0 - k * k)
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return math.pi / (2 * a)
