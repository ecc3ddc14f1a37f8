"""Lift files written anew: in other units, or at another scale."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from fractions import Fraction

from gantline.units import DIMENSIONS

#: Powers of the scale of length by which quantities grow where gravity and densities stay (Froude).
POWERS = {
    "length": Fraction(1),
    "mass": Fraction(3),
    "time": Fraction(1, 2),
    "force": Fraction(3),
    "power": Fraction(7, 2),
    "angle": Fraction(0),
    "speed": Fraction(1, 2),
    "angular_speed": Fraction(-1, 2),
    "acceleration": Fraction(0),
    "angular_acceleration": Fraction(-1),
    "mass_flow": Fraction(5, 2),
    "stiffness": Fraction(2),
    "damping": Fraction(5, 2),
    "torque": Fraction(4),
    "rotational_stiffness": Fraction(4),
    "rotational_damping": Fraction(9, 2),
    "inertia": Fraction(5),
    "area": Fraction(2),
    "volume": Fraction(3),
    "mass_moment": Fraction(4),
    "coupled_damping": Fraction(7, 2),
    "mass_per_length": Fraction(2),
    "density": Fraction(0),
    "stress": Fraction(1),
    "ratio": Fraction(0),
}

#: What grows with the masses of a lift where all else stays: whatever has a force or a mass in it.
WEIGHED = frozenset(
    {
        *("mass", "force", "power", "mass_flow", "stiffness", "damping", "torque", "rotational_stiffness"),
        *("rotational_damping", "inertia", "mass_moment", "coupled_damping", "mass_per_length", "density"),
        "stress",
    }
)

_UNITS = {
    unit: dimension for dimension, units in DIMENSIONS.items() for unit in units if unit not in ("", "%")
}
_QUANTITY = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?)\s+([A-Za-z][A-Za-z^0-9/ ]*?)(?=\s*[,\]}\n#\"])")


def rewritten(text: str, write: Callable[[float, str, str], str]) -> str:
    """A lift file with every quantity written by `write`, of its number, its unit and its dimension."""

    def anew(found: re.Match[str]) -> str:
        unit = found[2].strip()
        return write(float(found[1]), unit, _UNITS[unit]) if unit in _UNITS else found[0]

    return _QUANTITY.sub(anew, text)


def in_other_units(text: str, seed: int) -> str:
    """The same lift, each quantity in a unit of its dimension that is drawn by lot."""
    draw = random.Random(seed)

    def write(number: float, unit: str, dimension: str) -> str:
        units = DIMENSIONS[dimension]
        other = draw.choice(list(units))
        return f"{number * units[unit] / units[other]!r} {other}"

    return rewritten(text, write)


def at_scale(text: str, scale: float) -> str:
    """The same lift so many times as large, by Froude's law: gravity and densities stay."""

    def write(number: float, unit: str, dimension: str) -> str:
        return f"{number * scale ** float(POWERS[dimension])!r} {unit}"

    return rewritten(text, write)


def at_weight(text: str, factor: float) -> str:
    """The same lift so many times as heavy, as strong and as stiff: lengths and times stay."""

    def write(number: float, unit: str, dimension: str) -> str:
        return f"{number * (factor if dimension in WEIGHED else 1.0)!r} {unit}"

    return rewritten(text, write)
