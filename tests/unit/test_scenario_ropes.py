"""Kinds of rope in a lift file: by stiffness, or by construction, diameter and grade."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ruamel.yaml import YAML

from gantline.assembly import assemble
from gantline.rope_data import GRADES, rope_class, rope_classes
from gantline.scenario import parse_scenario
from gantline.scenario.gear import RopeMaterial
from lift_text import BASE, MECHANICS, spoiled

ROOT = Path(__file__).resolve().parents[2]
NAMES = [word for one in rope_classes().values() for word in (one.name, *one.designations)]


def rope(given: str) -> RopeMaterial:
    """The kind of rope that a flow mapping says."""
    kinds = parse_scenario(spoiled("{axial_stiffness: 100 MN, damping_time: 2 ms}", given)).ropes
    assert kinds is not None
    return kinds["thick"]


@pytest.mark.parametrize("name", NAMES)
def test_every_construction_can_be_written(name: str) -> None:
    kind = rope(f"{{construction: {name}, diameter: 60 mm, grade: 1770}}")
    one = rope_class(name)
    assert kind.catalogue is one
    assert kind.stiffness == pytest.approx(one.modulus * one.area_factor * 0.06**2)
    assert kind.mass_per_length == pytest.approx(one.mass_factor * 60**2 / 100)
    assert kind.breaking_force == pytest.approx(one.breaking_force_factor * 60**2 * 1770)


def test_what_overrides_the_class() -> None:
    kind = rope(
        "{construction: 6x36WS-IWRC, diameter: 60 mm, modulus: 115 kN/mm^2, mass: 14 kg/m, "
        "damping_time: 10 ms, minimum_breaking_force: 2500 kN}"
    )
    assert kind.stiffness == pytest.approx(115e3 * 0.460 * 60**2)  # N/mm² over mm²
    assert (kind.mass_per_length, kind.damping_time, kind.breaking_force) == (14.0, 0.01, 2500e3)
    certified = "{construction: 6x36 IWRC, diameter: 60 mm, grade: 2160, minimum_breaking_force: 2500 kN}"
    assert rope(certified).breaking_force == 2500e3


def test_a_rope_by_stiffness_has_what_it_is_given() -> None:
    kind = rope("{axial_stiffness: 188 MN, minimum_breaking_force: 2858 kN, mass: 16.8 kg/m}")
    assert (kind.stiffness, kind.breaking_force, kind.mass_per_length) == (188e6, 2858e3, 16.8)
    assert rope("{axial_stiffness: 188 MN, diameter: 64 mm}").breaking_force is None


@settings(max_examples=50)
@given(st.sampled_from(NAMES), st.integers(1, 300), st.sampled_from(GRADES))
def test_a_construction_is_the_same_as_its_figures_written_out(name: str, diameter: int, grade: str) -> None:
    kind = rope(f"{{construction: {name}, diameter: {diameter} mm, grade: {grade}, damping_time: 5 ms}}")
    again = rope(
        f"{{axial_stiffness: {kind.stiffness!r} N, mass: {kind.mass_per_length!r} kg/m, "
        f"minimum_breaking_force: {kind.breaking_force!r} N, damping_time: 5 ms}}"
    )
    for figure in ("stiffness", "mass_per_length", "breaking_force", "damping_time"):
        assert getattr(again, figure) == getattr(kind, figure)


@pytest.mark.parametrize(
    ("text", "old"),
    [
        (BASE, "{axial_stiffness: 100 MN, damping_time: 2 ms}"),  # equalizing rope
        (BASE, "{axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}"),  # slings
        (MECHANICS, "{inextensible: true}"),
    ],
    ids=["equalizing", "sling", "mechanics"],
)
def test_every_rope_may_have_a_construction(text: str, old: str) -> None:
    kind = "{construction: 6x19 FC, diameter: 20 mm, grade: 1960, damping_time: 1 ms}"
    document = assemble(parse_scenario(spoiled(old, kind, text))).document
    materials = [one["material"] for one in document["ropes"] if one["material"].get("damping_time") == 1e-3]
    assert materials
    assert all(one["axial_stiffness"] == pytest.approx(80e9 * 0.384 * 0.02**2) for one in materials)


def test_the_kinds_of_rope_in_the_documentation_can_be_used() -> None:
    page = (ROOT / "docs" / "concepts" / "rope_data.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```yaml\n(ropes:.*?)```", page, re.S)
    kinds = "\n".join(text.splitlines()[1:]) + "\n"
    assert len(YAML(typ="safe").load(text)["ropes"]) == 4
    old = "  sling: {axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}\n"
    assemble(parse_scenario(spoiled(old, kinds)))
