"""Cases into scenarios: the lift file's tree with one thing changed, validated and checked like any."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from gantline.scenario.afloat.mooring import line_rope
from gantline.scenario.errors import PathPart, Problem, ScenarioError, nearest
from gantline.scenario.file.case import ENVELOPE, TOLERANCE, Case
from gantline.scenario.file.from_tree import from_tree
from gantline.scenario.file.tree import MapNode, Node, TextNode, like, line_of
from gantline.scenario.file.tree_path import PathError, line_at, node_at, node_of, put, text_node
from gantline.scenario.file.types import filled_in
from gantline.scenario.findings import Findings
from gantline.scenario.model import Scenario
from gantline.scenario.rigging import resolve
from gantline.scenario.tag_line import tag_rope
from gantline.units import UnitError, common_dimension, quantity, si_text

__all__ = [
    "Variant",
    "changed",
    "check_cases",
    "tolerances",
    "variants_of",
    "with_lengths",
    "with_ropes_cut",
    "with_value",
    "with_values",
    "without_cases",
]

#: Most combinations of offsets that one case may ask for.
_MOST: Final = 256
_AXES: Final = ("x", "y", "z")


@dataclass(frozen=True)
class Variant:
    """One lift of a case.

    Attributes:
        label: what is different in it, short; empty where the case has only this one.
        scenario: the lift, without cases.
    """

    label: str
    scenario: Scenario


def check_cases(scenario: Scenario) -> None:
    """Check what the cases of a scenario change.

    Raises:
        ScenarioError: with every problem found, at the case that it belongs to.
    """
    findings = Findings(scenario)
    for name, case in (scenario.cases or {}).items():
        try:
            variants_of(scenario, name)
        except ScenarioError as error:
            findings.problems.extend(error.problems)
        if case.vary == TOLERANCE:
            needed = 2 if case.pattern == "worst_pair" else 1
            if len(tolerances(scenario)) < needed:
                sentence = f"slings with a 'tolerance': {len(tolerances(scenario))}, needed: {needed}"
                right = "give 'sling_defaults' one, such as 'tolerance: 0.25 %'"
                findings.add(("cases", name, "vary"), f"{sentence}; {right}")
        if case.cut:
            _check_cut(findings, name, case)
    findings.raise_any()


def variants_of(scenario: Scenario, name: str, *, to_run: bool = False) -> list[Variant]:
    """Lifts of a case that sets or varies quantities; none of one that varies lengths of slings, or cuts.

    Args:
        scenario: the lift.
        name: of the case.
        to_run: whether they start as the lift does. To be asked for an equilibrium they start as given:
            shorter slings, or a higher hook, may pull from the start.

    Raises:
        ScenarioError: if the case asks for what cannot be.
    """
    case = (scenario.cases or {})[name]
    if case.changes is not None:
        path = ("cases", name, "set")
        return [Variant("", _changed(scenario, case.changes, path, to_run=to_run))]
    if case.vary == ENVELOPE:
        return _corners(scenario, name, to_run=to_run)
    if isinstance(case.vary, dict):
        return _offset(scenario, name, case.vary, to_run=to_run)
    return []


def without_cases(scenario: Scenario) -> Scenario:
    """The lift as it is given, without cases."""
    return from_tree(_base(scenario), scenario.source, scenario.file_text).counted_from(scenario)


def with_value(scenario: Scenario, path: str, text: str) -> Scenario:
    """The lift with one value at a dotted path, without cases.

    Raises:
        PathError: if the path leads nowhere.
        ScenarioError: if the value cannot be there.
    """
    return with_values(scenario, {path: text})


def with_values(scenario: Scenario, texts: Mapping[str, str]) -> Scenario:
    """The lift with values at dotted paths, without cases.

    Raises:
        PathError: if a path leads nowhere.
        ScenarioError: if a value cannot be there.
    """
    return _still(_with_texts(scenario, _let_go(scenario), texts), scenario, texts)


def changed(scenario: Scenario, values: Mapping[str, Any]) -> Scenario:
    """The same for users, from where the lift starts; below its text stand the changes.

    A wrong path is a problem of the lift file.

    Raises:
        ScenarioError: if a path leads nowhere, or a value cannot be there.
        TypeError: if the values are no mapping.
    """
    if not isinstance(values, Mapping):
        raise TypeError(f"values: a mapping from paths to values is needed, not {type(values).__name__}")
    known = Scenario.keys()
    for path in values:
        if not isinstance(path, str):
            raise TypeError(f"values: {path!r} is no path; a text such as 'load.weight.calculated' is needed")
        first, *rest = path.split(".")
        if rest and first in known and first not in scenario.tree:
            sentence = f"there is no '{first}' in this file yet; it is given whole: {{'{first}': {{...}}}}"
            raise ScenarioError(scenario.source, [Problem(None, path, sentence)])
    try:
        other = _with_texts(scenario, _base(scenario), values)
    except PathError as problem:
        raise ScenarioError(scenario.source, [Problem(None, "", str(problem))]) from None
    told = "".join(f"# changed: {path}: {text}\n" for path, text in values.items())
    return other.telling(told)


def tolerances(scenario: Scenario) -> dict[str, float]:
    """What the length of each sling may be off, plus and minus [m]; of those that have a tolerance."""
    slings = resolve(scenario).slings.items()
    return {name: sling.tolerance for name, sling in slings if sling.tolerance > 0.0}


def with_lengths(
    scenario: Scenario, name: str, longer: Mapping[str, float], *, to_run: bool = False
) -> Scenario:
    """The lift of a case in which slings are longer than planned [m]; `to_run` as of `variants_of`.

    Raises:
        ScenarioError: if there can be no such slings.
    """
    path = ("cases", name, "vary")
    line = line_of(scenario.tree, path)
    lengths = {sling: one.length for sling, one in resolve(scenario).slings.items()}
    changes: dict[str, Node] = {
        f"slings.{sling}.length": text_node(si_text(lengths[sling] + more, "length"), line)
        for sling, more in longer.items()
    }
    return _changed(scenario, changes, path, to_run=to_run)


def with_ropes_cut(scenario: Scenario, name: str, time: float, *, to_run: bool = False) -> Scenario:
    """The lift of a case in which ropes are cut at a time [s]; `to_run` as of `variants_of`.

    Raises:
        ScenarioError: if they cannot be.
    """
    path = ("cases", name, "cut")
    line = line_of(scenario.tree, path)
    cut: dict[str, Node] = {
        f"{_home(scenario, rope)}.{rope}.cut_at": text_node(si_text(time, "time"), line)
        for rope in (scenario.cases or {})[name].cut
    }
    return _changed(scenario, cut, path, to_run=to_run)


def _corners(scenario: Scenario, name: str, *, to_run: bool) -> list[Variant]:
    path = ("cases", name, "vary")
    load = scenario.load
    margins = load.centre_of_gravity.envelope if load is not None else (0.0, 0.0, 0.0)
    if not any(margins):
        sentence = "the load has no such envelope; give 'centre_of_gravity' one"
        raise scenario.error(path, f"{sentence}, such as 'envelope: [0.1 m, 0.1 m, 0.1 m]'")
    if load is not None and load.centre_of_gravity.at == "from_cad":
        sentence = "the centre of gravity is that of the CAD file; state it in 'load.centre_of_gravity.at'"
        right = "so that it can be varied ('gantline check' without this case says where it is)"
        raise scenario.error(path, f"{sentence} {right}")
    offsets = {
        f"load.centre_of_gravity.at.{axis}": (si_text(-margin, "length"), si_text(margin, "length"))
        for axis, margin in zip(_AXES, margins, strict=True)
        if margin
    }
    shown = [axis for axis, margin in zip(_AXES, margins, strict=True) if margin]
    corners = _offset(scenario, name, offsets, to_run=to_run)
    signs = itertools.product("−+", repeat=len(shown))
    labels = (" ".join(sign + axis for sign, axis in zip(corner, shown, strict=True)) for corner in signs)
    return [Variant(label, one.scenario) for label, one in zip(labels, corners, strict=True)]


def _offset(
    scenario: Scenario, name: str, varied: Mapping[str, Sequence[str]], *, to_run: bool
) -> list[Variant]:
    path = ("cases", name, "vary")
    count = math.prod(len(offsets) for offsets in varied.values())
    if count > _MOST:
        raise scenario.error(path, f"these are {count} combinations; at most {_MOST} are allowed")
    places = {key: [(offset, _plus(scenario, (*path, key), key, offset)) for offset in offsets]
              for key, offsets in varied.items()}  # fmt: skip
    line = line_of(scenario.tree, path)
    variants = []
    for chosen in itertools.product(*places.values()):
        pairs = list(zip(places, chosen, strict=True))
        changes: dict[str, Node] = {key: text_node(text, line) for key, (_, text) in pairs}
        label = ", ".join(f"{key} {_signed(offset)}" for key, (offset, _) in pairs)
        variants.append(Variant(label, _changed(scenario, changes, path, to_run=to_run)))
    return variants


def _plus(scenario: Scenario, path: tuple[PathPart, ...], varied: str, offset: str) -> str:
    """The quantity at a dotted path with an offset added, as text."""
    try:
        given = node_at(filled_in(_base(scenario)), varied)
    except PathError as error:
        raise scenario.error(path, str(error)) from None
    if not isinstance(given, TextNode):
        sentence = "has several values" if given is not None else "is not given in this file"
        right = "name one of its parts" if given is not None else "write it out, so that it can be varied"
        raise scenario.error(path, f"'{varied}' {sentence}; {right}")
    try:
        dimension = common_dimension(given, offset)
    except UnitError as error:
        raise scenario.error(path, str(error)) from None
    return si_text(quantity(given, dimension) + quantity(offset, dimension), dimension)


def _signed(offset: str) -> str:
    text = offset.strip()
    return f"−{text[1:]}" if text.startswith("-") else f"+{text.removeprefix('+')}"


def _changed(
    scenario: Scenario, changes: Mapping[str, Node], path: tuple[PathPart, ...], *, to_run: bool
) -> Scenario:
    """The scenario with nodes put at dotted paths; what is wrong with that is said at a path of the case."""
    tree = _base(scenario) if to_run else _let_go(scenario)
    for place, node in changes.items():
        own = (*path, place) if path[-1] == "set" else path
        try:
            tree = put(tree, place, node)
        except PathError as error:
            raise scenario.error(own, str(error)) from None
    try:
        other = from_tree(tree, scenario.source, scenario.file_text).counted_from(scenario)
    except ScenarioError as error:
        problems = [scenario.problem(path, one.message) for one in error.problems]
        raise ScenarioError(scenario.source, problems) from None
    return other if to_run else _still(other, scenario, changes)


def _still(other: Scenario, scenario: Scenario, places: Collection[str]) -> Scenario:
    """The lift with changes, at rest as the one without is, unless these say how it starts."""
    return other if "start" in places else other.let_go_of(scenario)


def _with_texts(scenario: Scenario, tree: MapNode, texts: Mapping[str, Any]) -> Scenario:
    """The scenario of a tree with values at dotted paths, for which that of `scenario` knows the lines."""
    for path, text in texts.items():
        tree = put(tree, path, node_of(text, line_at(scenario.tree, path)))
    return from_tree(tree, scenario.source, scenario.file_text).counted_from(scenario)


def _base(scenario: Scenario) -> MapNode:
    """The tree of a lift file without its cases."""
    written = scenario.tree_as_written
    return like(written, {key: node for key, node in written.items() if key != "cases"})


def _let_go(scenario: Scenario) -> MapNode:
    """The same, starting as given: shorter slings, or a higher hook, may pull from the start."""
    tree = _base(scenario)
    return tree if scenario.load is None else put(tree, "start", text_node("as_given", tree.line))


def _home(scenario: Scenario, rope: str) -> str:
    """Section of the lift file that holds a rope which can be cut."""
    return "slings" if rope in (scenario.slings or {}) else "mechanics.ropes"


def _check_cut(findings: Findings, name: str, case: Case) -> None:
    scenario = findings.scenario
    plain = scenario.mechanics.ropes if scenario.mechanics is not None else None
    known = [*(scenario.slings or {}), *(plain or {})]
    lines = {line_rope(line): f"mooring_lines.{line}" for line in scenario.mooring_lines or {}}
    lines |= {tag_rope(line): f"tag_lines.{line}" for line in scenario.tag_lines or {}}
    for place, rope in enumerate(case.cut):
        if rope in lines:
            sentence = f"'{rope}' is a line, and a case cuts slings and ropes of 'mechanics'"
            right = f"'set: {{{lines[rope]}.cut_at: 0 s}}' is the lift without it"
            findings.add(("cases", name, "cut"), f"{sentence}; {right}")
        elif rope not in known:
            right = nearest(rope.removeprefix("sling."), known)
            findings.add(("cases", name, "cut"), f"'{rope}' is not a sling; {right}")
        elif rope in case.cut[:place]:
            findings.add(("cases", name, "cut"), f"'{rope}' is cut twice; once is right")
    if case.at is not None and case.at > scenario.duration:
        sentence = f"{case.at:g} s is after the end of the lift at {scenario.duration:g} s"
        findings.add(("cases", name, "at"), sentence)
    steps = [step.step for step in scenario.plan]
    if case.at_step is not None and case.at_step not in steps:
        sentence = f"'{case.at_step}' is not a step of the plan; {nearest(case.at_step, steps)}"
        findings.add(("cases", name, "at_step"), sentence)
