"""Whether what the plan pumps is there, and finds room."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.hooks import full_name
from gantline.scenario.steps import PumpStep
from gantline.scenario.tanks import SEA, bodies_afloat, ends_of_pump, sea_density, tanks_of
from gantline.scenario.water import BallastTank

__all__ = ["check_contents", "check_pump"]

_ROUNDING = 1 + 1e-9


def check_pump(findings: Findings, place: int, step: PumpStep) -> set[str]:
    """Note what is wrong with where a step pumps; returns the tanks that it moves."""
    scenario = findings.scenario
    path: Path = ("plan", place, "pump")
    known = tanks_of(scenario)
    for key, text in (("from", step.pump.from_), ("to", step.pump.to)):
        if text == SEA:
            if all(body.hull is None for body in bodies_afloat(scenario).values()):
                findings.add((*path, key), "there is no sea in this file: nothing in it has a hull")
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
    return {name for name in (source, target) if name is not None}


@dataclass
class _Content:
    """What may be in a tank, least and most [kg]."""

    least: float
    most: float


def check_contents(findings: Findings) -> None:
    """Note steps for which a tank has too little in it, or too little room, where that is known before."""
    scenario = findings.scenario
    known = tanks_of(scenario)
    contents = {name: _Content(tank.content, tank.content) for name, tank in known.items()}
    for place, step in enumerate(scenario.plan):
        if isinstance(step, PumpStep):
            source, target = ends_of_pump(scenario, step)
            if step.by is not None:
                _check_amount(findings, place, step.by, known, contents)
            _pump(step, known, contents, source, target)


def _check_amount(
    findings: Findings,
    place: int,
    amount: float,
    known: Mapping[str, BallastTank],
    contents: Mapping[str, _Content],
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


def _pump(
    step: PumpStep,
    known: Mapping[str, BallastTank],
    contents: Mapping[str, _Content],
    source: str | None,
    target: str | None,
) -> None:
    """Contents after a step; one that waits for something may pump anything or nothing."""
    least, most = (0.0, float("inf")) if step.by is None else (step.by, step.by)
    if source is not None:
        one = contents[source]
        one.least, one.most = max(one.least - most, 0.0), max(one.most - least, 0.0)
    if target is not None:
        one, capacity = contents[target], known[target].capacity
        one.least, one.most = min(one.least + least, capacity), min(one.most + most, capacity)
