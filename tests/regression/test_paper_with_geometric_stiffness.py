"""`paper: true` beside `geometric_stiffness: true` ran without geometric stiffness, and nobody said so.

`gantline compare equalizer --b integrator=del --b paper=true --b geometric_stiffness=true` printed both and
compared a run that had none. The page said that `geometric_stiffness: false` leaves out that alone, as if
`paper` did something else: runs of the two are the same bytes.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.overrides import SettingError
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, load_scenario
from gantline.simulation import Simulation

DEL = {"integrator": "del", "step": "10 ms"}


def lift(**settings: bool) -> gantline.Scenario:
    return load_scenario("equalizer").changed({"simulation": {**DEL, **settings}, "duration": "25 s"})


def run(**settings: bool) -> Recording:
    return Simulation(lift(**settings)).run()


def test_both_are_refused_in_a_lift_file() -> None:
    with pytest.raises(ScenarioError) as refused:
        lift(paper=True, geometric_stiffness=True)
    says = "'paper: true' is without geometric stiffness; leave one of both out"
    assert f"simulation.geometric_stiffness: {says}" in str(refused.value)


@pytest.mark.parametrize("file", [{}, {"paper": True}], ids=["run", "lift file and run"])
def test_both_are_refused_as_settings_of_a_run(file: dict[str, bool]) -> None:
    with pytest.raises(SettingError, match="geometric_stiffness: paper is without it"):
        gantline.simulate(lift(**file), paper=True, geometric_stiffness=True, duration=0.1)


def test_paper_is_without_geometric_stiffness_and_nothing_else() -> None:
    """All variables are the same bytes; with it, tensions after the load has come clear are others."""
    paper, without, usual = run(paper=True), run(geometric_stiffness=False), run()
    assert set(paper.variables) == set(without.variables)
    for name in paper.variables:
        assert np.array_equal(paper[name].values, without[name].values), name
    tension = "rope_tension"
    assert not np.array_equal(paper[tension].values, usual[tension].values)


def test_equilibria_know_no_method() -> None:
    """Tensions at rest, and the natural motions about it, to the last bit."""

    def at_rest(scenario: gantline.Scenario) -> tuple[list[float], list[float]]:
        question = gantline.Statics(scenario)
        tension = question.equilibrium().recording["rope_tension"].values[-1]
        return tension.tolist(), [mode.square for mode in question.modes()]

    assert at_rest(lift(paper=True)) == at_rest(lift())
