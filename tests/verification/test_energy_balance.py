"""The books of whole lifts: energy adds up, losses only grow, the remainder is bounded and falls with h."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.results.metrics import energy_bound
from gantline.results.variable import FloatArray

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
STORED = ("kinetic", "gravity", "elastic", "fluid")
WORK = ("drive_work", "fluid_work")
LOSSES = (
    "rope_damping",
    "joint_damping",
    "contact_damping",
    "friction",
    "drag",
    "impact",
    "parting",
    "adjusting",
    "method",
)

#: By which positions may be wrong in a step of `adaptive`, its default tolerance [m].
POSITION = 1e-4

scenarios = pytest.mark.parametrize(
    "name", sorted(path.parent.name for path in SCENARIOS.glob("*/scenario.yaml"))
)


def energy(recording: gantline.Recording, kinds: tuple[str, ...]) -> FloatArray:
    """Sum of the energies of some kinds [J], shape (time,); those of water or wind are not always there."""
    known = recording.coordinates["energy_kind"]
    total: FloatArray = np.sum([recording.column("energy", kind) for kind in kinds if kind in known], axis=0)
    return total + np.zeros(len(recording.time))


def held_by_sheaves(recording: gantline.Recording) -> float:
    """Largest sum of the differences of tension that sheaves hold by friction [N]."""
    if "sheave_tension" not in recording:
        return 0.0
    sides = recording["sheave_tension"].values
    return float(np.abs(sides[:, :, 0] - sides[:, :, 1]).sum(axis=1).max())


@scenarios
def test_the_balance_of_every_scenario_closes(name: str) -> None:
    """|remainder| of all steps within the bound of the integrator, relative to kinetic + elastic + |work|."""
    recording = gantline.simulate(SCENARIOS / name)
    assert 0.0 <= recording.metrics()["energy_remainder"] <= energy_bound(recording.attributes["settings"])
    assert not any("energy" in warning for warning in recording.attributes["warnings"])
    # The books hold at every sample: what is stored, less the work of the drives, plus all losses.
    stored = energy(recording, STORED)
    balance = stored - stored[0] - energy(recording, WORK) + energy(recording, LOSSES)
    scale = np.max(np.abs(stored)) + 1.0
    assert np.abs(balance - recording.column("energy", "remainder")).max() < 1e-9 * scale
    vessels = (gantline.load_scenario(SCENARIOS / name).vessels or {}).values()
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


def test_the_remainder_of_the_reference_lift_falls_with_the_step() -> None:
    """The step is of first order: half the step, half the remainder."""
    remainders = [
        gantline.simulate(SCENARIOS / "equalizer", integrator="del", step=step).metrics()["energy_remainder"]
        for step in (2e-3, 1e-3, 5e-4)
    ]
    assert remainders[0] / remainders[1] == pytest.approx(2.0, rel=0.1)
    assert remainders[1] / remainders[2] == pytest.approx(2.0, rel=0.1)


def test_what_the_reference_lift_dissipates_is_what_its_dampers_do() -> None:
    """After the hook has stopped, energy only falls, by the losses of ropes and of the method."""
    recording = gantline.simulate(SCENARIOS / "equalizer", integrator="del", step=2.5e-4)
    hanging = recording.time >= 26.5
    held = energy(recording, STORED)[hanging]
    assert np.ptp(recording.column("energy", "drive_work")[hanging]) < 1e-6 * np.ptp(held)
    lost = energy(recording, LOSSES)[hanging]
    # The remainder, 2e-5 of what the hoist put in, is 4 % of the 1 kJ that the ringing loses.
    assert held[0] - held[-1] == pytest.approx(lost[-1] - lost[0], rel=0.05)
    for kind in ("contact_damping", "friction", "impact", "joint_damping"):
        # J; the anchors of clear corners follow to rounding of the second order.
        assert np.ptp(recording.column("energy", kind)[hanging]) < 1e-3, kind
