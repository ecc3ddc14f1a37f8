"""Hydrostatics of hulls: what they displace, where they float, how they right themselves; databases.

Vessel axes: x forward, y to port, z up from the keel. Heel is positive to starboard, trim by the stern.
"""

from __future__ import annotations

from gantline.hydro.attitude import Attitude
from gantline.hydro.database import (
    DATABASE_FORMATS,
    Coupling,
    DatabaseError,
    HydrodynamicDatabase,
    read_database,
    write_database,
)
from gantline.hydro.floating import CannotFloatError, Floating, float_free
from gantline.hydro.hull import Closure, Hull
from gantline.hydro.hydrostatics import Hydrostatics, hydrostatics
from gantline.hydro.memory import Memory, Misfit, fit_memory
from gantline.hydro.mesh_file import HullError, read_hull
from gantline.hydro.motion_record import MotionRecord, read_motion_record, write_motion_record
from gantline.hydro.raos import DisplacementRaos, read_raos, write_raos
from gantline.hydro.righting import Heeled, Righting, RightingArms, righting_arms
from gantline.hydro.shapes import box_hull, raked_barge, wigley_hull
from gantline.hydro.tank import Tank, free_surface_correction

__all__ = [
    "DATABASE_FORMATS",
    "Attitude",
    "CannotFloatError",
    "Closure",
    "Coupling",
    "DatabaseError",
    "DisplacementRaos",
    "Floating",
    "Heeled",
    "Hull",
    "HullError",
    "HydrodynamicDatabase",
    "Hydrostatics",
    "Memory",
    "Misfit",
    "MotionRecord",
    "Righting",
    "RightingArms",
    "Tank",
    "box_hull",
    "fit_memory",
    "float_free",
    "free_surface_correction",
    "hydrostatics",
    "raked_barge",
    "read_database",
    "read_hull",
    "read_motion_record",
    "read_raos",
    "righting_arms",
    "wigley_hull",
    "write_database",
    "write_motion_record",
    "write_raos",
]
