"""Whether crawler cranes can stand as written."""

from __future__ import annotations

from gantline.scenario.crawler import Crawler
from gantline.scenario.findings import Findings

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
