"""The crawler crane: two tracks on the ground, an upper structure that slews on them, a boom that luffs.

Its axes begin on the ground in the middle of its tracks, where the slewing axis is: x forward along the
tracks, y to the left, z up. Those of the upper structure turn with it, x towards the boom.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element, Named
from gantline.scenario.cranes.boom import BoomHook, BoomParts, PlacedBoom, boom_name
from gantline.scenario.cranes.goliath import Traverse
from gantline.scenario.cranes.luffing import Luffing
from gantline.scenario.cranes.rating import Rating
from gantline.scenario.cranes.slewing import Slewing, refuse_outside_of_range, upper_body
from gantline.scenario.quantities import (
    Angle,
    Damping,
    Flag,
    Length,
    ListOf,
    Mass,
    Names,
    PositiveAngle,
    PositiveArea,
    PositiveLength,
    PositiveMass,
    PositiveSpeed,
    PositiveStiffness,
    PositiveStress,
    PositiveTime,
    Quantity,
    Time,
    refuse,
)

__all__ = [
    "TRACK_CORNERS",
    "Counterweight",
    "Crawler",
    "CrawlerBoom",
    "CrawlerPins",
    "Settling",
    "Tracks",
    "along_body",
    "crawler_boom",
    "tracks_body",
]

#: Ends of the two tracks.
TRACK_CORNERS = ("left.front", "left.back", "right.front", "right.back")

#: Length of tracks over their gauge, or the other way round, beyond which a decimal point has slipped [1].
_SLENDEST = 4.0

_Place = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]


def tracks_body(crane: str) -> str:
    """Name of what stands on the ground of a crawler crane."""
    return f"{crane}.tracks"


def along_body(crane: str) -> str:
    """Name of what goes along a crawler crane's heading, as it stands before the ground gives way."""
    return f"{crane}/along"


def _refuse_other_corners(given: tuple[str, ...], key: str) -> None:
    for corner in given:
        if corner not in TRACK_CORNERS:
            listed = ", ".join(f"'{one}'" for one in TRACK_CORNERS[:-1]) + f" and '{TRACK_CORNERS[-1]}'"
            raise refuse(f"'{corner}' is not an end of a track; there are {listed}", key)


class Settling(Element):
    """Ground that gives way under ends of tracks while the lift goes on."""

    what: ClassVar[str] = "settling ground"

    at: Time = Field(description="When it begins to.")
    over: PositiveTime = Field(description="How long it takes.")
    by: PositiveLength = Field(description="By how much.")
    corners: Names = Field(
        TRACK_CORNERS,
        description="Under which ends of tracks: 'left.front', 'left.back', 'right.front', 'right.back'; all "
        "if not given.",
    )

    @model_validator(mode="after")
    def _corners_are_ends(self) -> Settling:
        _refuse_other_corners(self.corners, "corners")
        if len(set(self.corners)) < len(self.corners):
            raise refuse("an end of a track is named twice; each stands once", "corners")
        return self


class Tracks(Element):
    """The two tracks and the ground under them."""

    what: ClassVar[str] = "the tracks of a crawler crane"

    length: PositiveLength = Field(description="Length of a track on the ground.")
    width: PositiveLength = Field(description="Width of a track, or of the foot of an outrigger.")
    gauge: PositiveLength = Field(description="Distance of the tracks, middle to middle.")
    height: PositiveLength = Field(1.6, description="Height of the turntable; 1.6 m if not given.")
    mats: PositiveLength | None = Field(
        None,
        description="Width of the mats under each track, as long as the track; none if not given.",
    )
    outrigger_mats: PositiveArea | None = Field(
        None,
        description="Area of the mat under each end, of a crane that stands on four outriggers in place of "
        "tracks: length and gauge are their distances, middle to middle.",
    )
    allowed_pressure: PositiveStress | None = Field(
        None, description="Pressure that the ground bears, under mats where there are any."
    )
    stiffness: PositiveStiffness = Field(
        200e6, description="Stiffness of mats and ground under each end of a track; 200 MN/m if not given."
    )
    damping: Damping = Field(4e6, description="Damping there; 4 MN s/m if not given.")
    levels: Annotated[dict[str, Length] | None, Field(min_length=1)] = Field(
        None, description="How much higher than the ground it is under ends of tracks; less than 0 is lower."
    )
    settling: Settling | None = Field(None, description="Ground that gives way during the lift.")

    @model_validator(mode="after")
    def _fits_together(self) -> Tracks:
        if self.gauge <= self.width:
            sentence = f"tracks of {self.width:g} m, {self.gauge:g} m apart from middle to middle, overlap"
            raise refuse(f"{sentence}; a larger gauge is right", "gauge")
        if not 1 / _SLENDEST <= self.length / self.gauge <= _SLENDEST:
            sentence = f"tracks of {self.length:g} m with a gauge of {self.gauge:g} m are no crane's"
            raise refuse(f"{sentence}; about as long as they are apart is usual", "length")
        if self.mats is not None and not self.width <= self.mats <= self.gauge:
            sentence = f"mats of {self.mats:g} m are not between the width and the gauge of the tracks"
            raise refuse(f"{sentence}, {self.width:g} m and {self.gauge:g} m", "mats")
        if self.outrigger_mats is not None:
            self._refuse_outriggers(self.outrigger_mats)
        _refuse_other_corners(tuple(self.levels or ()), "levels")
        return self

    def _refuse_outriggers(self, area: float) -> None:
        if self.mats is not None:
            raise refuse(
                "lie under tracks, and this crane stands on outriggers; leave one of both out", "mats"
            )
        least, most = self.width**2, min(self.length, self.gauge) ** 2
        if not least <= area <= most:
            sentence = (
                f"a mat of {area:g} m^2 is not between the foot of an outrigger and what there is room for"
            )
            raise refuse(f"{sentence}, {least:.3g} m^2 and {most:.3g} m^2", "outrigger_mats")


