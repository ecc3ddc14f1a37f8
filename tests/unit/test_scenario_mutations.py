"""Whatever is done to a right lift file, it is read, or refused with a message: never a crash."""

from __future__ import annotations

import copy
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gantline.scenario import ScenarioError, parse_scenario, template
from gantline.scenario.file.tree import parse_text
from gantline.simulation import Simulation, SimulationError
from lift_text import BASE, CASES, MECHANICS

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
TEXTS = [path.read_text(encoding="utf-8") for path in sorted(SCENARIOS.glob("*/scenario.yaml"))]
TEXTS += [BASE, BASE + CASES, MECHANICS, template()]

VALUES = [
    "0", "-1",
    "1e-300 m", "1e300 t", "nan", "inf m", "3 m", "-3 m", "1e5 m", "0.5 t", "1 N/m", "10 kN", "200 %",
    "1 deg", "true", "null", "~", "none", "rest", "ground", "fixed_hook", "hook", "e1", "e1.1", "block.L1",
    "world",
    "x" * 500, "a b", "ü", "\u2028", "0 m", "1e-9 s", "1e6 s", "[1, 2]", "until_end", "0.1 mm", "90 deg",
]  # fmt: skip
FUZZ = settings(max_examples=150)


def try_it(text: str) -> None:
    """Read, assemble, hand to the core, take three steps: only errors that the command line knows."""
    try:
        simulation = Simulation(parse_scenario(text, "lift.yaml"))
    except ScenarioError as error:
        message = str(error)
        assert message.startswith("lift.yaml")
        assert not any(
            word in message.lower() for word in ("traceback", "pydantic", "validation", "panic", "nonetype")
        )
        return
    step = simulation.settings["integrator"].get("step", 1e-3)
    with suppress(SimulationError):  # a singular system, for one, is found out when it shall move
        simulation.run(until=min(3 * step, simulation.duration))


def written(node: Any) -> str:
    """A tree as YAML in flow style, every scalar in quotes."""
    if isinstance(node, dict):
        return "{" + ", ".join(f"{written(key)}: {written(value)}" for key, value in node.items()) + "}"
    if isinstance(node, list):
        return "[" + ", ".join(written(item) for item in node) + "]"
    return '"' + "".join(_escaped(character) for character in str(node)) + '"'


def _escaped(character: str) -> str:
    return character if character.isalnum() or character in " ._-/%^'" else f"\\U{ord(character):08x}"


def places(node: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths of everything in a tree."""
    keys = list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else ()
    return [place for key in keys for place in ((*path, key), *places(node[key], (*path, key)))]


def at(node: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        node = node[key]
    return node


@cache
def trees() -> list[Any]:
    """Every lift as a tree; each draw copies its own."""
    return [parse_text(text, "lift.yaml") for text in TEXTS]


@st.composite
def spoiled_trees(draw: st.DrawFn) -> str:
    tree = copy.deepcopy(draw(st.sampled_from(trees())))
    for _ in range(draw(st.integers(1, 3))):
        found = places(tree)
        if not found:
            break
        path = draw(st.sampled_from(found))
        parent, key = at(tree, path[:-1]), path[-1]
        act = draw(st.sampled_from(["delete", "value", "garble", "graft", "rename", "repeat"]))
        if act == "delete":
            del parent[key]
        elif act == "value":
            parent[key] = draw(st.sampled_from(VALUES))
        elif act == "garble":
            parent[key] = (
                draw(st.text(max_size=8)) if not isinstance(parent[key], str) else _garbled(draw, parent[key])
            )
        elif act == "graft":
            other = draw(st.sampled_from(trees()))
            parent[key] = copy.deepcopy(at(other, draw(st.sampled_from(places(other)))))
        elif act == "rename" and isinstance(parent, dict):
            parent[_garbled(draw, str(key))] = parent.pop(key)
        elif act == "repeat":
            if isinstance(parent, list):
                parent.append(copy.deepcopy(parent[key]))
            else:
                parent[f"{key}_2"] = copy.deepcopy(parent[key])
    return written(tree)


def _garbled(draw: st.DrawFn, text: str) -> str:
    place = draw(st.integers(0, len(text)))
    return (
        text[:place]
        + draw(st.sampled_from(["", "-", "0", "1", ".", " ", "e", "m", "\n", "é"]))
        + text[place + 1 :]
    )


@FUZZ
@given(spoiled_trees())
def test_spoiled_trees(text: str) -> None:
    try_it(text)


@FUZZ
@given(st.data())
def test_spoiled_text(data: st.DataObject) -> None:
    text = data.draw(st.sampled_from(TEXTS))
    start = data.draw(st.integers(0, len(text)))
    end = min(len(text), start + data.draw(st.integers(0, 30)))
    piece = data.draw(
        st.sampled_from(
            ["", "\n", ": ", "{", "}", "[", "- ", "&a ", "*a", "!x ", "#", '"', "\t", text[start:end] * 2]
        )
    )
    try_it(text[:start] + piece + text[end:])


@pytest.mark.parametrize("text", TEXTS, ids=range(len(TEXTS)))
def test_lifts_that_are_not_spoiled_run(text: str) -> None:
    beside_files = str(SCENARIOS.parent / "python" / "gantline" / "scenarios" / "lift.yaml")
    simulation = Simulation(parse_scenario(written(parse_text(text, "lift.yaml")), beside_files))
    assert simulation.run(until=0.002).attributes["status"] in ("paused", "done")
