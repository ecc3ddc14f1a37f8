"""Whether crawler cranes can stand as written."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.scenario.cranes.crawler import TRACK_CORNERS, Crawler
from gantline.scenario.findings import Findings
from gantline.scenario.loads.structures import Dock, dock_of

__all__ = ["check_crawlers"]


def check_crawlers(findings: Findings) -> None:
    """Note everything that is wrong with crawler cranes beyond their booms and hooks."""
    scenario = findings.scenario
    for name, crane in (scenario.cranes or {}).items():
        if not isinstance(crane, Crawler):
            continue
        path = ("cranes", name)
        if scenario.ground is None:
            sentence = f"'{name}' stands on the ground, and there is none in this file"
            findings.add(path, f"{sentence}; give 'ground: {{level: 0 m}}'")
        settling = crane.tracks.settling
        if settling is not None and settling.at + settling.over > scenario.duration:
            sentence = f"ground settles until {settling.at + settling.over:g} s"
            right = f"the lift ends at {scenario.duration:g} s; settle earlier or make 'duration' longer"
            findings.add((*path, "tracks", "settling"), f"{sentence}, and {right}")
        dock = dock_of(scenario)
        over = [] if dock is None else list(_over_dock(crane, dock))
        if dock is not None and over:
            x, y = over[0]
            sentence = f"the end of a track of '{name}' at ({x:.2f}, {y:.2f}) m is over the dock"
            where = f"x {dock.x[0]:g} to {dock.x[1]:g} m, y {dock.y[0]:g} to {dock.y[1]:g} m"
            findings.add((*path, "position"), f"{sentence}, {where}; put the crane onto the ground beside it")


def _over_dock(crane: Crawler, dock: Dock) -> Iterator[tuple[float, float]]:
    """Ends of tracks on their middle lines that are over a dock at the start, x and y [m].

    Not those of which `levels` says what is under them: a crane may stand on the floor of a dry dock.
    """
    tracks = crane.tracks
    cos, sin = math.cos(crane.heading), math.sin(crane.heading)
    for corner in TRACK_CORNERS:
        side, end = corner.split(".")
        along = tracks.length / 2 if end == "front" else -tracks.length / 2
        across = tracks.gauge / 2 if side == "left" else -tracks.gauge / 2
        x = crane.position[0] + cos * along - sin * across
        y = crane.position[1] + sin * along + cos * across
        if corner not in (tracks.levels or {}) and dock.x[0] < x < dock.x[1] and dock.y[0] < y < dock.y[1]:
            yield x, y
