"""A database of two barges side by side, made up, and lifts with both in waves."""

from __future__ import annotations

import json
import math
import pickle
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import xarray as xr

import databases
import waves
from afloat import DRAFT, LENGTH, barge
from floating import SEA

#: Bodies of the file, and their reference points in its axes [m].
BODIES = ("left", "right")
REFERENCES = np.array([[12.0, -7.0, 0.0], [17.0, 33.0, 0.0]])
DIRECTIONS = np.radians(np.arange(0.0, 360.0, 30.0))
#: What shelters and reflects, made up: forces are so many times those of Froude and Krylov.
SHELTER = (0.7 + 0.2j, 1.2 - 0.3j)
#: How forces on the left go with motions of the right, over the roots of both diagonals.
_PATTERN = 0.05 * np.array(
    [
        [2.0, -1.0, 0.5, 0.3, 0.4, -1.0],
        [0.7, 3.0, -2.0, 1.0, 0.2, 0.5],
        [0.1, 2.0, 3.0, -1.0, 0.6, 0.0],
        [0.3, -1.0, 1.0, 2.0, 0.1, 0.4],
        [-0.4, 0.2, 0.5, 0.3, 2.0, 0.6],
        [1.0, -0.5, 0.2, 0.4, -0.7, 1.5],
    ]
)


def turn(heading: float) -> Any:
    """Of surge to yaw along the file's axes into those along axes of this heading [rad] (6, 6)."""
    cos, sin = math.cos(heading), math.sin(heading)
    one = np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return np.kron(np.eye(2), one)


def radiation(headings: tuple[float, float] = (0.0, 0.0), water: waves.Water = waves.radiated) -> Any:
    """Added mass and damping of both over `waves.FREQUENCIES`, along the file's axes (n, 12, 12) each."""
    frequency = waves.FREQUENCIES
    own = water(frequency)
    found = []
    for k, (values, shape) in enumerate(zip(own, (np.cos, np.sin), strict=True)):
        whole = np.zeros((len(frequency), 12, 12))
        scale = np.sqrt(np.diag((waves.ADDED, waves.DAMPING)[k]))
        between = _PATTERN * np.outer(scale, scale) * shape(1.3 * frequency)[:, None, None]
        whole[:, :6, :6] = turn(headings[0]).T @ values @ turn(headings[0])
        whole[:, 6:, 6:] = turn(headings[1]).T @ values @ turn(headings[1])
        whole[:, :6, 6:], whole[:, 6:, :6] = between, between.transpose(0, 2, 1)
        found.append(whole)
    return found


@cache
def excitation(frequency: float, direction: float, headings: tuple[float, float] = (0.0, 0.0)) -> Any:
    """Of both held fast, along the file's axes, phases from its origin (12,) [N/m, N]."""
    number = frequency**2 / waves.G
    parts = []
    for shelter, heading, place in zip(SHELTER, headings, REFERENCES, strict=True):
        way = number * (place[0] * math.cos(direction) + place[1] * math.sin(direction))
        own = waves.force_per_metre(frequency, direction - heading)
        parts.append(shelter * np.exp(1j * way) * (turn(heading).T @ own))
    return np.concatenate(parts)


def database(
    path: Path,
    headings: tuple[float, float] = (0.0, 0.0),
    water: waves.Water = waves.radiated,
    directions: Any = DIRECTIONS,
    **changes: Any,
) -> Path:
    """The file of both as Capytaine 3 writes it.

    Args:
        path: Where to.
        headings: Of both hulls in its axes [rad].
        water: Of each by itself.
        directions: Of its waves [rad].
        changes: `tables` and `coordinates` that differ, names `without`.
    """
    of_waves = [[excitation(w, b, headings) for b in directions] for w in waves.FREQUENCIES]
    held = (radiation(headings, water), np.array(of_waves), directions, changes)
    path.write_bytes(_database(pickle.dumps(held)))
    return path


