"""Added mass and damping of bodies as matrices: by axes, whole, or from hydrodynamic databases."""

from __future__ import annotations

import numpy as np

from gantline.assembly.afloat.databases import from_database
from gantline.assembly.spatial import Array
from gantline.hydro.database import HydrodynamicDatabase
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import AddedMass, WaterDamping
from gantline.scenario.errors import PathPart

__all__ = ["water_matrix"]

#: How far below zero an eigenvalue may be by rounding, relative to the diagonal.
_ROUNDING = 1e-9


def water_matrix(
    scenario: Scenario, path: tuple[PathPart, ...], given: AddedMass | WaterDamping, density: float
) -> tuple[list[list[float]], list[str]]:
    """The six rows of an added mass or a damping, SI units, and what is doubtful about them.

    Args:
        scenario: the lift.
        path: of the added mass or damping in the lift file.
        given: what the lift file says.
        density: of the water around the body [kg/m^3].

    Raises:
        ScenarioError: if a database cannot be used, or a matrix gains energy from the water.
    """
    if given.database is not None:
        return _from_database(scenario, path, given, density)
    if given.matrix is None:
        return np.diag(given.diagonal).tolist(), []
    rows = np.array(given.matrix)
    scale = np.sqrt(np.maximum(np.diag(rows), 0.0))
    scale = np.where(scale > 0, scale, 1.0)
    if np.diag(rows).min() < 0 or np.linalg.eigvalsh(rows / np.outer(scale, scale))[0] < -_ROUNDING:
        sentence = "some motion would gain energy from this water: an eigenvalue of the matrix is below zero"
        raise scenario.error((*path, "matrix"), f"{sentence}; check signs and units of its terms")
    return rows.tolist(), []


def _from_database(
    scenario: Scenario, path: tuple[PathPart, ...], given: AddedMass | WaterDamping, density: float
) -> tuple[list[list[float]], list[str]]:
    assert given.database is not None and given.period is not None  # validated
    period = None if given.period == "infinite_frequency" else float(given.period)

    def matrix_at(database: HydrodynamicDatabase) -> tuple[Array, list[str]]:
        if isinstance(given, AddedMass):
            return database.added_mass_at(period, density)
        assert period is not None  # validated
        return database.damping_at(period, density)

    matrix, doubts = from_database(
        scenario, path, (given.database, given.body, given.heading_in_file), matrix_at
    )
    return matrix.tolist(), doubts
