"""A lift linearised about an equilibrium, for who goes on with its matrices."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LinearModel:
    """Small motions about an equilibrium: M ẍ + D ẋ + K x = f with H x = 0, δT = P x + R ẋ (n coordinates).

    x are increments of the degrees of freedom that no drive moves [m, rad]: of a free body three along the
    axes of its joint and three turns about its own axes, of which a path of small angles is the sum. f are
    forces and moments along them; a force F at a body's centre of gravity and a moment N, world axes, are
    f = Jᵀ (F, N) with the body's J of `body_motion`.

    Attributes:
        coordinates: Names of x: a hinge, slider, flow or drum by its name, else body and axis, such as
            `block.z`, and `block.rz` for a turn.
        mass: M, shape (n, n) [kg, kg m, kg m^2]; with the added mass of the water.
        damping: D, shape (n, n) [N s/m, N s, N m s]: of joints, ropes, contacts, water and wind.
        stiffness: K, shape (n, n) [N/m, N, N m]: of gravity, water, tensions and what stretches. Both are
            symmetric but for what wind and current push with.
        held: H, a row for each inextensible rope, pin or brake that holds, shape (m, n).
        bodies: Names of the bodies.
        body_motion: J of each body, shape (body, 6, n): velocity of its centre of gravity and angular
            velocity, world axes, per unit of each ẋ.
        ropes: Names of the ropes, mooring lines too.
        tension: P, shape (rope, n) [N/m, N]; NaN of a rope that H holds, zero of a slack one.
        tension_rate: R, shape (rope, n) [N s/m, N s].
    """

    coordinates: tuple[str, ...]
    mass: Floats
    damping: Floats
    stiffness: Floats
    held: Floats
    bodies: tuple[str, ...]
    body_motion: Floats
    ropes: tuple[str, ...]
    tension: Floats
    tension_rate: Floats

    def __repr__(self) -> str:
        held = f", {len(self.held)} held" if len(self.held) else ""
        return f"<LinearModel: {len(self.coordinates)} coordinates{held}, {len(self.ropes)} ropes>"


def linear_model(found: Mapping[str, Any], names: Mapping[str, Sequence[str]]) -> LinearModel:
    """What the core has found, with the names of bodies and ropes."""
    return LinearModel(
        coordinates=tuple(found["coordinates"]),
        mass=found["mass"],
        damping=found["damping"],
        stiffness=found["stiffness"],
        held=found["held"],
        bodies=tuple(names["body"]),
        body_motion=np.ascontiguousarray(found["body_motion"].transpose(1, 2, 0)),
        ropes=tuple(names["rope"]),
        tension=found["rope_tension"],
        tension_rate=found["rope_tension_rate"],
    )
