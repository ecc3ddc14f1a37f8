"""Slings that steps of the plan take off and put on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from gantline.scenario.errors import nearest

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings, Path
    from gantline.scenario.model import Scenario
    from gantline.scenario.rigging import Rigging, SlingRigging

__all__ = ["check_put_on", "check_slinging", "first_put_on", "slings_on", "starts_off"]

_PREFIX = "sling."


def starts_off(scenario: Scenario) -> frozenset[str]:
    """Slings that are not on at the start, by their names: a step puts them on before any takes them off."""
    first: dict[str, bool] = {}
    for step in scenario.plan:
        for rope in step.detach:
            first.setdefault(rope, False)
        for rope in step.attach:
            first.setdefault(rope, True)
    return frozenset(rope.removeprefix(_PREFIX) for rope, is_put_on in first.items() if is_put_on)


def slings_on(scenario: Scenario) -> Iterator[frozenset[str]]:
    """Names of the slings that are on, by step of the plan; what a step does as it begins counts in it."""
    on = set(scenario.slings or {}) - starts_off(scenario)
    for step in scenario.plan:
        on = (on - _named(step.detach)) | _named(step.attach)
        yield frozenset(on)


def first_put_on(scenario: Scenario) -> dict[str, int]:
    """Of every sling that is not on at the start, the step of the plan that puts it on."""
    found: dict[str, int] = {}
    off = starts_off(scenario)
    for place, step in enumerate(scenario.plan):
        for name in sorted(_named(step.attach) & off):
            found.setdefault(name, place)
    return found


def _named(ropes: Iterable[str]) -> set[str]:
    return {rope.removeprefix(_PREFIX) for rope in ropes}


def check_slinging(findings: Findings, known: Iterable[str], loose: Iterable[str]) -> None:
    """Note what is wrong with slings that are taken off and put on.

    Args:
        findings: where problems go.
        known: names of all ropes.
        loose: those of them that can be taken off.
    """
    scenario = findings.scenario
    slings = [f"{_PREFIX}{name}" for name in scenario.slings or {}]
    known, loose = list(known), list(loose)
    off = {f"{_PREFIX}{name}" for name in starts_off(scenario)}
    for place, step in enumerate(scenario.plan):
        path: Path = ("plan", place, "detach")
        for rope in step.detach:
            if rope not in known:
                findings.add(path, f"'{rope}' is not a rope; {nearest(rope, loose)}")
            elif rope not in loose:
                sentence = f"'{rope}' cannot be taken off; slings and ropes of 'mechanics' can"
                findings.add(path, f"{sentence}. 'cut' parts any rope")
            elif rope in off:
                findings.add(path, f"'{rope}' has been taken off already; once is right")
            off.add(rope)
        path = ("plan", place, "attach")
        for rope in step.attach:
            if rope not in known:
                findings.add(path, f"'{rope}' is not a rope; {nearest(rope, slings)}")
            elif rope not in slings:
                findings.add(path, f"'{rope}' cannot be put on; slings can")
            elif rope in step.detach:
                sentence = f"'{rope}' is taken off and put on by one step"
                findings.add(path, f"{sentence}; a step for each, with what moves between them, is right")
            elif rope not in off:
                findings.add(path, f"'{rope}' is on already; 'detach' takes it off")
            off.discard(rope)
        for rope in step.cut:
            if rope in off and rope in slings:
                findings.add(("plan", place, "cut"), f"'{rope}' is not on then; cut it while it is")
        waits = step.until if step.until is not None and step.until.slings is not None else None
        for rope in waits.of if waits is not None else ():
            if rope in off and rope in slings:
                sentence = f"'{rope}' is not on in this step"
                findings.add(("plan", place, "until", "of"), f"{sentence}; wait for slings that are")


def check_put_on(findings: Findings, rigging: Rigging) -> None:
    """Note slings that cannot be put on: with nodes, or between gear that would fall without them."""
    for place, step in enumerate(findings.scenario.plan):
        for rope in step.attach:
            sling = rigging.slings.get(rope.removeprefix(_PREFIX)) if rope.startswith(_PREFIX) else None
            why = None if sling is None else _why_not(rigging, sling)
            if why is not None:
                findings.add(("plan", place, "attach"), f"'{rope}' cannot be put on: {why}")


def _why_not(rigging: Rigging, sling: SlingRigging) -> str | None:
    """Why a sling cannot be put on; None where it can."""
    if sling.over is not None or not sling.lugs:
        held = sling.over or sling.ends[0].extension or sling.ends[0].spreader
        return f"'{held}' would fall without it; slings to lugs of the load can be put on"
    if sling.weight.nodes:
        return "it has nodes, and would have to lie somewhere before; 'rope_weight: lumped' is right"
    if sling.equalizer is not None and not rigging.equalizers[sling.equalizer].has_sheaves:
        return f"'{sling.equalizer}' adjusts lengths all the time; 'mechanism: sheaves' is right"
    return None
