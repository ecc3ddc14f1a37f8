"""A chain whose masses differ by a million, on which a long step shows what geometric stiffness is for.

From the world down: a mass of 1,000,000 kg, four of 1 kg, and one of 1,000,000 kg, on six ropes of 5 m with
EA = 1e10 N. The light masses start 1 µm to alternate sides; the tension beside them is the weight of the
lower heavy mass.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from mechanics import Floats, G, Json, body, document, end, finished, point, rope, simulation

HEAVY, LIGHT, NODES = 1e6, 1.0, 4  # kg
EA, LENGTH = 1e10, 5.0  # N, m
STEP = 0.1  # s
DISTURBANCE = 1e-6  # m
MASSES = (HEAVY, *[LIGHT] * NODES, HEAVY)


def chain() -> Json:
    """The chain in balance but for the disturbance."""
    bodies: list[Json] = []
    ropes: list[Json] = []
    z, above = 0.0, None
    for k, mass in enumerate(MASSES):
        z -= LENGTH * (1 + sum(MASSES[k:]) * G / EA)
        x = DISTURBANCE * (-1) ** k if mass == LIGHT else 0.0
        name = f"mass{k}"
        bodies.append(body(name, point((x, 0, z)), mass))
        ropes.append(rope(f"rope{k}", LENGTH, [end(above), end(name)], EA))
        above = name
    return document(bodies, ropes=ropes)


@dataclass(frozen=True)
class Shake:
    """Every step: sideways positions and heights (time, mass) [m], tension of the middle rope [N]."""

    time: Floats
    sideways: Floats
    height: Floats
    tension: Floats

    @property
    def largest(self) -> Floats:
        """Largest sideways displacement at every time [m]."""
        found: Floats = np.abs(self.sideways).max(axis=1)
        return found


def shake(duration: float, *, geometric_stiffness: bool) -> Shake:
    """The chain by `del` at h = 0.1 s."""
    run = simulation(chain(), duration, step=STEP, geometric_stiffness=geometric_stiffness)
    status = run.run()
    assert status["status"] == "done", status
    result = finished(run, status)
    positions = np.stack([result.body(f"mass{k}") for k in range(len(MASSES))], axis=1)
    return Shake(result.time, positions[:, :, 0], positions[:, :, 2], result.tension("rope3"))
