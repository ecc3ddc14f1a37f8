"""Whether pairs are watched over steps that there are, in their order."""

from __future__ import annotations

from gantline.scenario.consistency.plan import place_of_step
from gantline.scenario.findings import Findings, Path

__all__ = ["check_watches"]


def check_watches(findings: Findings) -> None:
    """Note steps from and to which a pair is watched that are none, or in the wrong order."""
    for place, watch in enumerate(findings.scenario.watch):
        path: Path = ("watch", place)
        ends = [
            None if name is None else place_of_step(findings, (*path, key), name)
            for key, name in (("from_step", watch.from_step), ("to_step", watch.to_step))
        ]
        first, last = ends
        if first is not None and last is not None and last < first:
            sentence = f"'{watch.to_step}' comes before '{watch.from_step}' in the plan"
            findings.add((*path, "to_step"), f"{sentence}; change them over")
