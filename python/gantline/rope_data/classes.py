"""What a rope of a class and a diameter weighs, stretches and holds.

The factors stand with their sources in `en12385_4.csv` beside this file. A class is called by its strands and
its core, `6x36 IWRC`; the designation of one of its constructions by EN 12385-2, `6x36WS-IWRC`, means the
same class, for EN 12385-4 gives factors by class. FC is a core of fibre; IWRC (a rope of its own), WSC (a
strand) and `steel core` are cores of steel.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Final

from gantline.units import quantity

__all__ = ["GRADES", "RopeClass", "rope_class", "rope_classes"]

#: Rope grades of EN 12385-4 that lift files may name [N/mm^2], as written there.
GRADES: Final = ("1770", "1960", "2160")

_FILE: Final = Path(__file__).with_name("en12385_4.csv")


@dataclass(frozen=True)
class RopeClass:
    """A class of ropes that share their factors; d is the nominal diameter.

    Attributes:
        name: strands and core, such as `6x36 IWRC`.
        mass_factor: W of EN 12385-4 [kg/(100 m mm^2)]: mass of 100 m = W d^2.
        area_factor: C of EN 12385-4 [1]: metallic area = C d^2.
        breaking_force_factor: K of EN 12385-4 [1]: minimum breaking force = K d^2 R, R the rope grade.
        modulus: Axial modulus over the metallic area, of a rope in use [Pa]; EN 1993-1-11:2006, table 3.1.
        designations: Constructions of the class with their core, such as `6x36WS-IWRC`.
        factors_from: Sources of the factors: A Feyrer, B Vornbaeumen, as the head of the data file tells.
    """

    name: str
    mass_factor: float
    area_factor: float
    breaking_force_factor: float
    modulus: float
    designations: tuple[str, ...]
    factors_from: str

    def mass_per_length(self, diameter: float) -> float:
        """Nominal mass per length [kg/m], grease and core included, of a diameter [m]; EN 12385-4."""
        return self.mass_factor / 100 * (diameter / 1e-3) ** 2

    def metallic_area(self, diameter: float) -> float:
        """Nominal metallic area [m^2] of a diameter [m]; EN 12385-4."""
        return self.area_factor * diameter**2

    def minimum_breaking_force(self, diameter: float, grade: float) -> float:
        """Minimum breaking force [N] of a diameter [m] in a rope grade [Pa]; EN 12385-4."""
        return self.breaking_force_factor * diameter**2 * grade

    def axial_stiffness(self, diameter: float, modulus: float | None = None) -> float:
        """Axial stiffness EA [N] of a diameter [m] with a modulus [Pa], that of the class if None."""
        return (self.modulus if modulus is None else modulus) * self.metallic_area(diameter)


@cache
def rope_classes() -> Mapping[str, RopeClass]:
    """All classes by name, in the order of the data file."""
    with _FILE.open(encoding="utf-8", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        classes = [_read(row) for row in rows]
    return MappingProxyType({one.name: one for one in classes})


def rope_class(name: str) -> RopeClass:
    """The class of a name such as `6x36 IWRC`, or of a designation such as `6x36WS-IWRC`.

    Raises:
        KeyError: If there is no such class or designation.
    """
    known = _by_any_name()
    if str(name) not in known:
        raise KeyError(f"no class of ropes is {name!r}; there are {', '.join(rope_classes())}")
    return known[str(name)]


@cache
def _by_any_name() -> Mapping[str, RopeClass]:
    classes = rope_classes()
    return {**{word: one for one in classes.values() for word in one.designations}, **classes}


def _read(row: Mapping[str, str]) -> RopeClass:
    core = row["core"]
    return RopeClass(
        name=f"{row['rope_class']} {core}",
        mass_factor=float(row["mass_factor"]),
        area_factor=float(row["area_factor"]),
        breaking_force_factor=float(row["breaking_force_factor"]),
        modulus=quantity(f"{row['modulus']} kN/mm^2", "stress"),
        designations=tuple(f"{construction}-{core}" for construction in row["constructions"].split()),
        factors_from=row["factors_from"],
    )
