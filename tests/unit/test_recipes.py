"""What the recipes of CONTRIBUTING.md say must be entered in several places is entered in all of them."""

from __future__ import annotations

import ast
import re
from importlib import import_module
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
from gantline.scenario.cranes.crane import CRANE_TYPES
from gantline.scenario.cranes.crane_types import AnyCrane, Crane
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.ground import INTEGRATOR_KEYS, SimulationSettings
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


def text_of(path: str) -> str:
    return (ROOT / path).read_text(encoding="utf-8")


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


def variants(file: str, name: str) -> set[str]:
    """Variants of an `enum` of the core, as they are named there."""
    core = text_of(f"crates/gantline-core/src/{file}")
    inside = core[core.index(f"pub enum {name} {{") :]
    return words(inside[: inside.index("\n}")], r"^    ([A-Z]\w*)\b")


def test_the_core_and_python_know_the_same_joints() -> None:
    """Variants of `JointSpec` in the core, types in Python, rows of the page on bodies and joints."""
    known = {name.lower() for name in variants("spec/mod.rs", "JointSpec")}
    assert known == words(text_of("python/gantline/assembly/joints.py"), r'^    "(\w+)": \(_')
    assert known == words(text_of("docs/concepts/bodies_and_joints.md"), r"^\| `(\w+)` \|")


@pytest.mark.parametrize(
    ("file", "name"),
    [("spec/mod.rs", "JointSpec"), ("spec/force.rs", "ForceSpec"), ("spec/rope.rs", "GuideSpec")],
)
def test_every_joint_force_and_guide_is_drawn_at_random(file: str, name: str) -> None:
    """Its derivatives are compared with differences: what no rig draws may be wrong, and nobody sees it."""
    tests = (ROOT / "crates/gantline-core/tests").rglob("*.rs")
    text = "".join(path.read_text(encoding="utf-8") for path in tests)
    drawn = words(text, rf"{name}::(\w+)") | {one.title() for one in words(text, r'"type": "(\w+)"')}
    assert sorted(variants(file, name) - drawn) == []


def test_every_integrator_is_known_everywhere() -> None:
    """The lift file, its keys, the core, the bounds of its books, and those who choose one by name."""
    known = set(get_args(SimulationSettings.model_fields["integrator"].annotation))
    assert known == {name.lower() for name in variants("spec/settings.rs", "IntegratorSpec")}
    assert known == set(INTEGRATOR_KEYS) == set(metrics.ENERGY_BOUNDS)
    for page in (
        "python/gantline/cli/run.py",
        "python/gantline/simulation.py",
        "docs/reference/command_line.md",
    ):
        assert [name for name in sorted(known) if not re.search(rf"\b{name}\b", text_of(page))] == [], page


def test_every_type_of_crane_is_read_by_its_own_model() -> None:
    """The union of `python/gantline/scenario/cranes/crane_types.py`, and the words that choose among it."""
    models = get_args(get_args(Crane)[0])
    of_type = {get_args(model)[1].tag: get_args(model)[0] for model in models}
    assert tuple(of_type) == CRANE_TYPES
    assert set(of_type.values()) == set(get_args(AnyCrane))
    for name, model in of_type.items():
        assert get_args(model.model_fields["type"].annotation) == (name,)


def test_every_limit_has_a_key() -> None:
    """`LIMITS`, and `Limits` of a lift file or `Require` of a step."""
    said_elsewhere = {"clearance_margin"}  # by `smallest` of a pair under `watch`
    assert set(LIMITS) - set(Limits.model_fields) - set(Require.model_fields) == said_elsewhere


def named_checks(file: Path) -> set[str]:
    """Names of the checks that a source makes: the first of `Check(...)`, or handed to what calls that."""
    source = ast.parse(file.read_text(encoding="utf-8"))
    module = import_module(f"gantline.checks.{file.stem}")
    calls = [node for node in ast.walk(source) if isinstance(node, ast.Call) and node.args]
    place = {"Check": 0}
    for function in source.body:
        if isinstance(function, ast.FunctionDef):
            handed = [one.arg for one in function.args.args]
            inside = [node for node in ast.walk(function) if node in calls and called(node) == "Check"]
            names = {one.args[0].id for one in inside if isinstance(one.args[0], ast.Name)}
            for name in names & set(handed):
                place[function.name] = handed.index(name)
    made = [call.args[place[called(call)]] for call in calls if called(call) in place]
    texts = {str(one.value) for one in made if isinstance(one, ast.Constant)}
    return texts | {getattr(module, one.id) for one in made if isinstance(one, ast.Name) and one.id.isupper()}


def called(call: ast.AST) -> str:
    """Name of the function that is called; nothing of a method."""
    return call.func.id if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) else ""


def test_every_check_has_a_heading_to_link_to() -> None:
    """Its name, or a target of that name where a heading has several; steps ask for some without one."""
    page = (ROOT / "docs/reference/checks.md").read_text(encoding="utf-8")
    alone = words(page, r"^### `(\w+)`$")
    together = words(page, r"^\((\w+)\)=$")
    assert together == {one for line in words(page, r"^### (`.*`, .*)$") for one in words(line, r"`(\w+)`")}
    headings = alone | together
    of_steps = {"tension_spread", "load_transferred", "hook_load", "sling_tension"}
    made = {name for file in (ROOT / "python/gantline/checks").glob("*.py") for name in named_checks(file)}
    assert made >= {"plan_finished", "sling_outside_structures", "no_warnings", "no_overlap"}
    assert sorted((set(LIMITS) | made) - of_steps ^ headings) == []
    first = page[: page.index("How to read an entry")]
    assert sorted(headings) == sorted(re.findall(r"\[`\w+`\]\(#(\w+)\)", first))


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
