"""Whether spreaders and compensators are bodies that can exist, and hang where they say."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario.consistency.load import check_inertia, check_lug_type
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.spreader import Spreader
from gantline.scenario.rigging import Rigging, SlingRigging

__all__ = ["check_compensators", "check_spreaders"]

#: Lugs stand on a spreader or a little off it, at most by this share of its longest side.
_OFF = 0.5
_MEASURED = "positions are measured from the middle of its box"


def check_spreaders(findings: Findings, rigging: Rigging) -> None:
    """Note spreaders that nothing holds or that hang in a circle, and what is wrong with them as bodies."""
    for name, spreader in (findings.scenario.spreaders or {}).items():
        _check_body(findings, name, spreader)
        _check_hanging(
            findings, rigging, ("spreaders", name), "'to' one of its lugs", "'from' one of its lugs"
        )


def check_compensators(findings: Findings, rigging: Rigging) -> None:
    """Note compensators that nothing holds, that hold nothing, or that hang in a circle."""
    for name in findings.scenario.compensators or {}:
        _check_hanging(
            findings, rigging, ("compensators", name), f"with 'to: {name}'", f"with 'from: {name}'"
        )


def _check_hanging(findings: Findings, rigging: Rigging, path: Path, holds: str, hangs: str) -> None:
    """Of gear at a path: that slings hold it and hang from it, each as it would be right, and no circle."""
    name = str(path[-1])
    if not list(_held_by(rigging, name)):
        findings.add(path, f"no sling holds it; a sling {holds} does")
    elif not any(name in (sling.spreader, sling.compensator) for sling in rigging.slings.values()):
        findings.add(path, f"nothing hangs from it; a sling {hangs} does")
    elif (circle := _circle(rigging, name)) is not None:
        sentence = f"hangs in a circle ({' -> '.join(circle)})"
        findings.add(path, f"{sentence}; at the top there is a moving sheave or a hook")


def _check_body(findings: Findings, name: str, spreader: Spreader) -> None:
    path = ("spreaders", name)
    for lug_name, lug in spreader.lugs.items():
        check_lug_type(findings, (*path, "lugs", lug_name), lug)
        off = spreader.off(lug.at)
        if off > _OFF * max(spreader.size):
            sentence = f"this lug is {off:g} m outside the spreader's box"
            findings.add((*path, "lugs", lug_name, "at"), f"{sentence}; {_MEASURED}")
    if spreader.off(spreader.centre_of_gravity) > 0.0:
        x, y, z = spreader.centre_of_gravity
        sentence = f"({x:g}, {y:g}, {z:g}) m is outside the spreader's box; {_MEASURED}"
        findings.add((*path, "centre_of_gravity"), sentence)
    if spreader.inertia is not None:
        check_inertia(findings, (*path, "inertia"), spreader.inertia)


def _held_by(rigging: Rigging, name: str) -> Iterator[SlingRigging]:
    """Slings that lead down to a spreader or compensator."""
    for sling in rigging.slings.values():
        if any(name in (end.spreader, end.compensator) for end in sling.ends):
            yield sling


def _above(rigging: Rigging, name: str) -> Iterator[str]:
    """Spreaders and compensators that hold one of them, by slings and extension sheaves."""
    for sling in _held_by(rigging, name):
        over, passed = sling.over, set[str]()
        while over in rigging.extensions and over not in passed:
            passed.add(over)
            sling = rigging.slings[rigging.extensions[over].hangs_on]
            over = sling.over
        if (holder := sling.spreader or sling.compensator) is not None:
            yield holder


def _circle(rigging: Rigging, name: str) -> list[str] | None:
    """From a spreader or compensator upwards and back to it, if that is a way."""
    todo = [[name]]
    while todo:
        chain = todo.pop()
        for above in _above(rigging, chain[-1]):
            if above == name:
                return [*chain, name]
            if above not in chain:
                todo.append([*chain, above])
    return None
