"""What a file of plain geometry does not say, and is taken for granted instead."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from gantline.arguments import number
from gantline.cad.errors import CadError
from gantline.units import DIMENSIONS

__all__ = ["DENSITIES", "STAND_UP", "STEEL", "Assumptions"]

#: Density of shipbuilding steel [kg/m^3].
STEEL = 7850.0
#: Densities of materials [kg/m^3].
DENSITIES = (100.0, 25_000.0)
#: Turns what has y up, so that it has z up.
STAND_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
#: A lifted thing is smaller than this [m]; a file with larger numbers is in millimetres.
_LARGEST = 1000.0


@dataclass(frozen=True)
class Assumptions:
    """What to take where a file says nothing.

    Attributes:
        unit: unit of length, such as ``mm``; None to guess it from the size. It overrides what the file says.
        density: of solids and plates whose file names none [kg/m^3].
        thickness: of open surfaces [m]; None leaves them without weight.
        up: axis of the file that points up; None for the format's own: y in glTF, z in all others.
    """

    unit: str | None = None
    density: float = STEEL
    thickness: float | None = None
    up: Literal["y", "z"] | None = None

    def __post_init__(self) -> None:
        lengths = DIMENSIONS["length"]
        if self.unit is not None and self.unit not in tuple(lengths):
            raise CadError(f"'{self.unit}' is no unit of length that is known here: {', '.join(lengths)}")
        if not 0 < number(self.density, "density", "kilograms per cubic metre") < 1e5:
            raise CadError(f"a density of {self.density:g} kg/m^3 is not that of a material; steel has 7850")
        if self.thickness is not None and not 0 < number(self.thickness, "thickness", "metres") < 10:
            raise CadError(f"a plate thickness of {self.thickness:g} m is not possible; 10 mm is 0.01")

    def scale(self, size: float) -> tuple[float, str, str | None]:
        """Metres per unit of a file that names none, whose geometry has a diagonal of `size` units.

        Returns:
            the factor; the unit and how it is known; a doubt, or None.
        """
        if self.unit is not None:
            return DIMENSIONS["length"][self.unit], f"{self.unit}, as asked for", None
        unit = "m" if size < _LARGEST else "mm"
        factor = DIMENSIONS["length"][unit]
        why = f"with it the whole is {size * factor:.3g} m from corner to corner"
        return factor, f"{unit}, guessed", f"the file names no unit of length; {unit} is guessed, since {why}"