class Counterweight(Element):
    """The counterweight on the upper structure."""

    what: ClassVar[str] = "a counterweight"

    mass: PositiveMass = Field(description="Mass.")
    behind: PositiveLength = Field(description="Distance of its centre of gravity behind the slewing axis.")
    height: PositiveLength = Field(
        3.0, description="Height of its centre of gravity above the ground; 3 m if not given."
    )


class CrawlerPins(Element):
    """The pins about which the boom of a crawler crane turns."""

    what: ClassVar[str] = "the heel pins of a crawler crane's boom"

    ahead: Length = Field(description="How far they are ahead of the slewing axis.")
    height: PositiveLength = Field(description="Height above the ground.")
    apart: PositiveLength = Field(2.5, description="Distance of the two; 2.5 m if not given.")


class CrawlerBoom(BoomParts):
    """The boom of a crawler crane; its angle may be said by the radius."""

    heel_pins: CrawlerPins = Field(description="The pins about which it turns.")
    angle: PositiveAngle = Field(0.0, description="Angle over the ground at the start; or 'radius'.")
    radius: PositiveLength | None = Field(
        None, description="Distance of its head from the slewing axis at the start; or 'angle'."
    )

    @model_validator(mode="after")
    def _angle_or_radius(self) -> CrawlerBoom:
        given = [key for key in ("angle", "radius") if key in self.model_fields_set]
        if len(given) != 1:
            listed = "both" if given else "none of them"
            raise refuse(f"a boom has one of 'angle' and 'radius' at the start; found {listed}")
        if self.radius is None:
            return self
        least, most = self.heel_pins.ahead, self.heel_pins.ahead + self.length
        if not least < self.radius < most:
            sentence = f"the head of this boom does not come to a radius of {self.radius:g} m"
            raise refuse(f"{sentence}; {least:g} m to {most:g} m is right", "radius")
        return self.model_copy(update={"angle": math.acos((self.radius - least) / self.length)})


class Crawler(Element):
    """A crawler crane."""

    what: ClassVar[str] = "a crawler crane"

    type: Literal["crawler"] = Field(description="Type of crane: 'crawler'.")
    position: _Place = Field(description="Place of the slewing axis in the world, x and y.")
    heading: Angle = Field(0.0, description="Direction of the tracks, from world x towards y.")
    slew: Angle = Field(
        0.0, description="Direction of the boom at the start, from the heading towards the left."
    )
    rated_capacity: PositiveMass | None = Field(
        None, description="Rated capacity of all hooks together; by 'rating' it falls with the radius."
    )
    rating_includes_hook_block: Flag = Field(
        False,
        description="true: rated capacities are compared with hoist loads, false: with hook loads.",
    )
    tracks: Tracks = Field(description="Tracks and the ground under them.")
    base_mass: PositiveMass = Field(
        description="Mass of the base machine, on the slewing axis: tracks, turntable, machinery."
    )
    upper_mass: Mass = Field(0.0, description="What of the base machine slews with the boom.")
    central_ballast: Mass = Field(0.0, description="Mass of the ballast between the tracks.")
    counterweight: Counterweight = Field(description="Its counterweight.")
    boom: CrawlerBoom = Field(description="The boom.")
    luffing: Luffing | None = Field(None, description="What luffs the boom; it keeps its angle if not given.")
    slewing: Slewing | None = Field(None, description="What slews it; it keeps its angle if not given.")
    travel: Traverse | None = Field(
        None,
        description="Its drive along its heading, from 'position'; it stands if not given.",
    )
    rating: Rating | None = Field(None, description="Rating chart.")
    wind_limit: PositiveSpeed | None = Field(None, description="Largest gust in which it may lift.")
    hooks: Named[BoomHook] = Field(description="Hooks at the boom head, by name; each is <crane>.<hook>.")

    @model_validator(mode="after")
    def _masses_fit(self) -> Crawler:
        if self.upper_mass >= self.base_mass:
            sentence = f"{self.upper_mass / 1e3:g} t slew of a base machine of {self.base_mass / 1e3:g} t"
            raise refuse(f"{sentence}; a part of it stays on the ground", "upper_mass")
        if self.travel is not None and not self.travel.range_[0] <= 0 <= self.travel.range_[1]:
            sentence = "travel counts from where the crane stands"
            raise refuse(f"{sentence}; a range with 0 in it is right", "travel")
        if self.travel is not None and self.tracks.outrigger_mats is not None:
            raise refuse("a crane on outriggers stands; leave its travel out", "travel")
        refuse_outside_of_range(self.slew, self.slewing)
        return self


def crawler_boom(name: str, crane: Crawler) -> PlacedBoom:
    """The boom of a crawler crane, on its upper structure; its radius counts from the slewing axis."""
    pins = crane.boom.heel_pins
    return PlacedBoom(
        crane=name,
        name=boom_name(name),
        base=upper_body(name),
        boom=crane.boom,
        heel=(pins.ahead, 0.0, pins.height),
        apart=pins.apart,
        luffing=crane.luffing,
        hooks=crane.hooks,
        reach_from=(0.0, 0.0, 0.0),
        path=("cranes", name),
        slew=(crane.slew, crane.slewing),
    )
