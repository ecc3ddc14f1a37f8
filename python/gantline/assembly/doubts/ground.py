"""Ground under crawler cranes that cannot well be meant: what it bears, and how level it is."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.crawler import crawlers
from gantline.scenario import Scenario
from gantline.scenario.cranes.crawler import TRACK_CORNERS
from gantline.scenario.errors import Doubt
from gantline.units import format_quantity

__all__ = ["doubtful_ground"]

#: What sound granite bears [Pa], the most of BS 8004:1986, table 1.
_STRONGEST = 10e6
#: Charts are for cranes that stand level within about a hundredth; ground that differs by more than this
#: share of the shorter side of the tracks is none to lift from [1].
_STEEPEST = 0.05


def doubtful_ground(scenario: Scenario) -> Iterator[Doubt]:
    """Each crawler crane on ground as nowhere is, or where none lifts."""
    for name, crane in crawlers(scenario).items():
        tracks = crane.tracks
        if (allowed := tracks.allowed_pressure) is not None and allowed > _STRONGEST:
            bears = f"the ground under {name} bears {format_quantity(allowed, 'kPa', 0)}"
            most = f"more than sound rock, {format_quantity(_STRONGEST, 'kPa', 0)}"
            sentence = f"{bears}, {most}; a unit has slipped, MPa for kPa"
            yield Doubt(("cranes", name, "tracks", "allowed_pressure"), sentence)
        levels = [(tracks.levels or {}).get(corner, 0.0) for corner in TRACK_CORNERS]
        differ, side = max(levels) - min(levels), min(tracks.length, tracks.gauge)
        if differ > _STEEPEST * side:
            apart = f"the ground under {name} differs by {format_quantity(differ, 'm', 3)}"
            of = f"over tracks {format_quantity(side, 'm', 1)} long or apart"
            right = "charts are for cranes that stand level, or a unit has slipped, m for mm"
            yield Doubt(("cranes", name, "tracks", "levels"), f"{apart} {of}; {right}")
