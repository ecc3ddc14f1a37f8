"""Whether supports and structures can stand where they are said to, and pairs that are watched make sense."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.loads.structures import Dock, dock_of
from gantline.scenario.loads.supports import Support, Supports, supports_of
from gantline.scenario.model import Scenario

__all__ = ["check_beside", "check_places", "check_supports", "foot_of", "top_of"]

_ROUNDING = 1e-9
#: A top higher than this over the underside of a load is in the load and not under it [m].
_INSIDE = 0.1
#: How to say what a load stands on later.
_LATER = "what it comes down on elsewhere is a group with 'measured_from: world', places in the world"


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
    """Level of the highest top of a group of supports under a box [m]."""
    given = (scenario.supports or {})[group]
    foot = foot_of(scenario, given)
    underside = 0.0 if scenario.load is None else scenario.load.position[2]
    return max(underside if one.is_cut else foot + one.height for one in supports_of(group, given))


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
            sentence = f"'{key}' is not a support of the grid, number along x and number along y"
            findings.add((*path, "each", key), f"{sentence}; {nearest(key, own)}")
    for key in {key for key in own if own.count(key) > 1}:
        findings.add((*path, "places", key), f"'{key}' is a support of the grid already")
    for one in supports:
        if one.height <= 0.0 and not one.is_cut:
            right = "'height: 1.5 m' is usual, and 'height: to_load' is up to the load"
            findings.add((*path, "height"), f"the height of '{one.name}' is not known; {right}")
            break
    for one in supports:
        if one.removed_at is not None and one.removed_at > scenario.duration:
            sentence = f"'{one.name}' is taken away at {one.removed_at:g} s, after the end of the lift"
            findings.add(path, f"{sentence} at {scenario.duration:g} s")
    _check_over_dock(findings, name, group)
    return [one.name for one in supports]


def _in_world(findings: Findings, group: Supports, one: Support) -> tuple[float, float]:
    """Where the middle of a support is at the start [m]."""
    load = findings.scenario.load
    heading, from_x, from_y = group.heading, 0.0, 0.0
    if load is not None and group.measured_from == "load":
        heading, (from_x, from_y, _) = load.heading, load.position
    cos, sin = math.cos(heading), math.sin(heading)
    return from_x + cos * one.at[0] - sin * one.at[1], from_y + sin * one.at[0] + cos * one.at[1]


def check_beside(findings: Findings, least: Sequence[float], most: Sequence[float]) -> None:
    """Note supports inside a box of these least and largest x, y, z from the datum at the start [m].

    A load that is set down on supports may be beside them before, and nothing but this says that it is not.
    """
    load = findings.scenario.load
    if load is None:
        return
    for name, group in (findings.scenario.supports or {}).items():
        foot = foot_of(findings.scenario, group)
        cos, sin = math.cos(load.heading), math.sin(load.heading)
        underside, top = (load.position[2] + end[2] for end in (least, most))
        for one in supports_of(name, group):
            level = foot + one.height
            x, y = (at - of for at, of in zip(_in_world(findings, group, one), load.position, strict=False))
            along, across = cos * x + sin * y, cos * y - sin * x
            is_over = least[0] < along < most[0] and least[1] < across < most[1]
            if is_over and foot < top and level > underside + _INSIDE:
                sentence = f"'{one.name}' stands inside the load at the start: its top is at {level:g} m, the"
                right = "move it to where the load comes down, or the load to where it starts"
                findings.add(
                    ("supports", name), f"{sentence} underside of the load at {underside:g} m; {right}"
                )
                break


def _check_over_dock(findings: Findings, name: str, group: Supports) -> None:
    """Note a support whose middle is over the dock, where nothing says that its foot is on the floor."""
    load, dock = findings.scenario.load, dock_of(findings.scenario)
    if dock is None or load is None or group.foot is not None:
        return
    for one in supports_of(name, group):
        x, y = _in_world(findings, group, one)
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
                findings.add(("supports", group), f"{sentence}, which is at {from_to}; {_LATER}")
