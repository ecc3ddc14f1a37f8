"""Every scenario does what its `expect.yaml` says: keys of `metrics()`, each with the source of its value.

And documents show what `gantline run` prints of it, which is held here so that it is simulated once.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from ruamel.yaml import YAML

import gantline
from gantline.results.metrics import ENERGY_BOUNDS
from gantline.results.recording import Recording
from gantline.scenario import load_scenario
from gantline.units import DIMENSIONS, UnitError, quantity
from shown import PAGES, lift_that_runs, shown_on, stale, table_of

SCENARIOS = sorted(path.parent for path in (Path(__file__).parents[2] / "scenarios").glob("*/scenario.yaml"))
SHOWN = [one for page in PAGES for one in shown_on(page) if lift_that_runs(one.command)]


def si(text: str) -> tuple[float, str]:
    """Value and dimension of a quantity with a unit; every unit belongs to one dimension."""
    for dimension in DIMENSIONS:
        try:
            value = quantity(text, dimension)
        except UnitError:
            continue
        return value, dimension
    raise AssertionError(f"'{text}' is not a quantity with a unit")


def margin(within: str, value: float, dimension: str) -> float:
    """Tolerance as a difference: a share of the value, or a quantity of its dimension."""
    size, kind = si(within)
    if kind == "ratio" and dimension != "ratio":
        return abs(value) * size
    assert kind == dimension, f"'within: {within}' does not belong to a value of dimension {dimension}"
    return size


@pytest.mark.parametrize("folder", SCENARIOS, ids=lambda folder: folder.name)
def test_a_scenario_does_what_it_promises(folder: Path) -> None:
    expected: dict[str, dict[str, Any]] = YAML(typ="safe").load(folder / "expect.yaml")
    recording = gantline.simulate(folder)
    metrics = recording.metrics()
    wrong = []
    for key, entry in expected.items():
        assert set(entry) == {"value", "within", "source"}, key
        value, dimension = si(str(entry["value"]))
        if not abs(metrics[key] - value) <= margin(entry["within"], value, dimension):
            wrong.append(f"{key}: {metrics[key]:g}, not {entry['value']} within {entry['within']}")
    assert wrong == []
    assert stale_of(folder.name, recording) == {}


@pytest.mark.parametrize("folder", SCENARIOS, ids=lambda folder: folder.name)
def test_energy_is_held_at_least_as_closely_as_the_program_does(folder: Path) -> None:
    """A wider margin could fail only after the run itself had said that its balance does not close."""
    entry = YAML(typ="safe").load(folder / "expect.yaml").get("energy_remainder")
    if entry is not None:
        bound = ENERGY_BOUNDS[load_scenario(folder).simulation.integrator]
        assert margin(entry["within"], 0.0, "ratio") <= bound * (1 + 1e-12)  # 0.001 % read as a number


def stale_of(lift: str, recording: Recording) -> dict[str, list[str]]:
    """What pages show of the table of a lift and is otherwise, by where it stands."""
    shown = [one for one in SHOWN if lift_that_runs(one.command) == lift]
    differs = {str(one): stale(one, table_of(recording)) for one in shown}
    return {place: lines for place, lines in differs.items() if lines}


def test_the_documents_show_tables_of_scenarios() -> None:
    assert {"equalizer", "floating_crane"} <= {lift_that_runs(one.command) for one in SHOWN}


def test_a_margin_is_a_share_or_a_quantity() -> None:
    assert margin("1 %", 700e3, "force") == pytest.approx(7e3)
    assert margin("1 cm", 1.77, "length") == pytest.approx(0.01)
    assert margin("0.2 %", 0.012, "ratio") == pytest.approx(0.002)
    with pytest.raises(AssertionError, match="does not belong"):
        margin("1 s", 1.77, "length")
