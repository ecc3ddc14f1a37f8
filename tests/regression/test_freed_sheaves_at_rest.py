"""A load falls to the ground since slings of its equalizer are cut: the search for its rest stood still.

No sheave may run through the fixed ones in one step of the search, so what would is braked. The brake was
as stiff as the ropes: a sheave that nothing but its weight held, its sling cut, went on by half a
millimetre a step, and the rig with it. After 500 steps "no step brings its forces closer to balance (e1.4)"
was said of a load that stands on the ground, and of one that hangs clear. And of a sheave that cannot be
held it was said in place of what is wrong.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.scenario import Scenario
from gantline.statics import Losses, Statics

G, SHEAVE = 9.81, 300.0


def lift(scenario: str, values: Mapping[str, Any]) -> Scenario:
    return gantline.load_scenario(scenario).changed(values)


def test_it_comes_to_rest_on_the_ground() -> None:
    """Each sheave hangs in two parts, T = m g/2; each corner of the load carries a quarter of it.

    Three of five slings are cut at 20 s with 15 t on them; the two that are left are long enough then.
    """
    values = {f"slings.{sling}.cut_at": "20 s" for sling in ("S2", "S3", "S4")}
    rest = Statics(lift("equalizer", {"load.weight.calculated": "15 t", **values})).equilibrium()
    assert rest.tension("e1.equalizing") == pytest.approx(SHEAVE * G / 2, rel=1e-9)
    assert [rest.tension(f"sling.S{number}") for number in range(1, 6)] == [0.0] * 5
    corners = rest.recording["contact_force"].values[-1][:4]
    assert corners == pytest.approx([15e3 * G / 4] * 4, rel=1e-9)
    # The rope is as long as it was: what goes down in one place comes up in others.
    assert rest.recording["sheave_travel"].values[-1].sum() == pytest.approx(0.0, abs=1e-3)
    assert rest.steps <= 10


@pytest.mark.parametrize(
    ("scenario", "values"),
    [
        (
            "equalizer_sling_cut",
            {
                "load.centre_of_gravity.at": "[-0.3 m, 2 m, 1 m]",
                "slings.S5.length": "23.3 m",
                "plan[1].brake_from": "54.3 s",
            },
        ),
        (
            "equalizer",
            {
                "load.weight.calculated": "450 t",
                "equalizers.e1.hinge.tilts": "true",
                "slings.S2.length": "27 m",
                "slings.S5.cut_at": "30 s",
                "plan[1].brake_from": "28.637 s",
            },
        ),
    ],
)
def test_it_comes_to_rest_held_by_friction(scenario: str, values: dict[str, str]) -> None:
    """What is lifted and what stands make up the weight: forces on the load balance along z.

    One load ends on a corner and four slings, the other on the ground.
    """
    rest = Statics(lift(scenario, values)).equilibrium(losses="held")
    load = lift(scenario, values).load
    assert load is not None
    weight = load.weight.calculated * G
    recording = rest.recording
    hook = float(recording["hook_load"].values[-1].sum())
    frame = (20e3 + 5 * SHEAVE) * G
    carried = float(np.sum(recording["contact_force"].values[-1][:4]))
    assert hook - frame + carried == pytest.approx(weight, rel=1e-6)
    assert rest.residual < 1e-9


@pytest.mark.parametrize("losses", ["none", "held"])
def test_a_sheave_that_nothing_holds_is_named_by_its_rope(losses: Losses) -> None:
    """No stops, one sling cut, and the load hangs: its sheave runs up to the fixed ones, as in a run."""
    question = Statics(lift("equalizer", {"load.weight.calculated": "15 t", "slings.S2.cut_at": "20 s"}))
    with pytest.raises(gantline.NoEquilibriumError, match=r"come together: .* holds it \(e1\.equalizing\)"):
        question.equilibrium(losses=losses)


def test_what_keeps_a_sheave_from_running_up_is_said_at_the_start() -> None:
    """One sling of five is heavier than the others; with pins all are held."""
    heavy = {"ropes.heavy": {"axial_stiffness": "200 MN", "damping_time": "2 ms", "mass": "40 kg/m"}}
    values: dict[str, Any] = {**heavy, "slings.S4.rope": "heavy", "start": "rest"}
    said = r"equalizers\.e1: .* come together: .* 'stops: true' under 'travel' ends its way"
    with pytest.raises(gantline.ScenarioError, match=said):
        gantline.Simulation(lift("equalizer", values))
    gantline.Simulation(lift("equalizer", {**values, "equalizers.e1.travel.locked": "true"}))
