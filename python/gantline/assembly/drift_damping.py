"""What waves take of the slow way of a vessel, into a force of a document."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gantline.assembly.parts import Json
from gantline.hydro.database import ForcesAround
from gantline.hydro.drift_damping import Slowed, cubics_over_heading
from gantline.scenario import Scenario
from gantline.scenario.water import Water, WaveForces

__all__ = ["drift_damping"]

Array = npt.NDArray[np.float64]


def drift_damping(scenario: Scenario, name: str, given: WaveForces, slowed: list[Slowed], box: Array) -> Json:
    """The force, about the middle of a vessel.

    Args:
        scenario: the lift.
        name: of the vessel.
        given: its wave forces, which drift forces are about the point of.
        slowed: all waves with what they push it with.
        box: its least and largest x, y [m].
    """
    middle = float(box[:, 0].mean())
    lever = (given.at[0] - middle, given.at[1])
    current = (0.0, 0.0) if scenario.current is None else scenario.current.velocity[:2]
    cubics = cubics_over_heading(
        [_about_middle(one, lever) for one in slowed],
        length=float(np.ptp(box[:, 0])),
        current=current,
        gravity=scenario.simulation.gravity,
        depth=(scenario.water or Water()).depth,
    )
    return {
        "type": "drift_damping",
        "name": f"{name}.drift_damping",
        "body": name,
        "at": [middle, 0.0, given.at[2]],
        "around": cubics.tolist(),
    }


def _about_middle(slowed: Slowed, lever: tuple[float, float]) -> Slowed:
    """With yaw about a point from which that of the file is away by `lever` [m]."""

    def moved(forces: ForcesAround) -> ForcesAround:
        cubics = forces.cubics.copy()
        cubics[..., 2] += lever[0] * cubics[..., 1] - lever[1] * cubics[..., 0]
        return replace(forces, cubics=cubics)

    return replace(slowed, drift=moved(slowed.drift), over_frequency=moved(slowed.over_frequency))
