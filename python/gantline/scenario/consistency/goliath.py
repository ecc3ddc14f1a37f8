"""Whether Goliath cranes can be built as written."""

from __future__ import annotations

from gantline.scenario.consistency.hooks import check_carried_hook
from gantline.scenario.cranes.goliath import Goliath, Trolley
from gantline.scenario.findings import Findings, Path

__all__ = ["check_goliaths"]


def check_goliaths(findings: Findings) -> None:
    """Note everything that is wrong with Goliath cranes beyond the reeving of their hooks."""
    for name, crane in (findings.scenario.cranes or {}).items():
        if not isinstance(crane, Goliath):
            continue
        path = ("cranes", name)
        if crane.travel is not None:
            low, high = crane.travel.range_
            _check_within(findings, (*path, "position"), crane.position, (low, high), "range of travel")
        for trolley, given in crane.trolleys.items():
            at = (*path, "trolleys", trolley)
            _check_trolley(findings, at, crane, given)
            for hook, one in given.hooks.items():
                check_carried_hook(findings, (*at, "hooks", hook), one, "trolley")
        _check_distance(findings, path, crane)


def _check_within(findings: Findings, path: Path, at: float, limits: tuple[float, float], what: str) -> None:
    low, high = limits
    if not low <= at <= high:
        findings.add(path, f"{at:g} m is outside of the {what}, {low:g} m to {high:g} m")


def _check_trolley(findings: Findings, path: Path, crane: Goliath, trolley: Trolley) -> None:
    reach = crane.span / 2 - (crane.hook_approach or 0.0)
    limits = trolley.traverse.range_
    _check_within(findings, (*path, "position"), trolley.position, limits, "range of traverse")
    ends = [end + hook.along for hook in trolley.hooks.values() for end in limits]
    if max(abs(end) for end in ends) > reach * (1 + 1e-9):
        sentence = f"hooks of this trolley would come to {max(ends, key=abs):g} m along the girder"
        right = f"with this span and approach {reach:g} m is the most"
        findings.add((*path, "traverse", "range"), f"{sentence}; {right}")


def _check_distance(findings: Findings, path: Path, crane: Goliath) -> None:
    if crane.hook_distance is None:
        return
    places = [
        (trolley, hook, given.position + one.along)
        for trolley, given in crane.trolleys.items()
        for hook, one in given.hooks.items()
    ]
    for index, (trolley, hook, at) in enumerate(places):
        for other, second, there in places[:index]:
            if other != trolley and abs(at - there) < crane.hook_distance:
                sentence = f"'{hook}' starts {abs(at - there):g} m from '{second}' along the girder"
                findings.add((*path, "hook_distance"), f"{sentence}; {crane.hook_distance:g} m is the least")
