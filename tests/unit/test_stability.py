"""What a recording says of how sound its run was."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import mechanics
from chain import STEP, chain
from gantline.results.recording import Recording
from gantline.results.stability import Failure, Stability, stability_of
from gantline.results.variable import Variable
from sample_lift import sample_recording


def lift(energy: dict[str, Any] | None = None, **attributes: Any) -> Recording:
    recording = sample_recording(np.arange(5.0), tension=np.zeros((5, 5)), energy=energy)
    return Recording(recording.variables, recording.coordinates, {**recording.attributes, **attributes})


def text(stability: Stability) -> str:
    return "; ".join(stability.sentences())


def test_a_sound_run() -> None:
    found = stability_of(lift())
    assert found.is_sound
    assert text(found) == (
        "ran to its end, 4 s; energy remainder 1.0e-04, bound 1e-03: the balance closes; "
        "no energy from nowhere beyond 0.1 % of the largest energy; forces keep their laws to 0 N"
    )


def test_a_balance_that_does_not_close() -> None:
    found = stability_of(lift(energy_remainder=2e-3))
    assert not found.is_sound
    assert "energy remainder 2.0e-03, bound 1e-03: THE BALANCE DOES NOT CLOSE" in text(found)


def test_a_failure_is_told_with_time_element_and_cause() -> None:
    why = {"time": 3.25, "element": "sling.S1", "cause": "a pivot is zero"}
    found = stability_of(lift(status="failed", failure=why))
    assert found.failure == Failure(3.25, "sling.S1", "a pivot is zero")
    assert not found.is_sound
    assert text(found).startswith("FAILED at 3.250 s at sling.S1: a pivot is zero; ")


def test_an_old_recording_of_a_failure_does_not_tell_the_cause() -> None:
    assert "FAILED at 4.00 s; the recording does not tell the cause" in text(
        stability_of(lift(status="failed"))
    )


def test_a_stopped_run() -> None:
    assert text(stability_of(lift(status="stopped"))).startswith("STOPPED at 4.00 s")


def test_energy_that_no_drive_put_in() -> None:
    """Of 200 J at most, 100 - 90 + 0.1 J come back after the loss at 2 s: 5.05 %, without work."""
    kinetic = np.array([200.0, 100.0, 90.0, 90.1, 100.1])
    found = stability_of(lift({"kinetic": kinetic}))
    assert found.energy_gain == pytest.approx(10.1 / 200.0)
    assert found.energy_gain_time == 4.0  # 0.1/200 at 3 s is within a thousandth
    assert "GAINS ENERGY from 4.00 s on: up to 5.05 % of the largest energy comes from no drive" in text(
        found
    )
    assert not found.is_sound


def test_energy_that_a_drive_put_in_is_no_gain() -> None:
    work = np.array([0.0, 10.0, 20.0, 30.0, 40.0])
    found = stability_of(lift({"gravity": 0.9 * work, "rope_damping": 0.1 * work, "drive_work": work}))
    assert (found.energy_gain, found.energy_gain_time) == (0.0, None)


def test_energy_that_water_gives_back_is_no_gain() -> None:
    """What rights a vessel is a potential: 100 J of it come and go as she rolls."""
    righting = np.array([100.0, 50.0, 0.0, 50.0, 100.0])
    rolls = lift({"kinetic": 100.0 - righting, "joint_damping": righting})
    kinds = ["fluid" if kind == "joint_damping" else kind for kind in rolls.coordinates["energy_kind"]]
    afloat = Recording(rolls.variables, {**rolls.coordinates, "energy_kind": kinds}, rolls.attributes)
    found = stability_of(afloat)
    assert (found.energy_gain, found.energy_gain_time) == (0.0, None)


def test_residuals_and_steps_that_did_not_settle() -> None:
    recording = lift(counters={"steps": 10, "unconverged": 3})
    variables = {
        **recording.variables,
        "residual_complementarity": Variable(("time",), np.array([0.0, 2.5, 0, 0, 0]), "N", ""),
        "residual_constraint": Variable(("time",), np.array([0.0, 0, 1e-6, 0, 0]), "m", ""),
    }
    found = stability_of(Recording(variables, recording.coordinates, recording.attributes))
    assert (found.complementarity_residual, found.constraint_residual, found.unconverged) == (2.5, 1e-6, 3)
    assert not found.is_sound
    said = text(found)
    assert "forces keep their laws to 2.5 N" in said
    assert "inextensible ropes keep their length to 1e-06 m" in said
    assert "3 STEPS NOT SETTLED" in said


@pytest.mark.parametrize("geometric_stiffness", [True, False])
def test_a_chain_that_shakes_sideways_gains_energy(geometric_stiffness: bool) -> None:
    """Without geometric stiffness a step of 0.1 s throws the light masses aside: energy out of nothing."""
    run = mechanics.simulation(chain(), 5.0, step=STEP, geometric_stiffness=geometric_stiffness)
    columns = mechanics.finished(run, run.run())
    samples = len(columns.time)
    recording = sample_recording(
        columns.time,
        tension=np.zeros((samples, 5)),
        energy={kind: columns.columns["energy"][:, k] for k, kind in enumerate(columns.names["energy_kind"])},
    )
    assert (stability_of(recording).energy_gain_time is None) is geometric_stiffness