@cache
def _database(pickled: bytes) -> bytes:
    """What it holds as the bytes of the file, which tests ask for again and again."""
    (added, damping), of_waves, directions, changes = pickle.loads(pickled)
    names = [f"{body}__{axis}" for body in BODIES for axis in databases.AXES]
    order = np.argsort(names)
    parts = np.stack([of_waves.real, of_waves.imag])[..., order]
    over = ("omega", "influenced_dof", "radiating_dof")
    over_waves = ("complex", "omega", "wave_direction", "influenced_dof")
    tables: dict[str, Any] = {
        "added_mass": (over, added[:, order][:, :, order]),
        "radiation_damping": (over, damping[:, order][:, :, order]),
        "Froude_Krylov_force": (over_waves, 0.25 * parts),
        "diffraction_force": (over_waves, 0.75 * parts),
    }
    listed = [names[k] for k in order]
    coordinates: dict[str, Any] = {
        "omega": waves.FREQUENCIES,
        "influenced_dof": listed,
        "radiating_dof": listed,
        "wave_direction": directions,
        "complex": ["re", "im"],
        "body": list(BODIES),
        "rotation_center": (("body", "space_coordinate"), REFERENCES),
        "rho": SEA,
        "g": waves.G,
        "water_depth": np.inf,
    }
    tables |= changes.get("tables", {})
    coordinates |= changes.get("coordinates", {})
    for name in changes.get("without", ()):
        coordinates.pop(name)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "of_both.nc"
        xr.Dataset(tables, coordinates).to_netcdf(path, engine="h5netcdf")
        return path.read_bytes()


def in_waves(
    folder: Path,
    swell: dict[str, Any],
    headings: tuple[float, float] = (0.0, 0.0),
    bearing: float = 0.0,
    origin: tuple[float, float] = (0.0, 0.0),
    **changes: Any,
) -> Path:
    """The lift file of both as the file of `database` has them, in a water that remembers.

    Args:
        folder: Where to; `two.nc` is there.
        swell: The waves.
        headings: Of both hulls in the axes of the file [rad].
        bearing: Of the file's x axis in the world [rad].
        origin: Where its origin is in the world [m].
        changes: Of the lift; `left` and `right` of both vessels, `water` in place of `radiation`.
    """
    along = turn(bearing)[:2, :2].T
    vessels = {}
    water = changes.pop("water", None)
    for body, heading, place in zip(BODIES, headings, REFERENCES, strict=True):
        world = bearing + heading
        stern = np.array(origin) + along @ place[:2] - turn(world)[:2, :2].T @ [LENGTH / 2, 0.0]
        by_file = {
            "database": "two.nc",
            "body": body,
            "at": [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"],
            "heading_in_file": f"{math.degrees(heading)!r} deg",
        }
        vessels[body] = barge(
            position=[f"{float(part)!r} m" for part in stern],
            heading=f"{math.degrees(world)!r} deg",
            radii_of_gyration=[f"{radius} m" for radius in waves.RADII],
            wave_forces=by_file,
            **(water(by_file) if water else {"radiation": by_file}),
        )
        given = {key: value for key, value in changes.pop(body, {}).items()}
        vessels[body] = {key: value for key, value in {**vessels[body], **given}.items() if value is not None}
    lift = {
        "format": 1,
        "lift": {"title": "Two barges"},
        "duration": "1 s",
        "start": "as_given",
        "waves": {"swell": swell},
        "vessels": vessels,
        **changes,
    }
    path = folder / "lift.yaml"
    path.write_text(json.dumps(lift), encoding="utf-8")
    return path


def response(
    frequency: float, direction: float, headings: tuple[float, float] = (0.0, 0.0), damping_on_top: Any = 0.0
) -> Any:
    """Motions of both per metre among each other, along their own axes, phases from the file's origin (12,).

    (−ω²(M + A) − iω(B + D) + C)⁻¹ X of all twelve, M, D and C of each, A and B of the file.

    Args:
        frequency: ω [rad/s].
        direction: That waves run in, in the axes of the file [rad].
        headings: Of both hulls in these [rad].
        damping_on_top: D, of either about its reference point along its own axes (6, 6).
    """
    place = int(np.argmin(np.abs(waves.FREQUENCIES - frequency)))
    added, damping = (values[place] for values in radiation(headings))
    whole = -(frequency**2) * added - 1j * frequency * damping
    nothing = np.zeros((6, 6))
    own_damping = nothing + damping_on_top
    turns = [turn(heading) for heading in headings]
    for k, own in enumerate(turns):
        rows = slice(6 * k, 6 * k + 6)
        whole[rows, rows] += own.T @ waves.impedance(frequency, nothing, own_damping) @ own
    moved = np.linalg.solve(whole, excitation(frequency, direction, headings))
    return np.concatenate([own @ moved[6 * k : 6 * k + 6] for k, own in enumerate(turns)])
