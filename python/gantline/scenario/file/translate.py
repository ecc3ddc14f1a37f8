"""From the validator's errors to sentences that a lifting engineer understands."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pydantic_core import ErrorDetails

from gantline.scenario.errors import PathPart, Problem, closest, is_or_are, nearest, shorten
from gantline.scenario.file.other_words import (
    BESIDE,
    ELSEWHERE,
    INSTEAD,
    KINDS,
    MEANT,
    VALUES_MEANT,
    VERBS_MEANT,
)
from gantline.scenario.file.tree import ListNode, MapNode, TextNode, problem_at
from gantline.scenario.plan.plan import VERBS
from gantline.scenario.plan.steps import HoistStep, HoldStep
from gantline.scenario.quantities import found

__all__ = ["located", "translate"]


def translate(errors: Sequence[ErrorDetails], tree: MapNode) -> list[Problem]:
    """Problems for validation errors, with the lines of the tree that was validated."""
    whole = {**_nameless(errors, tree), **_sections_within(errors, tree)}
    depths = {len(path) for path in whole}
    told = [error for error in errors if not any(_locate(error["loc"], tree)[0][:d] in whole for d in depths)]
    misspelt = _misspelt(told, tree)
    return [*whole.values(), *(_problem(one, tree) for one in told if _place(one, tree) not in misspelt)]


def _place(error: ErrorDetails, tree: MapNode) -> tuple[PathPart, ...] | None:
    """Path of a key that is missing; None of any other error."""
    return (*_locate(error["loc"], tree)[0], error["loc"][-1]) if error["type"] == "missing" else None


def _misspelt(errors: Sequence[ErrorDetails], tree: MapNode) -> set[tuple[PathPart, ...] | None]:
    """Paths of the keys that unknown ones are told to be meant for: what is misspelt is not missing, too."""
    unknown = [_locate(error["loc"], tree) for error in errors if error["type"] == "extra_forbidden"]
    meant = ((path[:-1], _meant(str(path[-1]), around)) for path, _, around in unknown if around)
    return {(*path, key) for path, key in meant if key is not None}


def _sections_within(errors: Sequence[ErrorDetails], tree: MapNode) -> dict[tuple[PathPart, ...], Problem]:
    """Sections of a lift file that stand among the names of another one, and what to say of each."""
    told: dict[tuple[PathPart, ...], Problem] = {}
    for error in errors:
        path, _, around = _locate(error["loc"], tree)
        if len(path) < 2 or path[:2] in told or not isinstance(path[1], str):
            continue
        section, (names, given) = path[1], (around[1], around[1][path[1]])
        is_own = isinstance(given, MapNode) and any(key in given.allowed for key in given)
        if section in tree.allowed and section not in tree and not names.allowed and not is_own:
            wrong = f"'{section}' is not a name in '{path[0]}', but a section of {tree.what}"
            told[path[:2]] = problem_at(tree, path[:2], f"{wrong}: it stands too far in")
    return told


def _nameless(errors: Sequence[ErrorDetails], tree: MapNode) -> dict[tuple[PathPart, ...], Problem]:
    """Where keys of a thing stand in place of its name, by the path of the mapping, and what to say of it.

    Each of these keys, read as a name, is an error by itself, and so is all that stands below them.
    """
    told: dict[tuple[PathPart, ...], Problem] = {}
    for error in errors:
        context = error.get("ctx") or {}
        path, node, around = _locate(error["loc"], tree)
        if path[:-1] in told or not path or path[-1] not in context.get("keys", ()):
            continue
        names = around[-1]
        if not isinstance(names, MapNode) or names.allowed:
            continue
        key, what, section = path[-1], context["of"], shorten(str(path[-2])) if len(path) > 1 else ""
        value = shorten(str(node)) if isinstance(node, TextNode) else "…"
        right = f"{section}: {{first: {{{key}: {value}, …}}}}"
        wrong = f"'{key}' is a key of {what}, and stands where the name of one is needed"
        told[path[:-1]] = problem_at(
            tree, path, f"{wrong}; a name of yours comes before it, such as '{right}'"
        )
    return told


def _problem(error: ErrorDetails, tree: MapNode) -> Problem:
    loc = error["loc"]
    if "key" in (error.get("ctx") or {}):
        loc = (*loc, error["ctx"]["key"])
    path, node, around = _locate(loc, tree)
    return problem_at(tree, path, _sentence(error, node, around))


def located(loc: Sequence[PathPart], tree: MapNode) -> Any:
    """The node that a place in the models is read from, or that it would stand in."""
    return _locate(loc, tree)[1]


def _locate(loc: Sequence[PathPart], tree: MapNode) -> tuple[tuple[PathPart, ...], Any, list[Any]]:
    """Path in the file of a place in the models (tags of unions left out), its node, the nodes around it."""
    path: list[PathPart] = []
    node: Any = tree
    around: list[Any] = []
    was_tag = False
    for part in loc:
        # A kind of thing may be called as one of its keys is, `type: box` with `box: [4 m, 4 m, 3 m]`.
        was_tag = not was_tag and isinstance(node, MapNode) and node.get("type") == part
        if was_tag:
            continue
        inside = isinstance(node, MapNode) and part in node
        inside = inside or (isinstance(node, ListNode) and isinstance(part, int) and part < len(node))
        if inside:
            path.append(part)
            around.append(node)
            node = node[part]
    return tuple(path), node, around


def _sentence(error: ErrorDetails, node: Any, around: Sequence[Any]) -> str:
    kind = error["type"]
    context: Mapping[str, Any] = error.get("ctx") or {}
    last = str(error["loc"][-1]) if error["loc"] else ""
    if kind == "gantline":
        return error["msg"]
    if kind == "no_verb":
        return _no_verb(error["msg"], node)
    if kind == "missing":
        return _missing(last, node)
    if kind == "extra_forbidden":
        return _unknown_key(last, around)
    if kind == "literal_error":
        meant = VALUES_MEANT.get(last, {}).get(str(node).lower())
        likely = "" if meant is None else f"; did you mean '{meant}'?"
        return f"found {found(node)}; right is {context.get('expected', 'another word')}{likely}"
    if kind in ("union_tag_invalid", "union_tag_not_found"):
        return _kind_of_thing(context, node)
    if kind == "too_short" and not context.get("actual_length"):
        return "is empty; leave it out or fill it"
    if kind == "too_short":
        return f"found {context['actual_length']} entries; at least {context['min_length']} needed"
    if kind in ("dict_type", "model_type", "model_attributes_type"):
        return f"found {found(node)}; a mapping is needed"
    if kind in ("list_type", "tuple_type"):
        return f"found {found(node)}; a list is needed"
    return f"found {found(node)}, which is not right here"


def _no_verb(sentence: str, node: Any) -> str:
    """What is to be said of a step that does nothing which is known here."""
    known = {*HoistStep.keys(), *HoldStep.keys()}
    for key in node if isinstance(node, MapNode) else ():
        if key in known:
            continue
        if key.lower() in INSTEAD["a hold step"]:
            return f"'{shorten(key)}' is not what a step can do: {INSTEAD['a hold step'][key.lower()]}"
        verb = VERBS_MEANT.get(key.lower()) or closest(key, VERBS)
        if verb is not None:
            return f"'{shorten(key)}' is not what a step can do; did you mean '{verb}'?"
    return sentence


def _missing(key: str, node: Any) -> str:
    if not isinstance(node, MapNode):
        return f"'{key}' is missing"
    if key == "format":
        return f"'{key}' is missing; a lift file begins with 'format: 1'"
    what = node.what or "this mapping"
    need = "need" if is_or_are(what) == "are" else "needs"
    return f"'{key}' is missing; {what} {need} it{_explained(key, node)}"


def _explained(key: str, node: MapNode) -> str:
    """What a key says, in brackets; nothing where that is no more than its name."""
    said = "" if node.explained is None else node.explained(key)
    if {*said.lower().split()} <= {*key.split("_"), "its", "the", "of"}:
        return ""
    first = said[0].lower() if said[1].islower() else said[0]
    return f" ({first}{said[1:]})"


def _at_other_level(key: str, around: Sequence[Any]) -> str | None:
    """What to say of a key that is right farther out, or one mapping farther in; None of another.

    Indented wrongly a key stands in another mapping.
    """
    parent = around[-1]
    wrong = f"'{shorten(key)}' is not a key of {parent.what}"
    for outer in reversed(around[:-1]):
        if isinstance(outer, MapNode) and key in outer.allowed and key not in outer:
            return f"{wrong}, but of {outer.what}: it stands too far in"
    for name, inner in parent.items():
        if isinstance(inner, MapNode) and key in inner.allowed and key not in inner:
            return f"{wrong}, but of '{shorten(str(name))}' in it: it stands too far out"
    return None


def _elsewhere(key: str, around: Sequence[Any]) -> str | None:
    """What to say of an unknown key in whose place there is something else; None of any other."""
    shown, parent = shorten(key), around[-1] if around else None
    if key in ELSEWHERE:
        return f"'{shown}' has another place: {ELSEWHERE[key]}"
    if not isinstance(parent, MapNode) or not parent.allowed:
        return f"'{shown}' is not a key that is known here"
    instead = INSTEAD.get(parent.what or "", {}).get(key.lower())
    if instead is not None:
        return f"'{shown}' is not a key of {parent.what}: {instead}"
    return _at_other_level(key, around)


def _meant(key: str, around: Sequence[Any]) -> str | None:
    """The key of its mapping that an unknown one is told to be meant for, which is not given there."""
    if _elsewhere(key, around) is not None:
        return None
    parent = around[-1]
    unused = [name for name in parent.allowed if name not in parent] or list(parent.allowed)
    other_words = [name for name in MEANT.get(key.lower(), ()) if name in parent.allowed]
    by_words = next((name for name in other_words if name in unused), None)
    if by_words is not None or other_words:
        return by_words
    # Of all: beside `cranes`, `crane` is that, and not what is left and written most alike, `cases`.
    is_used = closest(key, parent.allowed) not in (None, *unused)
    return None if is_used else closest(key, unused)


def _unknown_key(key: str, around: Sequence[Any]) -> str:
    elsewhere = _elsewhere(key, around)
    if elsewhere is not None:
        return elsewhere
    parent, meant = around[-1], _meant(key, around)
    wrong = f"'{shorten(key)}' is not a key of {parent.what}"
    if meant is not None:
        beside = BESIDE.get(key.lower(), "") if meant in MEANT.get(key.lower(), ()) else ""
        return f"{wrong}; did you mean '{meant}'{beside}?"
    words = (name for name in MEANT.get(key.lower(), ()) if name in parent)
    likely = next(words, None) or closest(key, parent.allowed)
    if likely is not None:
        return f"{wrong}; did you mean '{likely}', which is there already?"
    return f"{wrong}; {nearest(key, [name for name in parent.allowed if name not in parent])}"


def _kind_of_thing(context: Mapping[str, Any], node: Any) -> str:
    if not isinstance(node, dict):
        return f"found {found(node)}; a mapping with a 'type' is needed"
    known = [tag.strip(" '") for tag in str(context.get("expected_tags", "")).split(",")]
    if "dock" in known and str(node["type"]).lower() in KINDS:
        return f"{found(node['type'])} is not a type that is known here; {KINDS[str(node['type']).lower()]}"
    return f"{found(node['type'])} is not a type that is known here; {nearest(str(node['type']), known)}"
