"""Metacentric heights by inclining: how far a vessel turns where a little of its weight is shifted.

Shifting the mass m of a vessel's body by dy across it, level, heels it with the moment m g dy, and it comes
to rest where Δ g GM dφ rights it as much: GM = m dy/(Δ dφ), with Δ all that it displaces. That is what a yard
does to find GM, done with derivatives of the equilibrium. So everything counts that follows the turn: liquids
in slack tanks, loads that hang from its hooks, ropes that hold it. What stands on its deck goes along with
it: friction holds that at an angle so small, whatever the equilibrium was found with. Derivatives are over
shifts along the axes of the vessel, of which only the level part turns it where it lies with heel and trim.
Through holes below the water liquid follows, too, which equilibria do not know: `open_tanks` has that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gantline.results.recording import Recording
from gantline.results.rotation import axes, heading
from gantline.statics.answers import Equilibrium
from gantline.statics.open_tanks import with_what_runs

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["MetacentricHeights", "heights_of", "metacentric_heights"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class MetacentricHeights:
    """What rights a vessel, free surfaces and hanging loads included; negative where nothing does.

    Attributes:
        yielding: turns about the level ways forward and to port under moments about them, over those of its
            displacement at a lever of 1 m, shape (2, 2) [1/m].
    """

    yielding: Floats

    @property
    def transverse(self) -> float:
        """For heel [m]."""
        return self.about((1.0, 0.0))

    @property
    def longitudinal(self) -> float:
        """For trim [m]."""
        return self.about((0.0, 1.0))

    def about(self, axis: npt.ArrayLike) -> float:
        """For turning about a level axis, forward and to port, shape (2,), length 1 [m].

        Infinite where nothing turns it, as of one that displaces nothing.
        """
        way = np.asarray(axis, dtype=float)
        yields = float(way @ self.yielding @ way)
        return 1.0 / yields if yields else math.inf


def metacentric_heights(
    question: Statics, rest: Equilibrium, *, at_level: bool = False
) -> dict[str, MetacentricHeights]:
    """Metacentric heights of every vessel of a lift that floats freely.

    Args:
        question: The lift.
        rest: Its equilibrium that was found last.
        at_level: Whether of tanks with holes those count only that have come to their level.
    """
    found = {}
    for vessel in (one for one in rest.recording.rig.vessels if not one.is_carried):
        displaced = float(rest.recording.column("vessel_displacement", vessel.name)[-1])
        found[vessel.name] = heights_of(question, rest.recording, vessel.body, displaced, at_level=at_level)
    return found


def heights_of(
    question: Statics, recording: Recording, body: str, displaced: float, *, at_level: bool = False
) -> MetacentricHeights:
    """Metacentric heights of a body that floats.

    Args:
        question: The lift.
        recording: How it rests, of its equilibrium that was found last.
        body: Name of the body.
        displaced: Mass of the water that it displaces [kg].
        at_level: Whether of tanks with holes those count only that have come to their level.
    """
    masses = {one["name"]: float(one["mass"]) for one in question.assembly.document["bodies"]}
    kinds = ("centre_x", "centre_y", "mass")
    found = question.sensitivities([(kind, body) for kind in kinds], standing=True)
    motions = np.array([one.of_body(body) for one in found])
    motions[:2] /= masses[body]
    answers = masses[body] * with_what_runs(question, recording, body, motions, at_level=at_level)
    orientation = recording.column("body_orientation", body)[-1]
    ahead = float(heading(orientation))
    # Forward and to port, level, as rows.
    level = np.array([[math.cos(ahead), math.sin(ahead)], [-math.sin(ahead), math.cos(ahead)]])
    shifts = level @ axes(orientation)[:2, :2]
    turns = level @ answers[:, 3:5].T
    # About the ways forward and to port, for level shifts along them: one to port heels it to port.
    per_shift = turns @ np.linalg.inv(shifts)
    share = masses[body] / displaced if displaced > 0.0 else math.inf
    return MetacentricHeights(per_shift @ np.array([[0.0, 1.0], [-1.0, 0.0]]) / share)
