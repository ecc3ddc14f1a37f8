"""Every scenario does what its `expect.yaml` says: keys of `metrics()`, each with the source of its value.

And its energy adds up, losses only grow and the remainder is bounded; documents show what `gantline run`
prints of it; and its recording says the same once it has been saved. All is held of one run, so that each is
simulated once: of lifts at whose runs other tests look too, among those.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest
from ruamel.yaml import YAML

import gantline
from gantline.results.metrics import ENERGY_BOUNDS
from gantline.results.recording import Recording
from gantline.scenario import load_scenario
from promises import PROMISES, SHOWN, Promise, margin
from shown import ROOT, lift_that_runs

SCENARIOS = sorted(path.parent for path in (ROOT / "scenarios").glob("*/scenario.yaml"))
#: Those whose promises are held where their hand figures are, in a file of this name.
ELSEWHERE = ("floating_crane", "floating_crane_and_crawlers", "goliath", "monopile", "upending")
HERE = [folder for folder in SCENARIOS if folder.name not in ELSEWHERE]


@dataclass(frozen=True)
class Ran:
    """A scenario and its recording."""

    folder: Path
    recording: Recording


@pytest.fixture(scope="module", params=HERE, ids=lambda folder: folder.name)
def ran(request: pytest.FixtureRequest) -> Ran:
    """One after the other: of tests that need it, all of one scenario come before those of the next."""
    return Ran(request.param, gantline.simulate(request.param))


@pytest.mark.parametrize("promise", PROMISES)
def test_a_scenario_does_what_it_promises(promise: Promise, ran: Ran, tmp_path: Path) -> None:
    """Metrics within the tolerance of their source; its balance closes; and saved, it says the same."""
    promise(ran.folder, ran.recording, tmp_path)


@pytest.mark.parametrize("name", ELSEWHERE)
def test_what_is_not_held_here_is_held_elsewhere(name: str) -> None:
    """All promises, of a run of the scenario as it comes."""
    text = (ROOT / "tests" / "validation" / f"test_{name}.py").read_text(encoding="utf-8")
    assert '@pytest.mark.parametrize("promise", PROMISES)\n' in text
    assert f'promise(ROOT / "scenarios" / "{name}", ' in text


@pytest.mark.parametrize("folder", SCENARIOS, ids=lambda folder: folder.name)
def test_energy_is_held_at_least_as_closely_as_the_program_does(folder: Path) -> None:
    """A wider margin could fail only after the run itself had said that its balance does not close."""
    entry = YAML(typ="safe").load(folder / "expect.yaml").get("energy_remainder")
    if entry is not None:
        bound = ENERGY_BOUNDS[load_scenario(folder).simulation.integrator]
        assert margin(entry["within"], 0.0, "ratio") <= bound * (1 + 1e-12)  # 0.001 % read as a number


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
