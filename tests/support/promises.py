"""What every scenario promises, held by the tests that have its recording, so that it is simulated once.

Its metrics are those of its `expect.yaml`, each with the source of its value; documents show what
`gantline run` prints of it; its energy adds up, losses only grow and the remainder is bounded; and its
recording says the same once it has been saved.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from ruamel.yaml import YAML

import gantline
from books import LOSSES, STORED, WORK, energy
from gantline.results.metrics import energy_bound
from gantline.results.recording import Recording
from gantline.scenario import load_scenario
from gantline.units import DIMENSIONS, UnitError, quantity
from scenario_figures import told_of
from shown import PAGES, lift_that_runs, shown_on, stale, table_of, unsaid

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


def stale_of(lift: str, recording: Recording) -> dict[str, list[str]]:
    """What pages show of the table of a lift and is otherwise, by where it stands."""
    shown = [one for one in SHOWN if lift_that_runs(one.command) == lift]
    table = table_of(recording) if shown else ""
    differs = {str(one): stale(one, table) for one in shown}
    return {place: lines for place, lines in differs.items() if lines}


def metrics_are_those_expected(folder: Path, recording: Recording, scratch: Path) -> None:
    """Metrics of the whole lift within the tolerance of their source; pages show its table as it is."""
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


def balance_closes(folder: Path, recording: Recording, scratch: Path) -> None:
    """|remainder| of all steps within the bound of the integrator, relative to kinetic + elastic + |work|."""
    assert 0.0 <= recording.metrics()["energy_remainder"] <= energy_bound(recording.attributes["settings"])
    assert not any("energy" in warning for warning in recording.attributes["warnings"])
    # The books hold at every sample: what is stored, less the work of the drives, plus all losses.
    stored = energy(recording, STORED)
    balance = stored - stored[0] - energy(recording, WORK) + energy(recording, LOSSES)
    scale = np.max(np.abs(stored)) + 1.0
    assert np.abs(balance - recording.column("energy", "remainder")).max() < 1e-9 * scale
    vessels = (load_scenario(folder).vessels or {}).values()
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


def says_the_same_when_it_has_been_saved(folder: Path, recording: Recording, scratch: Path) -> None:
    """Every value and label of every variable, bit for bit, and what else pages are made of."""
    saved = beginning(recording, SAVED)
    again = gantline.open_recording(saved.save(scratch / "recording.nc"))
    assert list(again.variables) == list(saved.variables) == list(recording.variables)
    assert again.coordinates == saved.coordinates
    for name, variable in saved.variables.items():
        assert again[name].values.tobytes() == variable.values.tobytes(), name
    assert again.attributes == saved.attributes


#: Asked with the folder of a scenario, its recording as it comes, and a folder that may be written to.
Promise = Callable[[Path, Recording, Path], None]
PROMISES: tuple[Promise, ...] = (
    metrics_are_those_expected,
    balance_closes,
    says_the_same_when_it_has_been_saved,
)
