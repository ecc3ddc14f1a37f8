"""What waves push a vessel with on the whole, into a force of a document."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gantline.assembly.parts import Json
from gantline.hydro.database import ForcesAround
from gantline.hydro.mean_drift import Drifting, cubics_over_heading
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import Water, WaveForces

__all__ = ["mean_drift"]

Array = npt.NDArray[np.float64]


def mean_drift(scenario: Scenario, name: str, given: WaveForces, pushes: list[Drifting], box: Array) -> Json:
    """The force, about the middle of a vessel.

    One on mooring lines that starts at rest has it from the start: with waves that only then begin, it would
    set the vessel swinging on them.

    Args:
        scenario: the lift.
        name: of the vessel.
        given: its wave forces, which drift forces are about the point of.
        pushes: all waves with what they push it with.
        box: its least and largest x, y [m].
    """
    middle = float(box[:, 0].mean())
    lever = (given.at[0] - middle, given.at[1])
    current = scenario.current.velocity[:2] if scenario.current and given.drift_damping else (0.0, 0.0)
    cubics = cubics_over_heading(
        [_about_middle(one, lever) for one in pushes],
        length=float(np.ptp(box[:, 0])),
        current=current,
        gravity=scenario.simulation.gravity,
        depth=(scenario.water or Water()).depth,
    )
    if not given.drift_damping:
        cubics[..., :3] = 0.0
    return {
        "type": "mean_drift",
        "name": f"{name}.mean_drift",
        "body": name,
        "at": [middle, 0.0, given.at[2]],
        "around": cubics.tolist(),
        "settled": scenario.has_mean_drift(name),
    }


def _about_middle(one: Drifting, lever: tuple[float, float]) -> Drifting:
    """With yaw about a point from which that of the file is away by `lever` [m]."""

    def moved(forces: ForcesAround) -> ForcesAround:
        cubics = forces.cubics.copy()
        cubics[..., 2] += lever[0] * cubics[..., 1] - lever[1] * cubics[..., 0]
        return replace(forces, cubics=cubics)

    return replace(one, drift=moved(one.drift), over_frequency=moved(one.over_frequency))
