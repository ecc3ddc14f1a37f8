"""The database of `tests/validation/test_measured_section.py`: a ship's section across a wave flume.

    python -m tools.section_in_flume

Potential flow about a box with round bilges that lies across a flume, in the plane along it: what the section
does to the water by swaying, heaving and rolling, and waves to it. By boundary elements of ln r and its image
in the bottom, with constant potential and flow on each, over section, water surface and two sides where waves
run off. Damping and forces of waves agree with Haskind's |X|² / (2 ρ g c), c the speed of their groups, to
0.2 % in waves of 0.9 s and longer, to 2 % at 0.63 s.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.hydro import HydrodynamicDatabase, write_database

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / "tests" / "support")]

from ship_section import BREADTH, FILE, LENGTH, outline, wave_number  # noqa: E402

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]

#: Of the flume [m].
DEPTH = 1.0
DENSITY, G = 1000.0, 9.81
FREQUENCIES = np.concatenate(
    [[0.7, 1.0], np.arange(1.5, 4.0, 0.5), np.arange(4.0, 10.1, 0.25), np.arange(10.5, 14.1, 0.5)]
)
#: Size of elements on the section [m], and on the water: from there on larger by this factor, to that share
#: of a wave; how many waves, or depths, the sides are away.
_ELEMENT, _LARGER, _OF_A_WAVE, _AWAY = 0.006, 1.04, 1 / 45, 3.0


@dataclass(frozen=True)
class Flow:
    """What a section does at a frequency, per metre of it, about the middle of its waterline.

    Attributes:
        added: A of sway, heave and roll (3, 3) [kg/m, kg, kg m].
        damping: B (3, 3).
        force: X of waves of 1 m towards +y, time as exp(−iωt) (3,) [N/m², N/m].
        away: Waves that run off towards +y and −y, as they would be at y = 0, by motions of 1 m/s, and those
            that the section throws of waves of 1 m (2, 4) [s, s, m s, 1].
    """

    added: Array
    damping: Array
    force: Complex
    away: Complex


def flow(frequency: float) -> Flow:
    """Of the section at a frequency [rad/s]."""
    k = wave_number(frequency, DEPTH)
    section = outline(_ELEMENT)
    water = _water_surface(2 * np.pi / k)
    far = water[-1]
    wall = np.linspace(-DEPTH, 0.0, 31)
    # Once around the water, its inside to the left.
    pieces = [
        np.stack([np.full(len(wall), far), wall], axis=1),
        np.stack([water[::-1], np.zeros(len(water))], axis=1),
        section,
        np.stack([-water, np.zeros(len(water))], axis=1),
        np.stack([np.full(len(wall), -far), wall[::-1]], axis=1),
    ]
    begin, end = np.vstack([one[:-1] for one in pieces]), np.vstack([one[1:] for one in pieces])
    kind = np.repeat(np.arange(len(pieces)), [len(one) - 1 for one in pieces])
    middle, length = (begin + end) / 2, np.linalg.norm(end - begin, axis=1)
    outward = np.stack([end[:, 1] - begin[:, 1], begin[:, 0] - end[:, 0]], axis=1) / length[:, np.newaxis]
    single, double = _influence(middle, begin, end)
    # The image in the bottom lets no water through there.
    image = middle * [1.0, -1.0] - [0.0, 2 * DEPTH]
    single, double = (
        one + other for one, other in zip((single, double), _influence(image, begin, end), strict=True)
    )
    # Green's third identity, π φ = Σ (φ ∂G/∂n − G ∂φ/∂n), with ∂φ/∂n = (ω²/g) φ on the water and ikφ at its
    # sides.
    of_potential = np.select([kind == 2, kind % 2 == 1], [0.0, frequency**2 / G], 1j * k)
    on_it = kind == 2
    place, normal = middle[on_it], outward[on_it]
    motions = np.stack([normal[:, 0], normal[:, 1], place[:, 0] * normal[:, 1] - place[:, 1] * normal[:, 0]])
    # Waves of 1 m that no section disturbs: φ = −i (g/ω) cosh k(z + h)/cosh kh exp(iky).
    deep = np.exp(1j * k * place[:, 0]) / np.cosh(k * DEPTH) * -1j * G / frequency
    over = k * (place[:, 1] + DEPTH)
    of_waves = deep * np.cosh(over)
    through = k * deep * (1j * np.cosh(over) * normal[:, 0] + np.sinh(over) * normal[:, 1])
    known = np.column_stack([motions.T, -through])
    matrix = np.pi * np.eye(len(middle)) - double + single * of_potential
    everywhere = np.linalg.solve(matrix, -single[:, on_it] @ known)
    potential = everywhere[on_it]
    # Pressure iωρφ pushes along the normal, which points into the section.
    pushed = 1j * frequency * DENSITY * (motions * length[on_it])
    by_motions = pushed @ potential[:, :3]
    # Of a wave, φ = −i (g/ω) η cosh k(z + h)/cosh kh at the sides.
    away = []
    for side in (kind == 0, kind == 4):
        shape = np.cosh(k * (middle[side, 1] + DEPTH))
        share = (shape * length[side]) @ everywhere[side] / (shape**2 @ length[side])
        away.append(share * np.cosh(k * DEPTH) * 1j * frequency / G * np.exp(-1j * k * far))
    force = pushed @ (potential[:, 3] + of_waves)
    return Flow(by_motions.imag / frequency, -by_motions.real, force, np.array(away))


def _water_surface(wave: float) -> Array:
    """Ends of elements on the water beside the section, from its side outwards (n,) [m]."""
    ends, size = [BREADTH / 2], _ELEMENT
    while ends[-1] < BREADTH / 2 + _AWAY * max(wave, DEPTH):
        ends.append(ends[-1] + size)
        size = min(size * _LARGER, wave * _OF_A_WAVE)
    return np.array(ends)


def _influence(points: Array, begin: Array, end: Array) -> tuple[Array, Array]:
    """Of ln r and of its derivative along the outward normal, over elements, by points (n, elements)."""
    along = end - begin
    length = np.linalg.norm(along, axis=1)
    along = along / length[:, np.newaxis]
    away = points[:, np.newaxis] - begin
    x = np.einsum("nej,ej->ne", away, along)
    y = away[..., 0] * along[:, 1] - away[..., 1] * along[:, 0]
    aside = np.abs(y)

    def to(u: Array) -> Array:
        square: Array = np.maximum(u * u + y * y, 1e-300)
        part: Array = u * np.log(square) / 2 - u + aside * np.arctan2(u, np.maximum(aside, 1e-300))
        return part

    angle = np.arctan2(length - x, aside) + np.arctan2(x, aside)
    return to(length - x) + to(x), np.where(aside < 1e-12, 0.0, -np.sign(y) * angle)


def database() -> HydrodynamicDatabase:
    """Of the whole section, from one wall of the flume to the other; waves from both ends."""
    flows = [flow(float(frequency)) for frequency in FREQUENCIES]
    plane = np.ix_([1, 2, 3], [1, 2, 3])
    added, damping = np.zeros((2, len(flows), 6, 6))
    forces = np.zeros((len(flows), 2, 6), dtype=np.complex128)
    for k, one in enumerate(flows):
        added[k][plane], damping[k][plane] = (LENGTH * (m + m.T) / 2 for m in (one.added, one.damping))
        towards = LENGTH * one.force
        forces[k, 0, 1:4] = towards
        forces[k, 1, 1:4] = towards * [-1.0, 1.0, -1.0]
    return HydrodynamicDatabase(
        "section",
        "section_in_flume.nc",
        FREQUENCIES,
        added,
        damping,
        DENSITY,
        reference=np.zeros(3),
        water_depth=DEPTH,
        directions=np.radians([90.0, 270.0]),
        excitation=forces,
    )


if __name__ == "__main__":
    write_database(database(), FILE)
