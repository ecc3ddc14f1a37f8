"""What the bodies of cranes are called."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from gantline.scenario.cranes.boom import FloatingCrane, boom_name
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.cranes.crane_types import AnyCrane
from gantline.scenario.cranes.crawler import Crawler, tracks_body
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hooks import trolley_name
from gantline.scenario.cranes.slewing import upper_body
from gantline.scenario.errors import PathPart

__all__ = ["crane_bodies", "crane_parts", "girder_body"]

_Path = tuple[PathPart, ...]


def girder_body(crane: str) -> str:
    """Name of the part of a girder that bends."""
    return f"{crane}.girder"


def crane_bodies(cranes: Mapping[str, AnyCrane]) -> list[str]:
    """Names of the bodies of cranes, without hooks."""
    return [str(name) for name, _, _ in crane_parts(cranes)] + [
        name for name, crane in cranes.items() if not isinstance(crane, FixedHook | Crawler)
    ]


def crane_parts(cranes: Mapping[str, AnyCrane]) -> list[tuple[str, str, _Path]]:
    """Names that the parts of cranes take, what they are, and where the file says them."""
    found: list[tuple[str, str, _Path]] = []
    for name, crane in cranes.items():
        path: _Path = ("cranes", name)
        if isinstance(crane, Goliath):
            found.append((girder_body(name), "the girder of a crane", (*path, "girder")))
            for trolley, given in crane.trolleys.items():
                at = (*path, "trolleys", trolley)
                found.append((trolley_name(name, trolley), "a trolley", at))
                found += [(f"{name}.{hook}", "a hook", (*at, "hooks", hook)) for hook in given.hooks]
        elif isinstance(crane, FloatingCrane | Crawler):
            if isinstance(crane, Crawler):
                found.append((tracks_body(name), "what a crane stands on", (*path, "tracks")))
            if isinstance(crane, Crawler) or crane.slewing_axis is not None:
                found.append((upper_body(name), "what slews of a crane", path))
            found.append((boom_name(name), "the boom of a crane", (*path, "boom")))
            found += [(f"{name}.{hook}", "a hook", (*path, "hooks", hook)) for hook in crane.hooks]
        elif not isinstance(crane, FixedHook):
            assert_never(crane)
    return found
