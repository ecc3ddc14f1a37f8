"""To what the ends of slings lead: words of the lift file looked up."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.extension import SlingEnd
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.spreader import spreader_lugs
from gantline.scenario.model import Scenario

__all__ = ["Upper", "lower_end", "split_reference", "upper_end"]


class Upper(NamedTuple):
    """From what a sling hangs."""

    hook: str = ""
    equalizer: str | None = None
    sheave: int | None = None
    spreader: str | None = None
    upper_lug: str | None = None
    compensator: str | None = None


def split_reference(text: str, owners: Iterable[str]) -> tuple[str, str] | None:
    """Owner and member of a dotted name, the longest owner first; None if no owner fits."""
    fitting = [owner for owner in owners if text.startswith(owner + ".") and len(text) > len(owner) + 1]
    if not fitting:
        return None
    owner = max(fitting, key=len)
    return owner, text[len(owner) + 1 :]


def upper_end(findings: Findings, text: str, path: Path) -> Upper | None:
    """From what a sling hangs; None, and a note, if that is not there."""
    hooks, equalizers = findings.scenario.hooks, findings.scenario.equalizers or {}
    if text in hooks:
        return Upper(text)
    of_spreader = _lug_of_spreader(findings.scenario, text)
    if of_spreader is not None:
        return Upper(spreader=of_spreader[0], upper_lug=of_spreader[1])
    compensators = findings.scenario.compensators or {}
    if text in compensators:
        return Upper(compensator=text)
    split = split_reference(text, equalizers)
    hook = full_name(text, hooks) if split is None else None
    if hook is not None:
        return Upper(hook)
    if split is None:
        lugs = spreader_lugs(findings.scenario)
        holders = [*(f"{name}.1" for name in equalizers), *hooks, *lugs, *compensators]
        kinds = "neither a moving sheave nor a hook"
        if lugs or compensators:
            others = ["no lug of a spreader"] * bool(lugs) + ["no compensator"] * bool(compensators)
            kinds = " and ".join([", ".join(["no moving sheave, no hook", *others[:-1]]), others[-1]])
        sentence = f"'{text}' is {kinds}; {nearest(text, holders)}"
        findings.add(path, sentence)
        return None
    name, sheave = split
    count = _count_of_moving_sheaves(findings.scenario, name)
    if count is None:
        return None  # the equalizer itself has been reported
    if (
        not sheave.isascii()
        or not sheave.isdecimal()
        or str(int(sheave)) != sheave
        or not 1 <= int(sheave) <= count
    ):
        sentence = f"'{name}' has no moving sheave '{sheave}'; it has '{name}.1' to '{name}.{count}'"
        findings.add(path, sentence)
        return None
    above = equalizers[name].hangs_from
    return Upper(full_name(above, hooks) or above, name, int(sheave))


def _count_of_moving_sheaves(scenario: Scenario, name: str) -> int | None:
    given = (scenario.equalizers or {})[name]
    sheaves = given.moving_sheaves
    if sheaves is None and given.type is not None and given.type in (scenario.equalizer_types or {}):
        sheaves = (scenario.equalizer_types or {})[given.type].moving_sheaves
    return None if sheaves is None else len(sheaves.along)


def lower_end(findings: Findings, text: str, path: Path) -> SlingEnd | None:
    """To what the lower end of a sling leads; None, and a note, if that is not there."""
    if text in (findings.scenario.extension_sheaves or {}):
        return SlingEnd(None, text)
    if text in (findings.scenario.compensators or {}):
        return SlingEnd(None, None, compensator=text)
    of_spreader = _lug_of_spreader(findings.scenario, text)
    if of_spreader is not None:
        return SlingEnd(of_spreader[1], None, of_spreader[0])
    lug = _lug(findings, text, path)
    return None if lug is None else SlingEnd(lug, None)


def _lug(findings: Findings, text: str, path: Path) -> str | None:
    load = findings.scenario.load
    if load is None:
        findings.add(path, f"'{text}' is not a lug; there is no 'load' in this file")
        return None
    split = split_reference(text, [load.name])
    if split is not None and split[1] in load.lugs:
        return split[1]
    known = [f"{load.name}.{lug}" for lug in load.lugs]
    known += [*(findings.scenario.extension_sheaves or {}), *spreader_lugs(findings.scenario)]
    known += findings.scenario.compensators or {}
    findings.add(path, f"'{text}' is not a lug; {nearest(text, known)}")
    return None


def _lug_of_spreader(scenario: Scenario, text: str) -> tuple[str, str] | None:
    """Spreader and lug of a dotted name; None if it is no lug of a spreader."""
    spreaders = scenario.spreaders or {}
    split = split_reference(text, spreaders)
    return split if split is not None and split[1] in spreaders[split[0]].lugs else None
