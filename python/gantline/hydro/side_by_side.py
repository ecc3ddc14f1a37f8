"""Wave forces on bodies that float side by side, by the databases of one computation of them all.

A wave program gives the force of waves on each body while all of them are held fast, X_i, and what each makes
by moving, A_ij and B_ij on i by j. A neighbour that floats makes waves of its own, which in long waves undo
the lee of one that is held. With ξ_j the motions in a wave of frequency ω, time as exp(−iωt),

    Σ_j (S_ij + W_ij) ξ_j = X_i        S = −ω² M − iω D + C        W = −ω² A − iω B

with the inertia M, damping D and stiffness C of each body by itself, zero between two. A run has each body by
itself too, in a water of its own, W'_i, which may be that of a body that lies alone, of a fit, or of another
period. The force by the wave on i beside neighbours that float is therefore

    Y_i = X_i − Σ_j W_ij ξ_j + W'_i ξ_i

so that i by itself, S_i + W'_i, moves under Y_i as it does among them all. Where W'_i is W_ii, only what the
others do is left of the sum.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.hydro.database import AXES, ForcesAround, HydrodynamicDatabase
from gantline.hydro.database.around import cubics_around
from gantline.hydro.database.model import turn_about_z

__all__ = ["ELSEWHERE", "Elsewhere", "Neighbour", "asymmetries", "forces_side_by_side"]

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]


@dataclass(frozen=True)
class Elsewhere:
    """From where on two vessels are in other waves than those that their file has between them.

    Attributes:
        of_breadth: how far one is from its place beside the other, of the breadth of the narrower hull.
        askew: how far it is turned [rad].
    """

    of_breadth: float
    askew: float


#: Of a lift at its start, and of a run: waves between hulls are those of the gap between them.
ELSEWHERE = Elsewhere(of_breadth=0.25, askew=math.radians(5.0))


@dataclass(frozen=True, eq=False)
class Neighbour:
    """A body of a file of several, and what it is by itself; all but `database` and `middle` in its own axes.

    Attributes:
        database: of the file, with what the others do to it.
        heading: of its x axis in the file's axes [rad].
        middle: point from which its forces change least with the direction of waves, file axes (2,) [m].
        inertia: about the file's reference point for it (6, 6) [kg, kg m, kg m^2].
        damping: beside that of the waves that it makes, about there (6, 6) [N s/m, N s, N m s].
        stiffness: about there (6, 6) [N/m, N, N m].
        water: A' and B' that it has in a run, about there, by ω (n,) [rad/s]: (n, 6, 6) each.
    """

    database: HydrodynamicDatabase
    heading: float
    middle: Array
    inertia: Array
    damping: Array
    stiffness: Array
    water: Callable[[Array], tuple[Array, Array]]


def forces_side_by_side(
    bodies: Sequence[Neighbour], place: int, frequency: Array, density: float
) -> ForcesAround:
    """Y of one of them in its axes from all directions, per metre of amplitude, phases from its middle.

    Args:
        bodies: all of a file.
        place: of the one among them.
        frequency: ω of waves (n,) [rad/s].
        density: of the water [kg/m^3].

    Raises:
        DatabaseError: if the file has no wave forces.
    """
    own = bodies[place]
    number = own.database.wave_number(frequency)
    pushed: list[Complex] = []
    for body in bodies:
        around = body.database.excitation_around(frequency, density, body.middle)
        along = np.stack([np.cos(around.directions), np.sin(around.directions)])
        way = np.outer(number, (body.middle - own.middle) @ along)
        pushed.append(around.cubics[:, :, 0] * np.exp(1j * way)[:, :, np.newaxis])
    directions = own.database.excitation_around(frequency, density, own.middle).directions
    added, damping = _radiated(bodies, frequency, density)
    square, once = (frequency**2)[:, np.newaxis, np.newaxis], frequency[:, np.newaxis, np.newaxis]
    water = -square * added - 1j * once * damping
    turns = [turn_about_z(body.heading) for body in bodies]
    alone = [
        _along_diagonal([turn.T @ getattr(body, of) @ turn for turn, body in zip(turns, bodies, strict=True)])
        for of in ("inertia", "damping", "stiffness")
    ]
    whole = water - square * alone[0] - 1j * once * alone[1] + alone[2]
    forces = np.concatenate(pushed, axis=-1)
    moved = np.linalg.solve(whole[:, np.newaxis], forces[..., np.newaxis])[..., 0]
    rows = slice(6 * place, 6 * place + 6)
    left_out = water[:, rows].copy()
    in_run = [turns[place].T @ matrices @ turns[place] for matrices in own.water(frequency)]
    left_out[:, :, rows] -= -square * in_run[0] - 1j * once * in_run[1]
    found = pushed[place] - np.einsum("nab,nkb->nka", left_out, moved)
    seen = (directions - own.heading) % math.tau
    order = np.argsort(seen)
    return ForcesAround(seen[order], cubics_around(seen[order], (found @ turns[place].T)[:, order]))


def asymmetries(one: HydrodynamicDatabase, other: HydrodynamicDatabase) -> tuple[float, str]:
    """How far what one does to the other is from what the other does to it, the same by nature.

    Returns:
        the largest difference at any frequency, of the roots of both diagonals where these are largest; where
        it is, in words.
    """
    worst, said = 0.0, ""
    there, back = one.others[other.name], other.others[one.name]
    kinds = (("added mass", "added_mass"), ("damping", "damping"))
    for (what, key), to, fro in zip(kinds, there, back, strict=True):
        scales = [_scales(getattr(database, key)) for database in (one, other)]
        apart = np.abs(to - fro.transpose(0, 2, 1)) / np.outer(*scales)
        k, i, j = (int(part) for part in np.unravel_index(np.argmax(apart), apart.shape))
        if apart[k, i, j] > worst:
            worst = float(apart[k, i, j])
            pair = f"of {one.name}'s {AXES[i]} and {other.name}'s {AXES[j]}"
            said = f"{what} {pair} at {one.periods[k]:.4g} s"
    return worst, said


def _scales(matrices: Array) -> Array:
    """Roots of the largest diagonal terms of shifts and of turns at any frequency (6,)."""
    largest = np.abs(np.diagonal(matrices, axis1=1, axis2=2)).max(axis=0)
    kinds = np.maximum([largest[:3].max(), largest[3:].max()], 1e-300)
    scales: Array = np.sqrt(np.repeat(kinds, 3))
    return scales


def _radiated(bodies: Sequence[Neighbour], frequency: Array, density: float) -> tuple[Array, Array]:
    """A and B of all bodies at frequencies (n, 6 bodies, 6 bodies), symmetric; as the file's at its ends."""
    from scipy.interpolate import CubicSpline  # takes a second to load

    known = bodies[0].database.frequencies
    wanted = np.clip(frequency, known[0], known[-1])
    found = []
    for key in ("added_mass", "damping"):
        rows = [
            np.concatenate(
                [
                    getattr(row.database if row is column else row.database.others[column.database.name], key)
                    for column in bodies
                ],
                axis=-1,
            )
            for row in bodies
        ]
        table = np.concatenate(rows, axis=-2)
        own = bodies[0].database.density
        table = (table + table.transpose(0, 2, 1)) / 2 * (1.0 if own is None else density / own)
        found.append(
            CubicSpline(known, table)(wanted) if len(known) > 1 else np.repeat(table, len(wanted), 0)
        )
    return found[0], found[1]


def _along_diagonal(matrices: Sequence[Array]) -> Array:
    whole = np.zeros((6 * len(matrices), 6 * len(matrices)))
    for k, matrix in enumerate(matrices):
        whole[6 * k : 6 * k + 6, 6 * k : 6 * k + 6] = matrix
    return whole
