"""A vessel at rest, with what answers to more in its tanks."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.hulls import hull_mesh
from gantline.assembly.afloat.water import hull_name
from gantline.hydro import Hull
from gantline.results import series
from gantline.results.afloat.attitude import Lie
from gantline.results.rotation import axes
from gantline.scenario.afloat.tanks import bodies_afloat, sea_density
from gantline.scenario.afloat.water import Water
from gantline.statics import Losses, Statics
from gantline.statics.inclining import heights_of

__all__ = ["Afloat", "VesselAttitude", "hull_of"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class VesselAttitude:
    """How a vessel floats.

    Attributes:
        heel: To starboard positive [rad].
        trim: By the stern positive [rad].
        draft: At half its length in the centre plane, along its own z [m].
    """

    heel: float
    trim: float
    draft: float


def hull_of(question: Statics, vessel: str) -> Hull:
    """The hull of a vessel of a lift, vessel axes."""
    name = hull_name(vessel)
    force = next(one for one in question.assembly.document["forces"] if one["name"] == name)
    return Hull(name, force["vertices"], force["triangles"])


class Afloat:
    """The vessel at rest at a moment [s] of the lift, with the contents that the lift file gives.

    What is asked about it later is asked of the equilibrium that `question` has found last.

    Attributes:
        rest: The equilibrium.
        mass: Of the vessel's body [kg].
        centre: Its centre of gravity, vessel axes [m].
        turn: World from vessel, shape (3, 3).
        attitude: How it floats.
        keel: Height of the lowest point of its hull, vessel axes [m].
        deck: Height of the highest [m].
    """

    def __init__(self, question: Statics, vessel: str, time: float, losses: Losses = "none") -> None:
        self.question, self.vessel = question, vessel
        self.scenario = scenario = question.scenario
        self.rest = self.question.equilibrium(time, losses=losses)
        body = next(one for one in self.question.assembly.document["bodies"] if one["name"] == vessel)
        self.mass, self.centre = float(body["mass"]), np.array(body["centre_of_gravity"])
        hull = hull_mesh(scenario, vessel, bodies_afloat(scenario)[vessel])
        assert hull is not None  # it floats
        self.keel, self.deck = (float(height) for height in hull.box[:, 2])
        self._middle = float(hull.box[:, 0].mean())
        self._level = (scenario.water or Water()).level
        self.turn = axes(self.rest.recording.column("body_orientation", vessel)[-1])
        self.attitude = self._attitude()

    def bears_loads(self) -> bool:
        """Whether a load stands aboard, on the vessel itself or on what is fixed to it."""
        rest = self.rest.recording
        parents = {body["name"]: body["parent"] for body in self.question.assembly.document["bodies"]}
        return any(
            self._is_of(under, parents) and float(rest.column("contact_force", contact)[-1]) > 0.0
            for load in rest.rig.loads
            for contact, under in load.meets.items()
        )

    def _is_of(self, body: str | None, parents: Mapping[str, str | None]) -> bool:
        while body is not None and body != self.vessel:
            body = parents.get(body)
        return body == self.vessel

    def content(self, tank: str) -> float:
        """What is in a tank at the moment [kg]."""
        return float(self.rest.recording.column("tank_content", f"{self.vessel}.{tank}")[-1])

    def _attitude(self) -> VesselAttitude:
        lie = Lie(self.turn, self._origin()[2] - self._level)
        return VesselAttitude(float(lie.heel), float(lie.trim), float(lie.draft(self._middle)))

    def _origin(self) -> Floats:
        centre = self.rest.recording.column("body_position", self.vessel)[-1]
        origin: Floats = centre - self.turn @ self.centre
        return origin

    def displacement(self) -> float:
        """Mass of the water displaced [kg]."""
        return self._displaced(self.turn[2], float(self._origin()[2] - self._level))

    def mass_of_loads(self) -> float:
        """Mass of all loads of the lift with rigging on them and their tanks, whatever bears them [kg]."""
        rest, gravity = self.rest.recording, self.question.rig.gravity
        return math.fsum(float(series.load_weight(rest, one)[-1]) for one in rest.rig.loads) / gravity

    def displacement_at(self, wanted: VesselAttitude) -> float:
        """Mass of the water that it would displace if it floated otherwise [kg]."""
        up = np.array(
            [
                math.sin(wanted.trim),
                math.cos(wanted.trim) * math.sin(wanted.heel),
                math.cos(wanted.trim) * math.cos(wanted.heel),
            ]
        )
        return self._displaced(up, -float(up @ (self._middle, 0.0, wanted.draft)))

    def _displaced(self, up: Floats, height: float) -> float:
        """With a vertical in vessel axes, and its origin at a height above the water [m]."""
        hull = hull_of(self.question, self.vessel)
        return float(hull.below(up, height)["volume"]) * sea_density(self.scenario)

    def slopes(self) -> dict[str, Floats]:
        """How heel, trim [rad] and draft [m] answer to mass of the vessel, shape (4,) each.

        To a kilogram more at its centre of gravity, and to moments about that of 1 kg m along its axes.
        """
        kinds = ("mass", "centre_x", "centre_y", "centre_z")
        found = self.question.sensitivities([(kind, self.vessel) for kind in kinds])
        motion = np.array([one.of_body(self.vessel) for one in found])
        motion[1:] /= self.mass
        x, y, z = self.turn.T
        turned = [np.cross(motion[:, 3:], axis)[:, 2] for axis in (x, y, z)]
        heel = (z[2] * turned[1] - y[2] * turned[2]) / (y[2] ** 2 + z[2] ** 2)
        trim = turned[0] / math.cos(self.attitude.trim)
        # The point of the vessel in which draft is read stays in the surface.
        arm = self.turn @ (np.array([self._middle, 0.0, self.attitude.draft]) - self.centre)
        draft = -(motion[:, 2] + np.cross(motion[:, 3:], arm)[:, 2]) / z[2]
        return {"heel": heel, "trim": trim, "draft": draft}

    def metacentric_heights(self) -> tuple[float, float]:
        """For heel and trim [m], see `gantline.statics.inclining`."""
        found = heights_of(self.question, self.rest.recording, self.vessel, self.displacement())
        return found.transverse, found.longitudinal
