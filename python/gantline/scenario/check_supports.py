"""Whether supports and structures can stand where they are said to, and pairs that are watched make sense."""

from __future__ import annotations

from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.load import Load
from gantline.scenario.model import Scenario
from gantline.scenario.structures import Dock
from gantline.scenario.supports import Supports, supports_of

__all__ = ["check_supports", "foot_of", "top_of"]

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
        if load is not None and group.measured_from == "load":
            _check_place(findings, load, path, one.name, one.at)
        if one.removed_at is not None and one.removed_at > scenario.duration:
            sentence = f"'{one.name}' is taken away at {one.removed_at:g} s, after the end of the lift"
            findings.add(path, f"{sentence} at {scenario.duration:g} s")
    return [one.name for one in supports]


def _check_place(
    findings: Findings, load: Load, path: tuple[str, ...], name: str, at: tuple[float, float]
) -> None:
    length, breadth, _ = load.shape.box
    if abs(at[0]) > length / 2 * (1 + _ROUNDING) or abs(at[1]) > breadth / 2 * (1 + _ROUNDING):
        sentence = f"'{name}' at ({at[0]:g}, {at[1]:g}) m is not under the load"
        findings.add(path, f"{sentence}, which is {length:g} by {breadth:g} m about its datum")
