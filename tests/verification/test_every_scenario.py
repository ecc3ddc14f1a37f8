"""Every scenario does what its `expect.yaml` says: keys of `metrics()`, each with the source of its value.

And its energy adds up, losses only grow and the remainder is bounded; documents show what `gantline run`
prints of it; and its recording says the same once it has been saved. All is held here so that each is
simulated once.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import gantline
from books import LOSSES, STORED, WORK, energy
from gantline.results.metrics import ENERGY_BOUNDS, energy_bound
from gantline.results.recording import Recording
from gantline.scenario import load_scenario
from gantline.units import DIMENSIONS, UnitError, quantity
from scenario_figures import told_of
from shown import PAGES, lift_that_runs, shown_on, stale, table_of, unsaid

SCENARIOS = sorted(path.parent for path in (Path(__file__).parents[2] / "scenarios").glob("*/scenario.yaml"))
SHOWN = [one for page in PAGES for one in shown_on(page) if lift_that_runs(one.command)]
#: How much of a recording is saved and read back [bytes]: its largest variables are in several chunks still.
SAVED = 32e6
#: By which positions may be wrong in a step of `adaptive`, its default tolerance [m].
POSITION = 1e-4


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


@dataclass(frozen=True)
class Ran:
    """A scenario and its recording."""

    folder: Path
    recording: Recording


@pytest.fixture(scope="module", params=SCENARIOS, ids=lambda folder: folder.name)
def ran(request: pytest.FixtureRequest) -> Ran:
    """One after the other: of tests that need it, all of one scenario come before those of the next."""
    return Ran(request.param, gantline.simulate(request.param))


def test_a_scenario_does_what_it_promises(ran: Ran) -> None:
    """Metrics of the whole lift within the tolerance of their source; pages show its table as it is."""
    folder, recording = ran.folder, ran.recording
    expected: dict[str, dict[str, Any]] = YAML(typ="safe").load(folder / "expect.yaml")
    metrics = recording.metrics()
    wrong = []
    for key, entry in expected.items():
        assert set(entry) == {"value", "within", "source"}, key
        value, dimension = si(str(entry["value"]))
        if not abs(metrics[key] - value) <= margin(entry["within"], value, dimension):
            wrong.append(f"{key}: {metrics[key]:g}, not {entry['value']} within {entry['within']}")
    assert wrong == []
    assert stale_of(folder.name, recording) == {}
    assert unsaid(f"scenarios/{folder.name}/README.md", *told_of(folder.name, recording)) == []


def held_by_sheaves(recording: Recording) -> float:
    """Largest sum of the differences of tension that sheaves hold by friction [N]."""
    if "sheave_tension" not in recording:
        return 0.0
    sides = recording["sheave_tension"].values
    return float(np.abs(sides[:, :, 0] - sides[:, :, 1]).sum(axis=1).max())


def test_the_balance_of_every_scenario_closes(ran: Ran) -> None:
    """|remainder| of all steps within the bound of the integrator, relative to kinetic + elastic + |work|."""
    recording = ran.recording
    assert 0.0 <= recording.metrics()["energy_remainder"] <= energy_bound(recording.attributes["settings"])
    assert not any("energy" in warning for warning in recording.attributes["warnings"])
    # The books hold at every sample: what is stored, less the work of the drives, plus all losses.
    stored = energy(recording, STORED)
    balance = stored - stored[0] - energy(recording, WORK) + energy(recording, LOSSES)
    scale = np.max(np.abs(stored)) + 1.0
    assert np.abs(balance - recording.column("energy", "remainder")).max() < 1e-9 * scale
    vessels = (load_scenario(ran.folder).vessels or {}).values()
    remembers = any(vessel.radiation is not None for vessel in vessels)
    for kind in LOSSES[:-1]:
        # A slip that turns round within one step may give back a little of its own: by sheaves what their
        # friction does along the way by which positions may be wrong.
        turned = 1e-7 * scale + (POSITION * held_by_sheaves(recording) if kind == "friction" else 0.0)
        lost = energy(recording, (kind,))
        if kind == "drag" and remembers:
            # Waves that a vessel has made push it on for a while: water that remembers takes in the whole.
            assert lost.min() >= 0.0
            continue
        assert np.diff(lost).min() > -turned, f"{kind} was given back"


def beginning(recording: Recording, most: float) -> Recording:
    """A recording up to the time until which its numbers take this much room [bytes]."""
    whole = sum(variable.values.nbytes for variable in recording.variables.values())
    samples = min(len(recording.time), math.ceil(len(recording.time) * most / whole))
    kept = {
        name: replace(variable, values=variable.values[:samples]) if "time" in variable.dims else variable
        for name, variable in recording.variables.items()
    }
    return Recording(kept, recording.coordinates, recording.attributes)


def test_a_recording_says_the_same_when_it_has_been_saved(ran: Ran, tmp_path: Path) -> None:
    """Every value and label of every variable, bit for bit, and what else pages are made of."""
    recording = beginning(ran.recording, SAVED)
    again = gantline.open_recording(recording.save(tmp_path / "recording.nc"))
    assert list(again.variables) == list(recording.variables) == list(ran.recording.variables)
    assert again.coordinates == recording.coordinates
    for name, variable in recording.variables.items():
        assert again[name].values.tobytes() == variable.values.tobytes(), name
    assert again.attributes == recording.attributes


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
    """Among them those of two lifts that guides go through."""
    assert {"equalizer", "floating_crane"} <= {lift_that_runs(one.command) for one in SHOWN}


def test_a_margin_is_a_share_or_a_quantity() -> None:
    """Of a value, or of its dimension; nothing else."""
    assert margin("1 %", 700e3, "force") == pytest.approx(7e3)
    assert margin("1 cm", 1.77, "length") == pytest.approx(0.01)
    assert margin("0.2 %", 0.012, "ratio") == pytest.approx(0.002)
    with pytest.raises(AssertionError, match="does not belong"):
        margin("1 s", 1.77, "length")
