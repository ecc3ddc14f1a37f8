"""Whether hinges of the load fit the rest of the lift."""

from __future__ import annotations

from gantline.scenario.cranes.crane_parts import crane_bodies
from gantline.scenario.cranes.hooks import hooks_of
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.hinge import LoadHinge, opened_in
from gantline.scenario.model import Scenario

__all__ = ["check_hinges"]


def check_hinges(findings: Findings) -> None:
    """Note everything that is wrong with hinges, and with steps that open them."""
    scenario = findings.scenario
    hinges = scenario.hinges or {}
    if hinges and scenario.load is None:
        sentence = "there is no 'load' for a hinge to hold"
        findings.add(("hinges",), f"{sentence}; joints of bodies belong under 'mechanics'")
        return
    for name in list(hinges)[1:]:
        first = next(iter(hinges))
        sentence = f"'{first}' holds the load already, and a load turns in one hinge"
        findings.add(("hinges", name), f"{sentence}; two in one line are one, 'at' in the middle of both")
    for name, hinge in hinges.items():
        _check_hinge(findings, ("hinges", name), hinge)
        _check_friction(findings, name, hinge)
    if hinges and scenario.start == "settled":
        sentence = "'settled' is for a load that lies free, and a hinge holds this one"
        findings.add(("start",), f"{sentence}; 'start: rest' is right")
    if hinges:
        findings.refuse_explicit("hinges of loads")
    _check_plan(findings)


def _check_hinge(findings: Findings, path: Path, hinge: LoadHinge) -> None:
    scenario = findings.scenario
    hooks = hooks_of(scenario.cranes or {}, scenario.hook_types or {})
    known = [
        *(scenario.vessels or {}),
        *(one for one in crane_bodies(scenario.cranes or {}) if one not in hooks),
    ]
    if hinge.held_by is not None and hinge.held_by not in (*known, "world"):
        right = "leave it out for a hinge in the yard" if not known else nearest(hinge.held_by, known)
        findings.add((*path, "held_by"), f"{_no_holder(scenario, hinge.held_by)}; {right}")
    if not any(hinge.axis):
        findings.add((*path, "axis"), "found [0, 0, 0], which points nowhere; [0, 1, 0] is across the load")


def _no_holder(scenario: Scenario, name: str) -> str:
    """What stands under a name that cannot hold a hinge."""
    if scenario.load is not None and name == scenario.load.name:
        return "the load cannot hold its own hinge"
    if name in hooks_of(scenario.cranes or {}, scenario.hook_types or {}):
        return f"'{name}' is a hook, and a hinge stands on a vessel or another part of a crane"
    if scenario.mechanics is not None and name in scenario.mechanics.bodies:
        instead = "ropes of 'mechanics' from it to the load carry its foot"
        return f"'{name}' is a body of 'mechanics', and holds no hinge: {instead}"
    return f"'{name}' is not a vessel or a part of a crane"


def _check_friction(findings: Findings, name: str, hinge: LoadHinge) -> None:
    """One that opens has none: the load would feel it hanging in its slings."""
    if hinge.friction > 0.0 and opened_in(findings.scenario, name):
        sentence = f"'{name}' has friction, and a step opens it: the load would feel it when it hangs free"
        findings.add(("hinges", name, "friction"), f"{sentence}; leave 'friction' out, or 'open_hinges'")


def _check_plan(findings: Findings) -> None:
    scenario = findings.scenario
    hinges, opened = scenario.hinges or {}, dict[str, str]()
    first = _first_steps(scenario) if scenario.starts_at_rest else set()
    for place, step in enumerate(scenario.plan):
        path: Path = ("plan", place, "open_hinges")
        for name in step.open_hinges:
            if name not in hinges:
                right = nearest(name, hinges) if hinges else "the lift has no 'hinges'"
                findings.add(path, f"'{name}' is not a hinge; {right}")
            elif place in first:
                sentence = f"'{name}' opens as the lift begins, so nothing tells what it lets go"
                findings.add(path, f"{sentence}; a 'hold' step before it does")
            elif name in opened:
                findings.add(path, f"step '{opened[name]}' has opened '{name}' already; a hinge opens once")
            opened.setdefault(name, step.step)
        shut = [name for name in hinges if name not in opened]
        if shut and getattr(step, "keep_plumb", None):
            sentence = f"hinge '{shut[0]}' holds the load, and falls askew; nothing is followed"
            findings.add(("plan", place, "keep_plumb"), f"{sentence}: 'to' or 'by' gives the way")
        until = getattr(step, "until", None)
        if shut and until is not None and until.load_transferred is not None:
            sentence = "a hinge bears a part of the load, which no step can wait for"
            right = "wait for 'supports: clear', 'load_tilt' or 'hoist_load'"
            findings.add(("plan", place, "until", "load_transferred"), f"{sentence}; {right}")


def _first_steps(scenario: Scenario) -> set[int]:
    """Places of the steps that begin as the lift does."""
    found: set[int] = set()
    for place, step in enumerate(scenario.plan):
        beside = place - 1 in found and getattr(step, "starts", None) == "with_previous"
        if not getattr(step, "start_at", None) and (place == 0 or beside):
            found.add(place)
    return found
