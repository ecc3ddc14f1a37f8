"""What a lift file says of a load in water: what is refused, what is doubtful, and how it is shared out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline import simulate
from gantline.assembly import assemble
from gantline.cad.assumptions import STEEL
from gantline.scenario import Scenario, ScenarioError, load_scenario, parse_scenario


def manifold(**changes: Any) -> Scenario:
    """`splash_zone` with other words under `in_water`."""
    return load_scenario("splash_zone").changed(
        {f"load.in_water.{key}": value for key, value in changes.items()}
    )


def lattices(lift: Scenario) -> list[dict[str, Any]]:
    forces = assemble(lift).document["forces"]
    (force,) = (force for force in forces if force["type"] == "submerged")
    found: list[dict[str, Any]] = force["lattices"]
    return found


def whole(lift: Scenario, key: str) -> Any:
    """All cells together."""
    return sum(4 * one["layers"] * np.array(one[key]) for one in lattices(lift))


def test_cells_have_together_what_the_load_has() -> None:
    """Volume, added mass and ½ ρ C S, evenly about the middle of the load's box, 0.2 m over its centre."""
    lift = manifold()
    assert whole(lift, "volume") == pytest.approx(7.6)
    assert whole(lift, "added_mass") == pytest.approx([30e3, 40e3, 80e3])
    sides = np.array([6 * 4, 8 * 4, 8 * 6])
    assert whole(lift, "quadratic") == pytest.approx(0.5 * 1025 * np.array([1.2, 1.2, 1.8]) * sides)
    even, slamming = lattices(lift)
    # With 234 kg of shackles and slings on its lugs at 4 m the load has its centre higher than at 1.8 m.
    centre = (60e3 * 1.8 + (4 * 16 + 4 * 4.5 * 9.424) * 4.0) / (60e3 + 4 * 16 + 4 * 4.5 * 9.424)
    middle = even["at"][2] + 3.5 * even["height"]
    assert middle == pytest.approx(2.0 - centre, abs=1e-5)
    assert 8 * even["height"] == pytest.approx(4.0)
    # Second moments of four cells at places of Gauss are those of the sides.
    assert even["half"] == pytest.approx([8 / np.sqrt(12), 6 / np.sqrt(12)])
    # C_s = 2 A/(ρ S d), (LW5).
    depth = 2 * 80e3 / (1025 * 48 * 5)
    assert 8 * slamming["height"] == pytest.approx(depth)
    assert slamming["added_mass"][:2] == [0.0, 0.0]
    assert slamming["volume"] == 0.0


def without(*lines: str) -> Scenario:
    """`splash_zone` without lines that begin so."""
    text = Path(load_scenario("splash_zone").source).read_text(encoding="utf-8")
    kept = [line for line in text.splitlines() if not line.strip().startswith(lines)]
    return parse_scenario("\n".join(kept))


def test_volume_is_that_of_steel_if_not_given() -> None:
    assert whole(without("displaced_volume:"), "volume") == pytest.approx(60e3 / STEEL)


def test_where_is_the_water() -> None:
    with pytest.raises(ScenarioError) as refused:
        without("water:", "waves:", "sea:")
    assert "where is the water? Write 'water: {level: 0 m}'" in str(refused.value)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"load.in_water.displaced_volume": "200 m^3"}, "200 m^3 are more than the load's box has, 192 m^3"),
        (
            {"load.in_water.displaced_volume": "7.6 t"},
            "'7.6 t' is a mass; needed is a volume, written",
        ),
        ({"load.in_water.slamming_coefficient": "0.5"}, "0.5 is less than 0.813, which added mass along z"),
        ({"load.in_water.added_mass": "80 t"}, "a list of 3 is needed"),
        ({"load.in_water.drag_coefficients": ["1", "1", "-1"]}, "item 3: '-1' is out of range"),
        (
            {"load.current_areas": {"side": {"area": "9 m^2", "coefficient": "1", "along": "x"}}},
            "'drag_coefficients' of 'in_water' say already how water resists the load",
        ),
    ],
)
def test_what_cannot_be(changes: dict[str, Any], expected: str) -> None:
    """0.5 · 2 · 80 t/(1.025 · 48 · 0.5 · 4 m) = 0.813 over the whole height."""
    with pytest.raises(ScenarioError) as refused:
        load_scenario("splash_zone").changed(changes)
    assert expected in str(refused.value)


def test_a_load_that_floats_is_doubtful() -> None:
    doubts = assemble(manifold(displaced_volume="70 m^3")).warnings
    assert any("the load floats: it weighs 60 t and displaces 71.75 t" in doubt for doubt in doubts)


def test_a_load_that_the_plan_lets_float_is_not() -> None:
    """There is nothing but water to leave it on, and the plan lets it down until its slings are slack."""
    wet = manifold(displaced_volume="70 m^3")
    steps = [{"step": "float", "lower": "crane", "speed": "3 m/min", "until": {"slings": "slack"}}]
    steps += [{"step": "look", "hold": "until_end"}]
    afloat = wet.changed({"plan": steps})
    assert not any("the load floats" in doubt for doubt in assemble(afloat).warnings)


def test_added_mass_that_no_load_of_this_size_has_is_doubtful() -> None:
    """1.025 t/m^3 (8 · 6 · 4 m^3 + (8 · 6 m^2)^1.5) = 538 t along z."""
    sentence = "are more than the water in the load's box and about it, 538 t; a unit has slipped"
    for along_z, is_doubtful in (("530 t", False), ("540 t", True)):
        doubts = assemble(manifold(added_mass=["30 t", "40 t", along_z], slamming_coefficient="20")).warnings
        assert any(f"540 t along z {sentence}" in doubt for doubt in doubts) is is_doubtful


def test_current_pushes_a_load_in_water() -> None:
    """It is not told to push nothing, as where no body has `current_areas`."""
    current = {"current": {"speed": "0.5 m/s", "direction": "90 deg"}}
    assembly = assemble(load_scenario("splash_zone").changed(current))
    assert not any("pushes nothing" in doubt for doubt in assembly.warnings)
    (force,) = (force for force in assembly.document["forces"] if force["type"] == "submerged")
    assert force["stream"] == pytest.approx([0.0, 0.5, 0.0], abs=1e-12)


def test_static_is_what_hangs_in_the_air() -> None:
    """Where the load goes down without a hold, the mean over the time before the water reaches it, in place
    of that at the end, which is ρ g V less.
    """
    plan = [
        {"step": "lower", "lower": "crane", "speed": "12 m/min", "by": "14 m"},
        {"step": "hold below", "hold": "until_end"},
    ]
    lift = load_scenario("splash_zone").changed(
        {"plan": plan, "duration": "120 s", "waves.sea.significant_height": "20 cm"}
    )
    metrics = simulate(lift).metrics()
    weight = (60e3 + 4 * 9 * 9.424 + 8 * 16) * 9.81
    # Setting out at 0.2 m/s within 25 s in the air takes 0.2/(25 g) = 8e-4 of the mean.
    assert metrics["static_hook_load"] == pytest.approx(weight, rel=1e-3)
