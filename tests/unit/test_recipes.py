"""What the recipes of CONTRIBUTING.md say must be entered in several places is entered in all of them."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.assembly.joints import start_of
from gantline.assembly.ropes import rope_rig
from gantline.assembly.spatial import rotation_matrix
from gantline.checks import LIMITS
from gantline.results import metrics
from gantline.scenario import (
    Rigging,
    Scenario,
    json_schema,
    load_scenario,
    mechanics,
    parse_scenario,
    shipped,
)
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.limits import Limits
from gantline.scenario.plan.bounds import Require
from gantline.scenario.rope_weight import RopeWeight
from gantline.simulation import simulate

ROOT = Path(__file__).resolve().parents[2]
AXIS = [0.48, 0.6, 0.64]
OFF_CENTRE = ", centre_of_gravity: [0.5 m, 0 m, 0.2 m]"
INERTIA = ", inertia: {xx: 1 kg m^2, yy: 1 kg m^2, zz: 1 kg m^2}"
JOINTS = {
    "fixed": "type: fixed",
    "hinge": f"type: hinge, axis: {AXIS}, position: 0.4 rad",
    "slider": f"type: slider, axis: {AXIS}, position: 0.7 m",
    "ball": "type: ball, orientation: {about: [0, 0.6, 0.8], angle: 0.5 rad}",
    "point": "type: point, position: [0.1 m, 0.2 m, 0.3 m]",
    "free": "type: free, position: [1 m, 2 m, 0.3 m], orientation: {about: [0, 0.6, 0.8], angle: 0.5 rad}",
}
LIFT = """\
format: 1
lift: {title: A body on a joint}
duration: 20 ms
mechanics:
  bodies:
    body: {at: [1 m, 2 m, 3 m], joint: {JOINT}, mass: 1 kgMORE}
