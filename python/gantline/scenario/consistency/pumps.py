"""Whether what the plan pumps is there, and finds room."""

from __future__ import annotations

from collections.abc import Mapping

from gantline.scenario.afloat.tanks import (
    SEA,
    Contents,
    contents_along,
    contents_of_load,
    ends_of_pump,
    has_sea,
    holed_tanks,
    load_tanks,
    sea_density,
    tanks_of,
)
from gantline.scenario.afloat.water import BallastTank
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.plan.steps import PumpStep

__all__ = ["check_contents", "check_pump", "check_shares"]

_ROUNDING = 1 + 1e-9
#: Share of a content that is rounding [1].
_ROUNDED = 1e-12


def check_pump(findings: Findings, place: int, step: PumpStep) -> set[str]:
    """Note what is wrong with where a step pumps; returns the tanks that it moves."""
    scenario = findings.scenario
    path: Path = ("plan", place, "pump")
    known = tanks_of(scenario)
    for key, text in (("from", step.pump.from_), ("to", step.pump.to)):
        if text == SEA:
            # What runs out of a load runs over board, or onto the ground; of no tank it is told below.
            source = full_name(step.pump.from_, known)
            needs_none = key == "to" and (source is None or source in load_tanks(scenario))
            if not has_sea(scenario) and not needs_none:
                sentence = "there is no sea in this file: nothing in it has a hull, and it has no 'water'"
                findings.add((*path, key), f"{sentence}; 'water: {{level: 0 m}}' says where it is")
        elif full_name(text, known) is None:
            sentence = f"'{text}' is not a tank, nor 'sea'; {nearest(text, [*known, SEA])}"
            findings.add((*path, key), sentence)
    source, target = ends_of_pump(scenario, step)
    if step.pump.from_ == step.pump.to or (source is not None and source == target):
        findings.add(path, f"'{step.pump.from_}' is pumped into itself; 'from' and 'to' are two")
    elif target is not None and (source is not None or step.pump.from_ == SEA):
        pumped = sea_density(scenario) if source is None else known[source].density
        if abs(pumped - known[target].density) > 1e-9 * pumped:
            sentence = f"liquid of {pumped:g} kg/m^3 would be pumped into a tank with"
            findings.add((*path, "to"), f"{sentence} {known[target].density:g} kg/m^3; give it the same")
    moved = {name for name in (source, target) if name is not None}
    for name in sorted(moved & set(holed_tanks(scenario))):
        sentence = f"'{name}' has holes, through which it drains or floods by itself"
        findings.add(path, f"{sentence}; leave its 'holes' out, or do not pump it")
    return moved


def check_contents(findings: Findings) -> None:
    """Note steps for which a tank has too little in it, or too little room, where that is known before."""
    scenario = findings.scenario
    known = tanks_of(scenario)
    for place, (step, contents) in enumerate(zip(scenario.plan, contents_along(scenario), strict=False)):
        if isinstance(step, PumpStep) and step.by is not None:
            _check_amount(findings, place, step.by, known, contents)


def check_shares(findings: Findings) -> None:
    """Note steps that wait for a share of the load's weight while nobody knows how much is in its tanks."""
    scenario = findings.scenario
    for place, (step, contents) in enumerate(zip(scenario.plan, contents_of_load(scenario), strict=True)):
        waits = step.until is not None and step.until.load_transferred is not None
        if waits and contents.most - contents.least > _ROUNDED * contents.most:
            least, most = (f"{one / 1e3:.6g} t" for one in (contents.least, contents.most))
            sentence = f"this waits for a share of a weight that changes: from {least} to {most} may be in"
            right = "wait for 'supports' or 'hoist_load'"
            if not set(load_tanks(scenario)) & set(holed_tanks(scenario)):
                right += ", or pump 'by' an amount in a step of its own before"
            findings.add(("plan", place, "until"), f"{sentence} the tanks of the load by then; {right}")


def _check_amount(
    findings: Findings,
    place: int,
    amount: float,
    known: Mapping[str, BallastTank],
    contents: Mapping[str, Contents],
) -> None:
    step = findings.scenario.plan[place]
    assert isinstance(step, PumpStep)
    source, target = ends_of_pump(findings.scenario, step)
    path: Path = ("plan", place, "by")
    if source is not None and amount > contents[source].most * _ROUNDING:
        sentence = f"'{source}' would run empty: {amount / 1e3:g} t are pumped from it"
        findings.add(path, f"{sentence}, and {contents[source].most / 1e3:.6g} t are in it then")
    if target is not None:
        room = known[target].capacity - contents[target].least
        if amount > room * _ROUNDING:
            sentence = f"'{target}' would run over: {amount / 1e3:g} t are pumped into it"
            findings.add(path, f"{sentence}, and there is room for {room / 1e3:.6g} t then")
