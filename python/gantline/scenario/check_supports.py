"""Whether supports and structures can stand where they are said to, and pairs that are watched make sense."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.model import Scenario
from gantline.scenario.structures import Dock, dock_of
from gantline.scenario.supports import Supports, supports_of

__all__ = ["check_places", "check_supports", "foot_of", "top_of"]

_ROUNDING = 1e-9


def check_supports(findings: Findings) -> None:
    """Note everything that is wrong with supports, structures, and steps that take supports away."""
    scenario = findings.scenario
    known: list[str] = []
    for name, group in (scenario.supports or {}).items():
        known.append(name)
        known += _check_group(findings, name, group)
    for place, step in enumerate(scenario.plan):
        for name in step.remove_supports:
            if name not in known:
                sentence = f"'{name}' is not a support or a group of them; {nearest(name, known)}"
                findings.add(("plan", place, "remove_supports"), sentence)
    docks = [name for name, one in (scenario.structures or {}).items() if isinstance(one, Dock)]
    for name in docks[1:]:
        findings.add(("structures", name), f"'{docks[0]}' is a dock already; one dock can be simulated")
    for name in docks:
        dock = (scenario.structures or {})[name]
        assert isinstance(dock, Dock)
        level = 0.0 if scenario.ground is None else scenario.ground.level
        if dock.floor >= level:
            sentence = f"the floor at {dock.floor:g} m is not below the ground at {level:g} m"
            findings.add(("structures", name, "floor"), f"{sentence}; a dock is a hole in the ground")


def top_of(scenario: Scenario, group: str) -> float:
    """Level of the highest top of a group of supports [m]."""
    given = (scenario.supports or {})[group]
    return foot_of(scenario, given) + max(one.height for one in supports_of(group, given))


def foot_of(scenario: Scenario, group: Supports) -> float:
    """Level of what a group of supports stands on [m]."""
    if group.foot is not None:
        return group.foot
    return 0.0 if scenario.ground is None else scenario.ground.level


def _check_group(findings: Findings, name: str, group: Supports) -> list[str]:
    """Check one group; gives the names of its supports."""
    scenario, path = findings.scenario, ("supports", name)
    load = scenario.load
    if load is None:
        findings.add(path, "there is no 'load' to stand on it")
    elif group.under != load.name:
        findings.add((*path, "under"), f"'{group.under}' is not the load; right is '{load.name}'")
    supports = supports_of(name, group)
    own = [one.name[len(name) + 1 :] for one in supports]
    for key in group.each or {}:
        if key not in own:
            sentence = f"'{key}' is not a support of the grid; {nearest(key, own)}"
            findings.add((*path, "each", key), f"{sentence}, number along x and number along y")
    for key in {key for key in own if own.count(key) > 1}:
        findings.add((*path, "places", key), f"'{key}' is a support of the grid already")
    for one in supports:
        if one.height <= 0.0:
            findings.add(
                (*path, "height"), f"the height of '{one.name}' is not known; 'height: 1.5 m' is usual"
            )
            break
    for one in supports:
        if one.removed_at is not None and one.removed_at > scenario.duration:
            sentence = f"'{one.name}' is taken away at {one.removed_at:g} s, after the end of the lift"
            findings.add(path, f"{sentence} at {scenario.duration:g} s")
    _check_over_dock(findings, name, group)
    return [one.name for one in supports]


def _check_over_dock(findings: Findings, name: str, group: Supports) -> None:
    """Note a support whose middle is over the dock, where nothing says that its foot is on the floor."""
    load, dock = findings.scenario.load, dock_of(findings.scenario)
    if dock is None or load is None or group.foot is not None:
        return
    is_on_load = group.measured_from == "load"
    heading, from_x, from_y = (load.heading, *load.position[:2]) if is_on_load else (group.heading, 0.0, 0.0)
    cos, sin = math.cos(heading), math.sin(heading)
    for one in supports_of(name, group):
        x, y = from_x + cos * one.at[0] - sin * one.at[1], from_y + sin * one.at[0] + cos * one.at[1]
        if dock.x[0] < x < dock.x[1] and dock.y[0] < y < dock.y[1]:
            sentence = f"'{one.name}' at ({x:.2f}, {y:.2f}) m is over the dock, and would stand on the air"
            right = f"'foot: {dock.floor:g} m' puts it onto the floor"
            findings.add(("supports", name), f"{sentence}; {right}, or move it onto the ground beside it")
            return


def check_places(findings: Findings, least: Sequence[float], most: Sequence[float]) -> None:
    """Note supports that are not under a load of these least and largest x, y from its datum [m]."""
    for group, given in (findings.scenario.supports or {}).items():
        if given.measured_from != "load":
            continue
        for one in supports_of(group, given):
            sides = zip(one.at, least, most, strict=False)
            if any(not low - _ROUNDING <= at <= high + _ROUNDING for at, low, high in sides):
                sentence = f"'{one.name}' at ({one.at[0]:g}, {one.at[1]:g}) m is not under the load"
                from_to = f"x {least[0]:g} to {most[0]:g} m, y {least[1]:g} to {most[1]:g} m from its datum"
                findings.add(("supports", group), f"{sentence}, which is at {from_to}")
