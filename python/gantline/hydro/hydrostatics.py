"""Hydrostatics of a hull in one attitude."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.arguments import number
from gantline.hydro.attitude import Attitude, attitude_of
from gantline.hydro.hull import Hull, hull_of

__all__ = ["SEA_WATER", "Hydrostatics", "hydrostatics"]

Array = npt.NDArray[np.float64]

#: Density of sea water [kg/m^3].
SEA_WATER = 1025.0


@dataclass(frozen=True)
class Hydrostatics:
    """What a hull displaces in one attitude, in vessel axes.

    Attributes:
        attitude: draft, heel and trim.
        density: of the water [kg/m^3].
        volume: displaced [m^3].
        centre_of_buoyancy: (3,) [m].
        waterplane_area: [m^2].
        centre_of_flotation: of the waterplane (3,) [m].
        second_transverse: second moment of the waterplane about its own axis along the vessel [m^4].
        second_longitudinal: about its own axis across the vessel [m^4].
        wetted_surface: [m^2].
        waterline_size: length and breadth of the waterplane, along and across the vessel (2,) [m].
        unbalanced: sideways rest of the pressure on the skin, as a share of buoyancy; zero where closed.
    """

    attitude: Attitude
    density: float
    volume: float
    centre_of_buoyancy: Array
    waterplane_area: float
    centre_of_flotation: Array
    second_transverse: float
    second_longitudinal: float
    wetted_surface: float
    waterline_size: Array
    unbalanced: float

    @property
    def mass(self) -> float:
        """Displacement [kg]."""
        return self.density * self.volume

    @property
    def kb(self) -> float:
        """Centre of buoyancy above the keel's z = 0, along the vessel's z [m]."""
        return float(self.centre_of_buoyancy[2])

    @property
    def lcb(self) -> float:
        """X of the centre of buoyancy [m]."""
        return float(self.centre_of_buoyancy[0])

    @property
    def lcf(self) -> float:
        """X of the centre of flotation [m]."""
        return float(self.centre_of_flotation[0])

    @property
    def bm_transverse(self) -> float:
        """From the centre of buoyancy to the metacentre for heel [m]."""
        return self.second_transverse / self.volume if self.volume > 0 else math.nan

    @property
    def bm_longitudinal(self) -> float:
        """From the centre of buoyancy to the metacentre for trim [m]."""
        return self.second_longitudinal / self.volume if self.volume > 0 else math.nan

    @property
    def km_transverse(self) -> float:
        """Metacentre for heel above the keel's z = 0, along the vessel's z [m]."""
        return self.kb + self.bm_transverse * float(self.attitude.normal[2])

    @property
    def km_longitudinal(self) -> float:
        """Metacentre for trim above the keel's z = 0, along the vessel's z [m]."""
        return self.kb + self.bm_longitudinal * float(self.attitude.normal[2])

    @property
    def per_metre(self) -> float:
        """Mass that sinks it by a metre [kg/m]."""
        return self.density * self.waterplane_area

    def gm(
        self, centre_of_gravity: npt.ArrayLike, correction: tuple[float, float] = (0.0, 0.0)
    ) -> tuple[float, float]:
        """Metacentric heights for heel and trim [m], less free-surface corrections [m]."""
        below = self.centre_of_buoyancy - np.asarray(centre_of_gravity, dtype=float)
        lever = float(self.attitude.normal @ below)
        return self.bm_transverse + lever - correction[0], self.bm_longitudinal + lever - correction[1]

    def centre_of_gravity_at(self, height: float) -> Array:
        """Where the centre of gravity is plumb over that of buoyancy, so that it floats as it lies (3,) [m].

        Args:
            height: of the centre of gravity above z = 0, along the vessel's z [m].
        """
        normal = self.attitude.normal
        place: Array = self.centre_of_buoyancy + normal * (height - self.kb) / normal[2]
        return place

    def as_dict(self) -> dict[str, Any]:
        """All figures by name, in SI units, for JSON."""
        return {
            "draft": self.attitude.draft,
            "heel": self.attitude.heel,
            "trim": self.attitude.trim,
            "volume": self.volume,
            "displacement": self.mass,
            "lcb": self.lcb,
            "tcb": float(self.centre_of_buoyancy[1]),
            "kb": self.kb,
            "waterplane_area": self.waterplane_area,
            "lcf": self.lcf,
            "tcf": float(self.centre_of_flotation[1]),
            "bm_transverse": self.bm_transverse,
            "bm_longitudinal": self.bm_longitudinal,
            "km_transverse": self.km_transverse,
            "km_longitudinal": self.km_longitudinal,
            "wetted_surface": self.wetted_surface,
            "waterline_length": float(self.waterline_size[0]),
            "waterline_breadth": float(self.waterline_size[1]),
            "unbalanced": self.unbalanced,
        }


def hydrostatics(hull: Hull, attitude: Attitude, density: float = SEA_WATER) -> Hydrostatics:
    """Hydrostatics of a hull in an attitude; the density of the water in [kg/m^3].

    Raises:
        TypeError: If it is no hull, no attitude, such as a draft alone, or the density is no number.
    """
    hull_of(hull)
    attitude_of(attitude)
    number(density, "density", "kilograms per cubic metre")
    normal, height = attitude.normal, attitude.height
    below, skin = hull.below(normal, height), hull.surface(normal, height)
    volume, area = below["volume"], below["area"]
    centre = below["moment"] / volume if volume > 0 else np.full(3, np.nan)
    flotation = below["area_moment"] / area if area > 0 else np.full(3, np.nan)
    spread = below["area_second"] - (area * np.outer(flotation, flotation) if area > 0 else 0.0)
    across, along = attitude.port, attitude.forward
    sideways = skin["thrust"] - normal * (normal @ skin["thrust"])
    size = skin["waterline_high"] - skin["waterline_low"]
    return Hydrostatics(
        attitude=attitude,
        density=density,
        volume=volume,
        centre_of_buoyancy=centre,
        waterplane_area=area,
        centre_of_flotation=flotation,
        second_transverse=float(across @ spread @ across),
        second_longitudinal=float(along @ spread @ along),
        wetted_surface=skin["wetted_area"],
        waterline_size=np.maximum(size[:2], 0.0) if np.isfinite(size).all() else np.zeros(2),
        unbalanced=float(np.linalg.norm(sideways) / volume) if volume > 0 else 0.0,
    )