"""


def words(text: str, pattern: str) -> set[str]:
    return set(re.findall(pattern, text, flags=re.M))


@pytest.mark.parametrize("kind", JOINTS)
def test_a_joint_starts_where_the_core_has_it(kind: str) -> None:
    """Python places what hangs on a body at the start, so it knows every joint, and alike: r = p + R c."""
    more = "" if kind == "point" else INERTIA + ("" if kind == "free" else OFF_CENTRE)
    lift = parse_scenario(LIFT.replace("JOINT", JOINTS[kind]).replace("MORE", more))
    [body] = assemble(lift).document["bodies"]
    moved, turned = start_of(body["joint"])
    placed = rotation_matrix(body["placement"]["orientation"])
    origin = np.array(body["placement"]["position"]) + placed @ moved
    expected = origin + placed @ turned @ np.array(body["centre_of_gravity"])
    recording = simulate(lift)
    assert recording.column("body_position", "body")[0] == pytest.approx(expected, abs=1e-12)
    orientation = rotation_matrix(list(recording.column("body_orientation", "body")[0]))
    assert orientation == pytest.approx(placed @ turned, abs=1e-12)


def test_every_joint_of_a_lift_file_is_among_them() -> None:
    models = get_args(get_args(mechanics.Joint)[0])
    assert {get_args(one.model_fields["type"].annotation)[0] for one in models} == set(JOINTS)


def test_the_core_and_python_know_the_same_joints() -> None:
    """Variants of `JointSpec` in the core, types in `python/gantline/assembly/joints.py`."""
    core = (ROOT / "crates/gantline-core/src/spec/mod.rs").read_text(encoding="utf-8")
    variants = core[core.index("pub enum JointSpec") : core.index("impl JointSpec")]
    python = (ROOT / "python/gantline/assembly/joints.py").read_text(encoding="utf-8")
    assert words(variants, r"^    ([A-Z]\w*)\b") == {
        name.capitalize() for name in words(python, r'^    "(\w+)": \(_')
    }


def test_every_limit_has_a_key_and_a_row() -> None:
    """`LIMITS`, `Limits` of a lift file or `Require` of a step, and the table of the page on checks."""
    said_elsewhere = {"clearance_margin"}  # by `smallest` of a pair under `watch`
    assert set(LIMITS) - set(Limits.model_fields) - set(Require.model_fields) == said_elsewhere
    page = (ROOT / "docs/concepts/checks.md").read_text(encoding="utf-8")
    assert [name for name in LIMITS if f"`{name}`" not in page] == []


def test_a_slipped_unit_is_found_in_every_limit_that_is_an_angle() -> None:
    """Nothing comes to a limit of 300 deg, which nobody meant, so that it would hide what it should show."""
    largest = {name for name, one in LIMITS.items() if one.unit == "deg" and not one.at_least}
    text = shipped()["spreader_bar"].read_text(encoding="utf-8").partition("\nlimits:")[0]
    for name in sorted(largest & set(Limits.model_fields)):
        doubts = assemble(parse_scenario(f"{text}\nlimits: {{{name}: 300 deg}}\n")).doubts
        assert f"limits.{name}" in [one.path for one in doubts], name


def test_every_key_of_a_lift_file_is_read() -> None:
    """As an attribute, or by its name: what somebody writes and nothing looks at would be an empty promise.

    Keys that can say one thing only, which is so anyhow, need not be.
    """
    keys = {
        key
        for model in json_schema()["$defs"].values()
        for key, one in model.get("properties", {}).items()
        if "const" not in one
    }
    read = set()
    for file in (ROOT / "python/gantline").rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Attribute):
                read.add(node.attr)
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                read.add(node.value)
    assert len(keys) > 400
    assert sorted(keys - read) == []


def test_a_rope_that_results_do_not_know_is_not_simulated(monkeypatch: pytest.MonkeyPatch) -> None:
    """It would be held against no breaking force, and no check would say so."""
    whole = rope_rig.rope_kinds

    def without_slings(scenario: Scenario, rigging: Rigging) -> dict[str, tuple[RopeMaterial, RopeWeight]]:
        kinds = whole(scenario, rigging).items()
        return {name: kind for name, kind in kinds if not name.startswith("sling.")}

    lift = load_scenario(ROOT / "scenarios/equalizer")
    assemble(lift)
    monkeypatch.setattr(rope_rig, "rope_kinds", without_slings)
    with pytest.raises(AssertionError):
        assemble(lift)


def pattern_of(name: ast.expr) -> str:
    """What matches a name that a source yields; in an f-string anything stands for what it puts in."""
    parts = name.values if isinstance(name, ast.JoinedStr) else [name]
    return "".join(re.escape(str(p.value)) if isinstance(p, ast.Constant) else r"[\w<>]+" for p in parts)


def test_every_metric_has_a_row_and_every_row_a_metric() -> None:
    """Names that are yielded in the source, those of a lift which no other test has among them."""
    source = ast.parse(Path(metrics.__file__).read_text(encoding="utf-8"))
    yields = [node.value for node in ast.walk(source) if isinstance(node, ast.Yield)]
    made = {pattern_of(one.elts[0]) for one in yields if isinstance(one, ast.Tuple)}
    rows = words(metrics.__doc__ or "", r"`([a-z_]+(?:\.<[a-z ]+>)?)`")
    rows = {row.replace(" ", "_") for row in rows if not row.startswith("gantline")}
    assert len(made) > 40
    assert [name for name in sorted(made) if not any(re.fullmatch(name, row) for row in rows)] == []
    assert [row for row in sorted(rows) if not any(re.fullmatch(name, row) for name in made)] == []


@pytest.mark.parametrize("name", shipped())
def test_a_scenario_is_complete(name: str) -> None:
    """Editors know its schema; it says what to see and expect; the list of the command line has it."""
    folder = ROOT / "scenarios" / name
    lift = (folder / "scenario.yaml").read_text(encoding="utf-8")
    assert lift.startswith("# yaml-language-server: $schema=../../schema/lift.schema.json\n")
    assert (folder / "README.md").is_file() and (folder / "expect.yaml").is_file()
    listed = (ROOT / "docs/reference/command_line.md").read_text(encoding="utf-8")
    assert f"`{name}`" in listed
