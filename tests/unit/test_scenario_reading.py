"""Reading lift files: what stands in the file is what the scenario says, in SI units."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import Scenario, ScenarioError, load_scenario, parse_scenario, resolve, template
from gantline.scenario.plan.bounds import Bound
from gantline.scenario.plan.steps import HoistStep, HoldStep
from gantline.scenario.sling_ends import split_reference
from lift_text import BASE, MECHANICS, spoiled

ROOT = Path(__file__).resolve().parents[2]
SCENARIOS = sorted(path.parent for path in (ROOT / "scenarios").glob("*/scenario.yaml"))


@pytest.mark.parametrize("folder", SCENARIOS, ids=lambda folder: folder.name)
def test_every_shipped_scenario_is_right(folder: Path) -> None:
    scenario = load_scenario(folder)
    assert scenario.source == str(folder / "scenario.yaml")
    assert scenario.text == (folder / "scenario.yaml").read_text(encoding="utf-8")
    assert load_scenario(folder / "scenario.yaml") == scenario
    assemble(scenario)


@pytest.mark.parametrize("folder", SCENARIOS, ids=lambda folder: folder.name)
def test_every_shipped_scenario_names_the_schema_and_explains_itself(folder: Path) -> None:
    first = (folder / "scenario.yaml").read_text(encoding="utf-8").splitlines()[0]
    assert first == "# yaml-language-server: $schema=../../schema/lift.schema.json"
    assert "## What to see" in (folder / "README.md").read_text(encoding="utf-8")
    assert (folder / "expect.yaml").is_file()


def test_the_reference_lift_in_si_units() -> None:
    scenario = load_scenario(ROOT / "scenarios" / "equalizer")
    assert scenario.load is not None and scenario.ground is not None and scenario.limits is not None
    assert scenario.duration == 40.0
    assert scenario.ground.stiffness == 200e6 and scenario.ground.damping == 2e6
    assert scenario.load.weight.simulated == 300e3
    assert scenario.load.lugs["L1"].at == (-2.5, 2.5, 5.0)
    rigging = resolve(scenario)
    equalizer = rigging.equalizers["e1"]
    assert equalizer.rope.stiffness == 100e6 and equalizer.rope.damping_time == 0.002
    assert equalizer.frame.inertia_about_vertical == pytest.approx(20e3 / 12 * (8**2 + 1.6**2), rel=1e-8)
    assert [sling.length for sling in rigging.slings.values()] == [23.0, 26.0, 26.0, 26.0, 23.0]
    assert [sling.upper_body for sling in rigging.slings.values()] == ["e1.1", "e1.2", "e1.3", "e1.4", "e1.5"]
    assert scenario.limits.load_tilt == pytest.approx(math.radians(2))
    hoist, hold = scenario.plan
    assert isinstance(hoist, HoistStep) and hoist.moved == ("test_hook",) and hoist.brake_from == 25.0
    assert isinstance(hold, HoldStep) and hold.hold == "until_end"


def test_requirements_of_the_creep_plan() -> None:
    plan = load_scenario(ROOT / "scenarios" / "equalizer_yard").plan
    require = plan[6].require
    assert require is not None
    assert require.load_tilt == Bound("below", math.radians(1))
    assert require.equalizer_travel_used == Bound("below", 0.9)
    assert plan[1].report == ("sling_tension", "equalizer_travel")


def test_the_template_is_right_and_commented() -> None:
    assemble(parse_scenario(template()))
    assert template().count("#") > 10


def test_names_are_text_and_never_numbers() -> None:
    text = BASE.replace("block.L1", "block.1").replace("    L1:", "    1:")
    text = text.replace("block.L2", "block.1e3").replace("    L2:", "    1e3:")
    text = text.replace("  S1:", "  on:").replace("  S2:", "  0x10:")
    scenario = parse_scenario(text.replace("title: A test lift", "title: 007"))
    assert scenario.load is not None and scenario.slings is not None
    assert scenario.lift.title == "007"
    assert list(scenario.load.lugs) == ["1", "1e3", "L3"]
    assert list(scenario.slings) == ["on", "0x10"]


@pytest.mark.parametrize(
    ("text", "owners", "split"),
    [
        ("block.L1", ["block"], ("block", "L1")),
        ("block.U1.1", ["block"], ("block", "U1.1")),
        ("block.U1.1", ["block", "block.U1"], ("block.U1", "1")),  # longest match first
        ("block", ["block"], None),
        ("block.", ["block"], None),
        ("blocks.L1", ["block"], None),
    ],
)
def test_names_with_dots(text: str, owners: list[str], split: tuple[str, str] | None) -> None:
    assert split_reference(text, owners) == split


def test_lugs_and_slings_with_dots() -> None:
    text = BASE.replace("    L1:", "    U1.1:").replace("block.L1", "block.U1.1").replace("  S1:", "  U1.1:")
    assert resolve(parse_scenario(text)).slings["U1.1"].lugs == ("U1.1",)


def test_types_and_defaults_say_once_what_many_share() -> None:
    plain = resolve(parse_scenario(BASE))
    start = BASE.index("    frame:")
    end = BASE.index("slings:\n")
    parts = BASE[start:end]
    text = BASE.replace(parts, "    type: EQ2\n").replace(
        "equalizers:\n", f"equalizer_types:\n  EQ2:\n{parts}equalizers:\n"
    )
    text = text.replace(
        "slings:\n", "sling_defaults: {length: 13 m, rope: sling, tolerance: 0.25 %}\nslings:\n"
    )
    text = text.replace(", length: 13 m, rope: sling, tolerance: 0.25 %", "")
    shared = resolve(parse_scenario(text))
    assert shared.equalizers == plain.equalizers
    assert shared.slings["S2"] == plain.slings["S2"]


def test_an_equalizer_may_differ_from_its_type() -> None:
    start, end = BASE.index("    frame:"), BASE.index("slings:\n")
    parts = BASE[start:end]
    text = BASE.replace(parts, "    type: EQ2\n    travel: {up: 0.5 m, down: 0.6 m}\n")
    text = text.replace("equalizers:\n", f"equalizer_types:\n  EQ2:\n{parts}equalizers:\n")
    equalizer = resolve(parse_scenario(text)).equalizers["e1"]
    assert (equalizer.travel.up, equalizer.travel.down) == (0.5, 0.6)
    assert equalizer.frame.mass == 5e3


def test_a_problem_of_a_type_is_shown_at_the_type() -> None:
    start, end = BASE.index("    frame:"), BASE.index("slings:\n")
    parts = BASE[start:end].replace("along: [-1.2 m, 1.2 m]", "along: [-1.2 m]")
    text = BASE[:start] + "    type: EQ2\n" + BASE[end:]
    text = text.replace("equalizers:\n", f"equalizer_types:\n  EQ2:\n{parts}equalizers:\n")
    with pytest.raises(ScenarioError, match=r"equalizer_types\.EQ2\.rope_ends\.along: found 1 rope end;"):
        parse_scenario(text)


def test_an_equalizer_without_parts_says_what_is_missing() -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(spoiled("    rope: thick\n", ""))
    assert str(caught.value) == (
        "scenario.yaml:30: equalizers.e1: 'rope' is missing; an equalizer needs it, or a type that has it"
    )


# Factors of EN 12385-4 for 6x36 IWRC 1960 with d in mm: mass 0.409 d²/100 kg/m, metallic area 0.460 d² mm²,
# minimum breaking force 0.356 d² 1960/1000 kN; EA = metallic area times 100 kN/mm².
@pytest.mark.parametrize(
    ("diameter", "mass", "stiffness", "breaking_force"),
    [(44, 7.92, 89.1e6, 1351e3), (64, 16.8, 188e6, 2858e3), (76, 23.6, 266e6, 4030e3)],
)
def test_catalogue_ropes(diameter: float, mass: float, stiffness: float, breaking_force: float) -> None:
    kind = f"sling: {{construction: 6x36 IWRC, grade: 1960, diameter: {diameter} mm, damping_time: 10 ms}}"
    text = spoiled("sling: {axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}", kind)
    rope = resolve(parse_scenario(text)).slings["S1"].rope
    assert rope.mass_per_length == pytest.approx(mass, rel=0.005)
    assert rope.stiffness == pytest.approx(stiffness, rel=0.005)
    assert rope.breaking_force == pytest.approx(breaking_force, rel=0.005)


def test_mass_of_ropes() -> None:
    catalogue = "construction: 6x36 IWRC, grade: 1960, diameter: 44 mm"
    for given, mass in (("mass: none", 0.0), ("mass: 9 kg/m", 9.0)):
        text = spoiled("axial_stiffness: 100 MN, damping_time: 2 ms, mass: none", f"{catalogue}, {given}")
        assert resolve(parse_scenario(text)).slings["S1"].rope.mass_per_length == mass


@pytest.mark.parametrize(
    ("change", "is_at_rest"),
    [
        (("start: rest\n", ""), True),  # stands on the ground
        (("start: rest", "start: as_given"), False),
        (("start: rest", "start: rest"), True),
    ],
)
def test_how_a_lift_starts(change: tuple[str, str], is_at_rest: bool) -> None:
    assert parse_scenario(spoiled(*change)).starts_at_rest is is_at_rest


def test_a_lift_of_plain_mechanics_starts_as_given() -> None:
    assert parse_scenario(MECHANICS).starts_at_rest is False


def test_a_scenario_never_changes() -> None:
    scenario = parse_scenario(BASE)
    with pytest.raises(AttributeError, match=r"stays as it was read; Scenario\.changed\("):
        scenario.duration = 3.0  # type: ignore[misc]
    assert isinstance(scenario, Scenario)
