"""The mean drift forces of `tests/validation/test_measured_drift.py`: on a ship's section across a flume.

    python -m tools.section_drift

By the momentum of the waves that run off (Longuet-Higgins 1977): of waves of amplitude a, thrown back by R a
and let through by T a in water of depth h,

    F = ¼ ρ g a² (1 + 2kh/sinh 2kh) (1 + |R|² − |T|²) per metre,

R and T of the section as it moves, by its mass, hull, springs and guides; what guides take of the waves is
missing in T. Where all is held |R|² + |T|² is 1 to 1 %, to 2 % in waves of 0.73 s.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt
from tools.section_in_flume import DENSITY, DEPTH, Flow, G, flow

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / "tests" / "support")]

from section_drift import FILE, RECORDED, SET_UPS  # noqa: E402
from ship_section import BREADTH, DRAFT, GUIDES, KG, LENGTH, MASS, ROLLS, SPRINGS, outline, wave_number  # noqa: E402

Array = npt.NDArray[np.float64]

#: Waves of the records, and such between them, closer together near natural periods [rad/s].
FREQUENCIES = np.unique(
    np.concatenate([RECORDED, np.arange(4.1, 4.8, 0.1), np.arange(4.8, 5.7, 0.05), np.arange(5.7, 10.0, 0.2)])
)
#: Of sway of the centre of gravity, heave and roll into motions about the middle of the waterline.
_ABOUT_WATERLINE = np.array([[1.0, 0.0, KG - DRAFT], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])


def drift(frequency: float, by: Flow, free: tuple[int, ...]) -> float:
    """Of waves of 1 m, of the whole section, where some of sway, heave and roll, 0 to 2, are free [N/m²]."""
    moves = np.zeros(3, dtype=np.complex128)
    if free:
        resists = -(frequency**2) * (_mass() + LENGTH * by.added) - 1j * frequency * LENGTH * by.damping
        about = _ABOUT_WATERLINE.T @ (resists + _stiffness()) @ _ABOUT_WATERLINE
        about += np.diag([SPRINGS - 1j * frequency * GUIDES, -1j * frequency * GUIDES, 0.0])
        pushed = _ABOUT_WATERLINE.T @ by.force * LENGTH
        moves[list(free)] = np.linalg.solve(about[np.ix_(free, free)], pushed[list(free)])
    velocity = -1j * frequency * (_ABOUT_WATERLINE @ moves)
    through, back = by.away[:, 3] + by.away[:, :3] @ velocity + [1.0, 0.0]
    kh = wave_number(frequency, DEPTH) * DEPTH
    of_depth = 1 + 2 * kh / np.sinh(2 * kh)
    return float(DENSITY * G * LENGTH / 4 * of_depth * (1 + abs(back) ** 2 - abs(through) ** 2))


def _mass() -> Array:
    """About the middle of the waterline."""
    high = KG - DRAFT
    return MASS * np.array([[1.0, 0.0, -high], [0.0, 1.0, 0.0], [-high, 0.0, ROLLS**2 + high**2]])


def _stiffness() -> Array:
    """Of the water, about the middle of the waterline: ρ g L B, and ρ g L (B³/12 + ∫z dA) − m g z of roll."""
    y, z = outline(0.001).T
    twice = y[:-1] * z[1:] - y[1:] * z[:-1]
    moment = -abs(((z[:-1] + z[1:]) @ twice) / 6)
    rolls = DENSITY * G * LENGTH * (BREADTH**3 / 12 + moment) - MASS * G * (KG - DRAFT)
    return np.diag([0.0, DENSITY * G * LENGTH * BREADTH, rolls])


def main() -> None:
    """Write all set-ups over all frequencies."""
    lines = [
        "# Mean force of waves on a section, over their amplitude squared [N/m^2], by tools/section_drift.py",
        ",".join(["frequency [rad/s]", *SET_UPS]),
    ]
    for frequency in FREQUENCIES:
        by = flow(float(frequency))
        forces = [drift(float(frequency), by, free) for free in SET_UPS.values()]
        lines.append(",".join([f"{frequency:.3f}", *(f"{force:.1f}" for force in forces)]))
    FILE.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
