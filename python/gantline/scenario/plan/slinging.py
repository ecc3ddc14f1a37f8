"""Slings that steps of the plan take off and put on, ropes that they cut."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from gantline.scenario.errors import nearest
from gantline.scenario.plan.steps import HoistStep

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings
    from gantline.scenario.model import Scenario
    from gantline.scenario.plan.plan import Step
    from gantline.scenario.rigging import Rigging, SlingRigging

__all__ = [
    "check_put_on",
    "check_slinging",
    "check_waits",
    "first_put_on",
    "ropes_cut",
    "slings_on",
    "starts_off",
]

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
    """Names of the slings that are on, not cut, by step of the plan; what a step does as it begins counts."""
    on = set(scenario.slings or {}) - starts_off(scenario)
    for step, cut in zip(scenario.plan, ropes_cut(scenario), strict=True):
        on = (on - _named(step.detach)) | _named(step.attach)
        yield frozenset(on - _named(cut))


def ropes_cut(scenario: Scenario) -> Iterator[frozenset[str]]:
    """Names of the ropes that steps have cut, by step of the plan; those that a step cuts count in it."""
    cut: set[str] = set()
    for step in scenario.plan:
        cut |= set(step.cut)
        yield frozenset(cut)


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
    """Note what is wrong with slings that are taken off and put on, and with ropes that are cut.

    Args:
        findings: where problems go.
        known: names of all ropes.
        loose: those of them that can be taken off.
    """
    scenario = findings.scenario
    slings = [f"{_PREFIX}{name}" for name in scenario.slings or {}]
    off = {f"{_PREFIX}{name}" for name in starts_off(scenario)}
    ropes = _Ropes(list(known), slings, list(loose), off)
    for place, step in enumerate(scenario.plan):
        for key, wrong in (("detach", ropes.taken_off), ("attach", ropes.put_on), ("cut", ropes.parted)):
            for rope in getattr(step, key):
                sentence = wrong(rope, step)
                if sentence is not None:
                    findings.add(("plan", place, key), sentence)
        waits = step.until if step.until is not None and step.until.slings is not None else None
        for rope in waits.of if waits is not None else ():
            path = ("plan", place, "until", "of")
            if rope in ropes.cut:
                findings.add(path, f"'{rope}' has been cut by then; wait for slings that are on")
            elif rope in ropes.off and rope in slings:
                findings.add(path, f"'{rope}' is not on in this step; wait for slings that are")


@dataclass
class _Ropes:
    """What steps have done with ropes so far; of what one does to a rope a sentence where it is wrong.

    Attributes:
        known: names of all ropes.
        slings: those of slings.
        loose: those that can be taken off.
        off: slings and ropes that are not on.
        cut: ropes that have been cut.
    """

    known: list[str]
    slings: list[str]
    loose: list[str]
    off: set[str]
    cut: set[str] = field(default_factory=set)

    def taken_off(self, rope: str, step: Step) -> str | None:
        """A step takes one off."""
        was_off = rope in self.off
        self.off.add(rope)
        if rope not in self.known:
            return f"'{rope}' is not a rope; {nearest(rope, self.loose)}"
        if rope not in self.loose:
            sentence = f"'{rope}' cannot be taken off; slings and ropes of 'mechanics' can"
            return f"{sentence}. 'cut' parts any rope"
        if rope in self.cut:
            return f"'{rope}' has been cut before; there is nothing to take off"
        return f"'{rope}' has been taken off already; once is right" if was_off else None

    def put_on(self, rope: str, step: Step) -> str | None:
        """A step puts one on."""
        was_off = rope in self.off
        self.off.discard(rope)
        if rope not in self.known:
            return f"'{rope}' is not a rope; {nearest(rope, self.slings)}"
        if rope not in self.slings:
            return f"'{rope}' cannot be put on; slings can"
        for order, others in (("taken off and put on", step.detach), ("put on and cut", step.cut)):
            if rope in others:
                right = "a step for each, with what moves between them, is right"
                return f"'{rope}' is {order} by one step; {right}"
        if rope in self.cut:
            return f"'{rope}' has been cut before, and stays so; put another sling on"
        return None if was_off else f"'{rope}' is on already; 'detach' takes it off"

    def parted(self, rope: str, step: Step) -> str | None:
        """A step cuts one."""
        if rope in self.off:
            return f"'{rope}' is not on then; cut it while it is"
        was_cut = rope in self.cut
        self.cut.add(rope)
        if rope not in self.known:
            return f"'{rope}' is not a rope; {nearest(rope, self.known)}"
        return f"'{rope}' has been cut already; once is right" if was_cut else None


def check_put_on(findings: Findings, rigging: Rigging) -> None:
    """Note slings that cannot be put on: with nodes, or between gear that would fall without them."""
    for place, step in enumerate(findings.scenario.plan):
        for rope in step.attach:
            sling = rigging.slings.get(rope.removeprefix(_PREFIX)) if rope.startswith(_PREFIX) else None
            why = None if sling is None else _why_not(rigging, sling)
            if why is not None:
                findings.add(("plan", place, "attach"), f"'{rope}' cannot be put on: {why}")


def check_waits(findings: Findings, rigging: Rigging) -> None:
    """Note steps that wait for slings, without naming any, or for what slings do, while none is on."""
    scenario = findings.scenario
    # Bodies and ropes of `mechanics` may lift a load too, and water.
    lifts_by_slings = scenario.mechanics is None and scenario.vessels is None
    for place, (step, on) in enumerate(zip(scenario.plan, slings_on(scenario), strict=True)):
        condition = step.until
        if condition is None or not rigging.slings:
            continue
        asked = condition.of or tuple(rigging.equalizers)
        path = ("plan", place, "until")
        if condition.slings is not None and not condition.of and not on:
            findings.add(path, "this waits for slings, and none is on in this step; 'attach' puts slings on")
        lifted = condition.load_transferred is not None or condition.supports == "clear"
        if isinstance(step, HoistStep) and lifted and lifts_by_slings and not on:
            sentence = "this waits for the load to leave its supports, and no sling is on in this step"
            findings.add(path, f"{sentence}; 'attach' puts slings on")
        if condition.tension_spread is not None and not any(
            sling.equalizer in asked and name in on for name, sling in rigging.slings.items()
        ):
            sentence = "this waits for slings of equalizers, and none of them is on in this step"
            findings.add(path, f"{sentence}; 'attach' puts slings on")


def _why_not(rigging: Rigging, sling: SlingRigging) -> str | None:
    """Why a sling cannot be put on; None where it can."""
    if sling.over is not None or not sling.lugs:
        held = sling.over or sling.ends[0].held
        return f"'{held}' would fall without it; slings to lugs of the load can be put on"
    if sling.weight.nodes:
        return "it has nodes, and would have to lie somewhere before; 'rope_weight: lumped' is right"
    if sling.equalizer is not None and not rigging.equalizers[sling.equalizer].has_sheaves:
        return f"'{sling.equalizer}' adjusts lengths all the time; 'mechanism: sheaves' is right"
    return None
