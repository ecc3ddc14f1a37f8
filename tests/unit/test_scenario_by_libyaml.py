"""A lift file is read by libyaml to what ruamel.yaml makes of it, line by line; and is refused as by that."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from gantline.scenario import ScenarioError
from gantline.scenario.file.tree import ListNode, MapNode, Node, parse_text
from lift_text import BASE, CASES, MECHANICS

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
FILES = sorted(SCENARIOS.glob("*/scenario.yaml"))
#: What YAML has a meaning for, somewhere, and where its versions 1.1 and 1.2 differ.
SIGNS = [
    *":-,[]{}#&*!|>'\"%@`?\t \n\r\\<=~", "\n  ", "\n- ", ": ", " #", "...\n", "---\n", "? ", "\u2028",
    "\x85", "\x07", "\ufeff", "é", "%YAML 1.2\n", "<<: ", "''", '"\\u0000"', '"\\/"', "|\n", "!!str ", "::",
    "{a:b}", "[a:b, c]", "a: b:c", ":x", "{? a}", "- - a", "{a: b, c}",
]  # fmt: skip


def outcome(text: str) -> Any:
    """The tree with the line of everything, or the message."""
    try:
        return shown(parse_text(text, "lift.yaml"))
    except ScenarioError as error:
        return str(error)


def shown(node: Node) -> Any:
    if isinstance(node, MapNode):
        return node.line, [(key, node.key_lines[key], shown(value)) for key, value in node.items()]
    if isinstance(node, ListNode):
        return node.line, [shown(value) for value in node]
    return node.line, str(node)


def without_libyaml(text: str) -> Any:
    with patch.object(yaml, "CBaseLoader", None):
        return outcome(text)


@st.composite
def spoiled_texts(draw: st.DrawFn) -> str:
    text = draw(st.sampled_from([BASE, BASE + CASES, MECHANICS]))
    for _ in range(draw(st.integers(1, 3))):
        at = draw(st.integers(0, len(text)))
        left_out = draw(st.sampled_from([0, 0, 1, 5, 30]))
        text = text[:at] + draw(st.sampled_from(["", *SIGNS])) + text[at + left_out :]
    return text


@given(text=spoiled_texts())
@settings(max_examples=300)
def test_whatever_is_typed_into_a_lift_it_is_read_alike(text: str) -> None:
    assert outcome(text) == without_libyaml(text)


@pytest.mark.parametrize("file", FILES, ids=[file.parent.name for file in FILES])
def test_every_lift_is_read_by_libyaml_alone(file: Path) -> None:
    """ruamel.yaml, which takes twenty times as long, is not asked where nothing is wrong."""
    text = file.read_text(encoding="utf-8")
    expected = without_libyaml(text)
    with patch("gantline.scenario.file.tree.YAML", side_effect=AssertionError):
        assert outcome(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "a: {b: x?}\n",  # ends the key to libyaml, as in YAML 1.1
        "a: {? b}\n",
        "a:\tb\n",  # what separates may be a tab to libyaml
        "a: {b: [c,\td]}\n",
        "a: b\u2028c\nd: e\n",  # a line ends there in YAML 1.1
        "a: b\x85c\nd: e\n",
    ],
)
def test_what_versions_of_yaml_take_differently(text: str) -> None:
    assert outcome(text) == without_libyaml(text)
