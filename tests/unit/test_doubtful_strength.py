"""What is a thousand times too strong, and would let everything pass, is told; shipped lifts have none."""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario

SCENARIOS = sorted(
    one.parent.name for one in (Path(__file__).parents[2] / "scenarios").glob("*/scenario.yaml")
)


def doubts(lift: str, changes: dict[str, object]) -> list[str]:
    """Doubts that a lift has with these changes and not without."""
    scenario = load_scenario(lift)
    before = {one.sentence for one in assemble(scenario).doubts}
    return [one.sentence for one in assemble(scenario.changed(changes)).doubts if one.sentence not in before]


@pytest.mark.parametrize(
    ("lift", "path", "value", "told"),
    [
        ("equalizer", "cranes.test_hook.rated_capacity", "400000 t", "bears more than 20000 t"),
        ("goliath", "hook_types.hook_500.rated_capacity", "500000 t", "bears more than 20000 t"),
        ("equalizer", "load.lugs.L1.capacity", "80000 t", "times all of the load"),
        ("goliath", "shackles.wb40.working_load_limit", "40000 t", "no shackle bears more"),
        ("goliath", "shackles.wb40.working_load_limit", "4000 t", "times as much"),
        ("floating_crane", "cranes.fc.rating.heel", "1500 deg", "no chart holds so far"),
        ("revolving_crane", "cranes.rc.rating.off_lead", "3000 deg", "no chart holds so far"),
        ("floating_crane_and_crawlers", "cranes.c1.slewing.speed", "300 rev/min", "108000 deg/min"),
        ("goliath", "limits.hoist_load_of_rated_capacity", "10000 %", "lets everything pass"),
        ("equalizer_sling_cut", "limits.equalizer_travel_used", "9000 %", "lets everything pass"),
        ("floating_crane_and_crawlers", "limits.load_tilt", "2000 deg", "lets everything pass"),
        ("upending", "hook_types.hook_200.drum.spare_turns", 0.003, "less than one turn"),
        ("upending", "hook_types.hook_120.drum.diameter", "0.8 mm", "less than its rope of 28 mm"),
        ("upending", "ropes.hoist_28.mass", "3200 kg/m", "a bar of solid steel has 4.83 kg/m"),
        ("upending", "ropes.hoist_28.mass", "0.0032 kg/m", "a bar of solid steel has 4.83 kg/m"),
        ("equalizer_yard", "ropes.equalizing.diameter", "46 m", "N/mm^2 over its circle"),
        ("upending", "watch.1.smallest", "2 mm", "no distance to keep"),
        ("mechanisms", "equalizers.e1.travel.down", "1900 m", "never meet a stop"),
        ("revolving_crane", "supports.stools.damping", "1000 MN s/m", "gives like dough"),
        ("equalizer_yard", "load.centre_of_gravity.envelope", ["100 m", "0.1 m", "0.1 m"], "long there"),
    ],
    ids=lambda one: str(one)[:40],
)
def test_it_is_told(lift: str, path: str, value: object, told: str) -> None:
    found = doubts(lift, {path: value})
    assert [one for one in found if told in one], found


def test_a_chart_that_reaches_too_far_is_told() -> None:
    radii = ["12 m", "14 m", "16 m", "18 m", "20 m", "24 m", "28000 m"]
    [found] = doubts("upending", {"cranes.main.rating.radius": radii})
    assert found.startswith("28000 m: no crane reaches farther than 200 m")


@pytest.mark.parametrize("lift", SCENARIOS)
def test_the_lifts_that_come_along_say_nothing_of_it(lift: str) -> None:
    said = [one.sentence for one in assemble(load_scenario(lift)).doubts]
    assert not [one for one in said if "slipped" in one or "wrong unit" in one], said
